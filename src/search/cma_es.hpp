// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <vector>

#include "cma_run.hpp"
#include "scorer.hpp"

namespace shigusa {

// Largest number of rows of the covariance; a generation takes genes³ / 6 operations.
inline constexpr int kCmaMaxGenes = 500;

struct CmaEsSettings {
  int evaluations = 1000;        // ≥ 1
  int population = 0;            // 4..10000; 0: the least multiple of 16 from 4 + 3 ln(genes) on
  double step = 0.3;             // initial standard deviation of a run, 1e-6..1
  double polish_step = 0.1;      // the same for a run from the best point, 1e-6..1
  std::vector<double> scales{};  // (genes) deviations of the first run, in `step`; empty: all 1
  double precision = 1e-9;       // smaller decreases of the best score count as none, ≥ 0
  bool mirrored = false;         // the second half of a generation mirrors the first
  int diagonal_until = 0;        // evaluations after which the whole of C is learnt
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;  // selects other random numbers for the same seed
};

// Covariance matrix adaptation (N. Hansen: The CMA evolution strategy: a tutorial, arXiv
// 1604.00772), with restarts: the default search.
//
//   one run from the problem's start, then again and again
//     a run from a random mean, with `step`, or, while those from the best have had fewer
//       evaluations than all others, from the best point seen, with `polish_step`
//   run: repeat
//     `population` points := mean + step · L z, with z normal and L Lᵀ = C
//     bring them into the cube, score them in one call, rank them
//     mean := weighted mean of the better half; C and step adapt along the two paths
//   until the best of the run has not fallen by `precision`, nor by a thousandth of itself, for
//     10 + 12 genes / population generations, or the points lie within 1e-8 of each other, or C has
//     lost its rank
//
// All constants are the tutorial's, including negative weights (active CMA). Two things differ. C =
// L Lᵀ is Cholesky's factor, not the symmetric root: it is exact in few operations, always in the
// same order, and only rotates the path of steps (as in O. Krause, D. R. Arbonès, C. Igel: CMA-ES
// with optimal covariance update and storage complexity, NIPS 2016). And a point beyond the cube is
// scored at the nearest point of the cube and ranked by that score plus a penalty quadratic in
// their distance, in units of the spread of scores. Reflection at the faces was ten times as far
// from an optimum on a face after 1000 evaluations, as mirrored points crowd in front of it; moving
// the sample itself to the face ended runs before their optimum.
//
// Two options are for searches with few evaluations per gene: mirrored sampling, where the second
// half of a generation mirrors the first at the mean (D. Brockhoff et al.: Mirrored sampling and
// sequential selection for evolution strategies, PPSN 2010), and a C of which first only the
// diagonal is learnt, at a higher rate.
//
// The first point scored is the start. The final population is the best point of each run, in their
// order, followed by the last generation scored completely.
//
// Left out: growing populations (IPOP, BIPOP): with budgets of some thousand evaluations they find
// no more than restarts of one size, and sizes that are multiples of 16 fill vector registers.
//
// The result depends on problem and settings only, for any compiler and instruction set. Settings
// or a problem outside the stated ranges throw PreconditionError; exceptions of problem.evaluate
// pass through.
[[nodiscard]] SearchResult cma_es_search(const SearchProblem& problem,
                                         const CmaEsSettings& settings,
                                         const Progress& progress = {});

// The same search in stages, whose division does not affect the result. Problem and progress
// outlive the object.
class CmaEs {
 public:
  CmaEs(const SearchProblem& problem, const CmaEsSettings& settings, const Progress& progress);

  // Continues, by whole generations, until this many points are scored; false once the search is
  // over.
  bool run_to(int evaluations);

  // The result so far; ends the search.
  [[nodiscard]] SearchResult take_result();

 private:
  // Detects when the best score of a run stops decreasing.
  class Standstill {
   public:
    Standstill(double precision, int patience) : precision_(precision), patience_(patience) {}
    [[nodiscard]] bool reached(double best);

   private:
    double precision_;
    int patience_;  // generations
    double last_ = kWorst;
    int since_ = 0;  // generations
  };
  // A run, with its best points.
  struct Descent {
    CmaRun run;
    Standstill standstill;
    int begun_at;     // evaluations
    bool polishes;    // starts from the best point
    bool mean_first;  // the mean is the first point scored
    std::vector<Individual> best{};
  };

  void begin_descent();
  void step();
  void end_descent();

  CmaEsSettings settings_;
  Scorer scorer_;
  Random random_;
  std::optional<Descent> descent_;
  int descents_ = 0;
  int elsewhere_ = 0;  // evaluations of the runs from other points than the best
  bool over_ = false;
  std::vector<double> scores_;       // of a generation
  std::vector<double> last_points_;  // of the last generation scored completely
  std::vector<double> last_scores_;
};

}  // namespace shigusa
