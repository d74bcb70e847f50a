// SPDX-License-Identifier: MIT
#include <shigusa/human_body.hpp>

#include "core/say.hpp"
#include "person_measurer.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;
using F = StatureFractions;

// From the ankle joint to the tip of the toes, along the floor.
constexpr double kToeAhead = (1.0 - kHeelShare) * F::kFootLength;
// The vertex is at least this share of the stature beyond the head's joint.
constexpr double kLeastSkull = 0.05;

}  // namespace

// The tips that the file has; where it has none, the limb ends at its last joint.
void PersonMeasurer::read_tips() {
  const auto is_thumb = [&](int i) { return part(i) == BonePart::thumb; };
  for (const Side side : kBothSides) {
    leg(side).toe = tree_.at(tree_.farthest(map_[leg_bones(side)[2]]));
    arm(side).fingertip = tree_.at(tree_.farthest(map_[arm_bones(side)[2]], is_thumb));
  }
  neck_ = map_[Bone::neck];
  head_ = map_[Bone::head];
  body().neck = neck_ >= 0 ? tree_.at(neck_) : mid_shoulder_;
  read_further_joints();
  if (head_ < 0) {
    head_tip_ = neck_ >= 0 && tree_.farthest(neck_) != neck_ ? tree_.farthest(neck_) : -1;
    return;
  }
  for (const int child : tree_.children(head_)) {
    const bool tip = tree_.node(child).end_site || part(child) == BonePart::tip;
    if (tip && head_tip_ < 0 && tree_.apart(child, head_)) head_tip_ = child;
  }
}

// Those of the extent human, as far as the file has them.
void PersonMeasurer::read_further_joints() {
  for (const Bone bone : {Bone::spine, Bone::chest, Bone::upper_chest}) {
    if (map_[bone] >= 0) body().spine.push_back(at(bone));
  }
  if (neck_ >= 0 && head_ >= 0 && tree_.apart(neck_, head_)) body().head = tree_.at(head_);
  if (map_[Bone::left_shoulder] >= 0) arm(Side::left).clavicle = at(Bone::left_shoulder);
  if (map_[Bone::right_shoulder] >= 0) arm(Side::right).clavicle = at(Bone::right_shoulder);
}

double PersonMeasurer::length_along_bones(int a, int b) const {
  const int meet = tree_.common_ancestor(a, b);
  double length = 0.0;
  for (int end : {a, b}) {
    for (; end != meet; end = tree_.node(end).parent) {
      length += norm(tree_.at(end) - tree_.at(tree_.node(end).parent));
    }
  }
  return length;
}

// From between the hips to the neck.
double PersonMeasurer::trunk_length(double leg_length) const {
  const int hips = map_[Bone::hips];
  const int chest = tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
  const Vec3d neck = neck_ >= 0 ? tree_.at(neck_) : mid_shoulder_;
  const int last = neck_ >= 0 ? neck_ : chest;
  const double to_hips = norm(tree_.at(hips) - mid_hip_);
  // hips far from the hip joints are a root on the floor, and hips below them would count the way
  // up to them twice: the straight way then
  constexpr double kClearly = 0.05;
  const Vec3d trunk = neck - mid_hip_;
  const bool low_hips = dot(mid_hip_ - tree_.at(hips), trunk) > kClearly * dot(trunk, trunk);
  if (last < 0 || tree_.common_ancestor(hips, last) < 0 || to_hips > 0.5 * leg_length || low_hips) {
    return norm(neck - mid_hip_);
  }
  return to_hips + length_along_bones(hips, last) + norm(neck - tree_.at(last));
}

double PersonMeasurer::measure_stature() {
  double legs = 0.0;
  double feet = 0.0;  // heights of the ankles over their soles
  for (const Side side : kBothSides) {
    legs += 0.5 * (norm(leg(side).hip - leg(side).knee) + norm(leg(side).knee - leg(side).ankle));
    if (leg(side).sole) feet += 0.5 * dot(leg(side).ankle - (*leg(side).sole)[0], up_);
  }
  const bool soles = leg(Side::left).sole && leg(Side::right).sole && feet > 0.0;
  const double below_neck = legs + trunk_length(legs) + (soles ? feet : 0.0);
  const double ankles = soles ? 0.0 : F::kAnkleHeight;  // share of the stature below them
  if (head_ >= 0) {
    head_length_ =
        neck_ >= 0 ? length_along_bones(neck_, head_) : norm(tree_.at(head_) - mid_shoulder_);
  }
  if (head_tip_ >= 0) {
    head_length_ = head_ >= 0 ? head_length_ + norm(tree_.at(head_tip_) - tree_.at(head_))
                              : length_along_bones(neck_, head_tip_);
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

void PersonMeasurer::place_missing_tips() {
  for (const Side side : kBothSides) {
    Landmarks::Leg& l = leg(side);
    if (l.toe == l.ankle) {
      const Vec3d shank = normalized(l.knee - l.ankle);
      const Vec3d turned = cross(left_, shank) * (dot(ahead_, cross(left_, up_)));
      l.toe = l.ankle + normalized(turned, ahead_) * (kToeAhead * stature_) -
              shank * (F::kAnkleHeight * stature_);
      doubt("foot_guessed", tree_.described(map_[leg_bones(side)[2]]), side_word(side));
    }
    Landmarks::Arm& a = arm(side);
    if (a.fingertip == a.wrist) {
      a.fingertip = a.wrist + normalized(a.wrist - a.elbow) * (F::kHand * stature_);
      doubt("hand_guessed", tree_.described(map_[arm_bones(side)[2]]), side_word(side));
    }
  }
  if (head_tip_ >= 0) {
    body().head_top = tree_.at(head_tip_);
    return;
  }
  if (skull_) {
    body().head_top = tree_.at(head_) + *skull_;
    return;
  }
  const Vec3d trunk = normalized(body().neck - mid_hip_, up_);
  const Vec3d head = head_ >= 0 ? tree_.at(head_) - body().neck : Vec3d{};
  body().head_top = body().neck + normalized(head, trunk) * head_length_;
  doubt("head_guessed");
}

// A goal's effector is a node of the file, so that anybody finds it there.
void PersonMeasurer::find_grips() {
  for (const Side side : kBothSides) {
    Landmarks::Arm& a = arm(side);
    const Vec3d nominal = grip_of(a);
    const int hand = map_[arm_bones(side)[2]];
    int best = hand;
    std::vector<int> open{hand};
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      if (part(i) == BonePart::thumb || tree_.node(i).end_site) continue;
      if (norm(tree_.at(i) - nominal) < norm(tree_.at(best) - nominal)) best = i;
      open.insert(open.end(), tree_.children(i).rbegin(), tree_.children(i).rend());
    }
    a.grip = tree_.at(best);
    result_.grip_nodes[static_cast<std::size_t>(side)] = best;
  }
}

}  // namespace shigusa
