// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body_model.hpp>
#include <shigusa/field.hpp>
#include <shigusa/quat.hpp>
#include <shigusa/result.hpp>
#include <shigusa/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

inline constexpr double kLoadMax = 500.0;  ///< kg

/// The body with a load (kg, 0..kLoadMax) at an effector's point, as if it were there in a point:
/// its weight and inertia count for torques, balance and the floor.
[[nodiscard]] BodyModel with_load(const BodyModel& body, int effector, double load);

/// A goal's and an obstacle's coordinates may not exceed this (m): nobody reaches so far, and
/// numbers stay harmless.
inline constexpr double kGoalRange = 100.0;

/// Something in the world that a body should not pass through: a box with round edges. One without
/// size is a sphere, one with size along a single axis a capsule.
struct Obstacle {
  std::string name;     ///< "table"
  Vec3d position{};     ///< m, world, of its middle
  Quatd rotation{};     ///< R_WO, a unit quaternion
  Vec3d size{};         ///< m, along its own axes, ≥ 0
  double radius = 0.0;  ///< m, ≥ 0, beyond the size on all sides
};

/// The fields of an obstacle.
template <>
inline constexpr FieldTable kFields<Obstacle>{
    "obstacle",
    "A box with round edges: without size_m a sphere, with size along one axis a capsule.",
    std::tuple{
        Field{"name", &Obstacle::name, "For messages.", {.written = always}},
        Field{"position_m",
              &Obstacle::position,
              "Its middle.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"size_m",
              &Obstacle::size,
              "Along its own axes.",
              {.high = kGoalRange, .written = always}},
        Field{"radius_m",
              &Obstacle::radius,
              "Of its round edges, beyond the size on all sides.",
              {.high = kGoalRange, .written = always}},
        Field{"rotation_xyzw",
              &Obstacle::rotation,
              "A unit quaternion.",
              {.mirroring = Mirroring::other_side, .written = always}},
    }};

/// The place of a support that is the thigh of the hand's own side.
inline constexpr std::string_view kThighPlace = "thigh";

/// A hand without a goal that rests on something, and may bear a part of the body's weight there.
struct Support {
  std::string effector = "left_hand";  ///< see BodyModel::find_effector
  std::string on{kThighPlace};         ///< kThighPlace, or an obstacle's name
  friend bool operator==(const Support&, const Support&) = default;
};

/// The fields of a support.
template <>
inline constexpr FieldTable kFields<Support>{
    "support", "A hand without a goal, and what it rests on.",
    std::tuple{
        Field{"effector",
              &Support::effector,
              "left_hand or right_hand.",
              {.required = true, .mirroring = Mirroring::other_side, .written = always}},
        Field{"on",
              &Support::on,
              "thigh: that of the hand's own side, a little above the knee; or the name of an "
              "obstacle.",
              {.required = true, .written = always}},
    }};

inline constexpr double kToleranceMax = 10.0;  ///< m

/// An axis of an effector and where it is to point. The effector's frame is the world's where the
/// body stands with every angle at 0, facing +Z, arms hanging with the thumbs ahead: of a hand
/// fingers point to -y, the thumb's side is +z, and the palm faces the body, +x of the right one.
struct GoalAxis {
  Vec3d axis{0, 0, 1};       ///< in the effector's frame; of any length but 0
  Vec3d direction{0, 1, 0};  ///< in the world; of any length but 0
  friend bool operator==(const GoalAxis&, const GoalAxis&) = default;
};

/// The fields of a goal's axis.
template <>
inline constexpr FieldTable kFields<GoalAxis>{
    "goal_axis", "An axis of the effector and the direction that it is to have.",
    std::tuple{
        Field{"axis",
              &GoalAxis::axis,
              "In the effector's own frame; of hands also by a word.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"direction",
              &GoalAxis::direction,
              "In the world.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
    }};

/// The final state of one effector.
struct Goal {
  std::string effector = "right_hand";  ///< see BodyModel::find_effector
  Vec3d position{};                     ///< m, shigusa's world
  double load = 0.0;                    ///< kg, 0..kLoadMax, held all the way
  /// How it is turned from the world's axes to its frame (see GoalAxis), a unit quaternion to
  /// within kUnitSlack; or one axis, about which it may turn. At most one of both.
  std::optional<Quatd> rotation{};
  std::optional<GoalAxis> axis{};  ///< the one axis
  /// m, ≥ 0: half the sides of the box about `position` where any place will do
  Vec3d tolerance{};
  friend bool operator==(const Goal&, const Goal&) = default;
};

/// The fields of a goal.
template <>
inline constexpr FieldTable kFields<Goal>{
    "goal", "The final place of one effector, and how it is turned there.",
    std::tuple{
        Field{"effector",
              &Goal::effector,
              "right_hand, left_foot, head, hips or another joint of the body: left or right "
              "shoulder, elbow, wrist, hip, knee, foot, toes, clavicle; spine, chest, neck; or the "
              "name of another node.",
              {.required = true, .mirroring = Mirroring::other_side, .written = always}},
        Field{"position_m",
              &Goal::position,
              "In the world.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"load_kg",
              &Goal::load,
              "The mass that a hand with a goal holds all the way.",
              {.high = kLoadMax,
               .option = "--load",
               .form = "EFFECTOR=KILOGRAMS",
               .group = OptionGroup::goal,
               .brief = "Mass that a hand with a goal holds all the way"}},
        Field{"rotation_xyzw",
              &Goal::rotation,
              "How the effector is turned at the end, a unit quaternion: from the world's axes, "
              "which its own are where the body stands upright facing +Z with arms hanging and "
              "thumbs ahead.",
              {.option = "--rotation",
               .form = "EFFECTOR=X,Y,Z,W",
               .group = OptionGroup::goal,
               .brief = "How the effector is turned at the end: a unit quaternion",
               .rare = true,
               .mirroring = Mirroring::other_side}},
        Field{"axis",
              &Goal::axis,
              "In place of a rotation: an axis of the effector and the direction that it is to "
              "have; the effector may turn about it.",
              {.mirroring = Mirroring::other_side}},
        Field{"tolerance_m",
              &Goal::tolerance,
              "Half the sides, along the world's axes, of a box about the goal: anywhere in it "
              "will do.",
              {.high = kToleranceMax,
               .option = "--tolerance",
               .form = "EFFECTOR=X,Y,Z",
               .group = OptionGroup::goal,
               .brief = "Half the sides of a box about the goal where any place will do"}},
    }};

/// An axis of a hand by its word, in the hand's frame (see GoalAxis): "palm" where it faces,
/// "thumb" along what it grips, to the thumb's side, "fingers" where they point. Fails on other
/// words, and on effectors that are no hands or wrists.
[[nodiscard]] Result<Vec3d> hand_axis(std::string_view word, std::string_view effector);
/// The words that hand_axis knows.
[[nodiscard]] std::span<const std::string> hand_axis_words();

/// A direction of the world by its word: "up", "down", "left", "right", "ahead" or "back", as the
/// body stands at the start; of a hand also "in", to the other hand's side, or "out".
[[nodiscard]] Result<Vec3d> direction_named(std::string_view word,
                                            std::string_view hand = "right_hand");
/// The words that direction_named knows.
[[nodiscard]] std::span<const std::string> direction_words();

/// The rotation that points axis `a` to `to_a`, and axis `b`, square to a, as nearly as that allows
/// to `to_b`. Fails where to_b is along to_a.
[[nodiscard]] Result<Quatd> rotation_pointing(const Vec3d& a, const Vec3d& to_a, const Vec3d& b,
                                              const Vec3d& to_b);

}  // namespace shigusa
