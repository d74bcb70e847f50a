// SPDX-License-Identifier: MIT
#include "criteria/posture_points.hpp"

#include <algorithm>

namespace shigusa {
namespace {

const BodyNode* find_node(const BodyModel& body, std::string_view name) {
  for (const BodyNode& node : body.nodes()) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

}  // namespace

PosturePoints posture_points(const BodyModel& body) {
  PosturePoints points;
  const Kinematics<double> start = start_kinematics(body);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string prefix = side == 0 ? "left_" : "right_";
    const BodyNode* hip = find_node(body, prefix + "upper_leg");
    const BodyNode* shoulder = find_node(body, prefix + "upper_arm");
    const BodyNode* ankle = find_node(body, prefix + "foot");
    if (hip == nullptr || shoulder == nullptr || ankle == nullptr) return {};
    points.hips[side] = {hip->link, hip->point};
    points.shoulders[side] = {shoulder->link, shoulder->point};
    points.standing += start.point(ankle->link, ankle->point) * 0.5;
  }
  points.found = true;
  return points;
}

std::vector<GoalHand> goal_hands(const BodyModel& body, const std::vector<int>& effectors) {
  std::vector<GoalHand> hands;
  for (int e = 0; e < static_cast<int>(body.effectors().size()); ++e) {
    const Effector& hand = body.effector(e);
    const bool wanted =
        effectors.empty() || std::find(effectors.begin(), effectors.end(), e) != effectors.end();
    if (!wanted || hand.part.limb != LimbKind::arm || hand.limb_root < 0) continue;
    double arm = norm(hand.point);
    int d = hand.link;
    while (d != kBaseLink && d != hand.limb_root) {
      arm += norm(body.dof(d).offset);
      d = body.dof(d).parent;
    }
    hands.push_back({{hand.link, hand.point}, {hand.limb_root, {}}, arm});
  }
  return hands;
}

}  // namespace shigusa
