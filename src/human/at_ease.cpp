// SPDX-License-Identifier: MIT
#include "human/at_ease.hpp"

#include <vector>

#include "body/capsules.hpp"
#include "human_frames.hpp"
#include "landmark_points.hpp"
#include "moved_limbs.hpp"
#include "part_shapes.hpp"
#include "segment_mass.hpp"
#include "stance.hpp"

namespace shigusa {
namespace {

// Clearance (m) of arms at ease from the body, and the most (rad) that they are raised outwards.
constexpr double kArmsClear = 0.005;
constexpr double kArmsOutMost = radians(40.0);

// Range along the soles (0 heel, 1 tip) of the centre of mass at ease: people's is some 5 cm ahead
// of the ankles. Leaning ahead, by at most kAheadMost (statures), brings it there.
constexpr double kMassOnSolesLeast = 0.38;
constexpr double kMassOnSolesMost = 0.55;
constexpr double kAheadMost = 0.05;

// Descent (m, ≥ 0) of moved hips that one leg requires.
double drop_for(const Landmarks::Leg& leg, const Vec3d& moved) {
  const double span = LegLengths(leg).span(kKneesAtEase);
  const Vec3d rise = leg.hip + moved - leg.ankle;
  const double across = rise.x * rise.x + rise.z * rise.z;
  // hips out of reach of any descent, or near enough, stay
  if (rise.y <= 0.0 || across >= span * span || dot(rise, rise) <= span * span) return 0.0;
  return rise.y - sqrt(span * span - across);
}

// Moves a leg's hip while its foot stays; it keeps its bending axis.
void move_hip(Landmarks::Leg& leg, const Vec3d& by, const Vec3d& axis) {
  const LegLengths length(leg);
  leg.hip += by;
  const Vec3d hip_to_ankle = leg.ankle - leg.hip;
  const double span = norm(hip_to_ankle);
  const double along =
      (length.thigh * length.thigh - length.shank * length.shank + span * span) / (2.0 * span);
  const double ahead = sqrt(max(length.thigh * length.thigh - along * along, 0.0));
  const Vec3d down = normalized(hip_to_ankle);
  leg.knee = leg.hip + down * along + normalized(cross(down, axis)) * ahead;
}

// The body above the ankles moved ahead (m), with hips lowered until no knee is straighter than
// kKneesAtEase.
Landmarks moved_ahead(const Landmarks& person, double ahead) {
  const HumanFrames before = human_frames(person);
  Vec3d by{0.0, 0.0, ahead};
  for (const Side side : kBothSides) {
    by.y = min(by.y, -drop_for(person.leg(side), {0.0, 0.0, ahead}));
  }
  Landmarks result = person;
  if (by == Vec3d{}) return result;
  for (const Side side : kBothSides) move_hip(result.leg(side), by, before.leg(side).thigh.cx);
  move_upper_body(result, by);
  return result;
}

// Position of the centre of mass along the soles (0 heel, 1 tip), and their length (m).
struct OnSoles {
  double share;
  double length;
};
OnSoles mass_on_soles(const Landmarks& person, double stature) {
  double heel = 0.0;
  double tip = 0.0;
  for (const Side side : kBothSides) {
    const SoleOutline sole = sole_outline(person.leg(side), stature);
    tip += 0.25 * (sole[0].z + sole[3].z);
    heel += 0.25 * (sole[1].z + sole[2].z);
  }
  const double length = max(tip - heel, 1e-3);
  return {(centre_of_mass(person, stature).z - heel) / length, length};
}

// The body leaning at the ankles until its centre of mass is where people's is.
Landmarks balanced(const Landmarks& person, double stature) {
  constexpr int kSteps = 3;  // iterated, as only a part of the mass leans
  const double most = kAheadMost * stature;
  double ahead = 0.0;
  Landmarks result = moved_ahead(person, ahead);
  for (int step = 0; step < kSteps; ++step) {
    const OnSoles mass = mass_on_soles(result, stature);
    const double wanted = clamp(mass.share, kMassOnSolesLeast, kMassOnSolesMost);
    ahead = clamp(ahead + (wanted - mass.share) * mass.length, -most, most);
    result = moved_ahead(person, ahead);
  }
  return result;
}

// Penetration depth (m) of the arms in trunk and legs, from the middle of the upper arms on;
// negative: their distance.
double depth_of_arms(const Landmarks& person, double stature) {
  const HumanFrames frames = human_frames(person);
  std::vector<Capsule> body;
  const auto add = [&](BodyPart part, std::vector<Capsule>& to) {
    for (Capsule& c : part_capsules(part, person, frames, stature)) to.push_back(std::move(c));
  };
  for (const BodyPart part : trunk_parts(person)) add(part, body);
  double deepest = -1e9;
  for (const Side side : kBothSides) {
    for (const BodyPart part : {BodyPart::left_thigh, BodyPart::left_shank}) {
      add(of_side(part, side), body);
    }
  }
  for (const Side side : kBothSides) {
    std::vector<Capsule> arm;
    add(of_side(BodyPart::left_upper_arm, side), arm);
    // the upper arm may lie against the trunk's flesh
    Capsule& upper = arm.front();
    upper.from = (upper.from + upper.to) * 0.5;
    upper.radius = max(0.5 * (upper.radius + upper.to_radius) - kFleshGives, 0.0);
    upper.to_radius = max(upper.to_radius - kFleshGives, 0.0);
    add(of_side(BodyPart::left_forearm, side), arm);
    add(of_side(BodyPart::left_hand, side), arm);
    for (const Capsule& limb : arm) {
      for (const Capsule& part : body) deepest = max(deepest, capsule_depth(limb, part));
    }
  }
  return deepest;
}

}  // namespace

Landmarks at_ease(const Landmarks& person, double stature) {
  const Landmarks::Arm like = standing_landmarks(stature, 0.0).right_arm;
  Landmarks result = balanced(person, stature);
  for (double outwards = 0.0; outwards <= kArmsOutMost; outwards += radians(1.0)) {
    lay_arms(result, person, normalized(like.elbow - like.shoulder),
             normalized(like.wrist - like.elbow), outwards);
    if (depth_of_arms(result, stature) <= -kArmsClear) break;
  }
  return result;
}

}  // namespace shigusa
