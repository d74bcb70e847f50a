// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

inline constexpr std::size_t kActionsMax = 64;  ///< largest number of actions
inline constexpr std::size_t kThingsMax = 64;   ///< largest number of things
inline constexpr std::size_t kPartsMax = 8;     ///< largest number of a thing's parts
inline constexpr double kPauseMax = 60.0;       ///< longest hold or wait of an action, s

/// The shape of a thing, whose sides are Thing::size.
enum class ThingShape {
  box,       ///< its sides along its own axes
  cylinder,  ///< upright: diameter, height, diameter
  sphere,    ///< three times its diameter
};
/// The words of ThingShape.
template <>
inline constexpr std::array kEnumWords<ThingShape>{
    EnumWord{ThingShape::box, "box"},
    EnumWord{ThingShape::cylinder, "cylinder"},
    EnumWord{ThingShape::sphere, "sphere"},
};

/// A box of which a thing is made, with others.
struct ThingPart {
  Vec3d position{};           ///< m, its middle from the thing's middle, along the thing's own axes
  Vec3d size{0.1, 0.1, 0.1};  ///< m, its sides along the thing's own axes, > 0
  friend bool operator==(const ThingPart&, const ThingPart&) = default;
};

/// A bar of a thing, around which a hand closes.
struct ThingHandle {
  Vec3d position{};      ///< m, middle of the bar from the thing's middle, along its own axes
  Vec3d along{0, 1, 0};  ///< direction of the bar in the thing's own axes, non-zero
  friend bool operator==(const ThingHandle&, const ThingHandle&) = default;
};

/// A rigid body that hands can grasp, carry and put down. Its density is even, but for `centre`.
struct Thing {
  std::string name{};                  ///< "box"
  ThingShape shape = ThingShape::box;  ///< its form
  Vec3d size{0.1, 0.1, 0.1};           ///< m, sides along its own axes, > 0
  double mass = 0.0;                   ///< kg, 0..kLoadMax
  Vec3d position{};                    ///< m, world: its middle at the start
  double turn_deg = 0.0;               ///< degrees about +Y from the world's axes, at the start
  Vec3d centre{};                      ///< m, centre of mass from the middle, along its own axes
  bool upright = false;  ///< keeps its upright axis upright in the hand, such as a cup
  std::optional<ThingHandle> handle{};  ///< a bar outside its shape, by which one hand takes it
  std::vector<ThingPart> parts{};       ///< boxes within a box that are its form; empty: all of it
  friend bool operator==(const Thing&, const Thing&) = default;
};

/// A place on the floor and a direction there.
struct Stance {
  double x = 0.0;           ///< m, world: middle of the feet, or of the seat
  double z = 0.0;           ///< m, world
  double facing_deg = 0.0;  ///< degrees from +Z, growing to the left
  double height = 0.45;     ///< m, of a seat
  friend bool operator==(const Stance&, const Stance&) = default;
};

/// The kinds of actions.
enum class ActionKind {
  goals,    ///< effectors go to their goals; goals alone also look
  wait,     ///< the body stays as it is
  grasp,    ///< hands take a thing and lift it
  place,    ///< a thing in the hands is put somewhere
  release,  ///< hands let a thing go where it is
  stand,    ///< the body stands up straight
  sit,      ///< the body sits down
};
/// The words of ActionKind.
template <>
inline constexpr std::array kEnumWords<ActionKind>{
    EnumWord{ActionKind::goals, "goals"},     EnumWord{ActionKind::wait, "wait_s"},
    EnumWord{ActionKind::grasp, "grasp"},     EnumWord{ActionKind::place, "place"},
    EnumWord{ActionKind::release, "release"}, EnumWord{ActionKind::stand, "stand"},
    EnumWord{ActionKind::sit, "sit"},
};

/// One of the actions that follow each other. Of goals, wait, grasp, place, release, stand and sit
/// one is given.
struct Action {
  std::vector<Goal> goals{};         ///< as Request::goals
  std::optional<Vec3d> look_at{};    ///< m, world: the point that the eyes are on
  std::string grasp{};               ///< name of the thing that hands take and lift
  std::vector<std::string> with{};   ///< the hands that take it; empty: by its size and mass
  std::string place{};               ///< name of the thing that is put to `position`
  std::optional<Vec3d> position{};   ///< m, world: middle of the thing there
  double turn_deg = 0.0;             ///< degrees about +Y from the world's axes, of the thing there
  std::string release{};             ///< name of the thing that is let go
  std::optional<Stance> stand{};     ///< where to stand
  std::optional<Stance> sit{};       ///< where to sit
  std::optional<double> wait{};      ///< s, for which the body stays as it is
  double hold = 0.0;                 ///< s, for which it stays at its end
  bool via = false;                  ///< goals are passed without a stop
  std::optional<double> duration{};  ///< s, of its main motion; empty: by the distance
  friend bool operator==(const Action&, const Action&) = default;
};

/// The kind of an action; nothing where it is none or more than one.
[[nodiscard]] std::optional<ActionKind> kind_of(const Action& action);

}  // namespace shigusa
