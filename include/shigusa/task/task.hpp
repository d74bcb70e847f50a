// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/core/result.hpp>
#include <shigusa/layers/layered_settings.hpp>
#include <shigusa/layers/plan.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/rollout/parameters.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/task/request.hpp>
#include <utility>

namespace shigusa {

// A foot that neither stands nor has a goal lifts by this (m).
inline constexpr double kFootLift = 0.10;

/// A request on a body, with the settings of its run: `generate` takes it. Another preset's
/// criteria and number of candidates come by with_preset.
struct Task : Request {
  explicit Task(BodyModel of, Request asked = {})
      : Request(std::move(asked)), body(std::move(of)) {}

  BodyModel body;
  SearchFunction own_search{};  // in the place of the named ones, when given; not of layers
  GeneticSettings genetic{};    // of the searches paper_ga and log_ga, which take the task's seed
  // The values of fixed_assignments, decoded: the search leaves them as they are.
  std::optional<FixedParameters> fixed{};
  int most_runs = 10;        // of the preset paper, see generate; ≥ 1
  LayeredSettings layers{};  // of layered presets
  BatchSettings batch{};     // SIMD set and threads; change no result
};

// Motions that are scored for a task that does not say how many, but for the paper's search.
[[nodiscard]] int usual_evaluations(const Task& task);

// What searches for a task: the method that it names, or its preset's.
[[nodiscard]] SearchMethod search_of(const Task& task);

// The task by a preset, with its criteria and number of candidates.
[[nodiscard]] Task with_preset(Task task, Preset preset);

// What the task's motions are scored by: its criteria, with the eyes on look_at, or on the first
// goal of a limb where nothing else is said.
[[nodiscard]] CriteriaSettings task_criteria(const Task& task);

// The plan that a preset has for a body's goals; `criteria` are those of its layers. Fails where a
// preset of several layers does not know the body or a goal (layers_to_goals).
[[nodiscard]] Result<Plan> plan_of(const BodyModel& body, std::span<const Goal> goals,
                                   Preset preset, LayerReading reading,
                                   const CriteriaSettings& criteria = {});
[[nodiscard]] Result<Plan> plan_of(const Task& task);

// The task with its goals' loads in the body's hands, standing on its contacts; fails as
// make_problem does, and where a foot has no way to be what is asked of it.
[[nodiscard]] Result<Task> prepared(const Task& task);
// Whether that is another task.
[[nodiscard]] bool needs_preparing(const Task& task);

// The problem that a task poses to the search: paths from the start posture to the goals, and the
// time for them. Fails with a message that names the goal and what is allowed: unknown effector
// (with the nearest name), two goals for one effector, coordinates that are not finite or beyond
// kGoalRange, no goal at all, a duration outside 0.05 to 60 s, criteria weights below 0 or all 0,
// phases that the preset does not know or that a fixed parameter is not of, a load, an obstacle, a
// rotation, an axis or a box out of range, more goals than kMaxIkRows allows.
// The problem points into the task.
[[nodiscard]] Result<ReachProblem> make_problem(const Task& task);

}  // namespace shigusa
