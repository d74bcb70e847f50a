// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/hierarchy/archive.hpp>
#include <shigusa/hierarchy/parameter_space.hpp>
#include <shigusa/hierarchy/task.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/search/searches.hpp>
#include <vector>

#include "squat_dial.hpp"

namespace shigusa {

// The search that a task asks for, and what its points mean.
[[nodiscard]] SearchMethod search_of(const Task& task);
[[nodiscard]] GeneCode gene_code(const Task& task);

// What is searched on one way to the goal, and what the search came upon. Problem and task outlive
// it.
class Searched {
 public:
  Searched(const ReachProblem& problem, const Task& task);

  // Of the preset flat, most of the budget goes to all parameters together and the rest to stoops
  // and squats apart, since people do both and no criterion decides between them. Each part is a
  // search of its own whose budget never shrinks as the whole grows, so more budget never gives a
  // worse best.
  SearchResult run(const Progress& progress);

  [[nodiscard]] const ParameterSpace& space() const { return space_; }
  [[nodiscard]] const Archive& archive() const { return archive_; }

 private:
  // one coordinate within bounds
  struct Bound {
    int gene = 0;
    double low = 0.0;
    double high = 1.0;
  };
  // a part of the space
  using Niche = std::vector<Bound>;

  [[nodiscard]] Niche stiff_knees() const;
  static void take_in(const Niche& niche, std::span<double> points, std::size_t genes);
  SearchResult run_in(const Niche& niche, int budget, const Progress& progress);
  SearchResult search_with(const SearchProblem& searched, int budget, const Progress& progress);
  void evaluate(std::span<const double> points, std::span<double> scores);
  void score_one_by_one(std::span<const double> points, std::span<double> scores);

  const ReachProblem& problem_;
  const Task& task_;
  CriteriaSettings criteria_;
  ParameterSpace space_;
  BatchRollout batch_;
  Archive archive_;
  std::optional<SquatDial> dial_;
  std::vector<float> angles_;  // (motions × dofs) rad, where they end
  std::vector<double> moved_;
  std::vector<double> kept_scores_;
};

}  // namespace shigusa
