// SPDX-License-Identifier: MIT
#include "task_search.hpp"

#include "search/genetic.hpp"

namespace shigusa {

SearchResult run_search(const Task& task, const SearchProblem& problem, int evaluations, bool once,
                        const Progress& progress) {
  const SearchMethod method = search_of(task);
  if (!info_of(method).genetic) return search(method, problem, evaluations, task.seed, progress);
  GeneticSettings settings = task.genetic;
  settings.seed = task.seed;
  return once ? genetic_search(problem, settings, progress)
              : restarted_genetic_search(problem, settings, evaluations, progress);
}

}  // namespace shigusa
