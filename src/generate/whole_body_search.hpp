// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/search.hpp>
#include <shigusa/task.hpp>
#include <string_view>
#include <vector>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "point_scorer.hpp"

namespace shigusa {

// The meaning of the points of a task's search.
[[nodiscard]] GeneCode gene_code(const Task& task);

// The search on one approach, with the archive of the points that it came upon. Problem and task
// outlive it.
class WholeBodySearch {
 public:
  WholeBodySearch(const ReachProblem& problem, const Task& task);

  // The preset flat spends 0.4 of the budget on all parameters together, and a tenth or two on each
  // style that people have otherwise: squat, stoop, half squat, turn the other way, put the elbow
  // elsewhere. A search that is good at finding the best ends with one motion, and no criterion
  // decides between those. Each part is a search of its own whose budget never shrinks as the whole
  // grows, and styles begin at the best of the first 480 motions, so more budget never gives a
  // worse best (from 1200 on, where all 480 are there). Styles run side by side.
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
  // a search of its own
  struct Part {
    Niche niche;
    std::vector<double> from;  // empty: begins upright
    int budget;                // motions
  };
  static constexpr double kFreeShare = 0.4;
  static constexpr double kStyleShare = 0.1;
  static constexpr double kFarShare = 0.2;

  [[nodiscard]] Niche stiff_knees() const;
  [[nodiscard]] std::vector<Part> styles(const PointScorer::Guess& guess, int budget) const;
  void bind(Niche& niche, std::string_view mode, double low, double high) const;
  static void take_in(const Niche& niche, std::span<double> points, std::size_t genes);
  SearchResult run_part(const Part& part, PointScorer& scorer, const Progress& progress) const;
  void run_parts(const std::vector<Part>& parts, const std::vector<Progress>& watched,
                 SearchResult& all);
  [[nodiscard]] std::vector<double> postures() const;
  [[nodiscard]] SearchResult begin_bent(SearchProblem& searched, int budget) const;
  SearchResult search_with(const SearchProblem& searched, int budget,
                           const Progress& progress) const;

  const ReachProblem& problem_;
  const Task& task_;
  CriteriaSettings criteria_;
  ParameterSpace space_;
  Archive archive_;
};

}  // namespace shigusa
