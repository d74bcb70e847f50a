// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/request.hpp>
#include <string>
#include <vector>

#include "figures.hpp"

// Tasks whose best motions are compared with people's.
namespace shigusa::bench {

// One figure of a recorded reach, with its spread between people.
struct Known {
  double Figures::*figure;
  double value;
  double unit;
};

// One task. Lengths are scaled to a body of kUsualStature (m), as those of figures.
struct Case {
  Task task;
  Side side = Side::right;
  bool both = false;              // hands
  double height = 0.0;            // of the goal above the floor
  double ahead = 0.0;             // of the goal, from the ankles
  double aside = 0.0;             // of the goal, from the middle
  double rise = 0.0;              // of the grip, relative to its path: -1 straight down, 1 straight
                                  // up
  double arm = 0.0;               // of a level reach: distance in arm lengths
  bool straight = false;          // knees stay straight
  std::vector<Known> recorded{};  // of a person's reach; no other bands hold for it
};

// The quantity that changes from case to case of a series.
enum class Series { none, heights, near_and_far, distances, arms, sexes };

// Cases that are kept together, for training or held out as a whole.
struct Unit {
  std::string name;
  Series series = Series::none;
  std::vector<Case> cases{};
  bool held_out = false;
};

// Series of goals all around, for men and women, small, average and tall. Every fourth unit is held
// out. A seed displaces goals by a few centimetres.
[[nodiscard]] std::vector<Unit> made_units(std::uint64_t seed);

// Reaches of recorded persons (reaches.tsv of `people`) and of the man of `reach`, with their
// measured figures; empty, with a message, if the folder is missing. One person is held out, and
// every fourth reach of the man.
[[nodiscard]] std::vector<Unit> recorded_units(const std::filesystem::path& shared);

// Properties of a task, from its goals and the body at the start.
[[nodiscard]] Case case_of(Task task, Side side);

}  // namespace shigusa::bench
