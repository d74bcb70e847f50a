// SPDX-License-Identifier: MIT
#include "task_search.hpp"

#include "search/genetic.hpp"

namespace shigusa {

RunSettings run_of(const Problem& problem) {
  const Task& task = problem.task;
  return {problem.task.criteria, task.evaluations, task.seed, task.genetic.stream};
}

SearchResult run_search(const Task& task, const RunSettings& run, const SearchProblem& problem,
                        int evaluations, bool once, const Progress& progress) {
  const SearchMethod method = search_of(task);
  if (!info_of(method).genetic) return search(method, problem, evaluations, run.seed, progress);
  GeneticSettings settings = task.genetic;
  settings.seed = run.seed;
  settings.stream = run.stream;
  return once ? genetic_search(problem, settings, progress)
              : restarted_genetic_search(problem, settings, evaluations, progress);
}

}  // namespace shigusa
