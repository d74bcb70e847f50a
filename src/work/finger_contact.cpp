// SPDX-License-Identifier: MIT
#include "work/finger_contact.hpp"

#include <array>
#include <optional>

#include "core/index.hpp"
#include "kinematics/penetration.hpp"
#include "rig/finger_bones.hpp"

namespace shigusa {
namespace {

// Shares of the phalanges in the middle finger's length, from the knuckle (B. Buchholz,
// T. Armstrong and S. Goldstein, Ergonomics 35 (1992) 261-273: 0.266, 0.170 and 0.108 hands).
constexpr std::array<double, kFingerJoints> kPhalanges{0.489, 0.312, 0.199};
// Half the thickness (m) of a finger.
constexpr double kFingerRadius = 0.008;
// Flexion of a fist, relative to that of a relaxed hand, and steps up to it.
constexpr double kFist = 2.0;
constexpr int kSteps = 100;
// Points of each phalanx that are compared with the thing.
constexpr int kPoints = 8;

// Length (m) of a hand's fingers, from its point to their tips.
std::optional<double> finger_length(const BodyModel& body, const Effector& hand) {
  std::optional<double> longest;
  for (const BodyNode& node : body.nodes()) {
    if (!node.end_site || node.link != hand.link) continue;
    longest = max(longest.value_or(0.0), norm(node.point - hand.point));
  }
  return longest;
}

}  // namespace

double flexion_about(const BodyModel& body, const Grip& grip, const Thing& thing) {
  const Effector& hand = body.effector(grip.hand);
  const std::optional<double> length = finger_length(body, hand);
  if (!length) return 1.0;
  const std::vector<PlacedBox> boxes = placed_boxes(obstacles_of(thing, grip.in_hand));
  // axes of a hand's frame, see GoalAxis
  const Vec3d ahead{0, -1, 0};
  const Vec3d palm{hand.part.side == Side::left ? -1.0 : 1.0, 0, 0};
  const auto touches = [&](double share) {
    Vec3d joint = hand.point;
    double bent = 0.0;
    for (int k = 0; k < kFingerJoints; ++k) {
      bent += share * flexion(HandPosture::relaxed, Finger::middle, k + 1);
      const SinCos<double> turn = sin_cos(bent);
      const Vec3d bone = (ahead * turn.cos + palm * turn.sin) * (*length * kPhalanges[index(k)]);
      for (int p = 1; p <= kPoints; ++p) {
        if (least_distance(boxes, joint + bone * (1.0 * p / kPoints)) < kFingerRadius) return true;
      }
      joint += bone;
    }
    return false;
  };
  int step = 0;
  while (step < kSteps && !touches(kFist * (step + 1) / kSteps)) ++step;
  return kFist * step / kSteps;
}

}  // namespace shigusa
