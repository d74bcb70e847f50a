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

// The parameter values of a search point, including the results of the layers below.
struct Expanded {
  Parameters values;
  int searches = 0;  // arm searches made for the values
};

// The motion of parameter values on one of the approaches to the goals.
struct Arrival {
  const ReachProblem* approach = nullptr;
  RolledOut rolled;
  bool as_searched = false;  // as scored by the search, apart from single precision
};

// The result of one search.
struct Found {
  SearchResult result;
  Selection selection;  // the points to replay
  // The values of the best point evaluated, kept or not; none if the task wants one motion.
  std::optional<Parameters> best_seen;
  double best_seen_score = 0.0;
};

// Searches a problem's plan, and makes motions of parameter values. An approach is one manner in
// which effectors go to their goals; the motion of given values is the one on the first approach
// that arrives, whichever approach they were found on. The problem outlives the planner.
class Planner {
 public:
  virtual ~Planner() = default;

  // Whether the goals are in reach; if not, approaches end at the closest point.
  [[nodiscard]] virtual bool in_reach() const = 0;

  // The number of approaches, which are tried in order.
  [[nodiscard]] virtual std::size_t approaches() const = 0;
  // Switches the approaches to another posture by its number, if there is one: at the edge of reach
  // a goal may be met in a posture that few motions lead to.
  virtual bool go_by_other_posture(int other) = 0;

  // Searches on one approach.
  virtual Found search(const RunSettings& run, std::size_t approach, const Progress& progress) = 0;
  // Expands a point of the last search to values.
  virtual Expanded expand(std::span<const double> point) = 0;

  // The motion of the values on the first approach, up to `last`, that leads to the goals.
  [[nodiscard]] virtual std::optional<Arrival> arrival(const Parameters& values,
                                                       std::size_t last) const = 0;
  // The motion of the values on the first of all approaches that leads to the goals; else the
  // nearest motion.
  [[nodiscard]] virtual Arrival nearest(const Parameters& values) const = 0;
  [[nodiscard]] virtual Candidate candidate(const Expanded& expanded, Arrival arrival) const = 0;

  // Stores the data that outlasts the search.
  virtual void finish(GenerateResult& generation) = 0;
};

// The planner of a problem, which outlives it. Fails if a hand cannot reach the place on which it
// is to rest.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_planner(const Problem& problem);
// The planners for a plan of one layer, and for a plan of several.
[[nodiscard]] Result<std::unique_ptr<Planner>> make_whole_body_planner(const Problem& problem);
[[nodiscard]] std::unique_ptr<Planner> make_layered_planner(const Problem& problem);

// Fails if the fixed parameters leave nothing to search, or if fixed parameters or start values do
// not fit the plan.
[[nodiscard]] Result<void> check_values(const Problem& problem);

}  // namespace shigusa
