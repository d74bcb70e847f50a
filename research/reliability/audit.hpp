// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <shigusa/criteria.hpp>
#include <shigusa/request.hpp>
#include <string>
#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa::bench {

// rad: of goals' turns, with what a file's digits leave open
inline constexpr double kTurned = kTurnTolerance + 1e-4;
// rad: of feet and limits
inline constexpr double kTilted = 2e-3;
// m: of goals, feet, hands that rest, seats
inline constexpr double kPlaced = 1e-3;
// m: of heights that are told, by the same angles
inline constexpr double kTold = 1e-4;
// m: capsules give way by kCollisionDepth, and their shape is not the flesh's
inline constexpr double kThroughFlesh = 0.010;
// m: of a bone's own line; an obstacle is asked about ends and middles of limbs
inline constexpr double kBoneInBox = 0.020;
// Share of a joint's strength, between two ways to differentiate.
inline constexpr double kTorqueDiffers = 0.1;
// m: of the floor's pressure, between the same
inline constexpr double kPressureDiffers = 0.01;

// One figure that is promised: the worst that was seen, and how bad it may be.
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
  const char* what;   // where it is not kept
  double allowed;
  double scale;  // of the page's unit
  const char* unit;
};
[[nodiscard]] const PromiseInfo& info_of(Promise promise);
inline constexpr std::size_t kPromises = 11;

// The findings of many tasks.
struct Audit {
  int tasks = 0;
  int refused = 0;
  int candidates = 0;
  double seconds = 0.0;                 // that tasks took
  std::map<std::string, int> statuses;  // by word
  std::map<std::string, int> verdicts;  // by word, of candidates
  std::map<std::string, int> best;      // … of the first candidates that meet their goals
  double worst[kPromises] = {};
  int over_limit = 0;                 // candidates that tell of a limit that they pass
  double head = -1.0;                 // m, the deepest in the head of what is told as free …
  double shank = -1.0;                // … and in shanks
  int fleshed = 0;                    // told as free, of built-in bodies
  int through = 0;                    // … and deeper than kThroughFlesh in either
  int resting = 0;                    // told as free, with hands that rest among obstacles
  int rest_through = 0;               // … whose hand goes through what it rests on, on its way
  int torques = 0;                    // motions whose torques were computed anew
  std::vector<std::string> failures;  // what was promised and not kept, with the task

  void add(const Audit& part);
  void require(bool kept, const std::string& what);
  void most(Promise promise, double value, const std::string& of = {});

  std::string place;  // the task that is judged
};

}  // namespace shigusa::bench
