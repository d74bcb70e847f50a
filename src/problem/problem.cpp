// SPDX-License-Identifier: MIT
#include "problem.hpp"

#include <utility>

#include "make_problem.hpp"
#include "plan_of.hpp"
#include "task_goals.hpp"

namespace shigusa {
namespace {

Result<std::unique_ptr<const Problem>> posed(Task task) {
  auto problem = std::make_unique<Problem>(std::move(task));
  SHG_TRY_ASSIGN(problem->reach, make_problem(problem->task));
  SHG_TRY_ASSIGN(problem->plan, plan_of(problem->task.body, problem->task.start, problem->task,
                                        problem->task.criteria));
  problem->parameters = std::make_shared<const ParameterList>(parameter_list(problem->plan));
  // given knees are in whatever proportion to the trunk they are
  if (fixed_value(*problem, "squat_rad")) {
    problem->task.criteria[CriterionKind::coordination].weight = 0.0;
  }
  return problem;
}

}  // namespace

std::optional<double> fixed_value(const Problem& problem, std::string_view name) {
  const std::optional<FixedParameters>& fixed = problem.task.fixed;
  const auto found = problem.parameters->find(name);
  if (!fixed || !found || *found >= fixed->set.size() || !fixed->set[*found]) return std::nullopt;
  return fixed->values.values[*found];
}

Result<std::unique_ptr<const Problem>> prepare(const Task& task) {
  SHG_TRY_ASSIGN(Task ready, standing(task));
  return posed(std::move(ready));
}

Result<std::unique_ptr<const Problem>> with_duration(const Problem& problem,
                                                     std::optional<double> duration) {
  Task task = problem.task;
  task.duration = duration;
  SHG_TRY_ASSIGN(auto other, posed(std::move(task)));
  other->way = problem.way.load();
  return other;
}

}  // namespace shigusa
