// SPDX-License-Identifier: MIT
#include "criteria/posture_points.hpp"

#include <algorithm>
#include <shigusa/motion.hpp>

#include "dynamics/centre_of_mass.hpp"

namespace shigusa {
namespace {

// Sets the home positions of a body upright over its feet.
void find_home(const BodyModel& body, const Kinematics<double>& start, PosturePoints& points) {
  const Vec3d left = points.shoulders[0].in(start);
  const Vec3d right = points.shoulders[1].in(start);
  points.hand_hangs = points.ankles.y + kHandHangs * body.stature();
  points.home_shoulders = {left, right};
  points.home_mass = centre_of_mass(body, start);
  if (body.dofs_of(JointKind::knee, FreedomKind::flexion).empty()) return;
  const double trunk = norm((left + right) * 0.5 - PosturePoints::middle(points.hips, start));
  const Vec3d ahead{0.0, 0.0, kStandsAhead * body.stature()};
  points.home_mass = points.ankles + ahead;
  const Vec3d middle = points.home_mass + Vec3d{0.0, points.leg + trunk, 0.0};
  const Vec3d half{0.5 * norm(left - right), 0.0, 0.0};
  points.home_shoulders = {middle + half, middle - half};
}

}  // namespace

PosturePoints posture_points(const BodyModel& body, const State& state) {
  PosturePoints points;
  const Kinematics<double> start = placed(body, state);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto node = [&](HumanoidBone left, HumanoidBone right) {
      return body.find_node(humanoid_bone_name(side == 0 ? left : right));
    };
    using Bone = HumanoidBone;
    const BodyNode* hip = node(Bone::left_upper_leg, Bone::right_upper_leg);
    const BodyNode* knee = node(Bone::left_lower_leg, Bone::right_lower_leg);
    const BodyNode* ankle = node(Bone::left_foot, Bone::right_foot);
    const BodyNode* shoulder = node(Bone::left_upper_arm, Bone::right_upper_arm);
    if (hip == nullptr || knee == nullptr || ankle == nullptr || shoulder == nullptr) return {};
    points.hips[side] = {hip->link, hip->point};
    points.shoulders[side] = {shoulder->link, shoulder->point};
    const Vec3d knee_at = start.point(knee->link, knee->point);
    const Vec3d ankle_at = start.point(ankle->link, ankle->point);
    points.leg += 0.5 * (norm(points.hips[side].in(start)-knee_at) + norm(knee_at - ankle_at));
    points.ankles += ankle_at * 0.5;
  }
  find_home(body, start, points);
  points.found = true;
  return points;
}

std::vector<GoalHand> goal_hands(const BodyModel& body, const CriteriaContext& context) {
  const PosturePoints points = posture_points(body, context.start);
  const Kinematics<double> start = placed(body, context.start);
  const std::vector<int>& effectors = context.effectors;
  std::vector<GoalHand> hands;
  for (int e = 0; e < static_cast<int>(body.effectors().size()); ++e) {
    const Effector& hand = body.effector(e);
    const bool wanted = effectors.empty()
                            ? hand.part.joint_kind == JointKind::hand
                            : std::find(effectors.begin(), effectors.end(), e) != effectors.end();
    if (!wanted || hand.part.limb != LimbKind::arm || hand.limb_root < 0) continue;
    const LinkPoint shoulder{hand.limb_root, {}};
    const std::size_t side = hand.part.side == Side::left ? 0 : 1;
    hands.push_back({{hand.link, hand.point},
                     shoulder,
                     points.found ? points.home_shoulders[side] : shoulder.in(start),
                     body.limb_length(hand)});
  }
  return hands;
}

}  // namespace shigusa
