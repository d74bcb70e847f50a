// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "subjects.hpp"

// The sections of docs/experiments.md, each measured and written by a file of its own.
namespace shigusa::bench {

// A picture of the page, which is written beside it.
struct Picture {
  std::string name;  // of its file, without .svg
  std::string svg;
};

// The preset flat against the paper's genetic algorithm.
[[nodiscard]] std::string against_paper(const Plan& plan, std::span<const Subject> subjects,
                                        std::vector<Picture>& pictures);
// The searches, and those of pagmo2 where it is there, on one problem.
[[nodiscard]] std::string against_searches(const Plan& plan, std::span<const Subject> subjects,
                                           std::vector<Picture>& pictures);
// Two layers against all parameters at once.
[[nodiscard]] std::string against_layers(const Plan& plan, std::span<const Subject> subjects);
// Candidates of both kinds for the goal at the feet.
[[nodiscard]] std::string stoop_and_squat(const Plan& plan, std::span<const Subject> subjects);
// Nonlinear programming in place of weighted inverse kinematics.
[[nodiscard]] std::string against_nlp(const Plan& plan, std::span<const Subject> subjects);
// Steps of a motion, and each parameter beside the weights left out.
[[nodiscard]] std::string what_earns_its_place(const Plan& plan, std::span<const Subject> subjects);
// Criteria, presets and parameters left out, each beside what people do; `program` is shigusa, and
// recorded people are looked for in `shared`.
[[nodiscard]] std::string what_criteria_buy(const Plan& plan, const std::string& program,
                                            const std::string& shared);
// The instructions that a motion takes with each of these; `program` is shigusa.
[[nodiscard]] std::string what_criteria_cost(const Plan& plan, const std::string& program);
// Limits, and goals that are met, over many random goals.
[[nodiscard]] std::string limits_and_goals(const Plan& plan);
// The best score at the default budget against the best that is known.
[[nodiscard]] std::string near_the_best(const Plan& plan);
// Time and memory of a default query; `program` is shigusa_query.
[[nodiscard]] std::string one_query(const Plan& plan, const std::string& program);

}  // namespace shigusa::bench
