// SPDX-License-Identifier: MIT
#include "rollout/batch_rollout.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <shigusa/run.hpp>

#include "core/check.hpp"
#include "lane_scorer.hpp"
#include "simd/usable_set.hpp"

namespace shigusa {
namespace {

// in the order of SimdSet
constexpr std::array kMakers{
#ifdef __wasm_simd128__
    make_lanes_4_scorer,  // a module has no scalar set, which require_usable refuses
#else
    make_scalar_scorer,
#endif
    make_lanes_4_scorer,
#ifdef SHIGUSA_HAS_AVX
    make_avx2_scorer,
    make_avx512_scorer,
#endif
};

}  // namespace

BatchRollout::BatchRollout(const ReachProblem& problem, const CriteriaSettings& criteria,
                           const BatchSettings& settings)
    : problem_(&problem),
      criteria_(&criteria),
      settings_(settings),
      scorers_(static_cast<std::size_t>(thread_count(settings.threads))) {
  require_usable(settings.simd);
}

BatchRollout::~BatchRollout() = default;

void BatchRollout::score(const MotionInputs& inputs, std::span<double> scores,
                         std::span<float> final_angles) {
  const std::size_t dofs = problem_->body->dofs().size();
  SHG_CHECK(inputs.inverse_weights.size() == scores.size() * dofs, "one weight per motion and dof");
  SHG_CHECK(inputs.posture.empty() || (inputs.posture.size() == scores.size() * dofs &&
                                       inputs.timing.size() == scores.size() * kTimings),
            "one change of posture per motion and dof, and the numbers of its timing");
  SHG_CHECK(inputs.supports.empty() ||
                inputs.supports.size() == scores.size() * problem_->supports.size(),
            "one share of the body's weight per motion and support");
  SHG_CHECK(final_angles.empty() || final_angles.size() == scores.size() * dofs,
            "room for one angle per motion and dof");
  const auto lanes = static_cast<std::size_t>(simd_lanes(settings_.simd));
  const std::size_t batches = (scores.size() + lanes - 1) / lanes;
  const auto work = [&](int batch, int worker) {
    const std::size_t first = static_cast<std::size_t>(batch) * lanes;
    const std::size_t count = std::min(lanes, scores.size() - first);
    std::unique_ptr<LaneScorer>& scorer = scorers_[static_cast<std::size_t>(worker)];
    if (!scorer) scorer = kMakers[static_cast<std::size_t>(settings_.simd)](*problem_, *criteria_);
    scorer->score(
        inputs.part(first, count, dofs), scores.subspan(first, count),
        final_angles.empty() ? final_angles : final_angles.subspan(first * dofs, count * dofs));
  };
  parallel_for(static_cast<int>(batches), settings_.threads, std::cref(work));
}

}  // namespace shigusa
