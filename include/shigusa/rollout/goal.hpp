// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body/load.hpp>
#include <shigusa/body/obstacle.hpp>
#include <shigusa/core/field.hpp>
#include <shigusa/math/quat.hpp>
#include <shigusa/math/vec3.hpp>
#include <string>

namespace shigusa {

inline constexpr double kToleranceMax = 10.0;  // m

// An axis of an effector and where it is to point. The effector's frame is the world's where the
// body stands with every angle at 0, facing +Z, arms hanging with the thumbs ahead: of a hand
// fingers point to -y, the thumb's side is +z, and the palm faces the body, +x of the right one.
struct GoalAxis {
  Vec3d axis{0, 0, 1};       // in the effector's frame; of any length but 0
  Vec3d direction{0, 1, 0};  // in the world; of any length but 0
  friend bool operator==(const GoalAxis&, const GoalAxis&) = default;
};

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

// The final state of one effector.
struct Goal {
  std::string effector = "right_hand";  // see BodyModel::find_effector
  Vec3d position{};                     // m, shigusa's world
  double load = 0.0;                    // kg, 0..kLoadMax, held all the way
  // How it is turned from the world's axes to its frame (see GoalAxis), a unit quaternion to within
  // kUnitSlack; or one axis, about which it may turn. At most one of both.
  std::optional<Quatd> rotation{};
  std::optional<GoalAxis> axis{};  // the one axis
  Vec3d tolerance{};  // m, ≥ 0: half the sides of the box about `position` where any place will do
  friend bool operator==(const Goal&, const Goal&) = default;
};

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
              {.high = kLoadMax, .option = "--load", .form = "EFFECTOR=KILOGRAMS"}},
        Field{"rotation_xyzw",
              &Goal::rotation,
              "How the effector is turned at the end, a unit quaternion: from the world's axes, "
              "which its own are where the body stands upright facing +Z with arms hanging and "
              "thumbs ahead.",
              {.option = "--rotation",
               .form = "EFFECTOR=X,Y,Z,W",
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
              {.high = kToleranceMax, .option = "--tolerance", .form = "EFFECTOR=X,Y,Z"}},
    }};

}  // namespace shigusa
