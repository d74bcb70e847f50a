// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "criteria/built_in_criteria.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa::bench {

// The stages of a frame of a rollout, and whole rollouts.
enum class Stage {
  forward_kinematics,
  ik_rows,      // Jacobian and residual
  ik_products,  // J A Jᵀ
  ik_solve,     // its factors and the solution
  ik,           // the whole step, the three above included
  dynamics,     // joint torques, the feet's shares, the centre of mass
  criteria,
  motion,  // all frames of one motion in each lane, and its score
};

// The kernel's stages, in the lanes of one SIMD set.
class Stages {
 public:
  virtual ~Stages() = default;
  [[nodiscard]] virtual int lanes() const = 0;
  // One frame; of Stage::motion one motion in each lane, the next ones at each call.
  virtual void run(Stage stage) = 0;
  // As many multiplications and additions, independent of each other and in registers, as
  // kPeakOperations says, in each lane.
  virtual void peak() = 0;
};

inline constexpr int kPeakChains = 7;  // of each kind
inline constexpr int kPeakRounds = 1000;
inline constexpr int kPeakOperations = 2 * kPeakChains * kPeakRounds;

// The input of the stages. The problem outlives them.
struct StagesInput {
  const ReachProblem* problem = nullptr;
  const CriteriaSettings* criteria = nullptr;
  std::span<const float> inverse_weights;  // (motions × dofs), full lanes
};

// One per SIMD set, each in a source file that is compiled for it; those named fma with fused
// multiply-add.
std::unique_ptr<Stages> make_lanes_4_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx2_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx2_fma_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx512_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx512_fma_stages(const StagesInput& input);

}  // namespace shigusa::bench
