// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <shigusa/request.hpp>
#include <string_view>
#include <utility>

#include "plan/plan.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Everything derived from a task and its body, by `prepare`, and const from then on, but for
// `way`.
struct Problem {
  Task task;    // goals without loads, which the body holds; the body stands on its contacts
  Plan plan{};  // plan_of
  std::shared_ptr<const ParameterList> parameters{};  // the plan's
  ReachProblem reach{};                               // make_problem; refers to the task's body

  // Number of the way to the goals, of several, which the first planner chooses; the same in each
  // duration, so that a motion that is played slower goes the same way.
  static constexpr int kNoWay = -1;
  mutable std::atomic<int> way = kNoWay;

  explicit Problem(Task of) : task(std::move(of)) {}
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;
};

// The value at which the task fixes a parameter of its plan; none if the search is free in it.
[[nodiscard]] std::optional<double> fixed_value(const Problem& problem, std::string_view name);

// The problem of a task. Fails if a foot cannot do as the task asks, and as make_problem and
// plan_of do, in this order.
[[nodiscard]] Result<std::unique_ptr<const Problem>> prepare(const Task& task);

// The problem in another duration (s); none: the usual one.
[[nodiscard]] Result<std::unique_ptr<const Problem>> with_duration(const Problem& problem,
                                                                   std::optional<double> duration);

}  // namespace shigusa
