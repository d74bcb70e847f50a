// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/math.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The quantity that is increased or decreased until a task is no longer possible.
enum class LimitKind {
  /// kg, sum of the loads in the hands with goals, in their own proportion, or evenly; of a task
  /// with actions the mass of a thing
  load,
  lowest,    ///< m, height of the goals' middle; all goals move together
  highest,   ///< m, height of the goals' middle; all goals move together
  farthest,  ///< m, horizontal distance of the goals' middle from that of the feet, in its
             ///< direction
};
/// The words of LimitKind.
template <>
inline constexpr std::array kEnumWords<LimitKind>{
    EnumWord{LimitKind::load, "heaviest load"},
    EnumWord{LimitKind::lowest, "lowest place"},
    EnumWord{LimitKind::highest, "highest place"},
    EnumWord{LimitKind::farthest, "farthest place"},
};
/// The unit of a limit: "kg" or "m".
[[nodiscard]] std::string_view limit_unit(LimitKind kind);

/// The share of a limit by which both of its sides are verified.
inline constexpr double kSharpMargin = 0.05;
/// Largest number of seeds.
inline constexpr int kLimitSeedsMax = 20;

/// The settings of find_limit.
struct LimitSettings {
  LimitKind kind = LimitKind::load;  ///< what is varied
  /// Highest total score that still counts; empty: the verdict `possible` alone decides.
  std::optional<double> score{};
  /// The last value tried (kg or m): for a load above 0 and up to kLoadMax, else beyond the task's
  /// own place. Empty: 100 kg, the floor, 1.5 statures of height, 1 stature of distance.
  std::optional<double> bound{};
  int seeds = 5;  ///< 1..kLimitSeedsMax: the task's seed and those that follow it
  /// Of a task with actions: the thing whose mass is varied; empty: the first that is grasped.
  std::string thing{};
};

/// How the search for a limit ended.
enum class LimitEnd {
  found,    ///< the limit lies within the range
  beyond,   ///< the last value of the range still holds: `value` is that bound
  nowhere,  ///< no value tried holds; `value` is the first one
};

/// The words of LimitEnd.
template <>
inline constexpr std::array kEnumWords<LimitEnd>{
    EnumWord{LimitEnd::found, "found"},
    EnumWord{LimitEnd::beyond, "beyond"},
    EnumWord{LimitEnd::nowhere, "nowhere"},
};

/// The limit of a task for one body.
struct Limit {
  LimitKind kind = LimitKind::load;  ///< what was varied
  LimitEnd end = LimitEnd::nowhere;  ///< how the search ended
  double value = 0.0;                ///< kg or m
  /// Whether all seeds hold just within kSharpMargin (of a place at least 1 cm) of the limit, and
  /// none at as much beyond it. If not, all hold within, as a rule, and some beyond: the limit is
  /// the lower end of a range in which the verdict depends on the search.
  bool sharp = false;
  /// A value beyond the limit at which the first seed holds again: the verdict is not monotone.
  std::optional<double> again{};
  bool out_of_reach = false;       ///< whether goals beyond the limit are out of reach
  std::optional<Reason> reason{};  ///< worst reason of the nearest trial beyond, if it is reached
  int trials = 0;                  ///< searches made, one for each value and seed
};

/// Finds the limit of a task: of each value, `seeds` searches as generate() or, of a task with
/// actions, perform() makes them.
///   1. The range, from an empty load or the task's own place to the bound, is tried at 13 values
///      with the first seed. The limit lies where the values from the first that holds end to hold.
///   2. Bisection to 2 % of the value, or 2 mm: a value holds if most of the seeds hold.
///   3. Both sides are verified with all seeds at 0.6 of kSharpMargin, so that other seeds agree at
///      the whole of it: the limit moves inwards until all hold that were tried within, else
///      outwards while any holds beyond (see Limit::sharp).
/// A seed holds if its first candidate reaches the goals, is possible, and scores at most
/// LimitSettings::score. Same task, same result, for any number of threads (Task::batch). Fails on
/// a task without goals and actions, on a load without a goal of a hand or a grasp, on other limits
/// of actions, on settings out of range, as generate() and perform() do, and with
/// ErrorCode::cancelled.
[[nodiscard]] Result<Limit> find_limit(const Task& task, const LimitSettings& settings,
                                       const Progress& progress = {});

inline constexpr double kSpacingMin = 0.005;          ///< smallest spacing of a map, m
inline constexpr double kSpacingMax = 1.0;            ///< largest spacing of a map, m
inline constexpr std::size_t kPlacesMax = 1'000'000;  ///< largest number of places of a map

/// The settings of reach_map.
struct MapSettings {
  double spacing = 0.1;  ///< m, kSpacingMin..kSpacingMax, between neighbouring places
  /// m, world: corners of the box of places. Empty: a box about the body of 1.6 lengths of the
  /// goal's limb to each side, from the floor to a length above the limb's root.
  std::optional<Vec3d> low{};
  std::optional<Vec3d> high{};  ///< see low
};

/// The cost of a place.
struct MapPlace {
  std::optional<Verdict> verdict{};  ///< of the best motion found; empty: out of reach
  double score = 0.0;                ///< total score of that motion
  double strength = 0.0;             ///< largest torque as a share of its joint's strength
  int dof = -1;                      ///< dof of that torque; -1 out of reach
  double duration = 0.0;             ///< s
  std::optional<int> reba{};         ///< worst score by REBA; empty out of reach or without arms
};

/// The costs of places on a grid.
struct ReachMap {
  std::string effector;            ///< name of the effector that goes there
  Vec3d low{};                     ///< m, world: the first place
  double spacing = 0.0;            ///< m
  std::array<int, 3> count{};      ///< number of places along x, y and z
  std::vector<MapPlace> places{};  ///< (x × y × z), z varying fastest
  long long evaluations = 0;       ///< motions scored

  /// Position (m, world) of a place by its index.
  [[nodiscard]] Vec3d position(std::size_t place) const;
  /// Index of a place by its numbers along x, y and z.
  [[nodiscard]] std::size_t at(int x, int y, int z) const;
  /// Coordinate (m) of a plane of places.
  [[nodiscard]] double coordinate(Axis axis, int k) const;
  /// Number along an axis of the plane nearest to a coordinate (m); nothing if that is more than
  /// half a spacing outside the map.
  [[nodiscard]] std::optional<int> plane(Axis axis, double coordinate) const;
};

/// Computes what the places about a body cost its first goal's effector, REBA by Task::ergonomics.
/// The task's other fields, other goals among them, stay as they are, and the first goal's own
/// position is ignored. Places out of reach (seems_in_reach) are not searched. The others are
/// searched from a coarse grid to the finest, each from the motions of places around it: where one
/// of these does as well, it is taken, else few motions are searched. So scores are upper bounds,
/// and verdicts near an edge may differ from those of generate(). Same task, same map, for any
/// number of threads (Task::batch). Fails on a task with actions, without goals, or of a preset
/// other than flat, on settings out of range, as generate() does, and with ErrorCode::cancelled.
[[nodiscard]] Result<ReachMap> reach_map(const Task& task, const MapSettings& settings = {},
                                         const Progress& progress = {});

}  // namespace shigusa
