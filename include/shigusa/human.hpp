// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The parts of a person that nothing should pass through. A trunk is one part, or pelvis, spine,
/// chest and upper chest where it has joints: a body has the one or the others.
enum class BodyPart {
  head,             ///< the skull without its lower part
  jaw,              ///< the lower part of the skull
  neck,             ///< between upper chest and head
  trunk,            ///< from hips to neck, of a body without a spine
  pelvis,           ///< about the hips
  spine,            ///< the waist
  chest,            ///< the lower ribs
  upper_chest,      ///< the upper ribs and the shoulders
  left_thigh,       ///< hip to knee
  right_thigh,      ///< hip to knee
  left_shank,       ///< knee to ankle
  right_shank,      ///< knee to ankle
  left_foot,        ///< heel to toes
  right_foot,       ///< heel to toes
  left_upper_arm,   ///< shoulder to elbow
  right_upper_arm,  ///< shoulder to elbow
  left_forearm,     ///< elbow to wrist
  right_forearm,    ///< elbow to wrist
  left_hand,        ///< wrist to fingertips
  right_hand,       ///< wrist to fingertips
};
/// Number of the parts.
inline constexpr int kBodyPartCount = 20;

/// "left_upper_arm".
[[nodiscard]] std::string_view body_part_name(BodyPart part);

/// A line with a thickness, in the part's own frame: its origin is the joint that the part hangs on
/// (of the trunk and its pieces between the hips), y points from its far end to that joint, z
/// ahead, x to the left; of head, neck and trunk these are the trunk's axes, and a foot's y is up
/// where it stands. A flat part is two such lines side by side.
struct PartShape {
  Vec3d from{};               ///< m
  Vec3d to{};                 ///< m
  double radius = 0.0;        ///< m, > 0, at `from`
  double to_radius = radius;  ///< m, > 0, at `to`; between them it changes evenly
  Vec3d aside{};              ///< m: of a flat part, from the middle to either line
};

/// (parts) shapes, as far as they are known.
struct PartShapes {
  std::array<std::optional<PartShape>, kBodyPartCount> shape{};  ///< by the number of the part

  /// The shape of a part, or nothing.
  [[nodiscard]] const std::optional<PartShape>& operator[](BodyPart part) const {
    return shape[static_cast<std::size_t>(part)];
  }
  /// The same, to be changed.
  [[nodiscard]] std::optional<PartShape>& operator[](BodyPart part) {
    return shape[static_cast<std::size_t>(part)];
  }
};

/// Corners of a sole, counter-clockwise from above: left of the tip, left of the heel, right of the
/// heel, right of the tip. m, as the landmarks.
using SoleOutline = std::array<Vec3d, 4>;

/// Joint centres and tips of a person in one posture: all that a body's geometry and start posture
/// are made of. Metres, in shigusa's world: +Y up, facing +Z, left is +X, origin on the floor
/// between the feet.
struct Landmarks {
  /// Joints of a leg (m).
  struct Leg {
    Vec3d hip;    ///< centre of the joint
    Vec3d knee;   ///< centre of the joint
    Vec3d ankle;  ///< centre of the joint
    Vec3d toe;    ///< tip of the foot
    /// the toes' joint, of a character that lifts its heels the file's node; see toes_joint
    std::optional<Vec3d> toes{};
    /// of a character with a mesh the shoe's, at the height of its lowest point; none: by stature
    std::optional<SoleOutline> sole{};
  };
  /// Joints of an arm (m).
  struct Arm {
    Vec3d shoulder;                   ///< centre of the joint
    Vec3d elbow;                      ///< centre of the joint
    Vec3d wrist;                      ///< centre of the joint
    Vec3d fingertip;                  ///< tip of the third finger
    std::optional<Vec3d> clavicle{};  ///< its joint with the breastbone; none: part of the trunk
    /// where the hand holds things: of a character the node nearest to it; see grip_of
    std::optional<Vec3d> grip{};
  };
  Leg left_leg;    ///< the person's own left
  Leg right_leg;   ///< and right
  Arm left_arm;    ///< the person's own left
  Arm right_arm;   ///< and right
  Vec3d neck;      ///< base of the neck (C7)
  Vec3d head_top;  ///< vertex
  /// Joints that the paper's rigid trunk does without; a person from a file may lack some.
  std::vector<Vec3d> spine{};   ///< 0..3, from below
  std::optional<Vec3d> head{};  ///< between neck and skull
  /// rad: how far back the line from the hips to the shoulders leans of a trunk that is upright
  double trunk_lean = 0.0;
  PartShapes parts{};  ///< of a character with a mesh, those that it tells

  /// The leg of a side.
  [[nodiscard]] const Leg& leg(Side side) const {
    return side == Side::left ? left_leg : right_leg;
  }
  /// The same, to be changed.
  [[nodiscard]] Leg& leg(Side side) { return side == Side::left ? left_leg : right_leg; }
  /// The arm of a side.
  [[nodiscard]] const Arm& arm(Side side) const {
    return side == Side::left ? left_arm : right_arm;
  }
  /// The same, to be changed.
  [[nodiscard]] Arm& arm(Side side) { return side == Side::left ? left_arm : right_arm; }
};

/// The point that an arm's goals are given for: its own grip, or the third knuckle.
[[nodiscard]] Vec3d grip_of(const Landmarks::Arm& arm);

/// Where the toes bend: their own joint, or at kToesShare of the way from the ankle to the tip.
[[nodiscard]] Vec3d toes_joint(const Landmarks::Leg& leg);
/// Share of the way from the ankle to the tip of the foot at which toes bend.
inline constexpr double kToesShare = 0.7;

/// Landmarks of a person standing upright at ease: knees bent by 5°, elbows by 10°, arms hanging,
/// each foot turned out by `toe_out` (rad).
[[nodiscard]] Landmarks standing_landmarks(double stature, double toe_out);

/// How much of the body moves (table 1 of the paper).
enum class BodyExtent {
  half,  ///< 9 dof: right ankle 1, knee 1, hip 3, shoulder 3, elbow 1; left limbs are mass
  full,  ///< 18 dof: both sides; both feet stay planted
  /// 45 dof, with the pelvis' six 51: spine, neck, clavicles, forearms, wrists and ankles' second
  /// freedom as well, as far as the landmarks tell of them
  human,
};
/// The words of BodyExtent.
template <>
inline constexpr std::array kEnumWords<BodyExtent>{
    EnumWord{BodyExtent::half, "half"},
    EnumWord{BodyExtent::full, "full"},
    EnumWord{BodyExtent::human, "human"},
};

/// How build_human makes a body.
struct HumanSettings {
  std::string name = "body";             ///< of the body
  BodyExtent extent = BodyExtent::full;  ///< how much of it moves
  double stature = 1.741;                ///< m
  double mass = 73.0;                    ///< kg
  Sex sex = Sex::male;                   ///< of the tables of masses and strengths
  Side base = Side::right;               ///< the foot that bears the body where both stand
  /// both feet stand, however high the one is above the other
  bool on_both = false;
  bool sits = false;  ///< on both thighs, see build_human; not of half extent
  /// Heels may lift: the body stands on its forefeet, and each foot turns about its toes' joint. Of
  /// extent human, standing.
  bool heels = false;
};

/// A lifted foot: its sole is more than this above the other's (m).
inline constexpr double kLiftedFoot = 0.05;

/// The body whose start posture has exactly these landmarks: their distances become the segment
/// lengths, masses come from the anthropometric tables by `mass` and `sex`. The trunk is rigid in
/// the shape of the start posture. The base is the foot of
/// settings.base, or the one that stands where the other does not (not of half extent). Where the
/// start posture lies outside a joint limit, that limit is widened to hold it, with a doubt. Half
/// extent: the left leg's mass moves as the right leg's translation, the left arm's with the trunk,
/// and leg strengths count for both legs (paper, section 3.1; each number in docs/paper_map.md).
/// A person who sits has the right thigh as the base, and the left one stands in a foot's place:
/// the pelvis tips over them and turns no further. The legs below are one piece with their thighs,
/// and where their soles are on the floor these are a part of what bears the body.
[[nodiscard]] BodyModel build_human(const Landmarks& landmarks, const HumanSettings& settings,
                                    std::vector<Message> doubts = {});

/// Each foot of the standing full body is turned out by this: 14° between the feet (McIlroy and
/// Maki, Clinical Biomechanics 12 (1997) 66-70). The half body's foot points straight ahead.
inline constexpr double kStandingToeOut = radians(7.0);

/// Makes the body of 9 freedoms, standing at ease (standing_landmarks).
[[nodiscard]] BodyModel half_body(const BodyBuild& stature = {});
/// Makes the body of 18 freedoms, standing at ease.
[[nodiscard]] BodyModel full_body(const BodyBuild& stature = {});
/// Makes the body of 45 freedoms, standing at ease.
[[nodiscard]] BodyModel human_body(const BodyBuild& stature = {});

}  // namespace shigusa
