// SPDX-License-Identifier: MIT
#include "criteria/head.hpp"

#include <shigusa/motion.hpp>

namespace shigusa {

HeadPoints head_points(const BodyModel& body, const State& start) {
  const BodyNode* head = body.find_node(humanoid_bone_name(HumanoidBone::head));
  const BodyNode* hips = body.find_node(humanoid_bone_name(HumanoidBone::hips));
  if (head == nullptr || hips == nullptr) return {};
  const Kinematics<double> kinematics = placed(body, start);
  const double distance =
      norm(kinematics.point(head->link, head->point) - kinematics.point(hips->link, hips->point));
  return {.head_link = head->link,
          .head = head->point,
          .pelvis_link = hips->link,
          .pelvis = hips->point,
          .distance = distance,
          .neck = body.find_dof(JointKind::neck, FreedomKind::flexion).has_value()};
}

}  // namespace shigusa
