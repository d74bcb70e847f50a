// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <shigusa/core/names.hpp>
#include <shigusa/project/result_file.hpp>
#include <utility>

namespace shigusa {
namespace {

// The whole text as a number; infinity where it is none, which no range allows.
double number_in(std::string_view text) {
  const std::string copy(text);
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  const bool whole = !copy.empty() && end == copy.c_str() + copy.size();
  return whole ? value : std::numeric_limits<double>::infinity();
}

Result<double> parse_weight(std::string_view text) {
  const double value = number_in(text);
  if (value >= kWeightMin && value <= kWeightMax) return value;
  return fail(ErrorCode::invalid_argument,
              fmt::format("weight is '{}'; allowed are numbers from {:g} to {:g}", text, kWeightMin,
                          kWeightMax));
}

// An angle is NAME_deg or NAME_rad.
Result<void> assign_posture(const BodyModel& body, std::string_view name, std::string_view text,
                            FixedParameters& fixed) {
  PostureParameters changed = fixed.values.posture;
  std::vector<std::string> names;
  const std::vector<PostureMember> members = posture_members(body, changed);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const PostureMember& member = members[m];
    for (const char* suffix : {"_deg", "_rad", ""}) {
      if (member.angle == std::string_view(suffix).empty()) continue;
      names.push_back(member.name + suffix);
      if (names.back() != name) continue;
      const double unit = std::string_view(suffix) == "_deg" ? radians(1.0) : 1.0;
      const double value = number_in(text) * unit;
      if (!(value >= member.low && value <= member.high)) {
        return fail(ErrorCode::invalid_argument,
                    fmt::format("{} is '{}'; allowed are numbers from {:.4g} to {:.4g}", name, text,
                                member.low / unit, member.high / unit));
      }
      *member.value = value;
      fixed.values.posture = changed;
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

}  // namespace

Result<void> fix_parameter(const BodyModel& body, std::string_view assignment,
                           FixedParameters& fixed) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.substr(0, equals).rfind('.');
  if (equals == assignment.npos) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not NAME.weight=NUMBER, NAME.locked=true|false or, of the "
                            "posture, NAME=NUMBER",
                            assignment.substr(0, 80)));
  }
  if (dot == assignment.npos) {
    return assign_posture(body, assignment.substr(0, equals), assignment.substr(equals + 1), fixed);
  }
  const std::string_view name = assignment.substr(0, dot);
  const std::string_view member = assignment.substr(dot + 1, equals - dot - 1);
  const std::string_view value = assignment.substr(equals + 1);
  const std::vector<std::string> members{"weight", "locked"};
  if (member != "weight" && member != "locked") {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", member, members));
  }
  std::vector<std::string> names;
  bool found = false;
  for (std::size_t d = 0; d < body.dofs().size(); ++d) {
    names.push_back(body.dofs()[d].name);
    const std::string& joint_name = body.dofs()[d].joint;
    if (std::find(names.begin(), names.end(), joint_name) == names.end()) {
      names.push_back(joint_name);
    }
    if (body.dofs()[d].name != name && body.dofs()[d].joint != name) continue;
    found = true;
    fixed.joints[d] = true;
    if (const auto ok = assign_joint({name, member, value}, fixed.values.joints[d]); !ok) return ok;
  }
  if (!found) return fail(ErrorCode::not_found, unknown_name("joint", name, names));
  return {};
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
  if (equals == assignment.npos || dot == assignment.npos) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not NAME.weight=NUMBER, NAME.locked=true|false or "
                            "NAME.contraction=NUMBER",
                            assignment.substr(0, 80)));
  }
  const Assignment asked{assignment.substr(0, dot), assignment.substr(dot + 1, equals - dot - 1),
                         assignment.substr(equals + 1)};
  const std::vector<std::string> kinds{"weight", "locked", "contraction"};
  if (std::find(kinds.begin(), kinds.end(), asked.member) == kinds.end()) {
    return fail(ErrorCode::invalid_argument, unknown_name("parameter", asked.member, kinds));
  }
  const bool contracts = asked.member == "contraction";
  std::vector<std::string> names;
  bool found = false;
  LayeredParameters changed = parameters;
  for (const LayeredMember& member : layered_members(layers, changed)) {
    if (contracts != (member.joint == nullptr)) continue;
    const std::string whole = member.layer.empty() ? member.name : member.layer + "." + member.name;
    const std::string joint = whole.substr(0, contracts ? whole.npos : whole.rfind('.'));
    for (const std::string& name : {whole, joint}) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    if (asked.name != whole && asked.name != joint) continue;
    found = true;
    const Result<void> ok =
        contracts ? assign_contraction(asked, member) : assign_joint(asked, *member.joint);
    if (!ok) return ok;
  }
  if (!found) {
    return fail(ErrorCode::not_found,
                unknown_name(contracts ? "limb" : "joint", asked.name, names));
  }
  parameters = std::move(changed);
  return {};
}

}  // namespace shigusa
