// SPDX-License-Identifier: MIT
#include "person_measurer.hpp"

#include <string>

#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "math/axes.hpp"
#include "rig/trunk_and_legs.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

std::string axis_name(const Vec3d& axis) {
  const double sum = axis.x + axis.y + axis.z;
  const char* letter = axis.x != 0.0 ? "x" : axis.y != 0.0 ? "y" : "z";
  return std::string(sum < 0.0 ? "-" : "+") + letter;
}

}  // namespace

PersonMeasurer::PersonMeasurer(const Skeleton& skeleton, const std::vector<Transformd>& world,
                               const HumanoidMap& map, std::span<const SkinVertex> skin)
    : skeleton_(skeleton), tree_(skeleton, world, skin), map_(map) {
  for (const Bone b : kHumanoidBones) {
    const int node = map[b];
    const bool optional = b == Bone::neck || b == Bone::head || b == Bone::left_toes ||
                          b == Bone::right_toes || b >= Bone::spine;
    SHG_CHECK((node >= 0 || optional) && node < tree_.size(),
              "a mapped node for " + std::string(humanoid_bone_name(b)));
  }
}

Result<MeasuredPerson> PersonMeasurer::measure(const MeasureSettings& settings) {
  SHG_TRY(read_limbs());
  up_ = find_up();
  SHG_TRY(find_left());
  read_tips();
  read_soles();
  stature_ = measure_stature();
  place_missing_tips();
  find_grips();
  SHG_TRY(find_unit(settings));
  move_to_world();
  if (settings.at_rest) find_trunk_lean();
  fit_parts();
  check_plausibility();
  return std::move(result_);
}

Result<void> PersonMeasurer::check_length(Side side, std::string_view segment, Bone a,
                                          Bone b) const {
  if (tree_.apart(map_[a], map_[b])) return {};
  return fail(ErrorCode::invalid_argument, say("no_length", side_word(side), segment,
                                               tree_.described(map_[a]), tree_.described(map_[b])));
}

Result<void> PersonMeasurer::read_limbs() {
  for (const Side side : kBothSides) {
    const auto [hip, knee, ankle] = leg_bones(side);
    const auto [shoulder, elbow, wrist] = arm_bones(side);
    SHG_TRY(check_length(side, "thigh", hip, knee));
    SHG_TRY(check_length(side, "shank", knee, ankle));
    SHG_TRY(check_length(side, "upper arm", shoulder, elbow));
    SHG_TRY(check_length(side, "forearm", elbow, wrist));
    leg(side) = {at(hip), at(knee), at(ankle), at(ankle)};
    arm(side) = {at(shoulder), at(elbow), at(wrist), at(wrist)};
  }
  mid_hip_ = mid_hip(body());
  mid_shoulder_ = mid_shoulder(body());
  return {};
}

Vec3d PersonMeasurer::find_up() {
  const Vec3d ankles = (body().left_leg.ankle + body().right_leg.ankle) * 0.5;
  const Vec3d posture = TrunkAndLegs{mid_shoulder_ - mid_hip_, mid_hip_ - ankles}.common_axis();
  const Vec3d rest = TrunkAndLegs::at_rest(skeleton_, map_).common_axis();
  const Vec3d none{};
  if (posture != none) {
    if (rest != none && rest != posture) {
      doubt("up_followed", axis_name(posture), axis_name(rest));
    }
    return posture;
  }
  const Vec3d rise = mid_shoulder_ - ankles;
  if (rest != none && dot(rest, rise) > 0.0) return rest;
  if (const Vec3d own = TrunkAndLegs{mid_shoulder_ - mid_hip_, mid_hip_ - ankles}.common_line();
      own != none) {
    doubt("no_upright");
    return own;
  }
  doubt("does_not_stand", axis_name(nearest_axis(rise)));
  return nearest_axis(rise);
}

Result<void> PersonMeasurer::find_left() {
  const Vec3d hips = body().left_leg.hip - body().right_leg.hip;
  const Vec3d shoulders = body().left_arm.shoulder - body().right_arm.shoulder;
  const Vec3d both = normalized(hips, {}) + normalized(shoulders, {});
  const Vec3d level = both - up_ * dot(both, up_);
  constexpr double kLeast = 0.2;
  if (norm(level) < kLeast) {
    return fail(ErrorCode::invalid_argument, say("no_facing", axis_name(up_)));
  }
  left_ = normalized(level);
  ahead_ = cross(left_, up_);
  if (map_.mirrored) {
    ahead_ = -ahead_;
    doubt("was_mirrored");
  }
  return {};
}

void PersonMeasurer::find_trunk_lean() {
  const Vec3d trunk = mid_shoulder(body()) - mid_hip(body());
  const double lean = atan2(-trunk.z, trunk.y);
  if (abs(lean) <= kTrunkLeanMost) body().trunk_lean = lean;
}

Vec3d Placement::to_world(const Vec3d& p) const {
  const Vec3d d = (p - origin) * unit;
  return {dot(d, left), dot(d, up), dot(d, ahead)};
}

Result<MeasuredPerson> measure_person(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world, const HumanoidMap& map,
                                      const MeasureSettings& settings) {
  return PersonMeasurer(skeleton, world, map, settings.skin).measure(settings);
}

}  // namespace shigusa
