// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/parameters.hpp>

#include "paper/arm_feedback.hpp"
#include "paper/layered_lanes.hpp"
#include "paper/layered_player.hpp"
#include "planner.hpp"

namespace shigusa {

// The genes of the upper layer that affect the motion: an arm without a goal hangs.
[[nodiscard]] std::vector<std::size_t> searched_genes(const LayeredProblem& problem);

// Values of the upper layer from a point of the searched genes' unit cube; unsearched genes have a
// weight of 1 and no contraction. `paper`: the paper's code of 16 numbers instead of
// decode_layer_point's.
[[nodiscard]] LayeredValues decode_searched(const LayeredProblem& problem,
                                            std::span<const std::size_t> searched,
                                            std::span<const double> point, bool paper);

// The values of all layers: the upper layer's, with start values below.
[[nodiscard]] LayeredValues below_upper(LayeredValues start, const LayeredValues& upper);

// Scores batches of upper-layer motions with their limbs.
class LayeredScorer {
 public:
  // Chooses the weights of weighted arms for the final positions of their hands (goals). Arms moved
  // by swivel get the best of a few angles.
  using ChooseArms = std::function<std::vector<ArmWeights>(std::span<const Vec3d>)>;

  LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria,
                const BatchSettings& settings, ChooseArms choose);

  // Scores motions of the upper layer. scores (parameters): the criteria's; if a hand or foot
  // leaves its place, above the worst by the size of the error. postures: (parameters × dofs) rad,
  // the last frame of each motion, or empty.
  void score(std::span<const LayeredValues> parameters, std::span<double> scores,
             std::span<float> postures = {});

  // Extent of the search in `play`. The upper layer reports arms that pass through the body to the
  // lower one (rule R11), which searches each of them again for this motion alone, up to `rounds`
  // times; the upper motion stays. Then arms moved by swivel get the best angle, and idle limbs the
  // best final angles by a search from `seed`; without a seed everything is as in score().
  struct Feedback {
    int rounds = kCollisionRounds;
    LimbSearch search = LimbSearch::ladder;
    std::optional<std::uint64_t> seed{};
  };
  // Values of all layers.
  struct Played {
    LayeredValues values;
    int searches = 0;  // arm searches made for the values
  };
  // Plays one motion in full, with the searches of the layers below.
  [[nodiscard]] Played play(const LayeredValues& upper, const Feedback& feedback);

 private:
  // The parameter rows of many motions, without those searched by lower layers.
  struct Rows {
    std::vector<float> inverse_weights;
    std::vector<float> contractions;
    std::vector<float> finals;
    std::vector<float> swivels;
    std::vector<float> arms;

    void add(const LayeredValues& parameters);
    [[nodiscard]] LayeredInputs inputs() const {
      return {inverse_weights, contractions, finals, swivels, arms};
    }
  };

  [[nodiscard]] std::vector<ArmWeights> choose_arms(std::span<const Vec3d> hands) const;
  // Scores one motion for user criteria, which take whole motions and run on one thread.
  double score_alone(const LayeredValues& upper, std::span<float> posture);
  [[nodiscard]] double judged(const RolledOut& played) const;
  void retake_weights(const ReducedClip<double>& clip, const Feedback& feedback, Played& played);
  void refine_swivels(const ReducedClip<double>& clip, LayeredValues& parameters);
  void settle_rest(const ReducedClip<double>& clip, std::uint64_t seed, LayeredValues& parameters);
  // Scores motions that differ only in their final angles.
  void score_finals(const ReducedClip<double>& clip, std::span<const LayeredValues> tried,
                    std::span<double> scores);

  const LayeredProblem* problem_;
  const CriteriaSettings* criteria_;
  int threads_;
  ChooseArms choose_;
  LayeredValues start_;  // of the layers below, before any search
  LayeredPlayer player_;
  LayeredBatch batch_;
};

}  // namespace shigusa
