// SPDX-License-Identifier: MIT
#include "fitted.hpp"

#include <shigusa/files.hpp>

#include "core/check.hpp"
#include "measures.hpp"
#include "plan/assignment.hpp"
#include "plan/held_input.hpp"
#include "plan/plan.hpp"
#include "problem/make_problem.hpp"
#include "rollout/rollout.hpp"
#include "search/cma_es.hpp"

namespace shigusa::bench {
namespace {

constexpr double kMissed = 10.0;  // rad: worse than any that arrives

std::vector<bool> moving_points(const ReachProblem& problem) {
  std::vector<bool> moved(problem.body->dofs().size());
  for (const auto& constraint : constraints(problem)) {
    for (const int d : problem.body->chain(constraint.link))
      moved[static_cast<std::size_t>(d)] = true;
  }
  return moved;
}

}  // namespace

std::vector<FitKind> fit_kinds() {
  return {{"log weights, straight path", GeneCode::logarithmic, true},
          {"weights and postures, straight path", GeneCode::natural, true},
          {"the same, bow and sway", GeneCode::natural},
          {"the same, delay and skew", GeneCode::every}};
}

FittedReach fitted_reach(const Recorded& reach, const FitKind& kind, int evaluations) {
  const Task task = reach.task();
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = parameter_list(whole_body_plan(task.body));
  FixedParameters fixed = no_fixed_parameters(list);
  if (kind.straight && kind.code != GeneCode::logarithmic) {
    for (const char* none : {"bow=0", "sway=0"}) {
      SHG_CHECK(fix_parameter(list, none, fixed).has_value(), "a parameter of the preset");
    }
  }
  const ParameterSpace space(problem, list, kind.code, fixed);
  const std::vector<bool> moved = moving_points(problem);
  Rollout<double> rollout(problem);
  Clip clip{task.body.dof_count(), problem.steps + 1, problem.duration / problem.steps, {}};
  const auto play = [&](std::span<const double> point) {
    clip.angles.clear();
    const HeldInput held(task.body, space.decode(point), task.supports.size());
    return rollout.run(held.input(), [&](const PlacedFrame<double>& frame) {
      clip.angles.insert(clip.angles.end(), frame.angles.begin(), frame.angles.end());
    });
  };
  const auto genes = static_cast<std::size_t>(space.genes());
  SearchProblem search{.genes = space.genes()};
  search.start = space.start();
  search.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const ReachOutcome outcome = play(points.subspan(i * genes, genes));
      scores[i] = outcome.met(problem.tolerance) ? angle_difference(reach.track.angles, clip, moved)
                                                 : kMissed + min(outcome.path_error, 1.0);
    }
  };
  CmaEsSettings settings;
  settings.evaluations = evaluations;
  const SearchResult found = cma_es_search(search, settings);
  if (!(found.best_seen.score < kMissed)) return {space.genes(), {}};
  play(found.best_seen.point);
  return {space.genes(), clip};
}

}  // namespace shigusa::bench
