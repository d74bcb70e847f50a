// SPDX-License-Identifier: MIT
#include "plan/assignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <shigusa/error.hpp>
#include <utility>

#include "core/parse_number.hpp"
#include "core/say.hpp"
#include "plan/parameter_info.hpp"

namespace shigusa {
namespace {

constexpr std::string_view kLocked = "locked";

// Parts of an assignment: "right_hip.flexion", "weight", "3" of "right_hip.flexion.weight=3". A
// posture parameter has no member: "squat_deg", "", "30".
struct Assignment {
  std::string_view whole;  // the text before the sign
  std::string_view name;
  std::string_view member;
  std::string_view value;
};

// Adds a name unless it is present.
void note(std::vector<std::string>& names, std::string name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

// The accepted names of a parameter: its own and, for a dof, its joint's.
std::vector<std::string> names_of(const ParameterInfo& info) {
  std::vector<std::string> names{info.subject()};
  if (info_of(info.kind).of_freedom) {
    names.push_back(names[0].substr(0, names[0].rfind('.')));
  }
  return names;
}

// The members of a kind's parameters: "weight" and "locked", "swivel_deg" and "swivel_rad".
std::vector<std::string> members_of(ParameterKind kind) {
  const ParameterKindInfo& info = info_of(kind);
  const std::string word(info.word);
  if (info.angle) return {word + "_deg", word + "_rad"};
  if (kind == ParameterKind::weight) return {word, std::string(kLocked)};
  return {word};
}

Result<Assignment> split(const ParameterList& list, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view whole = text.substr(0, equals);
  const std::size_t dot = whole.rfind('.');
  const bool posture = list.has_posture();
  if (equals == text.npos || (dot == text.npos && !posture)) {
    std::vector<std::string> members;
    for (const ParameterInfo& info : list.all) {
      if (info.of_posture()) continue;
      const std::string member = members_of(info.kind)[0];
      note(members, fmt::format("NAME.{}=NUMBER", member));
      if (info.kind == ParameterKind::weight) note(members, "NAME.locked=true|false");
    }
    const std::string forms = fmt::format("{}", fmt::join(members, ", "));
    return fail(ErrorCode::invalid_argument,
                posture ? say("no_assignment_posture", text.substr(0, 80), forms)
                        : say("no_assignment", text.substr(0, 80), forms));
  }
  const std::string_view value = text.substr(equals + 1);
  if (dot == text.npos) return Assignment{whole, whole, {}, value};
  return Assignment{whole, whole.substr(0, dot), whole.substr(dot + 1), value};
}

// The number for a parameter; infinity, which no range allows, for text that is no number.
Result<double> number_of(const Assignment& asked, const ParameterInfo& info) {
  const bool in_degrees = info_of(info.kind).angle && asked.whole.ends_with("_deg");
  const double unit = in_degrees ? radians(1.0) : 1.0;
  const double value =
      parse_number(asked.value).value_or(std::numeric_limits<double>::infinity()) * unit;
  if (!(value >= info.low && value <= info.high)) {
    return fail(ErrorCode::invalid_argument,
                say("assignment_range", asked.member.empty() ? asked.whole : asked.member,
                    asked.value, info.low / unit, info.high / unit));
  }
  return value;
}

// Sets the number or the lock of the parameter with this index.
Result<void> set(const Assignment& asked, const ParameterInfo& info, std::size_t index,
                 Parameters& values) {
  if (asked.member != kLocked) {
    SHG_TRY_ASSIGN(values.values[index], number_of(asked, info));
    values.locked[index] = false;
    values.posed = values.posed || info.of_posture();
    return {};
  }
  if (asked.value != "true" && asked.value != "false") {
    return fail(ErrorCode::invalid_argument, say("locked_is", asked.value));
  }
  values.locked[index] = asked.value == "true";
  return {};
}

Result<void> no_such_parameter(std::span<const ParameterInfo> all, const Assignment& asked) {
  const bool posture = asked.member.empty();
  std::string_view of = posture ? "posture parameter" : "";
  std::vector<std::string> members;
  std::vector<std::string> names;
  for (const ParameterInfo& info : all) {
    if (info.of_posture() != posture) continue;
    const std::vector<std::string> own = members_of(info.kind);
    for (const std::string& member : own) note(members, member);
    if (posture) {
      for (const std::string_view unit : {"_deg", "_rad"}) note(names, info.spelled(unit));
    } else if (std::find(own.begin(), own.end(), asked.member) != own.end()) {
      of = info_of(info.kind).of;
      for (std::string& name : names_of(info)) note(names, std::move(name));
    }
  }
  if (of.empty()) {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", asked.member, members));
  }
  const Message unknown = unknown_name(of, posture ? asked.whole : asked.name, names);
  return fail(ErrorCode::not_found,
              posture ? say("no_weight_assignment", asked.whole, unknown) : unknown);
}

// Whether an assignment refers to the parameter.
bool is_meant(const Assignment& asked, const ParameterInfo& info) {
  if (info.of_posture()) {
    return asked.whole == info.spelled("_deg") || asked.whole == info.spelled("_rad");
  }
  const std::vector<std::string> members = members_of(info.kind);
  const std::vector<std::string> names = names_of(info);
  return std::find(members.begin(), members.end(), asked.member) != members.end() &&
         std::find(names.begin(), names.end(), asked.name) != names.end();
}

}  // namespace

Result<void> fix_parameter(const ParameterList& list, std::string_view assignment,
                           FixedParameters& fixed) {
  SHG_TRY_ASSIGN(const Assignment asked, split(list, assignment));
  FixedParameters changed = fixed;
  changed.set.resize(list.size());
  bool known = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_meant(asked, list.all[i])) continue;
    SHG_TRY(set(asked, list.all[i], i, changed.values));
    known = changed.set[i] = true;
  }
  if (!known) return no_such_parameter(list.all, asked);
  fixed = std::move(changed);
  return {};
}

Result<void> assign_parameter(const ParameterList& list, std::string_view assignment,
                              Parameters& values) {
  FixedParameters fixed{values, {}};
  SHG_TRY(fix_parameter(list, assignment, fixed));
  values = std::move(fixed.values);
  return {};
}

}  // namespace shigusa
