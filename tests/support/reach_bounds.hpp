// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "support/bodies.hpp"

// Distance to a goal that remains by geometry alone, without joint limits.
namespace shigusa::testing_support {

inline constexpr Vec3d kMiddleOfTheBody{-0.08, 1.0, 0.0};

// Length of the stretched chain from a link's origin back to an earlier dof's.
inline double chain_length(const BodyModel& body, int link, int back_to) {
  double length = 0.0;
  for (int d = link; d != back_to; d = body.dof(d).parent) length += norm(body.dof(d).offset);
  return length;
}

// Exact for the half body: its ankle and knee carry the hip anywhere in a disc in the leg's plane,
// as shank and thigh are equally long to 2 mm, and from the hip, trunk and arm reach anywhere in a
// ball, as the arm is longer than the trunk's line from hip to shoulder.
inline double half_body_distance(const BodyModel& body, const Vec3d& goal) {
  const Effector& hand = body.effectors()[0];
  const int hip = body.find_dof("right_hip.rotation").value();
  const double leg = chain_length(body, hip, 0);
  const double rest = chain_length(body, hand.link, hip) + norm(hand.point);
  // in the standing foot's frame the leg's plane is x = const.
  const Vec3d at = transpose_times(body.base().rotation, goal - body.base().translation);
  const double in_plane = std::fmax(0.0, std::hypot(at.y, at.z) - leg);
  const double across = at.x - body.dof(1).offset.x - body.dof(hip).offset.x;
  return std::fmax(0.0, std::hypot(across, in_plane) - rest);
}

// Point where a ray from the middle of the body leaves the half body's reach.
inline Vec3d half_body_edge(const BodyModel& body, const Vec3d& direction) {
  double inside = 0.0;
  double outside = 4.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (inside + outside);
    const bool in = half_body_distance(body, kMiddleOfTheBody + direction * middle) == 0.0;
    (in ? inside : outside) = middle;
  }
  return kMiddleOfTheBody + direction * inside;
}

// A lower bound for the right hand of any body: the distance left when the whole chain from either
// standing foot is stretched.
inline double stretched_distance(const PosedBody& posed, const Vec3d& goal) {
  const BodyModel& body = posed.body;
  const Effector& hand =
      body.effectors()[static_cast<std::size_t>(body.find_effector("right_hand").value())];
  const Kinematics<double> start = placed(body, posed.home.angles);
  const double from_base = chain_length(body, hand.link, 0) + norm(hand.point);
  double bound = norm(goal - start.origin[0]) - from_base;
  if (body.feet().size() == 2) {
    // up the other leg to the trunk's link, across the trunk, and down the arm
    const int ankle = body.feet()[1].link;
    const int other_hip = body.find_dof("left_hip.flexion").value();
    const int shoulder = hand.limb_root;
    const double across = norm(body.dof(other_hip).offset - body.dof(shoulder).offset);
    const double from_other = chain_length(body, ankle, other_hip) + across +
                              chain_length(body, hand.link, shoulder) + norm(hand.point);
    bound = std::fmax(bound, norm(goal - start.link_origin(ankle)) - from_other);
  }
  return std::fmax(0.0, bound);
}

}  // namespace shigusa::testing_support
