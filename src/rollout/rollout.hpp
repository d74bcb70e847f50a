// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <shigusa/parameters.hpp>
#include <vector>

#include "criteria/built_in_criteria.hpp"
#include "plan/motion_input.hpp"
#include "rollout/frame_dynamics.hpp"
#include "rollout/hand_supports.hpp"
#include "rollout/limit_guard.hpp"
#include "rollout/posture_draw.hpp"
#include "rollout/posture_law.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Share of the duration after which heels lift towards a guide's posture.
inline constexpr double kHeelsBegin = 0.55;

// Treatment of a motion that has left its path, or moved a planted foot, beyond the tolerance:
// later frames cannot make up for it.
enum class LostMotion {
  corrected,  // as any other, so that it ends as near to its goal as possible
  left,       // no further corrections: other lanes would wait for them
};

// Generates a motion from parameters: follows the problem's paths by weighted IK, frame by frame,
// and passes each frame, with torques and centre of mass, to a visitor. S is double, or a pack
// whose lanes have separate parameters. Owns scratch memory: use one object per thread, repeatedly.
template <class S>
class Rollout {
 public:
  explicit Rollout(const ReachProblem& problem, LostMotion lost = LostMotion::corrected)
      : problem_(&problem),
        lost_(lost),
        contacts_from_(problem.goals.size()),
        ik_(*problem.body),
        dynamics_(problem),
        kinematics_{Kinematics<S>(*problem.body), Kinematics<S>(*problem.body)},
        angles_(3, std::vector<S>(problem.body->dofs().size())),
        unlocked_(problem.body->dofs().size()),
        reference_(unlocked_),
        posture_draw_(problem),
        law_(problem),
        momentum_(problem.momentum()),
        rest_(momentum_.size()),
        supports_(problem) {
    for (std::size_t d = 0; d < unlocked_.size(); ++d) {
      if (law_.bends_back(d)) backs_.push_back(d);
    }
    if (!momentum_.empty()) rest_placed_.emplace(*problem.body);
    if (problem.hold_limits) limits_.emplace(*problem.body, problem.start());
    for (const Constraint<double>& constraint : constraints(problem)) {
      constraints_.push_back(in_lanes<S>(constraint));
    }
    without_leads_.reserve(constraints_.size());
    for (const ReachGoal& goal : problem.goals) {
      turning_ = turning_ || goal.turn.kind != Turning::free;
    }
    for (int frame = 0; frame <= problem.steps; ++frame) {
      const double tau = problem.tau(frame);
      for (const ReachGoal& goal : problem.goals) {
        paths_.push_back(to_scalar<Element<S>>(goal.place_at(tau)));
        if (turning_) {
          turns_.push_back(to_scalar<Element<S>>(goal.turn_at(tau)));
        }
      }
    }
  }

  // Rolls out one motion. visit(const PlacedFrame<S>&) is called for the frames 0..steps in order.
  template <class Visitor>
  BasicReachOutcome<S> run(const MotionInput<S>& input, Visitor&& visit) {
    const BodyModel& body = *problem_->body;
    BasicReachOutcome<S> outcome;
    for (Constraint<S>& constraint : constraints_) {
      constraint.lag = S(0);
      constraint.lead = constraint.tilt_lead = {};
    }
    now_ = 0;
    drawn_ =
        !problem_->guide.empty() || !input.posture.empty() || !law_.empty() || !momentum_.empty();
    if (limits_) limits_->reset();
    for (std::size_t d = 0; d < unlocked_.size(); ++d) {
      angles_[0][d] = angles_[1][d] = S(problem_->start().angles[d]);
      unlocked_[d] = select(input.inverse_weights[d] > S(0), S(1), S(0));
    }
    move_before();
    forward_kinematics<S>(body, angles_[1], now());
    if (!supports_.empty()) dynamics_.begin(supports_.begin(input.supports, hands()));
    show([&](int frame) { follow(frame, input, outcome); }, visit);
    return outcome;
  }

  // Corrects a known motion: `angles` (frames × dofs, rad) are brought back to the paths and
  // contacts, frame by frame.
  template <class Visitor>
  BasicReachOutcome<S> retrace(const MotionInput<S>& input, std::span<const S> angles,
                               Visitor&& visit) {
    const std::size_t dofs = unlocked_.size();
    BasicReachOutcome<S> outcome;
    now_ = 0;
    if (limits_) limits_->reset();
    std::copy_n(angles.begin(), dofs, angles_[0].begin());
    angles_[1] = angles_[0];
    move_before();
    forward_kinematics<S>(*problem_->body, angles_[1], now());
    if (!supports_.empty()) dynamics_.begin(supports_.begin(input.supports, hands()));
    const auto next_frame = [&](int frame) {
      std::copy_n(angles.begin() + static_cast<std::ptrdiff_t>(index(frame) * dofs), dofs,
                  angles_[2].begin());
      return_to_paths(frame, input, outcome);
    };
    show(next_frame, visit);
    return outcome;
  }

  // (dofs, rad) the last frame of the last motion.
  [[nodiscard]] std::span<const S> final_angles() const { return angles_[1]; }

 private:
  // Placements in this frame and in the next.
  [[nodiscard]] Kinematics<S>& now() { return kinematics_[now_]; }
  [[nodiscard]] Kinematics<S>& next() { return kinematics_[1 - now_]; }

  // The planted feet, then the resting hands.
  [[nodiscard]] std::span<Constraint<S>> contacts() {
    return std::span(constraints_).subspan(contacts_from_);
  }
  // The constraints of a frame; `goals`: whether effectors keep to their paths in it.
  [[nodiscard]] std::span<Constraint<S>> held_by(bool goals) {
    return goals ? std::span(constraints_) : contacts();
  }
  [[nodiscard]] std::span<Constraint<S>> hands() {
    return std::span(constraints_).last(problem_->supports.size());
  }

  // Visits all frames; `move` computes each next one.
  template <class Move, class Visitor>
  void show(Move&& move, Visitor&& visit) {
    for (int frame = 1; frame <= problem_->steps; ++frame) {
      move(frame);
      visit(dynamics_.frame(angles_, now()));
      std::rotate(angles_.begin(), angles_.begin() + 1, angles_.end());
      now_ = 1 - now_;
    }
    // the motion ends at rest
    angles_[2] = angles_[1];
    visit(dynamics_.frame(angles_, now()));
  }

  // Moves the angles of the next frame to its points on the paths.
  void follow(int frame, const MotionInput<S>& input, BasicReachOutcome<S>& outcome) {
    const bool last = frame == problem_->steps;
    place_goals(frame, input);
    if (!supports_.empty()) supports_.place(frame, now(), hands());
    const std::span<Constraint<S>> held = held_by(problem_->follow_path || last);
    draw_null_space(frame, input);
    step(held, input.inverse_weights);
    BasicReachOutcome<S> missed = measure(frame, held, last, true);
    const int corrections = last ? problem_->goal_corrections : problem_->corrections;
    const S slack(last ? problem_->goal_tolerance : problem_->path_slack);
    for (int k = 0; k < corrections; ++k) {
      const S worst = max(missed.path_error, contact_error(missed));
      const auto off = (worst > slack) & (worst < S(problem_->rescue_limit)) & wanted(outcome);
      if (!any(off)) break;
      correct(held, input.inverse_weights, off);
      missed = measure(frame, held, last, false);
    }
    // a goal out of reach, or very unequal weights, must not drag a planted foot along
    for (int k = 0; k < problem_->contact_corrections; ++k) {
      const S tilt_as_slide = missed.contact_tilt * S(kReachTolerance / kTiltTolerance);
      const S worst = max(missed.contact_slide, tilt_as_slide);
      const auto off = (worst > S(problem_->contact_slack)) & wanted(outcome);
      if (!any(off)) break;
      correct(contacts(), unlocked_, off);
      missed = measure(frame, held, last, false);
    }
    add(missed, last, outcome);
  }

  // Brings the angles of the next frame back to the paths.
  void return_to_paths(int frame, const MotionInput<S>& input, BasicReachOutcome<S>& outcome) {
    const bool last = frame == problem_->steps;
    place_goals(frame, input);
    if (limits_) limits_->hold(angles_[2]);
    forward_kinematics<S>(*problem_->body, angles_[2], next());
    if (!supports_.empty()) supports_.keep(frame, next(), hands());
    const bool follows = problem_->follow_path && is_finite(problem_->tolerance.path);
    const std::span<Constraint<S>> held = held_by(follows || last);
    for (Constraint<S>& constraint : constraints_) constraint.lead = constraint.tilt_lead = {};
    BasicReachOutcome<S> missed = measure(frame, held, last, false);
    for (int k = 0; k < problem_->goal_corrections; ++k) {
      const auto off = max(missed.path_error, contact_error(missed)) > S(problem_->goal_tolerance);
      if (!any(off)) break;
      // the remaining error is small, so it does not raise the damping
      for (Constraint<S>& constraint : constraints_) constraint.lag = S(0);
      correct(held, input.inverse_weights, off);
      missed = measure(frame, held, last, false);
    }
    add(missed, last, outcome);
  }

  // Adds the errors of one frame.
  static void add(const BasicReachOutcome<S>& missed, bool last, BasicReachOutcome<S>& outcome) {
    outcome.path_error = worse(outcome.path_error, missed.path_error);
    outcome.contact_slide = worse(outcome.contact_slide, missed.contact_slide);
    outcome.contact_tilt = worse(outcome.contact_tilt, missed.contact_tilt);
    if (last) outcome.goal_error = missed.path_error;
  }

  // The lanes whose motions are to be corrected, by the errors before this frame.
  auto wanted(const BasicReachOutcome<S>& outcome) const {
    const auto all = S(0) < S(1);
    return lost_ == LostMotion::left ? outcome.keeps_to(problem_->tolerance) : all;
  }

  // One IK step from this frame to the next.
  void step(std::span<const Constraint<S>> held, std::span<const S> inverse_weights) {
    const std::span<const S> weights = within_limits(inverse_weights, angles_[1]);
    const std::span<const S> reference =
        drawn_ ? std::span<const S>(reference_) : std::span<const S>{};
    // a guide is within the limits, and so are all postures between
    const bool yields = limits_ && drawn_ && problem_->guide.empty();
    const IkStep<S> wanted{held, weights, yields ? limits_->allowed(reference) : reference};
    const std::span<const S> dq =
        weighted_ik_step<S>(*problem_->body, now(), wanted, problem_->ik, ik_);
    for (std::size_t d = 0; d < dq.size(); ++d) angles_[2][d] = angles_[1][d] + dq[d];
    if (limits_) {
      limits_->learn(inverse_weights, ik_.pull, reference);
      limits_->hold(angles_[2]);
    }
    forward_kinematics<S>(*problem_->body, angles_[2], next());
  }

  // One more IK step within the next frame, in the lanes with errors; the remaining error is small,
  // so no lead is added.
  template <class Condition>
  void correct(std::span<const Constraint<S>> held, std::span<const S> inverse_weights,
               const Condition& off) {
    without_leads_.assign(held.begin(), held.end());
    for (Constraint<S>& constraint : without_leads_) constraint.lead = constraint.tilt_lead = {};
    const IkStep<S> wanted{without_leads_, within_limits(inverse_weights, angles_[2])};
    const std::span<const S> dq =
        weighted_ik_step<S>(*problem_->body, next(), wanted, problem_->ik, ik_);
    for (std::size_t d = 0; d < dq.size(); ++d) {
      angles_[2][d] = select(off, angles_[2][d] + dq[d], angles_[2][d]);
    }
    if (limits_) limits_->hold(angles_[2]);
    forward_kinematics<S>(*problem_->body, angles_[2], next());
  }

  // The inverse weights for a step from these angles.
  std::span<const S> within_limits(std::span<const S> inverse_weights, std::span<const S> angles) {
    return limits_ ? limits_->soften(inverse_weights, angles) : inverse_weights;
  }

  // Sets the goals' places in this frame.
  void place_goals(int frame, const MotionInput<S>& input) {
    const double tau = problem_->tau(frame);
    for (std::size_t g = 0; g < contacts_from_; ++g) {
      const std::size_t k = index(frame) * contacts_from_ + g;
      constraints_[g].place = to_scalar<S>(paths_[k]);
      if (turning_) {
        constraints_[g].orientation = to_scalar<S>(turns_[k]);
        constraints_[g].direction = constraints_[g].orientation.cx;
      }
      if (input.posture.empty()) continue;
      const ReachGoal& goal = problem_->goals[g];
      const S done(goal.path.done(tau));
      constraints_[g].place +=
          to_scalar<S>(goal.bow) * (path_bow(done, input.timing.skew) * input.timing.bow) +
          to_scalar<S>(goal.sway) * (path_bow(done, S(0)) * input.timing.sway);
    }
  }

  // Moves the posture before the first frame, from which the start's velocities lead there.
  void move_before() {
    for (std::size_t d = 0; d < momentum_.size(); ++d) {
      angles_[0][d] = angles_[0][d] - S(momentum_[d] / problem_->steps);
    }
  }

  // (dofs, rad) the posture before this frame without what it was carried on by the start's
  // velocities.
  std::span<const S> not_carried(int frame) {
    if (momentum_.empty()) return angles_[1];
    const double done = carried_on(static_cast<double>(frame - 1) / problem_->steps);
    for (std::size_t d = 0; d < momentum_.size(); ++d) {
      rest_[d] = angles_[1][d] - S(momentum_[d] * done);
    }
    return rest_;
  }

  // The placement of those angles, which the law is for: it would move with the momentum twice.
  const Kinematics<S>& placed_without_momentum() {
    if (!rest_placed_) return now();
    forward_kinematics<S>(*problem_->body, std::span<const S>(rest_), *rest_placed_);
    return *rest_placed_;
  }

  // Adds to the reference what this frame is carried on by the start's velocities.
  void carry_on(int frame) {
    const double step = carried_on(static_cast<double>(frame) / problem_->steps) -
                        carried_on(static_cast<double>(frame - 1) / problem_->steps);
    for (std::size_t d = 0; d < momentum_.size(); ++d) {
      reference_[d] = reference_[d] + S(momentum_[d] * step);
    }
  }

  // Sets the null-space reference of this frame: over all frames it follows the minimum-jerk
  // profile into the guide posture, or makes the input's change of posture.
  void draw_null_space(int frame, const MotionInput<S>& input) {
    const bool guided = !problem_->guide.empty();
    const std::span<const S> angles = not_carried(frame);
    if (guided) {
      draw_to_guide(frame, angles);
    } else if (!input.posture.empty()) {
      posture_draw_.draw(frame, input.posture, input.inverse_weights, input.timing.delay,
                         reference_);
      const S bent = posture_draw_.made(TimedPart::spine, frame, input.timing.delay);
      for (const std::size_t d : backs_) {
        reference_[d] = posture_draw_.changed(d, input.posture) * bent;
      }
    } else if (drawn_) {
      for (S& change : reference_) change = S(0);
    }
    if (!supports_.empty()) supports_.keep_arms(reference_);
    if (!law_.empty()) law_.draw(frame, placed_without_momentum(), angles, guided, reference_);
    if (!supports_.empty()) supports_.restore_arms(frame, hands(), reference_);
    carry_on(frame);
  }

  void draw_to_guide(int frame, std::span<const S> angles) {
    const double share = guide_share(frame, 0.0);
    for (std::size_t d = 0; d < reference_.size(); ++d) {
      reference_[d] = (S(problem_->guide[d]) - angles[d]) * S(share);
    }
    // heels lift late, once the weight is over the forefeet; the shank leans as if they had lifted
    const double late = guide_share(frame, kHeelsBegin);
    for (const Foot& foot : problem_->body->feet()) {
      if (!foot.heel) continue;
      S& toes = reference_[index(foot.heel->toes)];
      S& ankle = reference_[index(foot.heel->ankle)];
      const S lean = toes + ankle;
      toes = toes * S(late / share);
      ankle = lean - toes;
    }
  }

  // Share of the remaining way to the guide made in this frame, for a change that begins at a share
  // of the duration.
  double guide_share(int frame, double begin) const {
    const auto done = [&](int f) {
      const double tau = problem_->tau(f);
      return minimum_jerk(max(tau - begin, 0.0) / (1.0 - begin));
    };
    return share_of_rest(done(frame - 1), done(frame));
  }

  // Errors of the constraints; `last`: goals' turns count fully; `learn`: adds the errors to the
  // leads.
  BasicReachOutcome<S> measure(int frame, std::span<Constraint<S>> held, bool last, bool learn) {
    BasicReachOutcome<S> missed;
    const S limit(problem_->lead_limit);
    const double time = static_cast<double>(frame) / problem_->steps;
    for (Constraint<S>& constraint : held) {
      if (!constraint.holds_at(time)) continue;
      const Vec3<S> error = position_error(next(), constraint);
      const S miss = norm(error);
      constraint.lag = miss;
      const auto follows = miss < limit;
      if (learn) constraint.lead = select(follows, constraint.lead + error, Vec3<S>{});
      if (!constraint.counts) continue;
      if (!constraint.exact) {
        const S off = constraint.turns()
                          ? turn_miss(constraint, miss, last ? 1.0 : constraint.turn_counts, learn)
                          : miss;
        missed.path_error = worse(missed.path_error, off);
        continue;
      }
      missed.contact_slide = worse(missed.contact_slide, miss);
      if (!constraint.turns()) continue;
      const Vec3<S> tilted = tilt_error(next(), constraint);
      if (learn) constraint.tilt_lead = select(follows, constraint.tilt_lead + tilted, Vec3<S>{});
      missed.contact_tilt = worse(missed.contact_tilt, tilt(next(), constraint));
    }
    return missed;
  }

  // The larger of the distance and the turn of a goal with an orientation.
  S turn_miss(Constraint<S>& goal, const S& miss, double turn_share, bool learn) {
    const Vec3<S> error = turn_error(next(), goal);
    const S turn = norm(error) * S(kTurnLength);
    if (learn) {
      const auto follows = turn < S(problem_->lead_limit);
      goal.tilt_lead = select(follows, goal.tilt_lead + error, Vec3<S>{});
    }
    goal.lag = max(goal.lag, turn);
    return worse(miss, turn * S(turn_share));
  }

  // The maximum of both; a NaN of the first persists.
  static S worse(const S& before, const S& now) { return max(now, before) + (before - before); }

  static S contact_error(const BasicReachOutcome<S>& outcome) {
    return max(outcome.contact_slide, S(kContactLength) * outcome.contact_tilt);
  }

  const ReachProblem* problem_;
  LostMotion lost_;
  std::size_t contacts_from_;  // index of the first contact, after the goals
  std::vector<Constraint<S>> constraints_;
  std::vector<Constraint<S>> without_leads_;  // those of a correction
  std::vector<Vec3<Element<S>>> paths_;       // (frames × goals) m, world
  bool turning_ = false;                      // whether some goal has an orientation
  std::vector<Mat3<Element<S>>> turns_;       // (frames × goals) R_WL, or empty
  IkWorkspace<S> ik_;
  FrameDynamics<S> dynamics_;
  std::vector<Kinematics<S>> kinematics_;  // of this frame and of the next, alternating
  std::size_t now_ = 0;                    // index of this frame's
  std::vector<std::vector<S>> angles_;     // of the frame before, this one and the next
  std::vector<S> unlocked_;                // (dofs) 1, or 0 if locked
  bool drawn_ = false;                     // whether the null space has a reference
  std::vector<S> reference_;               // (dofs, rad) of this frame
  PostureDraw<S> posture_draw_;
  PostureLaw<S> law_;
  std::vector<double> momentum_;              // (dofs) rad, or empty: see ReachProblem::momentum
  std::vector<S> rest_;                       // (dofs, rad) see not_carried()
  std::optional<Kinematics<S>> rest_placed_;  // empty without momentum
  HandSupports<S> supports_;
  std::vector<std::size_t> backs_;  // dofs of the back, bent by the law beside the posture
  std::optional<LimitGuard<S>> limits_;
};

// A motion with its outcome.
struct RolledOut {
  Motion motion;
  ReachOutcome outcome;
};

// Generates and records the whole motion of the parameters.
[[nodiscard]] RolledOut roll_out(const ReachProblem& problem, const Parameters& parameters);

}  // namespace shigusa
