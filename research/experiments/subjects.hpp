// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/body.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <vector>

// Bodies and goals of the experiments, and the amount of measurement.
namespace shigusa::bench {

// Amount of measurement.
struct Plan {
  bool quick = false;           // to see that all runs, not for numbers
  std::uint64_t goal_seed = 1;  // of the goals that are drawn
  int goals = 30;               // drawn for each body
  int seeds = 32;               // default number of seeds of searches
  int few_seeds = 8;            // for long series
  int slow_seeds = 2;           // for slow motions
  int motions = 5000;           // delivered per body in the experiment on limits
  int human_goals = 10000;      // goals drawn for the body human
};
[[nodiscard]] Plan quick_plan();

// A goal position for the right hand.
struct Place {
  std::string name;
  Vec3d position{};  // m, world
};

// The goals of the project's reported findings.
[[nodiscard]] std::vector<Place> named_places();

// Uniform in a box around a standing person, reachable or not: 2.6 m wide and deep, 2.3 m high.
[[nodiscard]] Vec3d random_place(Random& random);

// `count` of these for which the independent method finds a posture; determined by the seed.
[[nodiscard]] std::vector<Vec3d> reachable_goals(const PosedBody& body, int count,
                                                 std::uint64_t seed);

// A body with its goals.
struct Subject {
  PosedBody posed;
  std::vector<Place> places;  // those drawn, and then the named ones
  std::size_t drawn = 0;      // how many were drawn
};
[[nodiscard]] Subject make_subject(const Plan& plan, const PosedBody& body);
// The half and the full body.
[[nodiscard]] std::vector<Subject> make_subjects(const Plan& plan);

// Values for all places of a subject; the summary is over the drawn ones.
[[nodiscard]] std::vector<double> of_drawn(const Subject& subject,
                                           const std::vector<double>& of_places);

}  // namespace shigusa::bench
