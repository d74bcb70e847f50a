// SPDX-License-Identifier: MIT
#include "person/at_ease.hpp"

#include "body/anthropometry.hpp"
#include "human_frames.hpp"
#include "landmark_points.hpp"

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
  const Vec3d rise = leg.hip - leg.ankle;
  const double across = rise.x * rise.x + rise.z * rise.z;
  // hips that no drop brings near enough, or that are near enough, stay
  if (rise.y <= 0.0 || across >= span * span || dot(rise, rise) <= span * span) return 0.0;
  return rise.y - sqrt(span * span - across);
}

// The leg from its new hip to its old foot, bent about the axis that it has.
void lower_hip(Landmarks::Leg& leg, double drop, const Vec3d& axis) {
  const LegLengths length(leg);
  leg.hip.y -= drop;
  const Vec3d hip_to_ankle = leg.ankle - leg.hip;
  const double span = norm(hip_to_ankle);
  const double along =
      (length.thigh * length.thigh - length.shank * length.shank + span * span) / (2.0 * span);
  const double ahead = sqrt(max(length.thigh * length.thigh - along * along, 0.0));
  const Vec3d down = normalized(hip_to_ankle);
  leg.knee = leg.hip + down * along + normalized(cross(down, axis)) * ahead;
}

// The body above the hips, arms included.
void move_upper_body(Landmarks& person, const Vec3d& by) {
  person.neck += by;
  person.head_top += by;
  for (Vec3d& joint : person.spine) joint += by;
  if (person.head) *person.head += by;
  for (const Side side : kBothSides) {
    Landmarks::Arm& arm = person.arm(side);
    for (Vec3d* p : {&arm.shoulder, &arm.elbow, &arm.wrist, &arm.fingertip}) *p += by;
    if (arm.clavicle) *arm.clavicle += by;
    if (arm.grip) *arm.grip += by;
  }
}

// The arms in these directions, each hand with its forearm as it was in `before`.
void lay_arms(Landmarks& person, const Landmarks& before, const Vec3d& upper_arm,
              const Vec3d& forearm) {
  const HumanFrames frames = human_frames(before);
  for (const Side side : kBothSides) {
    const Landmarks::Arm& was = before.arm(side);
    Landmarks::Arm& arm = person.arm(side);
    arm.elbow = arm.shoulder + upper_arm * norm(was.elbow - was.shoulder);
    arm.wrist = arm.elbow + forearm * norm(was.wrist - was.elbow);
  }
  const HumanFrames after = human_frames(person);
  for (const Side side : kBothSides) {
    const Landmarks::Arm& was = before.arm(side);
    Landmarks::Arm& arm = person.arm(side);
    const Mat3d turn = along_segment(after.arm(side).forearm, arm.elbow, arm.wrist) *
                       transpose(along_segment(frames.arm(side).forearm, was.elbow, was.wrist));
    arm.fingertip = arm.wrist + turn * (was.fingertip - was.wrist);
    if (was.grip) arm.grip = arm.wrist + turn * (*was.grip - was.wrist);
  }
}

// The foot goes along with an ankle that was elsewhere.
void move_foot(Landmarks::Leg& leg, const Vec3d& was) {
  const Vec3d by = leg.ankle - was;
  leg.toe += by;
  if (leg.toes) *leg.toes += by;
  if (!leg.sole) return;
  for (Vec3d& corner : *leg.sole) corner += by;
}

// The leg from a lowered hip: shank upright over a flat foot, thigh ahead of the hip to where the
// knee is then. A thigh that would slope too much for that has its limit instead: from a high seat
// the foot hangs, at a low one it stands farther ahead.
void bend_over_seat(Landmarks::Leg& leg, const Vec3d& hip) {
  constexpr double kDown = 0.5;  // of the thigh's length, from hip to knee
  constexpr double kUp = 0.8;
  const LegLengths length(leg);
  const Vec3d ankle = leg.ankle;
  const Vec3d sole = leg.toe - leg.ankle;
  const Vec3d ahead = normalized(Vec3d{sole.x, 0.0, sole.z}, {0, 0, 1});
  const double wanted = leg.ankle.y + length.shank - hip.y;
  const double rise = clamp(wanted, -kDown * length.thigh, kUp * length.thigh);
  const double forwards = sqrt(length.thigh * length.thigh - rise * rise);
  const double foot = min(hip.y + rise - leg.ankle.y, length.shank);  // height of the knee above it
  const double on = sqrt(max(length.shank * length.shank - foot * foot, 0.0));
  leg.hip = hip;
  leg.knee = hip + ahead * forwards + Vec3d{0, rise, 0};
  leg.ankle = leg.knee + ahead * on - Vec3d{0, foot, 0};
  move_foot(leg, ankle);
}

}  // namespace

Landmarks at_ease(const Landmarks& person, double stature) {
  const HumanFrames before = human_frames(person);
  const Landmarks::Arm like = standing_landmarks(stature, 0.0).right_arm;
  Landmarks result = person;
  const double drop = max(drop_for(person.left_leg), drop_for(person.right_leg));
  for (const Side side : kBothSides) {
    if (drop > 0.0) lower_hip(result.leg(side), drop, before.leg(side).thigh.cx);
  }
  move_upper_body(result, {0.0, -drop, 0.0});
  lay_arms(result, person, normalized(like.elbow - like.shoulder),
           normalized(like.wrist - like.elbow));
  return result;
}

bool spreads_arms(const Landmarks& person) {
  constexpr double kLeast = radians(30.0);
  constexpr double kMost = radians(110.0);
  constexpr double kStraight = radians(25.0);
  constexpr double kAhead = 0.5;  // sine of what an arm may point ahead or back: 30°
  for (const Side side : kBothSides) {
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
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    if (knee_bend(leg) > kKnee || from_hanging(leg.ankle - leg.hip) > kLeg) return false;
    if (elbow_bend(person.arm(side)) > kElbow) return false;
  }
  const Vec3d feet = person.left_leg.ankle - person.right_leg.ankle;
  return from_hanging(mid_hip(person) - person.neck) <= kTrunk &&
         max(abs(feet.y), abs(feet.z)) <= kApart * stature &&
         alike(knee_bend(person.left_leg), knee_bend(person.right_leg), 20.0) &&
         alike(elbow_bend(person.left_arm), elbow_bend(person.right_arm), 30.0) &&
         alike(from_hanging(reach_of(person.left_arm)), from_hanging(reach_of(person.right_arm)),
               30.0);
}

Landmarks seated(const Landmarks& person, double stature, double seat) {
  Landmarks result = person;
  const double drop = mid_hip(person).y - (seat + kSeatedHip * stature);
  const auto between_feet = [](const Landmarks& p) {
    const Vec3d sum = p.left_leg.ankle + p.right_leg.ankle;
    return Vec3d{0.5 * sum.x, 0.0, 0.5 * sum.z};
  };
  for (const Side side : kBothSides) {
    bend_over_seat(result.leg(side), person.leg(side).hip - Vec3d{0.0, drop, 0.0});
  }
  move_upper_body(result, {0.0, -drop, 0.0});
  const SinCos<double> slope = sin_cos(kSeatedForearms);
  lay_arms(result, person, {0, -1, 0}, {0.0, -slope.sin, slope.cos});
  // the feet stay where they stood
  const Vec3d back = between_feet(person) - between_feet(result);
  move_upper_body(result, back);
  for (const Side side : kBothSides) {
    Landmarks::Leg& leg = result.leg(side);
    const Vec3d ankle = leg.ankle;
    for (Vec3d* p : {&leg.hip, &leg.knee, &leg.ankle}) *p += back;
    move_foot(leg, ankle);
  }
  return result;
}

}  // namespace shigusa
