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

inline constexpr double kLoadMax = 500.0;  ///< largest load, kg

/// Largest coordinate of goals and obstacles (m).
inline constexpr double kGoalRange = 100.0;

/// An obstacle: a box with rounded edges. Without size it is a sphere, with size along one axis a
/// capsule.
struct Obstacle {
  std::string name;     ///< "table"
  Vec3d position{};     ///< m, world, centre
  Quatd rotation{};     ///< R_WO, orientation, a unit quaternion
  Vec3d size{};         ///< m, side lengths along its own axes, without the radius, ≥ 0
  double radius = 0.0;  ///< m, ≥ 0, added to the size on all sides
};

/// Value of Support::on for the thigh on the hand's own side.
inline constexpr std::string_view kThighPlace = "thigh";

/// A hand without a goal that may rest on the thigh or an obstacle and bear part of the body's
/// weight there.
struct Support {
  std::string effector = "left_hand";  ///< see BodyModel::find_effector
  std::string on{kThighPlace};         ///< kThighPlace, or the name of an obstacle
  friend bool operator==(const Support&, const Support&) = default;
};

inline constexpr double kToleranceMax = 10.0;  ///< largest tolerance, m

/// An axis of an effector and its target direction. With all angles at 0, facing +Z and arms
/// hanging with thumbs ahead, the effector's frame is the world's: the fingers point to -y, the
/// thumb's side is +z, and the palm faces the body (+x for the right hand).
struct GoalAxis {
  Vec3d axis{0, 0, 1};       ///< in the effector's frame, non-zero
  Vec3d direction{0, 1, 0};  ///< in the world, non-zero
  friend bool operator==(const GoalAxis&, const GoalAxis&) = default;
};

/// The way of a thing in the hands: its middle goes straight, and it turns evenly.
struct Carry {
  Vec3d from{};       ///< m, world: middle of the thing at the start
  Quatd from_turn{};  ///< R_WT at the start
  Vec3d to{};         ///< m, world: middle at the end
  Quatd to_turn{};    ///< R_WT at the end
  friend bool operator==(const Carry&, const Carry&) = default;
};

/// The final state of one effector.
struct Goal {
  std::string effector = "right_hand";  ///< see BodyModel::find_effector
  Vec3d position{};                     ///< m, world
  double load = 0.0;                    ///< kg, 0..kLoadMax, held during the whole motion
  /// R_WE, target orientation (frame E: see GoalAxis), a unit quaternion to within kUnitSlack. At
  /// most one of `rotation` and `axis` is given.
  std::optional<Quatd> rotation{};
  /// Target direction of one axis, about which the effector may turn.
  std::optional<GoalAxis> axis{};
  /// Half the side lengths (m, ≥ 0) of the box about `position`, along the world's axes, in which
  /// any place meets the goal.
  Vec3d tolerance{};
  /// The thing to which the effector keeps its pose all the way; with a `rotation`.
  std::optional<Carry> carry{};
  /// m, world: a place that the effector passes on its way, without a stop.
  std::optional<Vec3d> via{};
  friend bool operator==(const Goal&, const Goal&) = default;
};

/// An axis of a hand by name, in the hand's frame (see GoalAxis): "palm", the direction the palm
/// faces; "thumb", along a gripped rod towards the thumb; "fingers", along the fingers. Fails on
/// other words, and on effectors that are not hands or wrists.
[[nodiscard]] Result<Vec3d> hand_axis(std::string_view word, std::string_view effector);
/// The names of hand_axis.
[[nodiscard]] std::span<const std::string> hand_axis_words();

/// A world direction by name: "up", "down", "left", "right", "ahead" or "back", as the body stands
/// at the start; for a hand also "in", towards the other hand's side, or "out". Fails on other
/// words.
[[nodiscard]] Result<Vec3d> direction_named(std::string_view word,
                                            std::string_view hand = "right_hand");
/// The names of direction_named.
[[nodiscard]] std::span<const std::string> direction_words();

/// The rotation that points axis `a` to `to_a`, and axis `b`, perpendicular to a, as nearly as
/// possible to `to_b`. Fails if to_b is parallel to to_a.
[[nodiscard]] Result<Quatd> rotation_pointing(const Vec3d& a, const Vec3d& to_a, const Vec3d& b,
                                              const Vec3d& to_b);

}  // namespace shigusa
