// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/document/result_file.hpp>
#include <shigusa/layers/layer.hpp>
#include <shigusa/layers/layered_parameters.hpp>
#include <utility>

namespace shigusa {
namespace {

// Infinity, which no range allows, where the text is no number.
double number_in(std::string_view text) {
  return parse_number(text).value_or(std::numeric_limits<double>::infinity());
}

Result<double> parse_weight(std::string_view text) {
  const double value = number_in(text);
  if (value >= kWeightMin && value <= kWeightMax) return value;
  return fail(ErrorCode::invalid_argument,
              fmt::format("weight is '{}'; allowed are numbers from {:g} to {:g}", text, kWeightMin,
                          kWeightMax));
}

// The values, of one phase or two, with room to note what is set of them.
void set_values(const BodyModel& body, Parameters values, FixedParameters& fixed) {
  fixed.values = std::move(values);
  Parameters counted = fixed.values;
  fixed.posture.resize(posture_members(body, counted).size());
  fixed.later_joints.resize(counted.later ? counted.joints.size() : 0);
}

// An angle is NAME_deg or NAME_rad.
Result<void> assign_posture(const BodyModel& body, std::string_view name, std::string_view text,
                            FixedParameters& fixed) {
  Parameters changed = fixed.values;
  const std::size_t of_first = posture_members(body, changed.posture).size();
  add_later_phase(changed);
  const bool later = name.starts_with(kLaterPrefix);
  std::vector<std::string> names;  // that are suggested
  const std::vector<PostureMember> members = posture_members(body, changed);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const PostureMember& member = members[m];
    for (const char* suffix : {"_deg", "_rad", ""}) {
      if (member.angle == std::string_view(suffix).empty()) continue;
      const std::string known = member.name + suffix;
      if (known.starts_with(kLaterPrefix) == later) names.push_back(known);
      if (known != name) continue;
      const double unit = std::string_view(suffix) == "_deg" ? radians(1.0) : 1.0;
      const double value = number_in(text) * unit;
      if (!(value >= member.low && value <= member.high)) {
        return fail(ErrorCode::invalid_argument,
                    fmt::format("{} is '{}'; allowed are numbers from {:.4g} to {:.4g}", name, text,
                                member.low / unit, member.high / unit));
      }
      *member.value = value;
      if (!fixed.values.later && m < of_first) changed.later.reset();
      set_values(body, std::move(changed), fixed);
      fixed.posture[m] = true;
      return {};
    }
  }
  return fail(ErrorCode::not_found,
              fmt::format("'{}' is not NAME.weight=NUMBER or NAME.locked=true|false, nor of the "
                          "posture: {}",
                          name, unknown_name("posture parameter", name, names)));
}

// "right_hip.flexion" of "right_hip.flexion.weight=3", with what follows.
struct Assignment {
  std::string_view name;
  std::string_view member;  // "weight", "locked", "contraction"
  std::string_view value;
};

// "squat_deg", "later.squat_deg", "switch"; not "right_hip.weight".
bool of_posture(std::string_view name) {
  return name_within_phase(name).find('.') == std::string_view::npos;
}

// Weight or lock of one freedom.
Result<void> assign_joint(const Assignment& assignment, JointWeight& joint) {
  if (assignment.member == "weight") {
    const Result<double> weight = parse_weight(assignment.value);
    if (!weight) return tl::unexpected(weight.error());
    joint = {*weight, false};
    return {};
  }
  if (assignment.value != "true" && assignment.value != "false") {
    return fail(ErrorCode::invalid_argument,
                fmt::format("locked is '{}'; allowed are true and false", assignment.value));
  }
  joint.locked = assignment.value == "true";
  return {};
}

// Those of one phase that go by the name.
Result<void> assign_joints(const BodyModel& body, const Assignment& asked, FixedParameters& fixed) {
  const bool later = asked.name.starts_with(kLaterPrefix);
  const std::string prefix(later ? kLaterPrefix : "");
  FixedParameters changed = fixed;
  if (later) {
    add_later_phase(changed.values);
    set_values(body, changed.values, changed);
  }
  std::vector<JointWeight>& joints = later ? changed.values.later->joints : changed.values.joints;
  std::vector<std::string> names;
  bool found = false;
  for (std::size_t d = 0; d < body.dofs().size(); ++d) {
    const std::string name = prefix + body.dofs()[d].name;
    const std::string joint = prefix + body.dofs()[d].joint;
    names.push_back(name);
    if (std::find(names.begin(), names.end(), joint) == names.end()) names.push_back(joint);
    if (name != asked.name && joint != asked.name) continue;
    found = true;
    (later ? changed.later_joints : changed.joints)[d] = true;
    if (const auto ok = assign_joint(asked, joints[d]); !ok) return ok;
  }
  if (!found) return fail(ErrorCode::not_found, unknown_name("joint", asked.name, names));
  fixed = std::move(changed);
  return {};
}

Result<void> assign_contraction(const Assignment& assignment, const LayeredMember& member) {
  const double value = number_in(assignment.value);
  if (!(value >= 0.0 && value <= kLayerGeneMax)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("contraction is '{}'; allowed are numbers from 0 to {}",
                            assignment.value, kLayerGeneMax));
  }
  for (double* limb : member.contraction) *limb = value;
  return {};
}

Result<void> assign_angle(const Assignment& assignment, const LayeredMember& member) {
  const double unit = assignment.member.ends_with("_deg") ? radians(1.0) : 1.0;
  const double value = number_in(assignment.value) * unit;
  if (!(value >= member.low && value <= member.high)) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("{} is '{}'; allowed are numbers from {:.4g} to {:.4g}", assignment.member,
                    assignment.value, member.low / unit, member.high / unit));
  }
  *member.angle = value;
  return {};
}

// What an assignment may be to: "weight" of "right_hip.weight=3", with what has such members.
struct LayeredKind {
  std::string_view member;
  LayerGeneKind kind;
  const char* of;
};
constexpr std::array<LayeredKind, 7> kLayeredKinds{{
    {"weight", LayerGeneKind::weight, "joint"},
    {"locked", LayerGeneKind::weight, "joint"},
    {"contraction", LayerGeneKind::contraction, "limb"},
    {"swivel_deg", LayerGeneKind::swivel, "arm"},
    {"swivel_rad", LayerGeneKind::swivel, "arm"},
    {"final_deg", LayerGeneKind::final_angle, "joint"},
    {"final_rad", LayerGeneKind::final_angle, "joint"},
}};

// The names that a member may be called by: its own and, of a freedom, its joint's.
std::vector<std::string> names_of(const LayeredMember& member) {
  switch (member.kind) {
    case LayerGeneKind::contraction:
      return {member.name};
    case LayerGeneKind::swivel:
      return {member.layer};
    case LayerGeneKind::final_angle:
      return {member.name, member.name.substr(0, member.name.rfind('.'))};
    case LayerGeneKind::weight:
      break;
  }
  const std::string whole = member.layer.empty() ? member.name : member.layer + "." + member.name;
  return {whole, whole.substr(0, whole.rfind('.'))};
}

Result<void> assign_member(const Assignment& assignment, const LayeredMember& member) {
  if (member.joint != nullptr) return assign_joint(assignment, *member.joint);
  if (member.angle != nullptr) return assign_angle(assignment, member);
  return assign_contraction(assignment, member);
}

}  // namespace

Result<void> fix_parameter(const BodyModel& body, std::string_view assignment,
                           FixedParameters& fixed) {
  const std::size_t equals = assignment.find('=');
  if (equals == assignment.npos) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not NAME.weight=NUMBER, NAME.locked=true|false or, of the "
                            "posture, NAME=NUMBER",
                            assignment.substr(0, 80)));
  }
  const std::string_view whole = assignment.substr(0, equals);
  const std::string_view value = assignment.substr(equals + 1);
  if (of_posture(whole)) return assign_posture(body, whole, value, fixed);
  const std::size_t dot = whole.rfind('.');
  const Assignment asked{whole.substr(0, dot), whole.substr(dot + 1), value};
  const std::vector<std::string> members{"weight", "locked"};
  if (asked.member != "weight" && asked.member != "locked") {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", asked.member, members));
  }
  return assign_joints(body, asked, fixed);
}

Result<void> assign_parameter(const BodyModel& body, std::string_view assignment,
                              Parameters& parameters) {
  FixedParameters fixed = no_fixed_parameters(body);
  fixed.values = parameters;
  const Result<void> done = fix_parameter(body, assignment, fixed);
  if (done) parameters = fixed.values;
  return done;
}

Result<void> assign_parameter(std::span<const Layer> layers, std::string_view assignment,
                              LayeredParameters& parameters) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.substr(0, equals).rfind('.');
  LayeredParameters changed = parameters;
  const std::vector<LayeredMember> all = layered_members(layers, changed);
  const auto there = [&all](const LayeredKind& known) {
    return std::any_of(all.begin(), all.end(),
                       [&known](const LayeredMember& member) { return member.kind == known.kind; });
  };
  if (equals == assignment.npos || dot == assignment.npos) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not NAME.weight=NUMBER, NAME.locked=true|false or "
                            "NAME.contraction=NUMBER{}",
                            assignment.substr(0, 80),
                            there(kLayeredKinds[3]) ? ", NAME.swivel_deg or NAME.final_deg" : ""));
  }
  const Assignment asked{assignment.substr(0, dot), assignment.substr(dot + 1, equals - dot - 1),
                         assignment.substr(equals + 1)};
  const LayeredKind* kind = nullptr;
  std::vector<std::string> members;
  for (const LayeredKind& known : kLayeredKinds) {
    if (!there(known)) continue;
    members.emplace_back(known.member);
    if (known.member == asked.member) kind = &known;
  }
  if (kind == nullptr) {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", asked.member, members));
  }
  std::vector<std::string> names;
  bool found = false;
  for (const LayeredMember& member : all) {
    if (member.kind != kind->kind) continue;
    bool meant = false;
    for (const std::string& name : names_of(member)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      meant = meant || asked.name == name;
    }
    if (!meant) continue;
    found = true;
    if (const Result<void> ok = assign_member(asked, member); !ok) return ok;
  }
  if (!found) return fail(ErrorCode::not_found, unknown_name(kind->of, asked.name, names));
  parameters = std::move(changed);
  return {};
}

}  // namespace shigusa
