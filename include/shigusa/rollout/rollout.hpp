// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <shigusa/criteria/criteria.hpp>
#include <shigusa/dynamics/centre_of_mass.hpp>
#include <shigusa/dynamics/contact_forces.hpp>
#include <shigusa/rollout/parameters.hpp>
#include <shigusa/rollout/reach_problem.hpp>
#include <utility>
#include <vector>

namespace shigusa {

// From parameters to a motion: follows the problem's paths by weighted IK, frame by frame, and
// shows each frame, with torques and centre of mass, to a visitor. Holds its scratch memory, so
// make one per thread and use it again and again.
template <class S>
class Rollout {
 public:
  explicit Rollout(const ReachProblem& problem)
      : problem_(&problem),
        targets_(ik_targets(problem)),
        ik_(*problem.body),
        dynamics_(*problem.body),
        kinematics_{Kinematics<S>(*problem.body), Kinematics<S>(*problem.body)},
        angles_(3, std::vector<S>(problem.body->dofs().size())),
        speeds_(problem.body->dofs().size()),
        accelerations_(speeds_),
        torques_(speeds_),
        step_(speeds_),
        unlocked_(speeds_),
        reference_(problem.guide.size()) {}

  // inverse_weights (dofs): see weighted_ik_step. visit(const MotionFrame<S>&, const
  // Kinematics<S>&) is called for the frames 0..steps in order.
  template <class Visitor>
  ReachOutcome run(std::span<const S> inverse_weights, Visitor&& visit) {
    const BodyModel& body = *problem_->body;
    ReachOutcome outcome;
    for (std::size_t i = 0; i < targets_.size(); ++i) targets_[i].lag = S(0);
    for (std::size_t d = 0; d < speeds_.size(); ++d) {
      angles_[0][d] = angles_[1][d] = S(body.start()[d]);
      unlocked_[d] = select(inverse_weights[d] > S(0), S(1), S(0));
    }
    forward_kinematics<S>(body, angles_[1], kinematics_[0]);
    for (int frame = 0; frame < problem_->steps; ++frame) {
      angles_[2] = angles_[1];
      kinematics_[1] = kinematics_[0];
      follow(frame + 1, inverse_weights, outcome);
      show_frame(visit);
      std::rotate(angles_.begin(), angles_.begin() + 1, angles_.end());
      std::swap(kinematics_[0], kinematics_[1]);
    }
    // the motion ends at rest
    angles_[2] = angles_[1];
    show_frame(visit);
    return outcome;
  }

 private:
  // moves the angles of the next frame to where the paths are then
  void follow(int frame, std::span<const S> inverse_weights, ReachOutcome& outcome) {
    const bool last = frame == problem_->steps;
    const double tau = static_cast<double>(frame) / problem_->steps;
    for (std::size_t g = 0; g < problem_->goals.size(); ++g) {
      targets_[g].position = to_scalar<S>(problem_->goals[g].path.at(tau));
    }
    const int corrections = last ? problem_->goal_corrections : problem_->corrections;
    const double tolerance = last ? problem_->goal_tolerance : problem_->path_tolerance;
    draw_to_guide(frame);
    std::span<const S> reference = reference_;
    const std::size_t skipped = problem_->follow_path || last ? 0 : problem_->goals.size();
    const auto targets = std::span<IkTarget<S>>(targets_).subspan(skipped);
    ReachOutcome now;
    for (int k = 0; k <= corrections; ++k) {
      step(targets, inverse_weights, reference);
      reference = {};
      now = measure(targets);
      if (now.path_error <= tolerance && contact_error(now) <= tolerance) break;
    }
    // a goal out of reach, or weights that are far apart, do not take a planted foot along
    const auto contacts = std::span<const IkTarget<S>>(targets_).subspan(problem_->goals.size());
    for (int k = 0; k < problem_->contact_corrections; ++k) {
      if (contact_error(now) <= problem_->contact_slack) break;
      step(contacts, unlocked_, {});
      now = measure(targets);
    }
    outcome.path_error = max(outcome.path_error, now.path_error);
    outcome.contact_slide = max(outcome.contact_slide, now.contact_slide);
    outcome.contact_tilt = max(outcome.contact_tilt, now.contact_tilt);
    if (last) outcome.goal_error = now.path_error;
  }

  void step(std::span<const IkTarget<S>> targets, std::span<const S> inverse_weights,
            std::span<const S> reference) {
    weighted_ik_step<S>(*problem_->body, kinematics_[1], targets, inverse_weights, reference,
                        problem_->ik, ik_, step_);
    for (std::size_t d = 0; d < step_.size(); ++d) angles_[2][d] = angles_[2][d] + step_[d];
    forward_kinematics<S>(*problem_->body, angles_[2], kinematics_[1]);
  }

  // the step that, taken in every frame, follows the minimum-jerk profile into the guide posture
  void draw_to_guide(int frame) {
    const double before = minimum_jerk(static_cast<double>(frame - 1) / problem_->steps);
    const double now = minimum_jerk(static_cast<double>(frame) / problem_->steps);
    for (std::size_t d = 0; d < reference_.size(); ++d) {
      reference_[d] = (S(problem_->guide[d]) - angles_[2][d]) * S((now - before) / (1.0 - before));
    }
  }

  // how far the targets are missed now
  ReachOutcome measure(std::span<IkTarget<S>> targets) {
    ReachOutcome now;
    for (IkTarget<S>& target : targets) {
      const S miss = norm(target.position - kinematics_[1].point(target.link, target.point));
      if (!target.contact) {
        target.lag = miss;
        now.path_error = max(now.path_error, miss);
        continue;
      }
      now.contact_slide = max(now.contact_slide, miss);
      const Mat3<S>& turned = kinematics_[1].link_rotation(target.link);
      now.contact_tilt =
          max(now.contact_tilt, norm(rotation_vector(target.orientation * transpose(turned))));
    }
    return now;
  }

  static double contact_error(const ReachOutcome& outcome) {
    return max(outcome.contact_slide, kContactLength * outcome.contact_tilt);
  }

  // shows the current frame: speeds by central differences to its neighbours
  template <class Visitor>
  void show_frame(Visitor&& visit) {
    const BodyModel& body = *problem_->body;
    const S rate(problem_->steps / problem_->duration);
    for (std::size_t d = 0; d < speeds_.size(); ++d) {
      speeds_[d] = (angles_[2][d] - angles_[0][d]) * (S(0.5) * rate);
      accelerations_[d] =
          ((angles_[2][d] - angles_[1][d]) - (angles_[1][d] - angles_[0][d])) * (rate * rate);
    }
    const Wrench<S> ground =
        inverse_dynamics<S>(body, kinematics_[0], speeds_, accelerations_, dynamics_, torques_);
    if (body.feet().size() == 2) {
      share_ground_wrench<S>(body, kinematics_[0], ground, body.feet()[0], body.feet()[1],
                             torques_);
    }
    visit(MotionFrame<S>{angles_[1], torques_, shigusa::centre_of_mass(body, kinematics_[0])},
          kinematics_[0]);
  }

  const ReachProblem* problem_;
  std::vector<IkTarget<S>> targets_;
  IkWorkspace<S> ik_;
  DynamicsWorkspace<S> dynamics_;
  std::vector<Kinematics<S>> kinematics_;  // of this frame and of the next
  std::vector<std::vector<S>> angles_;     // of the frame before, this one and the next
  std::vector<S> speeds_;
  std::vector<S> accelerations_;
  std::vector<S> torques_;
  std::vector<S> step_;
  std::vector<S> unlocked_;   // (dofs) 1, or 0 where locked
  std::vector<S> reference_;  // (dofs), or empty without a guide
};

// A motion with all that is known of it.
struct RolledOut {
  Motion motion;
  ReachOutcome outcome;
};

// Generates and keeps the whole motion for the parameters.
[[nodiscard]] RolledOut roll_out(const ReachProblem& problem, const Parameters& parameters);

}  // namespace shigusa
