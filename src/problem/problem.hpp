// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <shigusa/request.hpp>
#include <utility>

#include "plan/plan.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// All that a task means for its body, derived once by `prepare` and const from there on.
struct Problem {
  Task task;  // its goals without loads, which the body holds; its body on its contacts
  CriteriaSettings criteria;                          // task_criteria
  Plan plan{};                                        // plan_of
  std::shared_ptr<const ParameterList> parameters{};  // the plan's
  ReachProblem reach{};                               // make_problem; points to the task's body

  explicit Problem(Task of) : task(std::move(of)), criteria(task_criteria(task)) {}
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;
};

// The problem of a task. Fails where a foot has no way to be what is asked of it, and as
// make_problem and plan_of do, in this order.
[[nodiscard]] Result<std::unique_ptr<const Problem>> prepare(const Task& task);

// The problem in another duration (s).
[[nodiscard]] Result<std::unique_ptr<const Problem>> with_duration(const Problem& problem,
                                                                   double duration);

}  // namespace shigusa
