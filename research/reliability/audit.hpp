// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <shigusa/criteria.hpp>
#include <shigusa/request.hpp>
#include <string>
#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa::bench {

// rad, for rotations of goals, including the rounding of a file's digits
inline constexpr double kTurned = kTurnTolerance + 1e-4;
// rad, for feet and limits
inline constexpr double kTilted = 2e-3;
// m, for goals, feet, resting hands, seats
inline constexpr double kPlaced = 1e-3;
// m, for reported heights, from the same angles
inline constexpr double kTold = 1e-4;
// m, as capsules yield by kCollisionDepth, and only approximate the flesh
inline constexpr double kThroughFlesh = 0.010;
// m, for a bone's axis; obstacles are tested at ends and middles of limbs
inline constexpr double kBoneInBox = 0.020;
// Share of a joint's strength, between two methods of differentiation.
inline constexpr double kTorqueDiffers = 0.1;
// m, for the floor's pressure, between the same methods
inline constexpr double kPressureDiffers = 0.01;

// One promised figure: the worst value seen, and its bound.
enum class Promise {
  goal,
  turn,
  slide,
  tilt,
  limit,
  box,
  seat,
  heel,
  rest,
  on_box,
  torque,
};
struct PromiseInfo {
  const char* words;  // on the page
  const char* what;   // text for a violation
  double allowed;
  double scale;  // to the page's unit
  const char* unit;
};
[[nodiscard]] const PromiseInfo& info_of(Promise promise);
inline constexpr std::size_t kPromises = 11;

// Findings over many tasks.
struct Audit {
  int tasks = 0;
  int refused = 0;
  int candidates = 0;
  double seconds = 0.0;                 // spent on tasks
  std::map<std::string, int> statuses;  // by word
  std::map<std::string, int> verdicts;  // by word, of candidates
  std::map<std::string, int> best;      // by word, of the first candidates that meet their goals
  double worst[kPromises] = {};
  int over_limit = 0;                 // candidates that report exceeding a limit
  double head = -1.0;                 // m, deepest in the head, of those reported as free of
                                      // collisions
  double shank = -1.0;                // the same in shanks
  int fleshed = 0;                    // reported as free, of built-in bodies
  int through = 0;                    // of these, deeper than kThroughFlesh in either
  int resting = 0;                    // reported as free, with resting hands among obstacles
  int rest_through = 0;               // of these, hands that pass through their support on the way
  int torques = 0;                    // motions with independently computed torques
  std::vector<std::string> failures;  // violations, with the task

  void add(const Audit& part);
  void require(bool kept, const std::string& what);
  void most(Promise promise, double value, const std::string& of = {});

  std::string place;  // the task under judgement
};

}  // namespace shigusa::bench
