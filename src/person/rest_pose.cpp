// SPDX-License-Identifier: MIT
#include <array>

#include "person/at_ease.hpp"

namespace shigusa {
namespace {

constexpr std::array kSides{Side::left, Side::right};

// Angle between two directions (rad, 0 to π).
double angle_between(const Vec3d& a, const Vec3d& b) { return atan2(norm(cross(a, b)), dot(a, b)); }

double from_hanging(const Vec3d& v) { return angle_between(v, {0, -1, 0}); }

double knee_bend(const Landmarks::Leg& leg) {
  return angle_between(leg.knee - leg.hip, leg.ankle - leg.knee);
}
double elbow_bend(const Landmarks::Arm& arm) {
  return angle_between(arm.elbow - arm.shoulder, arm.wrist - arm.elbow);
}
Vec3d reach_of(const Landmarks::Arm& arm) { return normalized(arm.wrist - arm.shoulder); }

bool alike(double left, double right, double most_deg) {
  return abs(left - right) <= radians(most_deg);
}

}  // namespace

bool spreads_arms(const Landmarks& person) {
  constexpr double kLeast = radians(30.0);
  constexpr double kMost = radians(110.0);
  constexpr double kStraight = radians(25.0);
  constexpr double kAhead = 0.5;  // sine of what an arm may point ahead or back: 30°
  for (const Side side : kSides) {
    const Landmarks::Arm& arm = person.arm(side);
    const Landmarks::Leg& leg = person.leg(side);
    const Vec3d reach = reach_of(arm);
    const double raised = from_hanging(reach);
    const double outwards = side == Side::left ? reach.x : -reach.x;
    if (raised < kLeast || raised > kMost || outwards <= 0.0 || abs(reach.z) > kAhead) return false;
    if (elbow_bend(arm) > kStraight || knee_bend(leg) > kStraight) return false;
    if (from_hanging(leg.ankle - leg.hip) > kStraight) return false;
  }
  return alike(from_hanging(reach_of(person.left_arm)), from_hanging(reach_of(person.right_arm)),
               15.0);
}

bool stands_at_rest(const Landmarks& person, double stature) {
  constexpr double kKnee = radians(40.0);
  constexpr double kLeg = radians(30.0);
  constexpr double kElbow = radians(70.0);
  constexpr double kTrunk = radians(20.0);
  constexpr double kApart = 0.12;  // feet, ahead and up, in statures
  for (const Side side : kSides) {
    const Landmarks::Leg& leg = person.leg(side);
    if (knee_bend(leg) > kKnee || from_hanging(leg.ankle - leg.hip) > kLeg) return false;
    if (elbow_bend(person.arm(side)) > kElbow) return false;
  }
  const Vec3d hips = (person.left_leg.hip + person.right_leg.hip) * 0.5;
  const Vec3d feet = person.left_leg.ankle - person.right_leg.ankle;
  return from_hanging(hips - person.neck) <= kTrunk &&
         max(abs(feet.y), abs(feet.z)) <= kApart * stature &&
         alike(knee_bend(person.left_leg), knee_bend(person.right_leg), 20.0) &&
         alike(elbow_bend(person.left_arm), elbow_bend(person.right_arm), 30.0) &&
         alike(from_hanging(reach_of(person.left_arm)), from_hanging(reach_of(person.right_arm)),
               30.0);
}

}  // namespace shigusa
