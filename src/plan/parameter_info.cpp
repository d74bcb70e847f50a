// SPDX-License-Identifier: MIT
#include "plan/parameter_info.hpp"

#include <utility>

#include "body/joint_name.hpp"

namespace shigusa {
namespace {

// "right_leg" of "right_knee.flexion", "legs", "trunk"
std::string limb_group(std::string_view name) {
  const JointPlace part = parse_joint_name(name);
  if (part.limb == LimbKind::trunk) return "trunk";
  if (!part.side) return part.limb == LimbKind::leg ? "legs" : "arms";
  const std::string side = part.side == Side::left ? "left_" : "right_";
  return side + (part.limb == LimbKind::leg ? "leg" : "arm");
}

std::string group_of(ParameterKind kind, std::string_view name) {
  const bool of_limb = !info_of(kind).word.empty() || parse_joint_name(name).side;
  if (of_limb) return limb_group(name);
  return kind == ParameterKind::timing ? "path" : "posture";
}

}  // namespace

ParameterInfo ParameterInfo::named(ParameterKind kind, std::string name,
                                   std::vector<int> applies_to) {
  const ParameterKindInfo& common = info_of(kind);
  ParameterInfo info{.name = std::move(name), .kind = kind, .applies_to = std::move(applies_to)};
  info.group = group_of(kind, info.name);
  info.sentence = common.sentence;
  return std::move(info).within(common.low, common.high);
}

ParameterInfo ParameterInfo::within(double least, double most) && {
  low = shown_low = least;
  high = shown_high = most;
  return std::move(*this);
}

}  // namespace shigusa
