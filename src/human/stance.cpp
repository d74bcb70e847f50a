// SPDX-License-Identifier: MIT
#include "stance.hpp"

#include <algorithm>

#include "human/at_ease.hpp"
#include "landmark_points.hpp"
#include "segment_mass.hpp"

namespace shigusa {
namespace {

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

double trunk_lean(const Landmarks& person) { return from_hanging(mid_hip(person) - person.neck); }

// Distance (m) of the centre of mass inside the hull of the soles, negative outside: the least over
// a set of directions.
double inside_feet(const Landmarks& person, double stature) {
  constexpr int kDirections = 32;
  const Vec3d centre = centre_of_mass(person, stature);
  double least = 1e9;
  for (int k = 0; k < kDirections; ++k) {
    const SinCos<double> way = sin_cos(2.0 * kPi * k / kDirections);
    double farthest = -1e9;
    for (const Side side : kBothSides) {
      for (const Vec3d& corner : sole_outline(person.leg(side), stature)) {
        const Vec3d from = corner - centre;
        farthest = max(farthest, way.cos * from.x + way.sin * from.z);
      }
    }
    least = min(least, farthest);
  }
  return least;
}

}  // namespace

Vec3d centre_of_mass(const Landmarks& person, double stature) {
  const HumanFrames frames = human_frames(person);
  const SegmentMasses masses(person, frames, segment_table(Sex::male), 1.0, stature);
  LinkMass whole = masses.trunk_and_head();
  for (const Side side : kBothSides) {
    whole.add(masses.foot(side));
    whole.add(masses.shank(side));
    whole.add(masses.thigh(side));
    whole.add(masses.arm(side));
  }
  return whole.moment * (1.0 / whole.mass);
}

bool spreads_arms(const Landmarks& person) {
  constexpr double kLeast = radians(30.0);
  constexpr double kLeastAhead = radians(60.0);
  constexpr double kMost = radians(125.0);
  constexpr double kStraight = radians(25.0);
  constexpr double kAhead = 0.5;     // sine of an arm's largest angle ahead or back: 30°
  constexpr double kOutwards = 0.5;  // the same to the side, for an arm that points ahead
  const auto sideways = [&](const Vec3d& reach, double out) {
    return from_hanging(reach) >= kLeast && out > 0.0 && abs(reach.z) <= kAhead;
  };
  const auto ahead = [&](const Vec3d& reach, double out) {
    return from_hanging(reach) >= kLeastAhead && reach.z > 0.0 && abs(out) <= kOutwards;
  };
  bool all_sideways = true;
  bool all_ahead = true;
  for (const Side side : kBothSides) {
    const Landmarks::Arm& arm = person.arm(side);
    const Landmarks::Leg& leg = person.leg(side);
    const Vec3d reach = reach_of(arm);
    const double outwards = side == Side::left ? reach.x : -reach.x;
    all_sideways = all_sideways && sideways(reach, outwards);
    all_ahead = all_ahead && ahead(reach, outwards);
    if (from_hanging(reach) > kMost || !(all_sideways || all_ahead)) return false;
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
  constexpr double kApart = 0.12;  // distance between the feet, ahead and up, in statures
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    if (knee_bend(leg) > kKnee || from_hanging(leg.ankle - leg.hip) > kLeg) return false;
    if (elbow_bend(person.arm(side)) > kElbow) return false;
  }
  const Vec3d feet = person.left_leg.ankle - person.right_leg.ankle;
  return trunk_lean(person) <= kTrunk && max(abs(feet.y), abs(feet.z)) <= kApart * stature &&
         alike(knee_bend(person.left_leg), knee_bend(person.right_leg), 20.0) &&
         alike(elbow_bend(person.left_arm), elbow_bend(person.right_arm), 30.0) &&
         alike(from_hanging(reach_of(person.left_arm)), from_hanging(reach_of(person.right_arm)),
               30.0);
}

bool stands_on_both_feet(const Landmarks& person, double stature) {
  constexpr double kKnee = radians(60.0);
  constexpr double kLeg = radians(28.0);
  constexpr double kTrunk = radians(30.0);
  // in statures, height differences
  constexpr double kAnkles = 0.02;  // one over the other
  constexpr double kToes = 0.03;    // one over the other
  constexpr double kTiptoe = 0.09;  // an ankle over its toes
  constexpr double kInside = 0.01;
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    if (knee_bend(leg) > kKnee || from_hanging(leg.ankle - leg.hip) > kLeg) return false;
    if (leg.ankle.y - leg.toe.y > kTiptoe * stature) return false;
  }
  const Landmarks::Leg& left = person.left_leg;
  const Landmarks::Leg& right = person.right_leg;
  return trunk_lean(person) <= kTrunk && abs(left.ankle.y - right.ankle.y) <= kAnkles * stature &&
         abs(left.toe.y - right.toe.y) <= kToes * stature &&
         inside_feet(person, stature) >= kInside * stature;
}

std::optional<double> seat_below(const Landmarks& person, double stature) {
  constexpr double kThigh = radians(50.0);  // from hanging
  constexpr double kTrunk = radians(45.0);
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    if (from_hanging(leg.knee - leg.hip) < kThigh) return std::nullopt;
  }
  if (trunk_lean(person) > kTrunk || inside_feet(person, stature) >= 0.0) return std::nullopt;
  double floor = 1e9;
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    floor = min(floor, min(sole_outline(leg, stature)[0].y, leg.toe.y));
  }
  return mid_hip(person).y - kSeatedHip * stature - floor;
}

bool lies(const Landmarks& person, double stature) {
  constexpr double kLevel = 0.4;  // statures from the lowest joint to the highest one
  double low = 1e9;
  double high = -1e9;
  const auto take = [&](const Vec3d& p) {
    low = min(low, p.y);
    high = max(high, p.y);
  };
  take(person.neck);
  take(person.head_top);
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    for (const Vec3d& p : {leg.hip, leg.knee, leg.ankle}) take(p);
  }
  if (high - low > kLevel * stature) return false;
  // who crouches has the knees over the feet, and the hips off the floor
  constexpr double kKnees = 0.15;  // statures above the ankles
  constexpr double kHips = 0.1;
  return std::any_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
    const Landmarks::Leg& leg = person.leg(side);
    return leg.knee.y - leg.ankle.y < kKnees * stature || leg.hip.y - leg.ankle.y < kHips * stature;
  });
}

}  // namespace shigusa
