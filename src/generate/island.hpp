// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <shigusa/request.hpp>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

#include "generate/archive.hpp"
#include "generate/known_starts.hpp"
#include "generate/parameter_space.hpp"
#include "point_scorer.hpp"
#include "problem/task_search.hpp"
#include "search/cma_es.hpp"

namespace shigusa {

// Initial step of a search over a whole part of the space.
inline constexpr double kWideStep = 0.15;

// Motions per gene for which a search of the whole space adapts scales only: earlier, the rest of
// the covariance does not pay.
inline constexpr int kScalesAlone = 100;

// The search of an island: its part of the space, its start and its budget.
struct IslandPlan {
  Niche niche{};
  std::vector<double> from{};  // start point; empty: the plain motion
  bool bent = false;           // may start at a bent posture
  bool style = false;          // the niche is a style: may start at known motions of that style
  int budget = 0;              // motions
  double step = kWideStep;     // initial standard deviation
  std::uint64_t stream = 0;    // selects other random numbers for the same seed
};

// Adds another search's counts, and its best if better.
void add(SearchResult part, SearchResult& all);

// An independent search of a part of the space. Islands share nothing, so they may run in parallel
// and in any order.
class Island {
 public:
  // Largest number of motions scored to find a bent start, but for habit_starts().
  static constexpr int kStarts = 32;

  // Problem, approach, run and known starts outlive the island. `threads`: see BatchSettings.
  Island(const Problem& problem, const ReachProblem& approach, const RunSettings& run,
         const ParameterSpace& space, const KnownStarts& known, IslandPlan plan, int threads,
         const Progress& progress);
  Island(const Island&) = delete;
  Island& operator=(const Island&) = delete;

  // Continues until at least `motions` are scored, or the budget is used up. Only CMA-ES can pause:
  // any other search runs to its end at once.
  void run_to(int motions);

  // The points evaluated so far.
  [[nodiscard]] const Archive& archive() const { return scorer_.archive(); }
  // The result after the run; ends the island.
  [[nodiscard]] SearchResult take_result();

 private:
  void begin();
  void begin_at_best();
  [[nodiscard]] SearchResult search_at_once(int budget) const;
  // Map coordinates of this part to those of the space, and back to the nearest point of the part.
  void take_in(std::span<double> points) const;
  void bring_in(std::span<double> points) const;

  const Task& task_;
  const ReachProblem& approach_;
  const RunSettings& run_;
  ParameterSpace space_;
  const KnownStarts& known_;
  IslandPlan plan_;
  PointScorer scorer_;
  SearchProblem searched_;
  Progress progress_;  // after the start motions
  std::vector<double> moved_;
  std::vector<double> scales_;   // scales of the first steps (genes); empty: all equal
  SearchResult found_;           // without the share of CMA-ES
  std::optional<CmaEs> cma_es_;  // once started
  bool begun_ = false;
};

}  // namespace shigusa
