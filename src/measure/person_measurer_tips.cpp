// SPDX-License-Identifier: MIT
#include <shigusa/human.hpp>

#include "core/say.hpp"
#include "person_measurer.hpp"
#include "rig/facing.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;
using F = StatureFractions;

using OfFoot = Sentence<std::string, std::string_view>;

// Distance from the ankle joint to the tip of the toes, along the floor.
constexpr double kToeAhead = (1.0 - kHeelShare) * F::kFootLength;

}  // namespace

// Tip of a foot; its ankle if there is none, or if the tip points backwards without the name of
// toes, as a heel does.
int PersonMeasurer::toe_node(Side side) const {
  constexpr double kBackwards = -0.5;  // cosine of 120°
  const auto [hip, knee, ankle] = leg_bones(side);
  const int tip = foot_tip(tree_, map_[knee], map_[ankle]);
  for (int i = tip; i != map_[ankle]; i = tree_.node(i).parent) {
    if (part(i) == BonePart::toes) return tip;
  }
  const double hand = dot(ahead_, cross(left_, up_));  // -1 of mirrored files
  const Vec3d ahead = normalized(cross(left_, at(knee) - at(ankle)), {}) * hand;
  return dot(normalized(tree_.at(tip) - at(ankle), {}), ahead) < kBackwards ? map_[ankle] : tip;
}

// Reads the tips that the file has; a limb without one ends at its last joint.
void PersonMeasurer::read_tips() {
  const auto is_thumb = [&](int i) { return part(i) == BonePart::thumb; };
  for (const Side side : kBothSides) {
    leg(side).toe = tree_.at(toe_node(side));
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

// Reads the further joints of the extent human, as far as the file has them.
void PersonMeasurer::read_further_joints() {
  for (const Bone bone : {Bone::spine, Bone::chest, Bone::upper_chest}) {
    if (map_[bone] >= 0) body().spine.push_back(at(bone));
  }
  if (neck_ >= 0 && head_ >= 0 && tree_.apart(neck_, head_)) body().head = tree_.at(head_);
  if (map_[Bone::left_shoulder] >= 0) arm(Side::left).clavicle = at(Bone::left_shoulder);
  if (map_[Bone::right_shoulder] >= 0) arm(Side::right).clavicle = at(Bone::right_shoulder);
}

void PersonMeasurer::place_missing_tips() {
  for (const Side side : kBothSides) {
    Landmarks::Leg& l = leg(side);
    if (l.toe == l.ankle) {
      const Vec3d shank = normalized(l.knee - l.ankle);
      const Vec3d turned = cross(left_, shank) * (dot(ahead_, cross(left_, up_)));
      l.toe = l.ankle + normalized(turned, ahead_) * (kToeAhead * stature_) -
              shank * (F::kAnkleHeight * stature_);
      const int foot = map_[leg_bones(side)[2]];
      const bool heel = tree_.farthest(foot) != foot;
      doubt(heel ? OfFoot("foot_guessed_at_heel") : OfFoot("foot_guessed"), tree_.described(foot),
            side_word(side));
    }
    widen_peg(side);
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

// Finds the grips. A goal's effector is a node of the file, so that other programs find it there.
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
