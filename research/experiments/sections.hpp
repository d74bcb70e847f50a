// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "subjects.hpp"

// Sections of docs/experiments.md, each measured and written by a file of its own.
namespace shigusa::bench {

// A picture, stored beside the page.
struct Picture {
  std::string name;  // of its file, without .svg
  std::string svg;
};

// The preset flat against the paper's genetic algorithm.
[[nodiscard]] std::string against_paper(const Plan& plan, std::span<const Subject> subjects,
                                        std::vector<Picture>& pictures);
// All searches, and those of pagmo2 if available, on one problem.
[[nodiscard]] std::string against_searches(const Plan& plan, std::span<const Subject> subjects,
                                           std::vector<Picture>& pictures);
// Two layers against all parameters at once.
[[nodiscard]] std::string against_layers(const Plan& plan, std::span<const Subject> subjects);
// Candidates of both kinds for the goal at the feet.
[[nodiscard]] std::string stoop_and_squat(const Plan& plan, std::span<const Subject> subjects);
// Nonlinear programming in place of weighted inverse kinematics.
[[nodiscard]] std::string against_nlp(const Plan& plan, std::span<const Subject> subjects);
// Ablation: fewer steps of a motion, and each parameter except the weights left out.
[[nodiscard]] std::string what_earns_its_place(const Plan& plan, std::span<const Subject> subjects);
// Ablation of criteria, presets and parameters, compared with people; `program`: shigusa; `shared`:
// folder of recorded people.
[[nodiscard]] std::string what_criteria_buy(const Plan& plan, const std::string& program,
                                            const std::string& shared);
// Instructions per motion in these variants; `program`: shigusa.
[[nodiscard]] std::string what_criteria_cost(const Plan& plan, const std::string& program);
// Limits, and goals reached, over many random goals.
[[nodiscard]] std::string limits_and_goals(const Plan& plan);
// Best score at the default budget against the best known one.
[[nodiscard]] std::string near_the_best(const Plan& plan);
// Time and memory of a default query; `program`: shigusa_query.
[[nodiscard]] std::string one_query(const Plan& plan, const std::string& program);

}  // namespace shigusa::bench
