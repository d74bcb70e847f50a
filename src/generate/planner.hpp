// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <span>

#include "plan/plan.hpp"
#include "problem/task_search.hpp"
#include "rollout/rollout.hpp"
#include "selection.hpp"

namespace shigusa {

// The values of a search's point, with all that the layers below find for it.
struct Expanded {
  Parameters values;
  int searches = 0;  // that the arms took for it
};

// The motion of some values on one of the approaches to the goals.
struct Arrival {
  const ReachProblem* approach = nullptr;
  RolledOut rolled;
  bool as_searched = false;  // as the search scored it, which was in single precision
};

// The result of one search.
struct Found {
  SearchResult result;
  Selection selection;   // the points that are worth a replay
  Parameters best_seen;  // the values of the best of all points evaluated, kept or not
  double best_seen_score = 0.0;
};

// Searches a problem's plan, and makes motions of its values. An approach is one manner in which
// effectors go to their goals; the motion of some values is the one on the first approach that
// leads there, whichever approach they were found on. The problem outlives the planner.
class Planner {
 public:
  virtual ~Planner() = default;

  // Whether the body can be at the goals; if not, approaches end at the closest point.
  [[nodiscard]] virtual bool in_reach() const = 0;

  // How many approaches there are, in the order in which they are tried.
  [[nodiscard]] virtual std::size_t approaches() const = 0;
  // Takes the other posture of that number for its approaches, if there is one: at the edge of
  // reach a goal may be met in a posture that hardly any motion leads to.
  virtual bool go_by_other_posture(int other) = 0;

  // Searches on one approach.
  virtual Found search(const RunSettings& run, std::size_t approach, const Progress& progress) = 0;
  // Finds the values of a point of the last search.
  virtual Expanded expand(std::span<const double> point) = 0;

  // The motion of values on the first approach that leads to the goals, up to `last`.
  [[nodiscard]] virtual std::optional<Arrival> arrival(const Parameters& values,
                                                       std::size_t last) const = 0;
  // The motion of values on the first of all approaches that leads to the goals; where none does,
  // the motion that comes nearest.
  [[nodiscard]] virtual Arrival nearest(const Parameters& values) const = 0;
  [[nodiscard]] virtual Candidate candidate(const Expanded& expanded, Arrival arrival) const = 0;

  // Stores whatever lasts beyond the search.
  virtual void finish(GenerateResult& generation) = 0;
};

// The planner of a problem, which outlives it. Fails where a hand does not reach the place on which
// it is to rest.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_planner(const Problem& problem);
// The planners of a plan of one layer, and of a plan of several.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_whole_body_planner(const Problem& problem);
[[nodiscard]] std::unique_ptr<Planner> make_layered_planner(const Problem& problem);

// Fails where what a person fixed leaves nothing to search, or where that or what is to be begun
// with is not of the plan.
[[nodiscard]] Result<void> check_values(const Problem& problem);

}  // namespace shigusa
