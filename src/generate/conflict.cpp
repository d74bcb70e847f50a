// SPDX-License-Identifier: MIT
#include "conflict.hpp"

#include <string>
#include <vector>

#include "core/say.hpp"
#include "problem/problem.hpp"
#include "problem/reachability.hpp"

namespace shigusa {
namespace {

bool in_reach(const Task& task) {
  const auto problem = prepare(task);
  return problem && closest_reach((*problem)->reach).reached();
}

// Whether a goal also asks for an orientation.
bool has_turn(const Goal& goal) { return goal.rotation || goal.axis; }

// The task without one goal, or without its turn.
Task without_goal(Task task, std::size_t g) {
  task.goals.erase(task.goals.begin() + static_cast<std::ptrdiff_t>(g));
  return task;
}
Task without_turn(Task task, std::size_t g) {
  task.goals[g].rotation.reset();
  task.goals[g].axis.reset();
  return task;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) text += k + 1 < names.size() ? ", " : " or ";
    text += names[k];
  }
  return text;
}

}  // namespace

Message conflict_of(const Task& task) {
  std::vector<std::string> goals;
  for (std::size_t g = 0; g < task.goals.size(); ++g) {
    const std::string& name = task.goals[g].effector;
    if (has_turn(task.goals[g]) && in_reach(without_turn(task, g))) {
      return say("turn_in_the_way", name);
    }
    if (task.goals.size() > 1 && in_reach(without_goal(task, g))) goals.push_back(name);
  }
  if (goals.empty()) return {};
  return goals.size() == 1 ? say("goal_in_the_way", goals.front())
                           : say("goals_in_the_way", joined(goals));
}

}  // namespace shigusa
