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

/// The parts of a person that collide. A rigid trunk is the one part `trunk`, a trunk with joints
/// is pelvis, spine, chest and upper chest.
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

/// The shape of a body part: a segment with a radius at each end, in the part's frame. Its origin
/// is the joint that the part hangs on (for the trunk and its pieces the point between the hips), y
/// points from the part's far end to that joint, z ahead, x to the left. Head, neck and trunk use
/// the trunk's axes, and a foot's y is up where it stands. A flat part is two such shapes side by
/// side.
struct PartShape {
  Vec3d from{};               ///< m
  Vec3d to{};                 ///< m
  double radius = 0.0;        ///< m, > 0, at `from`
  double to_radius = radius;  ///< m, > 0, at `to`; linear in between
  Vec3d aside{};              ///< m, for a flat part: offset from the middle to either segment
};

/// The known shapes of body parts.
struct PartShapes {
  /// (parts) shapes in the order of BodyPart.
  std::array<std::optional<PartShape>, kBodyPartCount> shape{};

  /// The shape of a part, or nothing.
  [[nodiscard]] const std::optional<PartShape>& operator[](BodyPart part) const {
    return shape[static_cast<std::size_t>(part)];
  }
  /// Mutable access.
  [[nodiscard]] std::optional<PartShape>& operator[](BodyPart part) {
    return shape[static_cast<std::size_t>(part)];
  }
};

/// Corners of a sole (m, frame of the landmarks), counter-clockwise from above: left of the tip,
/// left of the heel, right of the heel, right of the tip.
using SoleOutline = std::array<Vec3d, 4>;

/// Joint centres and tips of a person in one posture, from which a body's geometry and start
/// posture are built. Metres, world: +Y up, facing +Z, left is +X, origin on the floor between the
/// feet.
struct Landmarks {
  /// Joints of a leg (m).
  struct Leg {
    Vec3d hip;    ///< centre of the joint
    Vec3d knee;   ///< centre of the joint
    Vec3d ankle;  ///< centre of the joint
    Vec3d toe;    ///< tip of the foot
    /// Joint of the toes, set for a character whose heels may lift; see toes_joint.
    std::optional<Vec3d> toes{};
    /// Sole of the shoe, at the height of its lowest point, for a character with a mesh; empty: by
    /// the stature.
    std::optional<SoleOutline> sole{};
  };
  /// Joints of an arm (m).
  struct Arm {
    Vec3d shoulder;                   ///< centre of the joint
    Vec3d elbow;                      ///< centre of the joint
    Vec3d wrist;                      ///< centre of the joint
    Vec3d fingertip;                  ///< tip of the third finger
    std::optional<Vec3d> clavicle{};  ///< its joint with the breastbone; empty: part of the trunk
    /// Grip of the hand, for a character from a file the nearest node; empty: see grip_of.
    std::optional<Vec3d> grip{};
  };
  Leg left_leg;    ///< the person's own left
  Leg right_leg;   ///< and right
  Arm left_arm;    ///< the person's own left
  Arm right_arm;   ///< and right
  Vec3d neck;      ///< base of the neck (C7)
  Vec3d head_top;  ///< vertex
  /// Joints of the spine, 0..3, from the lowest up. The paper's rigid trunk has none; a person from
  /// a file may lack some.
  std::vector<Vec3d> spine{};   ///< 0..3, from below
  std::optional<Vec3d> head{};  ///< between neck and skull
  /// Backward lean (rad) of the line from the hips to the shoulders in an upright trunk.
  double trunk_lean = 0.0;
  PartShapes parts{};  ///< part shapes measured on a mesh, if there is one

  /// The leg of a side.
  [[nodiscard]] const Leg& leg(Side side) const {
    return side == Side::left ? left_leg : right_leg;
  }
  /// Mutable access.
  [[nodiscard]] Leg& leg(Side side) { return side == Side::left ? left_leg : right_leg; }
  /// The arm of a side.
  [[nodiscard]] const Arm& arm(Side side) const {
    return side == Side::left ? left_arm : right_arm;
  }
  /// Mutable access.
  [[nodiscard]] Arm& arm(Side side) { return side == Side::left ? left_arm : right_arm; }
};

/// The point of an arm that goals are for: its grip, or the third knuckle.
[[nodiscard]] Vec3d grip_of(const Landmarks::Arm& arm);

/// The joint of the toes: the measured one, or the point at kToesShare of the way from the ankle to
/// the tip.
[[nodiscard]] Vec3d toes_joint(const Landmarks::Leg& leg);
/// Position of the toes' joint between the ankle and the tip of the foot, 0..1.
inline constexpr double kToesShare = 0.7;

/// Landmarks of a person standing upright at ease: knees bent by 5°, elbows by 10°, arms hanging,
/// each foot turned out by `toe_out` (rad).
[[nodiscard]] Landmarks standing_landmarks(double stature, double toe_out);

/// The extent of the moving body (table 1 of the paper).
enum class BodyExtent {
  half,  ///< 9 dof: right ankle 1, knee 1, hip 3, shoulder 3, elbow 1; left limbs count as mass
         ///< only
  full,  ///< 18 dof: both sides, on both feet
  /// 45 dof, 51 with the pelvis' six: also spine, neck, clavicles, forearms, wrists and the ankles'
  /// second dof, as far as the landmarks contain them.
  human,
};
/// The words of BodyExtent.
template <>
inline constexpr std::array kEnumWords<BodyExtent>{
    EnumWord{BodyExtent::half, "half"},
    EnumWord{BodyExtent::full, "full"},
    EnumWord{BodyExtent::human, "human"},
};

/// Settings of build_human.
struct HumanSettings {
  std::string name = "body";             ///< name of the body
  BodyExtent extent = BodyExtent::full;  ///< extent of the moving body
  double stature = 1.741;                ///< m
  double mass = 73.0;                    ///< kg
  Sex sex = Sex::male;                   ///< selects the tables of masses and strengths
  Side base = Side::right;               ///< fixed base foot if both feet stand
  /// Whether both feet stand even if one is more than kLiftedFoot above the other.
  bool on_both = false;
  bool sits = false;  ///< sits on both thighs, see build_human; not for half extent
  /// Whether heels may lift: the body then stands on its forefeet, and each foot turns about its
  /// toes' joint. Only for a standing body of extent human.
  bool heels = false;
};

/// Height (m) of a sole above the other one beyond which its foot counts as lifted.
inline constexpr double kLiftedFoot = 0.05;

/// Builds the body whose start posture has exactly these landmarks. Their distances become segment
/// lengths, and masses come from anthropometric tables by `mass` and `sex`. The trunk is rigid in
/// the shape of the start posture unless it has spine joints. The base is the foot of
/// settings.base, or the standing foot if the other is lifted (not for half extent). Joint limits
/// are widened to include the start posture, with a doubt. Half extent: the left leg's mass moves
/// with the right leg's translation, the left arm's with the trunk, and leg strengths count for
/// both legs (paper, section 3.1; numbers in docs/paper_map.md). A seated person has the right
/// thigh as the base and the left thigh in place of a foot: the pelvis tips over them and does not
/// turn otherwise. The lower legs are rigid with their thighs, and their soles, if on the floor,
/// are part of the support polygon.
[[nodiscard]] PosedBody build_human(const Landmarks& landmarks, const HumanSettings& settings,
                                    std::vector<Message> doubts = {});

/// Outward turn of each foot of the standing full body (rad): 14° between the feet (McIlroy and
/// Maki, Clinical Biomechanics 12 (1997) 66-70). The half body's foot points straight ahead.
inline constexpr double kStandingToeOut = radians(7.0);

/// Builds the half body with 9 dof, standing at ease (standing_landmarks). PreconditionError for a
/// stature or a mass out of range, as of the others below; open_character returns it as an Error.
[[nodiscard]] PosedBody half_body(const BodyBuild& build = {});
/// Builds the full body with 18 dof, standing at ease.
[[nodiscard]] PosedBody full_body(const BodyBuild& build = {});
/// Builds the human body with 45 dof, standing at ease.
[[nodiscard]] PosedBody human_body(const BodyBuild& build = {});

}  // namespace shigusa
