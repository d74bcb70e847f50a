// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "criteria/built_in_criteria.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa::bench {

// Stages of a frame of a rollout, and whole rollouts.
enum class Stage {
  forward_kinematics,
  ik_rows,      // Jacobian and residual
  ik_products,  // J A Jᵀ
  ik_solve,     // its factors and the solution
  ik,           // the whole step, the three above included
  dynamics,     // joint torques, the feet's shares, the centre of mass
  criteria,
  motion,  // all frames of one motion per lane, and its score
};

// Stages of the kernel in the lanes of one SIMD set.
class Stages {
 public:
  virtual ~Stages() = default;
  [[nodiscard]] virtual int lanes() const = 0;
  // Runs one frame; for Stage::motion one motion per lane, the next ones at each call.
  virtual void run(Stage stage) = 0;
  // Runs kPeakOperations multiplications and additions per lane, independent of each other and in
  // registers.
  virtual void peak() = 0;
};

inline constexpr int kPeakChains = 7;  // of each operation
inline constexpr int kPeakRounds = 1000;
inline constexpr int kPeakOperations = 2 * kPeakChains * kPeakRounds;

// Input of the stages, which must outlive them.
struct StagesInput {
  const ReachProblem* problem = nullptr;
  const CriteriaSettings* criteria = nullptr;
  std::span<const float> inverse_weights;  // (motions × dofs), full lanes
};

// One factory per SIMD set, each in a source file that is compiled for it; those named fma use
// fused multiply-add.
std::unique_ptr<Stages> make_lanes_4_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx2_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx2_fma_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx512_stages(const StagesInput& input);
std::unique_ptr<Stages> make_avx512_fma_stages(const StagesInput& input);

}  // namespace shigusa::bench
