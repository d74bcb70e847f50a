// SPDX-License-Identifier: MIT
#include <shigusa/generate.hpp>
#include <utility>

#include "attempt.hpp"
#include "candidate.hpp"
#include "conflict.hpp"
#include "core/say.hpp"
#include "delivery.hpp"
#include "other_durations.hpp"
#include "problem_search.hpp"

namespace shigusa {
namespace {

// Fails where the task asks for something that its preset does not support.
Result<void> check_choices(const Task& task) {
  const auto wrong = [&](const Message& what) {
    return fail(ErrorCode::invalid_argument, say("preset_cannot", word_of(task.preset), what));
  };
  if (task.pareto && task.preset != Preset::flat) return wrong(say("no_pareto"));
  if (!task.starts.empty() && task.preset != Preset::flat) return wrong(say("no_starts"));
  if (!traits_of(task.preset).layers) return {};
  if (task.generator != MotionGenerator::weighted_ik) return wrong(say("weighted_ik_only"));
  if (task.own_search) return wrong(say("no_own_search"));
  for (const Goal& goal : task.goals) {
    const auto index = task.body.find_effector(goal.effector);
    if (!index || *index < static_cast<int>(task.body.effectors().size())) continue;
    return wrong(say("hands_only"));
  }
  if (task.contacts) return wrong(say("feet_kept"));
  return {};
}

}  // namespace

void SearchLog::add_run(const SearchLog& other) {
  spend(other);
  runs += other.runs;
  generations += other.generations;
  near_copies += other.near_copies;
  missed += other.missed;
  replay_differs += other.replay_differs;
  replay_difference = max(replay_difference, other.replay_difference);
}

Result<PreparedTask> PreparedTask::of(const Task& task) {
  SHG_TRY(check_choices(task));
  SHG_TRY_ASSIGN(auto problem, prepare(task));
  SHG_TRY(check_values(*problem));
  return PreparedTask(std::move(problem));
}

const Task& PreparedTask::task() const { return problem_->task; }

Task played_task(Task task, const GenerateResult& generation) {
  if (generation.slowed || generation.gentled) task.duration = generation.duration;
  return task;
}

Result<GenerateResult> generate(const Task& task, const Progress& progress) {
  SHG_TRY_ASSIGN(const PreparedTask prepared, PreparedTask::of(task));
  return generate(prepared, progress);
}

Result<GenerateResult> generate(const PreparedTask& prepared, const Progress& progress) {
  const Problem& problem = prepared.problem();
  const Task& task = problem.task;
  JointProgress joint(progress);
  const PresetTraits& traits = traits_of(task.preset);
  const bool lanes = task.generator == MotionGenerator::weighted_ik;
  const bool on_all = traits.natural && lanes && !traits.layers && !task.pareto;
  SHG_TRY_ASSIGN(GenerateResult found, search_problem(problem, run_of(problem), joint.part(1.0),
                                                      on_all && !wants_one(task)));
  for (NextAttempt* const next : kAttempts) {
    const auto attempt = traits.natural ? next(problem, found) : std::nullopt;
    if (!attempt) continue;
    Result<GenerateResult> other = made(*attempt, problem, found, joint);
    if (!other) continue;
    other->slowed = attempt->duration.has_value();
    found = better_of(task, std::move(found), std::move(*other));
  }
  if (traits.natural && minds_jolts(task)) try_gentler(problem, found);
  check_possible_in(problem, on_all, joint, found);
  found.parameters = problem.parameters;
  if (!found.meets_goals()) found.conflict = conflict_of(task);
  return found;
}

}  // namespace shigusa
