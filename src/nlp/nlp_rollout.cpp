// SPDX-License-Identifier: MIT
#include "nlp/nlp_rollout.hpp"

#include <algorithm>

#include "rollout/record_motion.hpp"

namespace shigusa {

NlpRollout::NlpRollout(const ReachProblem& problem, const NlpIkSettings& settings)
    : problem_(&problem),
      contacts_from_(problem.goals.size()),
      targets_(constraints(problem)),
      ik_(*problem.body, problem.start(), settings),
      limits_(*problem.body, problem.start()),
      dynamics_(problem),
      now_(*problem.body),
      next_(*problem.body),
      angles_(3, std::vector<double>(problem.body->dofs().size())),
      reference_(problem.body->dofs().size()),
      posture_draw_(problem) {
  SHG_CHECK(problem.steps >= 1 && problem.duration > 0.0, "steps and duration of a motion");
  SHG_CHECK(problem.supports.empty(), "NLP-IK knows no hands that rest");
  SHG_CHECK(problem.guide.empty() || problem.guide.size() == reference_.size(),
            "one angle of the guide per dof");
}

void NlpRollout::begin(const MotionInput<double>& input) {
  SHG_CHECK(input.posture.empty() || input.posture.size() == reference_.size(),
            "one change of posture per dof");
  const std::span<const double> start = problem_->start().angles;
  for (std::vector<double>& angles : angles_) angles.assign(start.begin(), start.end());
  for (Constraint<double>& target : targets_) {
    target.lag = 0.0;
    target.lead = target.tilt_lead = {};
  }
  drawn_ = !problem_->guide.empty() || !input.posture.empty();
  ik_.begin(targets_, input.inverse_weights);
  forward_kinematics<double>(*problem_->body, start, now_);
}

// Moves the angles of the next frame to its points on the paths.
void NlpRollout::follow(int frame, const MotionInput<double>& input, ReachOutcome& outcome) {
  const bool last = frame == problem_->steps;
  place_goals(frame, input);
  draw_null_space(frame, input);
  const std::size_t skipped = problem_->follow_path || last ? 0 : contacts_from_;
  const auto targets = std::span<Constraint<double>>(targets_).subspan(skipped);
  const std::span<const double> reference =
      drawn_ ? std::span<const double>(reference_) : std::span<const double>{};
  (void)ik_.solve(targets, angles_[1], reference, angles_[2]);
  // removes excess by rounding
  limits_.hold(angles_[2]);
  forward_kinematics<double>(*problem_->body, angles_[2], next_);
  measure(targets, last, outcome);
}

void NlpRollout::advance() {
  std::rotate(angles_.begin(), angles_.begin() + 1, angles_.end());
  std::swap(now_, next_);
}

// Sets the effectors' targets in this frame.
void NlpRollout::place_goals(int frame, const MotionInput<double>& input) {
  const double tau = problem_->tau(frame);
  for (std::size_t g = 0; g < contacts_from_; ++g) {
    const ReachGoal& goal = problem_->goals[g];
    targets_[g].place = goal.place_at(tau);
    const double done = goal.path.done(tau);
    if (!input.posture.empty()) {
      targets_[g].place += goal.bow * (path_bow(done, input.timing.skew) * input.timing.bow) +
                           goal.sway * (path_bow(done, 0.0) * input.timing.sway);
    }
    if (!targets_[g].turns()) continue;
    targets_[g].orientation = goal.turn_at(tau);
    targets_[g].direction = targets_[g].orientation.cx;
  }
}

// Sets the null-space reference of this frame, as in Rollout.
void NlpRollout::draw_null_space(int frame, const MotionInput<double>& input) {
  if (!drawn_) return;
  const auto tau = [&](int f) { return problem_->tau(f); };
  if (!problem_->guide.empty()) {
    const double share = share_of_rest(minimum_jerk(tau(frame - 1)), minimum_jerk(tau(frame)));
    for (std::size_t d = 0; d < reference_.size(); ++d) {
      reference_[d] = (problem_->guide[d] - angles_[1][d]) * share;
    }
    return;
  }
  posture_draw_.draw(frame, input.posture, input.inverse_weights, input.timing.delay, reference_);
}

void NlpRollout::measure(std::span<Constraint<double>> targets, bool last, ReachOutcome& outcome) {
  // the maximum of both; a NaN of the first persists
  const auto worse = [](double before, double now) { return max(now, before) + (before - before); };
  double missed = 0.0;
  for (Constraint<double>& target : targets) {
    if (!target.counts) continue;
    double miss = norm(position_error(next_, target));
    if (!target.exact) {
      if (target.turns()) {
        const double turn = norm(turn_error(next_, target)) * kTurnLength;
        miss = worse(miss, turn * (last ? 1.0 : kTurnOnWay));
      }
      target.lag = miss;
      missed = worse(missed, miss);
      continue;
    }
    outcome.contact_slide = worse(outcome.contact_slide, miss);
    outcome.contact_tilt = worse(outcome.contact_tilt, tilt(next_, target));
  }
  outcome.path_error = worse(outcome.path_error, missed);
  if (last) outcome.goal_error = missed;
}

RolledOut roll_out_nlp(const ReachProblem& problem, const Parameters& parameters) {
  return record_motion(problem, parameters, NlpRollout(problem));
}

}  // namespace shigusa
