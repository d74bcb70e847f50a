// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/parameters.hpp>

#include "paper/arm_feedback.hpp"
#include "paper/layered_lanes.hpp"
#include "paper/layered_player.hpp"
#include "planner.hpp"

namespace shigusa {

// The upper layer's genes that have something to act on: an arm without a goal hangs.
[[nodiscard]] std::vector<std::size_t> searched_genes(const LayeredProblem& problem);

// Values of the upper layer from a point of the searched genes' unit cube; the genes that are
// not searched have a weight of 1 and no contraction. `paper`: in the paper's code of 16 numbers,
// else decode_layer_point's.
[[nodiscard]] LayeredValues decode_searched(const LayeredProblem& problem,
                                            std::span<const std::size_t> searched,
                                            std::span<const double> point, bool paper);

// The values of all layers: those of the upper one, and below it those that they start with.
[[nodiscard]] LayeredValues below_upper(LayeredValues start, const LayeredValues& upper);

// Scores upper motions with their limbs, many at once.
class LayeredScorer {
 public:
  // Chooses the weights of the arms that go by them, for hands whose paths end there (goals). Arms
  // that go by their swivel are given the best of a few.
  using ChooseArms = std::function<std::vector<ArmWeights>(std::span<const Vec3d>)>;

  LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria,
                const BatchSettings& settings, ChooseArms choose);

  // scores (parameters): the criteria's; where hand or foot leaves its place, the worst of all and
  // more, by what is missed. postures: (parameters × dofs) rad, how each motion ends, or empty.
  void score(std::span<const LayeredValues> parameters, std::span<double> scores,
             std::span<float> postures = {});

  // How much `play` searches. The upper layer reports arms that pass through the body to the lower
  // one (rule R11), which searches each of them again for this motion alone, up to `rounds` times;
  // the upper motion stays. Then arms that go by their swivel are given the best of all, and limbs
  // that no goal moves the best final angles by a search from `seed`; without one all is as score()
  // has it.
  struct Feedback {
    int rounds = kCollisionRounds;
    LimbSearch search = LimbSearch::ladder;
    std::optional<std::uint64_t> seed{};
  };
  // Values of all layers.
  struct Played {
    LayeredValues values;
    int searches = 0;  // that the arms took for them
  };
  // Plays one motion in full, with all that the layers below find for it.
  [[nodiscard]] Played play(const LayeredValues& upper, const Feedback& feedback);

 private:
  // The rows of many motions' parameters; no rows of what is searched below.
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
  // For criteria of a user's, which want whole motions: one thread scores one after the other.
  double score_alone(const LayeredValues& upper, std::span<float> posture);
  [[nodiscard]] double judged(const RolledOut& played) const;
  void retake_weights(const ReducedClip<double>& clip, const Feedback& feedback, Played& played);
  void refine_swivels(const ReducedClip<double>& clip, LayeredValues& parameters);
  void settle_rest(const ReducedClip<double>& clip, std::uint64_t seed, LayeredValues& parameters);
  // of motions that differ by their final angles alone
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
