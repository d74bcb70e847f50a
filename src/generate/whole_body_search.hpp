// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <shigusa/request.hpp>
#include <shigusa/search.hpp>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "island.hpp"
#include "joint_progress.hpp"
#include "problem/task_search.hpp"

namespace shigusa {

// The code of the points of a task's search.
[[nodiscard]] GeneCode gene_code(const Task& task);

// The search on one approach, with the archive of its points. Problem, approach and run outlive it.
class WholeBodySearch {
 public:
  WholeBodySearch(const Problem& problem, const ReachProblem& approach, const RunSettings& run);

  // Runs the search. One that finds the best well ends with one motion, and no criterion decides
  // between that and the alternatives of people. So the preset flat spends half of the budget on
  // all parameters together, and a twelfth or two on each style (StylePlans). Each is an island;
  // islands run in parallel, one per thread:
  //  the first starts | all parameters to kGuess motions, early styles | the rest, late styles
  // Styles begin at the best of the first starts or of the first kGuess motions: at fixed counts,
  // never at times. The points of a smaller budget are not the first of a larger one's.
  SearchResult run(const Progress& progress);

  [[nodiscard]] const ParameterSpace& space() const { return space_; }
  [[nodiscard]] const Archive& archive() const { return archive_; }

 private:
  void add_islands(std::vector<IslandPlan> plans, JointProgress& joint);
  void run_islands(int motions);

  const Problem& problem_;
  const ReachProblem& approach_;
  const RunSettings& run_;
  ParameterSpace space_;
  KnownStarts known_;
  Archive archive_;
  int budget_;       // motions
  int part_;         // motions per style; 0: no styles
  int threads_;      // threads for the islands
  int own_threads_;  // threads for the motions of each island
  std::deque<Island> islands_;
};

}  // namespace shigusa
