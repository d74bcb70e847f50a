// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/hierarchy/archive.hpp>
#include <shigusa/hierarchy/parameter_space.hpp>
#include <shigusa/hierarchy/task.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/search/searches.hpp>
#include <string_view>
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

  // Of the preset flat, 0.4 of the budget goes to all parameters together, and a tenth or two each
  // to what people do otherwise: squat, stoop, half squat, turn the other way, put the elbow
  // elsewhere. A search that is good at finding the best ends with one motion, and no criterion
  // decides between those. Each part is a search of its own whose budget never shrinks as the whole
  // grows, and styles begin at the best of the first 480 motions, so more budget never gives a
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
  struct Style {
    Niche niche;
    double share;  // of the budget
    bool far;      // from the guess: begins upright
  };
  static constexpr double kStyleShare = 0.1;
  static constexpr double kFarShare = 0.2;
  // the best of the first motions
  struct Guess {
    std::vector<double> point{};  // empty where none arrives
    double score = 0.0;
    bool bends = true;  // ends with the shoulders down
  };

  [[nodiscard]] Niche stiff_knees() const;
  [[nodiscard]] std::vector<Style> styles() const;
  void bind(Niche& niche, std::string_view mode, double low, double high) const;
  void guess(std::span<const double> points, std::span<const double> scores);
  static void take_in(const Niche& niche, std::span<double> points, std::size_t genes);
  SearchResult run_in(const Niche& niche, const std::vector<double>& from, int budget,
                      const Progress& progress);
  [[nodiscard]] std::vector<double> postures() const;
  [[nodiscard]] SearchResult begin_bent(SearchProblem& searched, int budget) const;
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
  Guess guess_;
  int guessed_ = 0;  // motions
  std::vector<double> moved_;
  std::vector<double> kept_scores_;
};

}  // namespace shigusa
