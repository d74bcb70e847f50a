// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

#include "paper/layered_problem.hpp"

namespace shigusa {

// Parameters of many motions of layers, in sequence, in single precision.
struct LayeredInputs {
  std::span<const float> inverse_weights;  // (motions × dofs of the upper layer) 0 where locked
  std::span<const float> contractions;     // (motions × limbs)
  std::span<const float> finals;           // (motions × final angles) rad
  // (motions × arms by swivel) rad, or empty: the best of a few angles
  std::span<const float> swivels{};
  // (motions × arms by weights × kArmDofs) 0 where locked; chosen after the upper layer's motion
  std::span<const float> arms{};
  bool idle = false;  // includes IdleCost

  // The rows of `count` motions from `first` on, out of `motions`.
  [[nodiscard]] LayeredInputs part(std::size_t first, std::size_t count,
                                   std::size_t motions) const {
    const auto rows = [&](std::span<const float> all) {
      const std::size_t columns = all.size() / motions;
      return all.subspan(first * columns, count * columns);
    };
    return {rows(inverse_weights), rows(contractions), rows(finals),
            rows(swivels),         rows(arms),         idle};
  }
};

// Scores as many layered motions in parallel as a SIMD set has lanes: each motion's upper layer,
// then its lower ones. One per batch in progress.
class LayeredLanes {
 public:
  virtual ~LayeredLanes() = default;
  // Moves the upper layer of at most simd_lanes() motions. hands: (motions × goals) m, the ends of
  // the hands' paths, as in HandPath.
  virtual void run_upper(const LayeredInputs& inputs, std::span<Vec3d> hands) = 0;
  // Moves the layers below, of the same motions. scores (motions); final_angles (motions × dofs).
  virtual void expand(const LayeredInputs& inputs, std::span<double> scores,
                      std::span<float> final_angles) = 0;
};

// One per SIMD set, each in a source file compiled for it.
std::unique_ptr<LayeredLanes> make_scalar_layers(const LayeredSetup& setup,
                                                 const CriteriaSettings& criteria);
std::unique_ptr<LayeredLanes> make_lanes_4_layers(const LayeredSetup& setup,
                                                  const CriteriaSettings& criteria);
std::unique_ptr<LayeredLanes> make_avx2_layers(const LayeredSetup& setup,
                                               const CriteriaSettings& criteria);
std::unique_ptr<LayeredLanes> make_avx512_layers(const LayeredSetup& setup,
                                                 const CriteriaSettings& criteria);

// Cost per radian of exceeded limits, and its maximum, where limits are held: a motion within its
// limits is preferred unless it is bad.
inline constexpr double kOverLimitCost = 2.0;
inline constexpr double kOverLimitMost = 0.5;

// Scores batches of layered motions by the built-in criteria, as BatchRollout does for the whole
// body. A motion's score depends on its parameters alone.
class LayeredBatch {
 public:
  // Returns the inverse weights (arms by weights × kArmDofs) of a motion for the ends of its hands'
  // paths (goals). Called from one thread.
  using ChooseArms = std::function<std::vector<float>(std::span<const Vec3d> hands)>;

  // Setup and criteria outlive the batch.
  LayeredBatch(const LayeredSetup& setup, const CriteriaSettings& criteria,
               const BatchSettings& settings);
  ~LayeredBatch();
  LayeredBatch(const LayeredBatch&) = delete;
  LayeredBatch& operator=(const LayeredBatch&) = delete;

  // Scores layered motions. scores (motions): the criteria's, plus the cost of exceeded limits if
  // they are held; if a hand or foot leaves its place, above the worst by the size of the error.
  // final_angles: (motions × dofs) rad, the last frame of each motion, or empty.
  void score(const LayeredInputs& inputs, const ChooseArms& choose, std::span<double> scores,
             std::span<float> final_angles);

 private:
  // The motions of one call, with intermediate results.
  struct Call;
  LayeredLanes& lanes(std::size_t slot);
  [[nodiscard]] std::size_t arms_by_weights() const;
  void run_upper(Call& call, std::size_t batch, std::size_t slot);
  void choose_arms(Call& call, const ChooseArms& choose, std::size_t first, std::size_t count);
  void expand(Call& call, std::size_t batch, std::size_t slot);

  const LayeredSetup* setup_;
  const CriteriaSettings* criteria_;
  BatchSettings settings_;
  std::vector<std::unique_ptr<LayeredLanes>> lanes_;  // made on demand
};

}  // namespace shigusa
