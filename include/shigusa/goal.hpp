// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
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

/// The place of a support that is the thigh of the hand's own side.
inline constexpr std::string_view kThighPlace = "thigh";

/// A hand without a goal that rests on something, and may bear a part of the body's weight there.
struct Support {
  std::string effector = "left_hand";  ///< see BodyModel::find_effector
  std::string on{kThighPlace};         ///< kThighPlace, or an obstacle's name
  friend bool operator==(const Support&, const Support&) = default;
};

inline constexpr double kToleranceMax = 10.0;  ///< m

/// An axis of an effector and where it is to point. The effector's frame is the world's where the
/// body stands with every angle at 0, facing +Z, arms hanging with the thumbs ahead: of a hand
/// fingers point to -y, the thumb's side is +z, and the palm faces the body, +x of the right one.
struct GoalAxis {
  Vec3d axis{0, 0, 1};       ///< in the effector's frame; of any length but 0
  Vec3d direction{0, 1, 0};  ///< in the world; of any length but 0
  friend bool operator==(const GoalAxis&, const GoalAxis&) = default;
};

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
