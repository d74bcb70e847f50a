// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/hierarchy/arm_feedback.hpp>
#include <shigusa/hierarchy/layered_player.hpp>
#include <shigusa/hierarchy/layered_settings.hpp>

namespace shigusa {

// The upper layer's genes that have something to act on: an arm without a goal hangs.
[[nodiscard]] std::vector<std::size_t> searched_genes(const LayeredProblem& problem);

// Parameters of the upper layer from a point of the searched genes' unit cube; the genes that are
// not searched have a weight of 1 and no contraction. `paper`: in the paper's code of 16 numbers,
// else decode_layer_point's.
[[nodiscard]] LayerParameters decode_searched(const LayeredProblem& problem,
                                              std::span<const std::size_t> searched,
                                              std::span<const double> point, bool paper);

// Scores upper motions with their limbs, many at once.
class LayeredScorer {
 public:
  // Chooses the arms' weights for an upper motion: (goals).
  using ChooseArms = std::function<std::vector<ArmWeights>(std::span<const HandPath>)>;

  LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria, int threads,
                ChooseArms choose);

  // scores (parameters): the criteria's; where hand or foot leaves its place, the worst of all and
  // more, by what is missed.
  void score(std::span<const LayerParameters> parameters, std::span<double> scores);

  // One motion in full, by the same way.
  struct Played {
    RolledOut motion;
    std::vector<ArmWeights> arms;
    int feedback_rounds = 0;
  };
  // What the upper layer reports to the lower one (rule R11): arms that pass through the body are
  // searched again for this motion alone, up to `rounds` times each. The upper motion stays.
  struct Feedback {
    int rounds = kCollisionRounds;
    LimbSearch search = LimbSearch::ladder;
  };
  [[nodiscard]] Played play(const LayerParameters& parameters, const Feedback& feedback);

 private:
  const LayeredProblem* problem_;
  const CriteriaSettings* criteria_;
  int threads_;
  ChooseArms choose_;
  std::vector<std::unique_ptr<LayeredPlayer>> players_;  // one per thread, made when first needed
};

}  // namespace shigusa
