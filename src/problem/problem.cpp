// SPDX-License-Identifier: MIT
#include "problem.hpp"

#include <utility>

#include "make_problem.hpp"
#include "plan_of.hpp"
#include "task_goals.hpp"

namespace shigusa {
namespace {

// Whether the user fixes this parameter of the whole body.
bool fixes(const Task& task, std::string_view name) {
  if (!task.fixed || traits_of(task.preset).layers) return false;
  const auto found = parameter_list(whole_body_plan(task.body, task.supports)).find(name);
  return found && *found < task.fixed->set.size() && task.fixed->set[*found];
}

Result<std::unique_ptr<const Problem>> posed(Task task) {
  if (fixes(task, "squat_rad")) {
    // given knees are in whatever proportion to the trunk they are
    task.criteria[CriterionKind::coordination].weight = 0.0;
  }
  auto problem = std::make_unique<Problem>(std::move(task));
  SHG_TRY_ASSIGN(problem->reach, make_problem(problem->task));
  SHG_TRY_ASSIGN(problem->plan, plan_of(problem->task.body, problem->task.start, problem->task,
                                        problem->task.criteria));
  problem->parameters = std::make_shared<const ParameterList>(parameter_list(problem->plan));
  return problem;
}

}  // namespace

Result<std::unique_ptr<const Problem>> prepare(const Task& task) {
  SHG_TRY_ASSIGN(Task ready, standing(task));
  return posed(std::move(ready));
}

Result<std::unique_ptr<const Problem>> with_duration(const Problem& problem, double duration) {
  Task task = problem.task;
  task.duration = duration;
  return posed(std::move(task));
}

}  // namespace shigusa
