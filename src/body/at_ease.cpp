// SPDX-License-Identifier: MIT
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/at_ease.hpp>

#include "human_frames.hpp"

namespace shigusa {
namespace {

constexpr std::array kSides{Side::left, Side::right};

// A triangle of thigh and shank seen from the ankle.
struct LegLengths {
  double thigh;
  double shank;

  explicit LegLengths(const Landmarks::Leg& leg)
      : thigh(norm(leg.hip - leg.knee)), shank(norm(leg.knee - leg.ankle)) {}

  // From hip to ankle (m) when the knee is bent by kKneesAtEase.
  [[nodiscard]] double span() const {
    return sqrt(thigh * thigh + shank * shank + 2.0 * thigh * shank * sin_cos(kKneesAtEase).cos);
  }
};

// How far the hips come down for one leg (m, ≥ 0).
double drop_for(const Landmarks::Leg& leg) {
  const double span = LegLengths(leg).span();
  const Vec3d way = leg.hip - leg.ankle;
  const double across = way.x * way.x + way.z * way.z;
  // hips that no drop brings near enough, or that are near enough, stay
  if (way.y <= 0.0 || across >= span * span || dot(way, way) <= span * span) return 0.0;
  return way.y - sqrt(span * span - across);
}

// The leg from its new hip to its old foot, bent about the axis that it has.
void lower_hip(Landmarks::Leg& leg, double drop, const Vec3d& axis) {
  const LegLengths length(leg);
  leg.hip.y -= drop;
  const Vec3d way = leg.ankle - leg.hip;
  const double span = norm(way);
  const double along =
      (length.thigh * length.thigh - length.shank * length.shank + span * span) / (2.0 * span);
  const double ahead = sqrt(max(length.thigh * length.thigh - along * along, 0.0));
  const Vec3d down = normalized(way);
  leg.knee = leg.hip + down * along + normalized(cross(down, axis)) * ahead;
}

void hang(Landmarks::Arm& arm, const Landmarks::Arm& like) {
  const double upper_arm = norm(arm.elbow - arm.shoulder);
  const double forearm = norm(arm.wrist - arm.elbow);
  arm.elbow = arm.shoulder + normalized(like.elbow - like.shoulder) * upper_arm;
  arm.wrist = arm.elbow + normalized(like.wrist - like.elbow) * forearm;
}

}  // namespace

Landmarks at_ease(const Landmarks& person, double stature) {
  const HumanFrames before = human_frames(person);
  const Landmarks like = standing_landmarks(stature, 0.0);
  Landmarks result = person;
  const double drop = max(drop_for(person.left_leg), drop_for(person.right_leg));
  const Vec3d down{0.0, -drop, 0.0};
  result.neck += down;
  result.head_top += down;
  for (Vec3d& joint : result.spine) joint += down;
  if (result.head) *result.head += down;
  for (const Side side : kSides) {
    if (drop > 0.0) {
      lower_hip(side == Side::left ? result.left_leg : result.right_leg, drop,
                before.leg(side).thigh.cx);
    }
    Landmarks::Arm& arm = side == Side::left ? result.left_arm : result.right_arm;
    for (Vec3d* p : {&arm.shoulder, &arm.elbow, &arm.wrist}) *p += down;
    if (arm.clavicle) *arm.clavicle += down;
    hang(arm, like.arm(side));
  }
  const HumanFrames after = human_frames(result);
  for (const Side side : kSides) {
    const Landmarks::Arm& was = person.arm(side);
    Landmarks::Arm& arm = side == Side::left ? result.left_arm : result.right_arm;
    // the hand goes with its forearm
    const Mat3d turn = along_segment(after.arm(side).forearm, arm.elbow, arm.wrist) *
                       transpose(along_segment(before.arm(side).forearm, was.elbow, was.wrist));
    arm.fingertip = arm.wrist + turn * (was.fingertip - was.wrist);
    if (was.grip) arm.grip = arm.wrist + turn * (*was.grip - was.wrist);
  }
  return result;
}

}  // namespace shigusa
