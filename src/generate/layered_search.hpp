// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/layered_settings.hpp>

#include "layers/arm_feedback.hpp"
#include "layers/layered_player.hpp"
#include "layers/swivel_search.hpp"
#include "planner.hpp"

namespace shigusa {

// The upper layer's genes that have something to act on: an arm without a goal hangs.
[[nodiscard]] std::vector<std::size_t> searched_genes(const LayeredProblem& problem);

// Parameters of the upper layer from a point of the searched genes' unit cube; the genes that are
// not searched have a weight of 1 and no contraction. `paper`: in the paper's code of 16 numbers,
// else decode_layer_point's.
[[nodiscard]] Parameters decode_searched(const LayeredProblem& problem,
                                         std::span<const std::size_t> searched,
                                         std::span<const double> point, bool paper);

// The values of all layers: those of the upper one, and below it those that they start with.
[[nodiscard]] Parameters below_upper(Parameters start, const Parameters& upper);

// Where limits are to be held, an upper motion whose limbs pass them costs the first for each
// radian in all, and the second at most: so a motion within its limits is better unless it is bad.
inline constexpr double kOverLimitCost = 2.0;
inline constexpr double kOverLimitMost = 0.5;

// Scores upper motions with their limbs, many at once.
class LayeredScorer {
 public:
  // Chooses the weights of the arms that go by them for an upper motion: (goals). Arms that go by
  // their swivel are given the best of a few.
  using ChooseArms = std::function<std::vector<ArmWeights>(std::span<const HandPath>)>;

  LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria, int threads,
                ChooseArms choose);

  // scores (parameters): the criteria's; where hand or foot leaves its place, the worst of all and
  // more, by what is missed. postures: (parameters × dofs) rad, how each motion ends, or empty.
  void score(std::span<const Parameters> parameters, std::span<double> scores,
             std::span<float> postures = {});

  // How much `play` searches. The upper layer reports arms that pass through the body to the lower
  // one (rule R11), which searches each of them again for this motion alone, up to `rounds` times;
  // the upper motion stays. Then arms that go by their swivel are given the best of all, and limbs
  // that no goal moves the best final angles, unless `coarse`: then all is as score() has it.
  struct Feedback {
    int rounds = kCollisionRounds;
    LimbSearch search = LimbSearch::ladder;
    bool coarse = false;
    std::uint64_t seed = 0;  // of the search for final angles
  };
  // Plays one motion in full, with all that the layers below find for it.
  [[nodiscard]] Expanded play(const Parameters& upper, const Feedback& feedback);

 private:
  // An upper motion, and the paths on which it leads hands (goals); none where it leads nowhere.
  struct UpperMotion {
    ReducedClip clip;
    std::vector<HandPath> paths;
  };
  // The scratch memory of one thread.
  struct Worker {
    LayeredPlayer player;
    std::vector<SwivelSearch> swivels;  // (goals whose arm goes by its swivel)
  };
  Worker& worker(int index);
  [[nodiscard]] std::size_t swivel_goals() const { return start_.swivels.size(); }
  // Plays all upper motions, and gives each the score that it has if it leads nowhere.
  std::vector<UpperMotion> run_upper(std::span<const Parameters> parameters,
                                     std::span<double> scores);
  // One thread alone calls a user's criteria.
  [[nodiscard]] int body_threads() const { return criteria_->user.empty() ? threads_ : 1; }
  // a path of an upper motion as the lower layer's feedback has it, without obstacles
  [[nodiscard]] ArmFeedback bare(std::size_t goal, const ReducedClip& clip, HandPath path) const;
  [[nodiscard]] double judged(const RolledOut& played) const;
  void retake_weights(const ReducedClip& clip, const Feedback& feedback, Expanded& played);
  void refine_swivels(const ReducedClip& clip, Parameters& parameters);
  void settle_rest(const ReducedClip& clip, const Feedback& feedback, Parameters& parameters);

  const LayeredProblem* problem_;
  const CriteriaSettings* criteria_;
  int threads_;
  ChooseArms choose_;
  Parameters start_;                              // of the layers below, before any search
  std::vector<std::unique_ptr<Worker>> workers_;  // one per thread, made when first needed
};

}  // namespace shigusa
