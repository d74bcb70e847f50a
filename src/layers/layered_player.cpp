// SPDX-License-Identifier: MIT
#include "layers/layered_player.hpp"

#include <algorithm>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

// how the knee turns the thigh on the shank, seen from the foot
double climbing_sign(const BodyModel& body, const BodyLimb& leg) {
  const double sign = body.dof(leg.hinge).sign;
  return leg.carries ? sign : -sign;
}

// the ankle's freedom that is next to the foot
int foot_dof(const BodyLimb& leg) { return leg.inversion < 0 ? leg.ankle : leg.inversion; }

int foot_link(const BodyLimb& leg) { return leg.carries ? kBaseLink : foot_dof(leg); }

// m, of the ankle in its foot's frame
Vec3d ankle_in_foot(const BodyModel& body, const BodyLimb& leg) {
  return leg.carries ? body.dof(foot_dof(leg)).offset : Vec3d{};
}

// how an ankle's inversion turns the shank on the foot about z
double inversion_sign(const BodyModel& body, const BodyLimb& leg) {
  const double sign = body.dof(leg.inversion).sign;
  return leg.carries ? sign : -sign;
}

}  // namespace

EffectorTurn hand_turn(const LayeredProblem& problem, const ReducedClip& clip, std::size_t goal) {
  EffectorTurn turn = problem.reach.goals[goal].turn;
  const Mat3d& carrier = clip.carriers[goal].back().rotation;
  turn.start = transpose(carrier) * turn.start;
  turn.goal = transpose(carrier) * turn.goal;
  turn.direction = transpose_times(carrier, turn.direction);
  return turn;
}

LayeredPlayer::LayeredPlayer(const LayeredProblem& problem)
    : problem_(&problem),
      body_(problem.reach.body),
      upper_(problem.layers[0].body, problem.reach),
      start_(*body_),
      placed_(*body_),
      whole_(*body_),
      law_(problem.reach),
      drawn_(body_->dofs().size()) {
  forward_kinematics<double>(*body_, body_->start(), start_);
  std::size_t by_weights = 0;
  std::size_t by_swivel = 0;
  for (std::size_t g = 0; g < problem.arms.size(); ++g) {
    const BodyModel& arm = problem.arm_bodies[g];
    if (searches(problem.layers[1 + g], ParameterKind::swivel)) {
      const BodyLimb& limb = problem.limbs.arms[index(problem.arms[g])];
      arms_.push_back({.by_swivel = std::make_unique<SwivelArm>(arm, limb), .slot = by_swivel++});
    } else {
      arms_.push_back({.by_weights = std::make_unique<ArmRollout>(arm), .slot = by_weights++});
    }
  }
  for (const Layer& layer : problem.layers) add_finals(layer);
  for (const TrunkJoint& joint : problem.layers[0].body.joints) {
    const bool used = std::any_of(problem.arms.begin(), problem.arms.end(), [&](int arm) {
      return body_->moves(joint.of_body, problem.limbs.arms[index(arm)].carrier);
    });
    if (used) joints_.push_back(joint);
  }
  for (const BodyLimb& leg : problem.limbs.legs) {
    const Dof& ankle = body_->dof(leg.ankle);
    const Dof& knee = body_->dof(leg.hinge);
    ranges_.emplace_back(leg.segments,
                         PelvisRange::Limits{ankle.lower, ankle.upper, knee.lower, knee.upper});
  }
}

void LayeredPlayer::add_finals(const Layer& layer) {
  for (const ParameterInfo& info : layer.parameters) {
    if (info.kind != ParameterKind::final_angle) continue;
    const ReducedDof& dof = layer.body.dofs[index(info.applies_to[0])];
    finals_.push_back({index(body_->find_dof(dof.name).value()), dof.start});
  }
}

std::vector<HandPath> LayeredPlayer::hand_paths(const ReducedClip& clip) const {
  std::vector<HandPath> paths(problem_->arms.size());
  for (std::size_t g = 0; g < paths.size(); ++g) {
    const BodyLimb& arm = problem_->limbs.arms[index(problem_->arms[g])];
    for (std::size_t f = 0; f < clip.trunk.size(); ++f) {
      const Transformd& carrier = clip.carriers[g][f];
      const Vec3d hand = clip.hands[g][f] - carrier.translation;
      paths[g].push_back(transpose_times(carrier.rotation, hand) - arm.root);
    }
  }
  return paths;
}

// where the hip is from the foot
LayeredPlayer::LegLine LayeredPlayer::leg_line(const BodyLimb& leg, const ReducedClip& clip,
                                               int frame) const {
  // the base's leg has them as freedoms of its own, the first ones
  if (leg.carries && leg.inversion < 0) return {clip.frame(frame)[0], clip.frame(frame)[1]};
  if (leg.carries) {
    const std::span<const double> values = clip.frame(frame);
    return {values[1], values[2], inversion_sign(*body_, leg) * values[0]};
  }
  const Vec3d hip = clip.trunk[index(frame)] * leg.root;
  const int foot = foot_link(leg);
  Vec3d line = transpose_times(start_.link_rotation(foot),
                               hip - start_.point(foot, ankle_in_foot(*body_, leg)));
  double turn = 0.0;
  if (leg.inversion >= 0) {
    turn = plane_turn(line, leg.segments.across());
    line = transpose_times(rotation(Axis::z, turn), line);
  }
  return {atan2(line.z, line.y), sqrt(line.y * line.y + line.z * line.z), turn};
}

// rad, of the ankle
double LayeredPlayer::inversion(const BodyLimb& leg, const LegLine& line) const {
  return inversion_sign(*body_, leg) * line.turn;
}

LayeredPlayer::PelvisCheck LayeredPlayer::check_pelvis(const ReducedClip& clip) const {
  PelvisCheck check;
  for (int f = 1; f <= problem_->reach.steps; ++f) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const BodyLimb& leg = problem_->limbs.legs[i];
      const LegLine line = leg_line(leg, clip, f);
      check.excess = max(check.excess, ranges_[i].excess(line.lean, line.length));
      if (leg.inversion >= 0) {
        const Dof& ankle = body_->dof(leg.inversion);
        const double angle = inversion(leg, line);
        check.excess = max(check.excess, max(angle - ankle.upper, ankle.lower - angle));
      }
      if (line.length > leg.segments.longest() || line.length < leg.segments.shortest()) {
        check.in_reach = false;
      }
    }
  }
  return check;
}

// `angles` has the frame before's, to go on from
void LayeredPlayer::bend_leg(const BodyLimb& leg, const LegLine& line, const Mat3d& trunk,
                             std::span<double> angles) const {
  const double knee = leg.segments.bend(line.length);
  const double ankle = line.lean - leg.segments.direction(knee);
  angles[index(leg.hinge)] = knee;
  angles[index(leg.ankle)] = ankle;
  Mat3d plane = start_.link_rotation(foot_link(leg));
  if (leg.inversion >= 0) {
    angles[index(leg.inversion)] = inversion(leg, line);
    plane = plane * rotation(Axis::z, line.turn);
  }
  const Mat3d thigh = plane * rotation(Axis::x, ankle + climbing_sign(*body_, leg) * knee);
  const BallTurns before = leg.turns_of(*body_, angles);
  leg.put_turns(*body_, ball_turns(transpose(trunk) * thigh, before), angles);
}

// Draws what no goal moves, from where the frame before left it.
void LayeredPlayer::follow_law(int frame, std::span<double> angles) {
  if (law_.empty()) return;
  std::fill(drawn_.begin(), drawn_.end(), 0.0);
  forward_kinematics<double>(*body_, angles, placed_);
  // "guided": clavicles of arms with goals are the upper layer's
  constexpr bool kGuided = true;
  law_.draw(frame, placed_, angles, kGuided, drawn_);
  for (std::size_t d = 0; d < drawn_.size(); ++d) angles[d] += drawn_[d];
}

Clip LayeredPlayer::expanded_clip(const ReducedClip& clip, const ArmAngles& arm_angles,
                                  std::span<const double> finals) {
  const ReachProblem& reach = problem_->reach;
  Clip whole{.dofs = body_->dof_count(),
             .frames = reach.steps + 1,
             .frame_time = reach.duration / reach.steps,
             .angles = {}};
  std::vector<double> angles(body_->start().begin(), body_->start().end());
  whole.angles = angles;
  for (int f = 1; f <= reach.steps; ++f) {
    for (const BodyLimb& leg : problem_->limbs.legs) {
      bend_leg(leg, leg_line(leg, clip, f), clip.trunk[index(f)].rotation, angles);
    }
    for (const TrunkJoint& joint : joints_) {
      angles[index(joint.of_body)] = clip.frame(f)[index(joint.dof)];
    }
    for (std::size_t g = 0; g < arm_angles.size(); ++g) {
      const BodyLimb& arm = problem_->limbs.arms[index(problem_->arms[g])];
      const int dofs = problem_->arm_bodies[g].dof_count();
      const double* at = arm_angles[g].data() + index(f * dofs);
      for (const int dof : arm_dofs(arm, dofs == kTurningArmDofs)) angles[index(dof)] = *at++;
    }
    const double schedule = minimum_jerk(static_cast<double>(f) / reach.steps);
    for (std::size_t k = 0; k < finals_.size(); ++k) {
      angles[finals_[k].dof] = finals_[k].start + (finals[k] - finals_[k].start) * schedule;
    }
    follow_law(f, angles);
    whole.angles.insert(whole.angles.end(), angles.begin(), angles.end());
  }
  return whole;
}

// hands and feet, frame after frame
ReachOutcome LayeredPlayer::measured(Motion& motion) {
  const ReachProblem& reach = problem_->reach;
  ReachOutcome outcome;
  motion.effectors.resize(reach.goals.size());
  for (int f = 0; f <= reach.steps; ++f) {
    const double tau = static_cast<double>(f) / reach.steps;
    forward_kinematics<double>(*body_, motion.clip.frame(f), placed_);
    for (std::size_t g = 0; g < reach.goals.size(); ++g) {
      const Effector& hand = body_->effectors()[index(reach.goals[g].effector)];
      const Vec3d at = placed_.point(hand.link, hand.point);
      motion.effectors[g].push_back(at);
      const double miss = norm(at - reach.goals[g].path.at(tau));
      outcome.path_error = max(outcome.path_error, miss);
      if (f != reach.steps) continue;
      const double turn = reach.goals[g].turn.miss(placed_.link_rotation(hand.link));
      outcome.goal_error = max(outcome.goal_error, max(miss, kTurnLength * turn));
    }
    for (const Foot& foot : body_->feet()) {
      const double slide =
          norm(placed_.point(foot.link, foot.centre) - start_.point(foot.link, foot.centre));
      const double tilt =
          rotation_chord(placed_.link_rotation(foot.link), start_.link_rotation(foot.link));
      outcome.contact_slide = max(outcome.contact_slide, slide);
      outcome.contact_tilt = max(outcome.contact_tilt, tilt);
    }
  }
  return outcome;
}

RolledOut LayeredPlayer::expanded(const ReducedClip& clip, const ArmAngles& arm_angles,
                                  std::span<const double> finals) {
  RolledOut played;
  played.motion = whole_.completed(expanded_clip(clip, arm_angles, finals));
  played.outcome = measured(played.motion);
  return played;
}

void LayeredPlayer::check_counts(const Parameters& parameters) const {
  SHG_CHECK(parameters.arms.size() + parameters.swivels.size() == arms_.size() &&
                parameters.finals.size() == finals_.size(),
            "parameters of the layers that are played");
}

double LayeredPlayer::move_arm(std::size_t goal, const ReducedClip& clip, const HandPath& path,
                               const Parameters& parameters, std::vector<double>& angles) {
  const GoalArm& arm = arms_[goal];
  if (arm.by_swivel) {
    return arm.by_swivel->run(path, parameters.swivels[arm.slot], angles,
                              hand_turn(*problem_, clip, goal));
  }
  return arm.by_weights->run(path, parameters.arms[arm.slot], angles);
}

RolledOut LayeredPlayer::expand(const ReducedClip& clip, const Parameters& parameters) {
  const std::vector<HandPath> paths = hand_paths(clip);
  check_counts(parameters);
  ArmAngles angles(paths.size());
  for (std::size_t g = 0; g < paths.size(); ++g) move_arm(g, clip, paths[g], parameters, angles[g]);
  return expanded(clip, angles, parameters.finals);
}

RolledOut LayeredPlayer::expand_freeing(const ReducedClip& clip, Parameters& parameters) {
  const std::vector<HandPath> paths = hand_paths(clip);
  check_counts(parameters);
  ArmAngles angles(paths.size());
  for (std::size_t g = 0; g < paths.size(); ++g) {
    const double miss = move_arm(g, clip, paths[g], parameters, angles[g]);
    if (miss <= problem_->reach.tolerance.path || !arms_[g].by_weights) continue;
    parameters.arms[arms_[g].slot] = {};
    move_arm(g, clip, paths[g], parameters, angles[g]);
  }
  return expanded(clip, angles, parameters.finals);
}

}  // namespace shigusa
