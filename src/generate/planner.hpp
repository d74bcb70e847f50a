// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <shigusa/generate.hpp>
#include <shigusa/progress.hpp>
#include <span>

#include "layers/plan.hpp"
#include "rollout/rollout.hpp"
#include "selection.hpp"

namespace shigusa {

// A point of a search with all that the layers below find for it.
struct Expanded {
  Parameters values;
  int searches = 0;  // that its arms took
};

// The motion of some values on one of the approaches to the goals.
struct Arrival {
  const ReachProblem* approach = nullptr;
  RolledOut rolled;
  bool as_searched = false;  // as the search scored it, which was in single precision
};

// What one search came to.
struct Found {
  SearchResult result;
  Selection choice;      // what is worth a replay
  Parameters best_seen;  // of the best of all points evaluated, kept or not
  double best_seen_score = 0.0;
};

// How a task's plan is searched and how its values become motions. An approach is one way in which
// effectors go to their goals; the first approach that leads there is the motion of some values,
// whichever approach they were found on. The task outlives it.
class Planner {
 public:
  virtual ~Planner() = default;

  [[nodiscard]] virtual std::span<const Layer> plan() const = 0;
  [[nodiscard]] virtual double duration() const = 0;
  // Whether the body can be at the goals; if not, approaches end at the closest point.
  [[nodiscard]] virtual bool in_reach() const = 0;

  // Fails where nothing is left to search, or what is fixed is not of the plan.
  [[nodiscard]] virtual Result<void> check_search() const = 0;

  // How many approaches there are, in the order in which they are tried.
  [[nodiscard]] virtual std::size_t approaches() const = 0;
  // At the edge of reach a goal may be met in a posture that hardly any motion leads to: goes by
  // the other posture of that number. Whether there is one.
  virtual bool go_by_other_posture(int other) = 0;

  // Searches on one approach. `task` differs from the planner's by criteria, budget or random
  // numbers at most.
  virtual Found search(const Task& task, std::size_t approach, const Progress& progress) = 0;
  // Of the last search's points.
  virtual Expanded expand(std::span<const double> point) = 0;

  // The motion of values on the first approach that leads to the goals, up to `last`.
  [[nodiscard]] virtual std::optional<Arrival> arrival(const Parameters& values,
                                                       std::size_t last) const = 0;
  // The same of all approaches; where none leads to the goals, the motion that comes nearest.
  [[nodiscard]] virtual Arrival nearest(const Parameters& values) const = 0;
  [[nodiscard]] virtual Candidate candidate(const Expanded& expanded, Arrival arrival) const = 0;

  // Takes care of what lasts beyond the search.
  virtual void finish(GenerateResult& generation) = 0;
};

// The planner of a task, which outlives it. Fails on a task that is wrong: see make_problem,
// plan_of.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_planner(const PreparedTask& task);
// Of a plan of one layer, and of several.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_whole_body_planner(const Task& task);
[[nodiscard]] Result<std::unique_ptr<Planner>> make_layered_planner(const Task& task);

// The same of a plan of several layers, where its layers can be made.
[[nodiscard]] Result<void> check_layers(const Task& task);
// Fails as make_planner and check_search do, at once.
[[nodiscard]] Result<void> check_plan(const PreparedTask& task);

}  // namespace shigusa
