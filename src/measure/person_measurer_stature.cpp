// SPDX-License-Identifier: MIT
#include "core/index.hpp"
#include "person_measurer.hpp"
#include "rig/trunk_and_legs.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;
using F = StatureFractions;

// Least distance from the head's joint to the vertex, as a share of the stature.
constexpr double kLeastSkull = 0.05;

}  // namespace

// Length along the bones between two nodes with positions `at` (nodes).
double PersonMeasurer::length_along_bones(int a, int b, const std::vector<Vec3d>& at) const {
  const int meet = tree_.common_ancestor(a, b);
  double length = 0.0;
  for (int end : {a, b}) {
    for (; end != meet; end = tree_.node(end).parent) {
      length += norm(at[index(end)] - at[index(tree_.node(end).parent)]);
    }
  }
  return length;
}

// Length from mid-hip to the neck in a posture `at` (nodes).
double PersonMeasurer::trunk_length(double leg_length, const std::vector<Vec3d>& at) const {
  const auto mid = [&](Bone a, Bone b) { return (at[index(map_[a])] + at[index(map_[b])]) * 0.5; };
  const Vec3d hip = mid(Bone::left_upper_leg, Bone::right_upper_leg);
  const Vec3d& hips = at[index(map_[Bone::hips])];
  const int chest = tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
  const Vec3d neck =
      neck_ >= 0 ? at[index(neck_)] : mid(Bone::left_upper_arm, Bone::right_upper_arm);
  const int last = neck_ >= 0 ? neck_ : chest;
  const double to_hips = norm(hips - hip);
  // hips far from the hip joints are a root on the floor, and hips below them would be counted
  // twice: then the straight distance
  constexpr double kClearly = 0.05;
  const Vec3d trunk = neck - hip;
  const bool low_hips = dot(hip - hips, trunk) > kClearly * dot(trunk, trunk);
  if (last < 0 || tree_.common_ancestor(map_[Bone::hips], last) < 0 || to_hips > 0.5 * leg_length ||
      low_hips) {
    return norm(trunk);
  }
  return to_hips + length_along_bones(map_[Bone::hips], last, at) + norm(neck - at[index(last)]);
}

// Ratio of the trunk's length along its bones to the straight distance, for a person who stands at
// rest: a zigzag of bones is too long in every posture.
double PersonMeasurer::winding(double leg_length) const {
  constexpr double kStraight = 1.03;
  if (neck_ < 0 || TrunkAndLegs::at_rest(skeleton_, map_).common_axis() == Vec3d{}) return 1.0;
  const std::vector<Vec3d> rest = rest_origins(skeleton_);
  const Vec3d hip =
      (rest[index(map_[Bone::left_upper_leg])] + rest[index(map_[Bone::right_upper_leg])]) * 0.5;
  const double ratio = trunk_length(leg_length, rest) / norm(rest[index(neck_)] - hip);
  return ratio > kStraight ? ratio : 1.0;
}

// Whether the person stands upright on straight legs, so that stature is the height of the vertex.
bool PersonMeasurer::stands_straight() const {
  constexpr double kUpright = 0.97;  // cosine of 14°
  constexpr double kStraight = 0.98;
  const Vec3d trunk = tree_.at(neck_ >= 0 ? neck_ : head_) - mid_hip_;
  bool straight = dot(trunk, up_) > kUpright * norm(trunk);
  for (const Side side : kBothSides) {
    const Landmarks::Leg& l = result_.landmarks.leg(side);
    const double along = norm(l.hip - l.knee) + norm(l.knee - l.ankle);
    straight = straight && dot(l.hip - l.ankle, up_) > kUpright * along * kStraight;
  }
  return straight;
}

// Stature of a person who stands straight, from soles to vertex of the mesh; along the bones if
// both nearly agree.
double PersonMeasurer::measure_stature() {
  constexpr double kSame = 0.014;
  const double along = stature_along_bones();
  const bool soles = leg(Side::left).sole && leg(Side::right).sole;
  if (!soles || !skull_ || !stands_straight()) return along;
  const double floor =
      min(dot((*leg(Side::left).sole)[0], up_), dot((*leg(Side::right).sole)[0], up_));
  const double upright = dot(tree_.at(head_) + *skull_, up_) - floor;
  return wound_ || abs(upright - along) > kSame * upright ? upright : along;
}

double PersonMeasurer::stature_along_bones() {
  double feet = 0.0;  // mean height of the ankles over their soles
  for (const Side side : kBothSides) {
    legs_ += 0.5 * (norm(leg(side).hip - leg(side).knee) + norm(leg(side).knee - leg(side).ankle));
    if (leg(side).sole) feet += 0.5 * dot(leg(side).ankle - (*leg(side).sole)[0], up_);
  }
  const bool soles = leg(Side::left).sole && leg(Side::right).sole && feet > 0.0;
  std::vector<Vec3d> at;
  for (int i = 0; i < tree_.size(); ++i) at.push_back(tree_.at(i));
  const double wound = winding(legs_);
  wound_ = wound > 1.0;
  const double below_neck = legs_ + trunk_length(legs_, at) / wound + (soles ? feet : 0.0);
  const double ankles = soles ? 0.0 : F::kAnkleHeight;  // share of the stature below them
  if (head_ >= 0) {
    head_length_ =
        neck_ >= 0 ? length_along_bones(neck_, head_, at) : norm(tree_.at(head_) - mid_shoulder_);
  }
  if (head_tip_ >= 0) {
    head_length_ = head_ >= 0 ? head_length_ + norm(tree_.at(head_tip_) - tree_.at(head_))
                              : length_along_bones(neck_, head_tip_, at);
    return (below_neck + head_length_) / (1.0 - ankles);
  }
  skull_ = head_ >= 0 ? skull_by_mesh() : std::nullopt;
  if (skull_) {
    head_length_ += norm(*skull_);
    return (below_neck + head_length_) / (1.0 - ankles);
  }
  const double stature = below_neck / (1.0 - ankles - F::kHeadLength);
  if (head_length_ + kLeastSkull * stature <= F::kHeadLength * stature) {
    head_length_ = F::kHeadLength * stature;
    return stature;
  }
  const double tall = (below_neck + head_length_) / (1.0 - ankles - kLeastSkull);
  head_length_ += kLeastSkull * tall;
  return tall;
}

}  // namespace shigusa
