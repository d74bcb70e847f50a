// SPDX-License-Identifier: MIT
#include "swivel_search.hpp"

#include <shigusa/motion_measures.hpp>
#include <utility>

#include "criteria/built_in_criteria.hpp"
#include "motion/jolt.hpp"

namespace shigusa {
namespace {

constexpr int kCoarsePoints = 6;  // every 30°
constexpr int kGridPoints = 11;   // every 15°
constexpr int kGoldenSteps = 6;   // to within a degree
constexpr double kGolden = 0.6180339887498949;

}  // namespace

SwivelSearch::SwivelSearch(const BodyModel& arm, const BodyLimb& limb, const Layer& layer)
    : arm_(&arm), layer_(&layer), moved_(arm, limb), dynamics_(arm), placed_(arm) {}

double SwivelSearch::coarse(const ArmFeedback& feedback) {
  return best_of_grid(feedback, kCoarsePoints).swivel;
}

double SwivelSearch::fine(const ArmFeedback& feedback) {
  Best best = best_of_grid(feedback, kGridPoints);
  const ParameterInfo& range = layer_->parameters.front();
  const double step = (range.high - range.low) / (kGridPoints - 1);
  double low = max(best.swivel - step, range.low);
  double high = min(best.swivel + step, range.high);
  const auto at = [&](double share) {
    const double swivel = low + share * (high - low);
    const double scored = score(feedback, swivel);
    if (scored < best.score) best = {swivel, scored};
    return scored;
  };
  double below = at(1.0 - kGolden);
  double above = at(kGolden);
  for (int k = 0; k < kGoldenSteps; ++k) {
    if (below < above) {
      high = low + kGolden * (high - low);
      above = std::exchange(below, at(1.0 - kGolden));
    } else {
      low = low + (1.0 - kGolden) * (high - low);
      below = std::exchange(above, at(kGolden));
    }
  }
  return best.swivel;
}

SwivelSearch::Best SwivelSearch::best_of_grid(const ArmFeedback& feedback, int points) {
  const ParameterInfo& range = layer_->parameters.front();
  Best best{.swivel = 0.0, .score = score(feedback, 0.0)};
  for (int k = 0; k < points; ++k) {
    const double swivel = min(range.high, range.low + (range.high - range.low) * k / (points - 1));
    const double scored = score(feedback, swivel);
    if (scored < best.score) best = {swivel, scored};
  }
  return best;
}

double SwivelSearch::score(const ArmFeedback& feedback, double swivel) {
  const auto frames = static_cast<int>(feedback.path.size());
  Clip clip{.dofs = arm_->dof_count(),
            .frames = frames,
            .frame_time = feedback.duration / (frames - 1),
            .angles = {}};
  moved_.run(feedback.path, swivel, clip.angles, feedback.turn);
  double cost = 0.0;
  for (const LimitExcess& over : limit_excess(*arm_, clip)) cost += kSwivelOver + over.excess;
  if (jolts(clip)) cost += kSwivelOver;
  const double depth = depth_along(feedback, clip, placed_);
  cost += kSwivelCollisionWeight * clamp(depth / kCollisionFull, 0.0, 1.0);
  const Motion motion = dynamics_.completed(std::move(clip));
  return cost + score_motion(*arm_, motion, layer_->criteria).total;
}

}  // namespace shigusa
