// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/request.hpp>
#include <string>
#include <vector>

#include "figures.hpp"

// The tasks whose best motions are set beside people's.
namespace shigusa::bench {

// One figure of a recorded reach, and how far people are from one another in it.
struct Known {
  double Figures::*figure;
  double value;
  double unit;
};

// One task. Lengths are those of a body of kUsualStature, as figures have them (m).
struct Case {
  Task task;
  Side side = Side::right;
  bool both = false;              // hands
  double height = 0.0;            // of the goal above the floor
  double ahead = 0.0;             // of the goal, from the ankles
  double aside = 0.0;             // of the goal, from the middle
  double rise = 0.0;              // of the grip, over its way: -1 straight down, 1 straight up
  double arm = 0.0;               // of a level reach: how far it is, in arms
  bool straight = false;          // knees stay straight
  std::vector<Known> recorded{};  // of a person's reach; no other bands hold for it
};

// The quantity that changes from case to case of a series.
enum class Series { none, heights, near_and_far, distances, arms, sexes };

// Cases that belong together, and go to the training or are held out as a whole.
struct Unit {
  std::string name;
  Series series = Series::none;
  std::vector<Case> cases{};
  bool held_out = false;
};

// Series of goals all around, for men and women, small, usual and tall. Every fourth unit is held
// out. The same seed moves goals by the same few centimetres.
[[nodiscard]] std::vector<Unit> made_units(std::uint64_t seed);

// The reaches of recorded persons (reaches.tsv of `people`) and of the man of `reach`, with what
// was measured of them; nothing, and a message, where the folder is not there. One person is held
// out, and every fourth reach of the man.
[[nodiscard]] std::vector<Unit> recorded_units(const std::filesystem::path& shared);

// The task's facts, from its goals and the body at the start.
[[nodiscard]] Case case_of(Task task, Side side);

}  // namespace shigusa::bench
