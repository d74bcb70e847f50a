// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/layered_settings.hpp>
#include <shigusa/parallel.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <shigusa/result.hpp>
#include <shigusa/search.hpp>
#include <utility>
#include <vector>

namespace shigusa {

/// A foot that neither stands nor has a goal lifts by this (m).
inline constexpr double kFootLift = 0.10;

/// A request on a body, with the settings of its run: `generate` takes it. Another preset's
/// criteria and number of candidates come by with_preset.
struct Task : Request {
  /// The request on that body.
  explicit Task(BodyModel of, Request asked = {})
      : Request(std::move(asked)), body(std::move(of)) {}

  BodyModel body;               ///< in its start posture
  SearchFunction own_search{};  ///< in the place of the named ones, when given; not of layers
  GeneticSettings genetic{};    ///< of the searches paper_ga and log_ga, which take the task's seed
  /// The values of fixed_assignments, decoded: the search leaves them as they are.
  std::optional<FixedParameters> fixed{};
  /// Of the preset flat: motions that are known to be good for tasks like this one, as
  /// Candidate::parameters of a body with the same freedoms. The search scores them first and
  /// begins beside the best, as it does with its own table of such motions; 16 of them take that
  /// table's place, fewer are put before it. None changes nothing.
  std::vector<Parameters> starts{};
  int most_runs = 10;        ///< of the preset paper, see generate; ≥ 1
  LayeredSettings layers{};  ///< of layered presets
  BatchSettings batch{};     ///< SIMD set and threads; change no result
};

/// Motions that are scored for a task that does not say how many, but for the paper's search.
[[nodiscard]] int usual_evaluations(const Task& task);

/// The search of a task: the method that it names, or its preset's.
[[nodiscard]] SearchMethod search_of(const Task& task);

/// The task by a preset, with its criteria and number of candidates.
[[nodiscard]] Task with_preset(Task task, Preset preset);

/// The criteria that the task's motions are scored by: its own, with the eyes on look_at, or on the
/// first goal of a limb, or between those of two hands, where nothing else is said.
[[nodiscard]] CriteriaSettings task_criteria(const Task& task);

/// The parameters of the motions that a request's preset makes for its goals on a body. Fails where
/// a preset of several layers does not know the body, a goal or supports.
[[nodiscard]] Result<ParameterList> parameter_list(const BodyModel& body, const Request& request);

/// Whether some posture of the task's body on its feet meets the goals: a quick look that may miss
/// one. Fails where a foot or a goal is not one that motions can have.
[[nodiscard]] Result<bool> seems_in_reach(const Task& task);

/// Notes on goals of hands that may be an oversight: in the body's own head or a foot, where these
/// are at the start, below the floor (y < 0), or nearer to it than the hand is thick. They refuse
/// nothing.
[[nodiscard]] std::vector<Message> goal_notes(const Task& task);

}  // namespace shigusa
