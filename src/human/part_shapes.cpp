// SPDX-License-Identifier: MIT
#include "part_shapes.hpp"

#include "body/anthropometry.hpp"
#include "body/capsules.hpp"
#include "core/check.hpp"
#include "landmark_points.hpp"
#include "segment_mass.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

Vec3d middle(const Vec3d& a, const Vec3d& b) { return (a + b) * 0.5; }

// A paired part: its side, and its left counterpart.
struct Sided {
  Side side;
  BodyPart left;
};
std::optional<Sided> sided(BodyPart part) {
  const int index = static_cast<int>(part) - static_cast<int>(BodyPart::left_thigh);
  if (index < 0) return std::nullopt;
  return Sided{index % 2 == 0 ? Side::left : Side::right,
               static_cast<BodyPart>(static_cast<int>(part) - index % 2)};
}

// A limb's segment: its anatomical frame, its joints, and its thickness as a share of the stature.
struct Segment {
  Mat3d frame;
  Vec3d from;
  Vec3d to;
  double radius;
};
Segment segment(const Sided& part, const Landmarks& person, const HumanFrames& frames) {
  const Landmarks::Leg& leg = person.leg(part.side);
  const Landmarks::Arm& arm = person.arm(part.side);
  switch (part.left) {
    case BodyPart::left_thigh:
      return {frames.leg(part.side).thigh, leg.hip, leg.knee, kThighRadius};
    case BodyPart::left_shank:
      return {frames.leg(part.side).shank, leg.knee, leg.ankle, kShankRadius};
    case BodyPart::left_upper_arm:
      return {frames.arm(part.side).upper_arm, arm.shoulder, arm.elbow, kUpperArmRadius};
    case BodyPart::left_forearm:
      return {frames.arm(part.side).forearm, arm.elbow, arm.wrist, kForearmRadius};
    default:
      return {frames.arm(part.side).forearm, arm.wrist, arm.fingertip, kHandRadius};
  }
}

Transformd limb_frame(const Sided& part, const Landmarks& person, const HumanFrames& frames) {
  if (part.left == BodyPart::left_foot) {
    return {frames.leg(part.side).foot, person.leg(part.side).ankle};
  }
  // a hand has its forearm's axes
  const bool hand = part.left == BodyPart::left_hand;
  const Segment s = segment({part.side, hand ? BodyPart::left_forearm : part.left}, person, frames);
  return {along_segment(s.frame, s.from, s.to), hand ? s.to : s.from};
}

// Capsule between two points of the world.
PartShape between(const Transformd& frame, const Vec3d& from, const Vec3d& to, double radius) {
  const Transformd to_part = inverse(frame);
  return {to_part * from, to_part * to, radius};
}

// Foot from heel to tip, at half the height of its back.
PartShape foot_shape(const Transformd& frame, const Landmarks::Leg& leg, double stature) {
  const SoleOutline sole = sole_outline(leg, stature);
  const Vec3d tip = middle(sole[0], sole[3]);
  const Vec3d heel = middle(sole[1], sole[2]);
  const double rise = max(leg.ankle.y - heel.y, 0.25 * F::kAnkleHeight * stature);
  const double radius = 0.5 * min(min(rise, norm(sole[0] - sole[3])), norm(tip - heel));
  const Vec3d inset = normalized(tip - heel, {0, 0, 1}) * radius;
  const Vec3d up{0.0, radius, 0.0};
  return between(frame, heel + inset + up, tip - inset + up, radius);
}

PartShape head_shape(BodyPart part, const Landmarks& person, const HumanFrames& frames,
                     const Transformd& frame, double stature) {
  const Vec3d joint = head_joint(person);
  if (part == BodyPart::neck) {
    return between(frame, person.neck, joint, kNeckRadius * stature);
  }
  const Vec3d up = normalized(person.head_top - joint, frames.trunk.cy);
  const Vec3d ahead = normalized(cross(frames.trunk.cx, up), frames.trunk.cz);
  const double skull = 0.5 * kHeadBreadth * stature;
  const double half = 0.5 * kHeadDepth * stature;
  if (part == BodyPart::head) {
    const Vec3d centre = person.head_top - up * skull;
    const Vec3d reach = ahead * (half - skull);
    return between(frame, centre - reach, centre + reach, skull);
  }
  const double radius = kJawRadius * stature;
  const Vec3d face = person.head_top + ahead * (half - radius);
  return between(frame, face - up * (2.0 * skull - radius),
                 face - up * (kChinBelowVertex * stature - radius), radius);
}

PartShape trunk_shape(BodyPart part, const Landmarks& person, const Transformd& frame,
                      double stature) {
  const TrunkPiece piece = trunk_piece(part, person);
  // the upper end is round: it begins a radius within
  const Vec3d rise = mid_shoulder(person) - mid_hip(person);
  const Vec3d inset = normalized(rise) * (piece.last ? kTrunkRadius * stature : 0.0);
  return between(frame, piece.from, piece.to - inset, kTrunkRadius * stature);
}

}  // namespace

std::string_view body_part_name(BodyPart part) {
  static constexpr std::array<std::string_view, kBodyPartCount> kNames{
      "head",         "jaw",           "neck",           "trunk",
      "pelvis",       "spine",         "chest",          "upper_chest",
      "left_thigh",   "right_thigh",   "left_shank",     "right_shank",
      "left_foot",    "right_foot",    "left_upper_arm", "right_upper_arm",
      "left_forearm", "right_forearm", "left_hand",      "right_hand"};
  return kNames[static_cast<std::size_t>(part)];
}

Vec3d head_joint(const Landmarks& person) {
  return person.head.value_or(person.neck + (person.head_top - person.neck) * kHeadJointShare);
}

Transformd part_frame(BodyPart part, const Landmarks& person, const HumanFrames& frames) {
  if (const auto limb = sided(part)) return limb_frame(*limb, person, frames);
  switch (part) {
    case BodyPart::head:
    case BodyPart::jaw:
      return {frames.trunk, head_joint(person)};
    case BodyPart::neck:
      return {frames.trunk, person.neck};
    default:
      return {frames.trunk, mid_hip(person)};
  }
}

std::vector<BodyPart> trunk_parts(const Landmarks& person) {
  if (person.spine.empty()) return {BodyPart::trunk};
  std::vector<BodyPart> parts;
  for (std::size_t j = 0; j <= std::min(person.spine.size(), kSpineJoints); ++j) {
    parts.push_back(static_cast<BodyPart>(static_cast<std::size_t>(BodyPart::pelvis) + j));
  }
  return parts;
}

TrunkPiece trunk_piece(BodyPart part, const Landmarks& person) {
  TrunkPiece piece{mid_hip(person), mid_shoulder(person)};
  if (part == BodyPart::trunk) return piece;
  const std::size_t joints = std::min(person.spine.size(), kSpineJoints);
  const auto below = static_cast<std::size_t>(part) - static_cast<std::size_t>(BodyPart::pelvis);
  SHG_CHECK(below <= joints, "a piece of the trunk that the spine's joints tell");
  if (below > 0) piece.from = person.spine[below - 1];
  if (below == joints) return piece;
  return {piece.from, person.spine[below], false};
}

double limb_length(BodyPart part, const Landmarks& person) {
  const auto limb = sided(part);
  SHG_CHECK(limb && limb->left != BodyPart::left_foot, "a limb's part");
  const Segment s = segment(*limb, person, human_frames(person));
  return norm(s.to - s.from);
}

PartShape part_shape(BodyPart part, const Landmarks& person, const HumanFrames& frames,
                     double stature) {
  if (person.parts[part]) return *person.parts[part];
  const Transformd frame = part_frame(part, person, frames);
  if (const auto limb = sided(part)) {
    if (limb->left == BodyPart::left_foot) {
      return foot_shape(frame, person.leg(limb->side), stature);
    }
    const Segment s = segment(*limb, person, frames);
    return between(frame, s.from, s.to, s.radius * stature);
  }
  if (part == BodyPart::head || part == BodyPart::jaw || part == BodyPart::neck) {
    return head_shape(part, person, frames, frame, stature);
  }
  return trunk_shape(part, person, frame, stature);
}

Capsule beyond_trunk(Capsule upper_arm) {
  constexpr double kGrownOn = 0.5;  // share of it that may lie within the trunk
  upper_arm.grown_on = false;
  upper_arm.from += (upper_arm.to - upper_arm.from) * kGrownOn;
  upper_arm.radius += taper_of(upper_arm) * kGrownOn;
  return upper_arm;
}

std::vector<Capsule> part_capsules(BodyPart part, const Landmarks& person,
                                   const HumanFrames& frames, double stature) {
  const Transformd frame = part_frame(part, person, frames);
  const PartShape shape = part_shape(part, person, frames, stature);
  std::vector<Capsule> capsules;
  // shapes without a mesh are rough, and have no compliance
  const bool soft = person.parts[part] && part >= BodyPart::trunk && part <= BodyPart::right_thigh;
  const auto add = [&](const Vec3d& aside) {
    capsules.push_back({.name = std::string(body_part_name(part)),
                        .from = frame * (shape.from + aside),
                        .to = frame * (shape.to + aside),
                        .radius = shape.radius,
                        .to_radius = shape.to_radius,
                        .give = soft ? kFleshGives : 0.0});
  };
  add(shape.aside);
  if (shape.aside != Vec3d{}) add(-shape.aside);
  return capsules;
}

}  // namespace shigusa
