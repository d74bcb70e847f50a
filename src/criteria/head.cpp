// SPDX-License-Identifier: MIT
#include "criteria/head.hpp"

namespace shigusa {

HeadPoints head_points(const BodyModel& body) {
  const BodyNode* head = nullptr;
  const BodyNode* hips = nullptr;
  for (const BodyNode& node : body.nodes()) {
    if (node.name == "head") head = &node;
    if (node.name == "hips") hips = &node;
  }
  if (head == nullptr || hips == nullptr) return {};
  const Kinematics<double> kinematics = start_kinematics(body);
  const double distance =
      norm(kinematics.point(head->link, head->point) - kinematics.point(hips->link, hips->point));
  return {.head_link = head->link,
          .head = head->point,
          .pelvis_link = hips->link,
          .pelvis = hips->point,
          .distance = distance,
          .neck = body.find_dof("neck.flexion").has_value()};
}

}  // namespace shigusa
