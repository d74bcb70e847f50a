// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <shigusa/request.hpp>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "point_scorer.hpp"
#include "problem/task_search.hpp"
#include "search/cma_es.hpp"

namespace shigusa {

// One coordinate within bounds.
struct Bound {
  int gene = 0;
  double low = 0.0;
  double high = 1.0;
};
// A part of the space.
using Niche = std::vector<Bound>;

// The step of a search that looks all over its part of the space.
inline constexpr double kWideStep = 0.15;

// A search of the whole space learns nothing but scales for that many motions a gene: before, what
// else the covariance holds does not pay.
inline constexpr int kScalesAlone = 100;

// The search of an island: where, from where, and how much.
struct IslandPlan {
  Niche niche{};
  std::vector<double> from{};  // empty: begins at the plain motion
  bool bent = false;           // begins at the best of known starts and bent postures instead
  int budget = 0;              // motions
  double step = kWideStep;     // standard deviation that a run begins with
  std::uint64_t stream = 0;    // other random numbers for the same seed
};

// Adds another search's counts, and its best if it is better.
void add(SearchResult part, SearchResult& all);

// A search of its own on a part of the space. It knows nothing of other islands, so they may run
// side by side and in any order.
class Island {
 public:
  // The motions by which it begins where it begins bent, at most.
  static constexpr int kStarts = 32;

  // Problem, approach and run outlive it. `threads` as BatchSettings has them.
  Island(const Problem& problem, const ReachProblem& approach, const RunSettings& run,
         const ParameterSpace& space, IslandPlan plan, int threads, const Progress& progress);
  Island(const Island&) = delete;
  Island& operator=(const Island&) = delete;

  // Goes on until at least that many motions are scored, or all of its budget. Only CMA-ES stops
  // there: any other search runs to its end at once.
  void run_to(int motions);

  // All that it came upon so far.
  [[nodiscard]] const Archive& archive() const { return scorer_.archive(); }
  // The result, when it has run; nothing comes after it.
  [[nodiscard]] SearchResult take_result();

 private:
  void begin();
  void begin_bent();
  [[nodiscard]] SearchResult search_at_once(int budget) const;
  // from coordinates of its part to those of the space, and back to the nearest that it has
  void take_in(std::span<double> points) const;
  void bring_in(std::span<double> points) const;

  const Task& task_;
  const ReachProblem& approach_;
  const RunSettings& run_;
  ParameterSpace space_;
  IslandPlan plan_;
  PointScorer scorer_;
  SearchProblem searched_;
  Progress progress_;  // of what comes after the starts
  std::vector<double> moved_;
  std::vector<double> scales_;   // of what its first steps are, by gene; none: all alike
  SearchResult found_;           // but for what CMA-ES has found
  std::optional<CmaEs> cma_es_;  // once it has begun
  bool begun_ = false;
};

}  // namespace shigusa
