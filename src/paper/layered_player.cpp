// SPDX-License-Identifier: MIT
#include "paper/layered_player.hpp"

#include <utility>

#include "core/check.hpp"
#include "rollout/record_motion.hpp"

namespace shigusa {

std::vector<double> upper_weights(const LayeredValues& parameters) {
  std::vector<double> inverse;
  for (const JointWeight& joint : parameters.joints) {
    inverse.push_back(joint.locked ? 0.0 : 1.0 / joint.weight);
  }
  return inverse;
}

LayeredPlayer::LayeredPlayer(const LayeredProblem& problem)
    : setup_(std::make_unique<LayeredSetup>(problem)),
      rollout_(std::make_unique<LayeredRollout<double>>(*setup_)) {
  const BodyModel& body = setup_->body();
  for (const BodyLimb& leg : problem.limbs.legs) {
    const Dof& ankle = body.dof(leg.ankle);
    const Dof& knee = body.dof(leg.hinge);
    ranges_.emplace_back(leg.segments,
                         PelvisRange::Limits{ankle.lower, ankle.upper, knee.lower, knee.upper});
  }
}

LayeredPlayer::LayeredPlayer(LayeredPlayer&&) noexcept = default;
LayeredPlayer::~LayeredPlayer() = default;

void LayeredPlayer::run_upper(const LayeredValues& parameters, ReducedClip<double>& clip) {
  rollout_->run_upper({upper_weights(parameters), parameters.contractions});
  clip = rollout_->clip();
}

std::vector<HandPath> LayeredPlayer::hand_paths(const ReducedClip<double>& clip) {
  rollout_->take(clip);
  return rollout_->paths();
}

LayeredPlayer::PelvisCheck LayeredPlayer::check_pelvis(const ReducedClip<double>& clip) {
  rollout_->take(clip);
  PelvisCheck check{.in_reach = rollout_->in_reach()};
  const LayeredProblem& problem = *setup_->problem;
  for (int f = 1; f <= problem.reach.steps; ++f) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const BodyLimb& leg = problem.limbs.legs[i];
      const auto line = rollout_->leg_line(i, f);
      check.excess = max(check.excess, ranges_[i].excess(line.lean, line.length));
      if (leg.inversion < 0) continue;
      const Dof& ankle = setup_->body().dof(leg.inversion);
      const double angle = (leg.carries ? ankle.sign : -ankle.sign) * line.turn;
      check.excess = max(check.excess, max(angle - ankle.upper, ankle.lower - angle));
    }
  }
  return check;
}

std::vector<double> LayeredPlayer::find_swivels(const ReducedClip<double>& clip) {
  rollout_->take(clip);
  std::vector<double> swivels;
  for (const LayeredSetup::GoalArm& arm : setup_->arms) {
    if (arm.by_swivel) swivels.push_back(0.0);
  }
  rollout_->find_swivels(swivels);
  return swivels;
}

RolledOut LayeredPlayer::played(const ReducedClip<double>& clip, const LayeredValues& parameters,
                                bool freeing) {
  SHG_CHECK(parameters.arms.size() + parameters.swivels.size() == setup_->arms.size() &&
                parameters.finals.size() == setup_->finals.size(),
            "parameters of the layers that are played");
  std::vector<double> weights;
  for (const ArmWeights& arm : parameters.arms) {
    const std::vector<double> own = inverse_weights(arm);
    weights.insert(weights.end(), own.begin(), own.end());
  }
  rollout_->take(clip);
  rollout_->move_arms({weights, parameters.swivels, parameters.finals}, freeing);
  MotionRecorder recorder(setup_->problem->reach);
  const ReachOutcome outcome = rollout_->play(parameters.finals, recorder);
  return {std::move(recorder.motion), outcome};
}

RolledOut LayeredPlayer::expand(const ReducedClip<double>& clip, const LayeredValues& parameters) {
  return played(clip, parameters, false);
}

RolledOut LayeredPlayer::expand_freeing(const ReducedClip<double>& clip,
                                        LayeredValues& parameters) {
  RolledOut rolled = played(clip, parameters, true);
  for (std::size_t g = 0; g < setup_->arms.size(); ++g) {
    const LayeredSetup::GoalArm& arm = setup_->arms[g];
    const bool follows = rollout_->arm_misses()[g] <= setup_->problem->reach.tolerance.path;
    if (!follows && !arm.by_swivel) parameters.arms[arm.slot] = {};
  }
  return rolled;
}

}  // namespace shigusa
