// SPDX-License-Identifier: MIT
#include "plan/assignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <shigusa/words.hpp>
#include <utility>

#include "core/say.hpp"

namespace shigusa {
namespace {

constexpr std::string_view kLocked = "locked";

// An assignment in its parts: "right_hip.flexion", "weight", "3" of "right_hip.flexion.weight=3".
// A number of the posture has no member: "squat_deg", "", "30".
struct Assignment {
  std::string_view whole;  // what stands before the sign
  std::string_view name;
  std::string_view member;
  std::string_view value;
};

// Adds a name that is not there yet.
void note(std::vector<std::string>& names, std::string name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

// The names that a parameter goes by: its own and, of a freedom, its joint's.
std::vector<std::string> names_of(const Parameter& parameter) {
  std::vector<std::string> names{parameter.subject()};
  if (info_of(parameter.info->kind).of_freedom) {
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

bool of_posture(const Parameter& parameter) { return info_of(parameter.info->kind).word.empty(); }

Result<Assignment> split(std::span<const Parameter> all, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view whole = text.substr(0, equals);
  const std::size_t dot = whole.rfind('.');
  const bool posture = std::any_of(all.begin(), all.end(), of_posture);
  if (equals == text.npos || (dot == text.npos && !posture)) {
    std::vector<std::string> members;
    for (const Parameter& parameter : all) {
      if (of_posture(parameter)) continue;
      const std::string member = members_of(parameter.info->kind)[0];
      note(members, fmt::format("NAME.{}=NUMBER", member));
      if (parameter.locked != nullptr) note(members, "NAME.locked=true|false");
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

// A number of a parameter; infinity, which no range allows, where the text is none.
Result<void> set_number(const Assignment& asked, const Parameter& parameter) {
  const ParameterInfo& info = *parameter.info;
  const bool in_degrees = info_of(info.kind).angle && asked.whole.ends_with("_deg");
  const double unit = in_degrees ? radians(1.0) : 1.0;
  const double value =
      parse_number(asked.value).value_or(std::numeric_limits<double>::infinity()) * unit;
  if (!(value >= info.low && value <= info.high)) {
    return fail(ErrorCode::invalid_argument,
                say("assignment_range", asked.member.empty() ? asked.whole : asked.member,
                    asked.value, info.low / unit, info.high / unit));
  }
  parameter.set(value);
  if (parameter.locked != nullptr) *parameter.locked = false;
  return {};
}

Result<void> set_lock(const Assignment& asked, const Parameter& parameter) {
  if (asked.value != "true" && asked.value != "false") {
    return fail(ErrorCode::invalid_argument, say("locked_is", asked.value));
  }
  *parameter.locked = asked.value == "true";
  return {};
}

Result<void> no_such_posture(std::span<const Parameter> all, const Assignment& asked) {
  std::vector<std::string> names;
  for (const Parameter& parameter : all) {
    if (!of_posture(parameter)) continue;
    note(names, parameter.spelled("_deg"));
    note(names, parameter.spelled("_rad"));
  }
  return fail(ErrorCode::not_found, say("no_weight_assignment", asked.whole,
                                        unknown_name("posture parameter", asked.whole, names)));
}

Result<void> no_such_parameter(std::span<const Parameter> all, const Assignment& asked) {
  if (asked.member.empty()) return no_such_posture(all, asked);
  std::vector<std::string> members;
  std::vector<std::string> names;
  std::string_view of;
  for (const Parameter& parameter : all) {
    if (of_posture(parameter)) continue;
    const std::vector<std::string> own = members_of(parameter.info->kind);
    for (const std::string& member : own) note(members, member);
    if (std::find(own.begin(), own.end(), asked.member) == own.end()) continue;
    of = info_of(parameter.info->kind).of;
    for (std::string& name : names_of(parameter)) note(names, std::move(name));
  }
  if (of.empty()) {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", asked.member, members));
  }
  return fail(ErrorCode::not_found, unknown_name(of, asked.name, names));
}

// Whether an assignment means the parameter.
bool is_meant(const Assignment& asked, const Parameter& parameter) {
  if (of_posture(parameter)) {
    return asked.whole == parameter.spelled("_deg") || asked.whole == parameter.spelled("_rad");
  }
  const std::vector<std::string> members = members_of(parameter.info->kind);
  const std::vector<std::string> names = names_of(parameter);
  return std::find(members.begin(), members.end(), asked.member) != members.end() &&
         std::find(names.begin(), names.end(), asked.name) != names.end();
}

// Sets what an assignment means; the indices of it in `all`.
Result<std::vector<std::size_t>> set_meant(std::span<const Parameter> all, std::string_view text) {
  SHG_TRY_ASSIGN(const Assignment asked, split(all, text));
  std::vector<std::size_t> meant;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_meant(asked, all[i])) continue;
    SHG_TRY(asked.member == kLocked ? set_lock(asked, all[i]) : set_number(asked, all[i]));
    meant.push_back(i);
  }
  if (!meant.empty()) return meant;
  return tl::unexpected(no_such_parameter(all, asked).error());
}

}  // namespace

Result<void> fix_parameter(std::span<const Layer> plan, std::string_view assignment,
                           FixedParameters& fixed) {
  // all that could be meant has a place in a copy …
  Parameters changed = fixed.values;
  give_posture(plan, changed);
  const std::vector<Parameter> all = parameters_of(plan, changed);
  SHG_TRY_ASSIGN(const std::vector<std::size_t> meant, set_meant(all, assignment));
  // … and a posture that was neither there nor meant is taken out again
  if (std::none_of(meant.begin(), meant.end(),
                   [&all](std::size_t i) { return of_posture(all[i]); })) {
    changed.posture = fixed.values.posture;
  }
  fixed.values = std::move(changed);
  fixed.set.resize(parameters_of(plan, fixed.values).size());
  for (const std::size_t i : meant) {
    if (i < fixed.set.size()) fixed.set[i] = true;
  }
  return {};
}

Result<void> assign_parameter(std::span<const Layer> plan, std::string_view assignment,
                              Parameters& values) {
  FixedParameters fixed{values, {}};
  SHG_TRY(fix_parameter(plan, assignment, fixed));
  values = std::move(fixed.values);
  return {};
}

}  // namespace shigusa
