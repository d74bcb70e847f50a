// SPDX-License-Identifier: MIT
#include "whole_body_search.hpp"

#include <shigusa/run.hpp>
#include <utility>

#include "core/index.hpp"
#include "generate/known_starts.hpp"
#include "search/genetic.hpp"
#include "whole_body_styles.hpp"

namespace shigusa {
namespace {

// Styles get one or two twelfths of a budget, in full batches; the rest is spent on all parameters.
constexpr int kBatch = static_cast<int>(kFullBatch);
constexpr int kUnit = 12 * kBatch;
// Motions after which late styles begin: known starts leave little to find after them.
constexpr int kGuess = 8 * kBatch;

int style_part(const Task& task, int budget) {
  return task.preset == Preset::paper ? 0 : budget / kUnit * kBatch;
}

}  // namespace

// The paper's own searches use its codes; others a wider range.
GeneCode gene_code(const Task& task) {
  if (task.preset != Preset::paper) return GeneCode::natural;
  if (task.own_search) return GeneCode::logarithmic;
  return info_of(search_of(task)).paper_code ? GeneCode::paper : GeneCode::logarithmic;
}

WholeBodySearch::WholeBodySearch(const Problem& problem, const ReachProblem& approach,
                                 const RunSettings& run)
    : problem_(problem),
      approach_(approach),
      run_(run),
      space_(approach, *problem.parameters, gene_code(problem.task), problem.task.fixed),
      known_(approach, space_),
      archive_(problem.task, approach.goals.front().effector),
      budget_(run.evaluations.value_or(usual_evaluations(problem.task))),
      part_(style_part(problem.task, budget_)),
      threads_(problem.task.batch.threads),
      own_threads_(threads_) {
  // user functions are called from one thread, and whole motions use all threads
  const bool together =
      !problem.task.own_search && !scores_whole_motions(problem.task, run.criteria);
  if (!together) threads_ = 1;
  if (together && part_ > 0) own_threads_ = 1;
}

SearchResult WholeBodySearch::run(const Progress& progress) {
  JointProgress joint(progress);
  StylePlans styles(space_, part_);
  const bool paper = problem_.task.preset == Preset::paper;
  // if the user fixes the squat, the knees follow it
  Niche knees = !paper && space_.find("squat") < 0 ? stiff_knees(space_) : Niche{};
  add_islands({{.niche = std::move(knees),
                .bent = !paper,
                .budget = budget_ - StylePlans::kParts * part_,
                .step = paper ? kWideStep : kSearchStep}},
              joint);
  const Island& all = islands_.front();
  if (part_ > 0) {
    run_islands(Island::kStarts);
    add_islands(styles.early(all.archive().best()), joint);
    run_islands(kGuess);
    if (!progress.cancelled()) add_islands(styles.late(all.archive().best()), joint);
  }
  run_islands(budget_);
  SearchResult found;
  for (Island& island : islands_) {
    archive_.add(island.archive());
    SearchResult own = island.take_result();
    if (&island == &all) found.final_population = std::move(own.final_population);
    add(std::move(own), found);
  }
  islands_.clear();
  return found;
}

void WholeBodySearch::add_islands(std::vector<IslandPlan> plans, JointProgress& joint) {
  for (IslandPlan& plan : plans) {
    const Progress progress = joint.part(static_cast<double>(plan.budget) / budget_);
    islands_.emplace_back(problem_, approach_, run_, space_, known_, std::move(plan), own_threads_,
                          progress);
  }
}

// Runs each island to this number of motions, or to its end.
void WholeBodySearch::run_islands(int motions) {
  parallel_for(static_cast<int>(islands_.size()), threads_,
               [&](int i, int) { islands_[index(i)].run_to(motions); });
}

}  // namespace shigusa
