// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "paper/swivel_search.hpp"
#include "rollout/posture_law.hpp"

namespace shigusa {

// Values of the layers below the upper one, in the form of their rollout.
template <class S>
struct LowerInput {
  std::span<const S> inverse_weights{};  // (arms by weights × kArmDofs) 0 where locked
  std::span<const S> swivels{};          // (arms by swivel) rad
  std::span<const S> finals{};           // (final angles) rad
};

// Plays a hierarchy from the top: the reduced body moves, then its rods become limbs again. Legs
// follow in closed form from the pelvis (paper, section 3.4; rule R3), with their feet planted;
// arms with a goal move along the path of the rod's end, by weights or by their swivel; dofs with a
// final angle move to it with minimum jerk; head, free arm and its clavicle follow PostureLaw, if
// the problem has it; all others stay.
//
// S is double, or a pack whose lanes have separate parameters. Owns scratch memory: one per thread.
// The setup outlives it.
template <class S>
class LayeredRollout {
 public:
  explicit LayeredRollout(const LayeredSetup& setup)
      : setup_(&setup),
        body_(&setup.body()),
        upper_(setup.upper),
        paths_(setup.arms.size()),
        arm_angles_(setup.arms.size()),
        arm_misses_(setup.arms.size()),
        dynamics_(setup.problem->reach),
        kinematics_{Kinematics<S>(*body_), Kinematics<S>(*body_)},
        angles_(3, std::vector<S>(body_->dofs().size())),
        drawn_(body_->dofs().size()),
        unlocked_(kArmDofs, S(1)),
        law_(setup.problem->reach) {
    for (std::size_t g = 0; g < setup.arms.size(); ++g) {
      if (setup.arms[g].by_swivel) {
        swivels_.push_back({g, SwivelArm<S>(setup.problem->arm_bodies[g], setup.arm(g)),
                            SwivelSearch<S>(setup, g, Pace::coarse)});
      } else {
        rollouts_.push_back({g, ArmRollout<S>(setup.problem->arm_bodies[g])});
      }
    }
    for (const BodyLimb& limb : setup.problem->limbs.legs) legs_.push_back(leg_of(limb));
  }

  // Moves the upper layer, and finds the paths of its hands.
  void run_upper(const ReducedInput<S>& input) {
    upper_.run(input, clip_);
    find_paths();
  }
  // Adopts a motion of the upper layer.
  void take(const ReducedClip<S>& clip) {
    clip_ = clip;
    find_paths();
  }

  [[nodiscard]] const ReducedClip<S>& clip() const { return clip_; }
  // (goals) of the upper layer's motion.
  [[nodiscard]] const std::vector<HandPathOf<S>>& paths() const { return paths_; }

  // Tolerance (m) for a leg's length beyond its range, for rounding.
  static constexpr double kLegSlack = sizeof(Element<S>) == sizeof(double) ? 0.0 : 2e-6;

  // Whether all legs can have the lengths of the upper layer's motion.
  [[nodiscard]] auto in_reach() const {
    auto within = S(0) <= S(1);
    for (int f = 1; f <= steps(); ++f) {
      for (const Leg& leg : legs_) {
        const S length = leg_line(leg, f).length;
        const auto not_over = length <= leg.segments.longest() + S(kLegSlack);
        const auto not_under = length >= leg.segments.shortest() - S(kLegSlack);
        within = within & not_over & not_under;
      }
    }
    return within;
  }

  // Finds the best of a few swivels (arms by swivel).
  void find_swivels(std::span<S> swivels) {
    for (std::size_t k = 0; k < swivels_.size(); ++k) {
      Swivelled& moved = swivels_[k];
      moved.search.follow(paths_[moved.goal], turn_of(moved));
      swivels[k] = moved.search.coarse();
    }
  }

  // Moves the arms along their paths. An arm that cannot follow its path with its weights (mostly
  // for locked joints) leaves it, or with `freeing` gets equal weights for all dofs.
  void move_arms(const LowerInput<S>& input, bool freeing) {
    for (std::size_t k = 0; k < swivels_.size(); ++k) {
      Swivelled& moved = swivels_[k];
      moved.arm.follow(paths_[moved.goal], turn_of(moved));
      arm_misses_[moved.goal] = moved.arm.run(input.swivels[k], arm_angles_[moved.goal]);
    }
    for (std::size_t k = 0; k < rollouts_.size(); ++k) {
      move_by_weights(k, input.inverse_weights.subspan(k * kArmDofs, kArmDofs), freeing);
    }
  }
  // (goals) m, largest distance of the hands from their paths, with the given weights.
  [[nodiscard]] const std::vector<S>& arm_misses() const { return arm_misses_; }

  // Plays the whole body's motion after move_arms(): calls visit(const PlacedFrame<S>&) for the
  // frames 0..steps in order.
  template <class Visitor>
  BasicReachOutcome<S> play(std::span<const S> finals, Visitor&& visit) {
    BasicReachOutcome<S> outcome;
    for (std::size_t d = 0; d < drawn_.size(); ++d) {
      angles_[0][d] = angles_[1][d] = S(setup_->problem->reach.start().angles[d]);
    }
    now_ = 0;
    forward_kinematics<S>(*body_, angles_[1], now());
    for (int frame = 1; frame <= steps(); ++frame) {
      expand(frame, finals);
      measure(frame, outcome);
      visit(dynamics_.frame(angles_, now()));
      std::rotate(angles_.begin(), angles_.begin() + 1, angles_.end());
      now_ = 1 - now_;
    }
    // the motion ends at rest
    angles_[2] = angles_[1];
    visit(dynamics_.frame(angles_, now()));
    return outcome;
  }

  // (dofs, rad) the last frame of the last motion.
  [[nodiscard]] std::span<const S> final_angles() const { return angles_[1]; }

  // Line from a foot to its hip.
  struct LegLine {
    S lean{};    // rad, in the leg's plane
    S length{};  // m
    S turn{};    // rad, about the foot's z: of the leg's plane, by the ankle's inversion
  };
  [[nodiscard]] LegLine leg_line(std::size_t leg, int frame) const {
    return leg_line(legs_[leg], frame);
  }

 private:
  using T = Element<S>;
  struct Leg {
    const BodyLimb* limb = nullptr;
    BasicHingedLimb<S> segments;
    Mat3<S> foot{};   // R_WF
    Vec3<S> ankle{};  // m, world
    T inverts{};  // +1 or -1: direction of an ankle's inversion as a turn of the shank on the foot
                  // about z
    T climbs{};   // the same for the knee's turn of the thigh on the shank, seen from the foot
  };
  struct Swivelled {
    std::size_t goal = 0;
    SwivelArm<S> arm;
    SwivelSearch<S> search;
  };
  struct Weighted {
    std::size_t goal = 0;
    ArmRollout<S> rollout;
  };

  [[nodiscard]] int steps() const { return setup_->problem->reach.steps; }
  [[nodiscard]] HandTurn<S> turn_of(const Swivelled& moved) const {
    return hand_turn(*setup_->problem, clip_, moved.goal);
  }
  [[nodiscard]] Kinematics<S>& now() { return kinematics_[now_]; }
  [[nodiscard]] Kinematics<S>& next() { return kinematics_[1 - now_]; }

  Leg leg_of(const BodyLimb& limb) const {
    // the ankle's dof next to the foot
    const int ankle = limb.inversion < 0 ? limb.ankle : limb.inversion;
    const int foot = limb.carries ? kBaseLink : ankle;
    const Vec3d in_foot = limb.carries ? body_->dof(ankle).offset : Vec3d{};
    const double sense = limb.carries ? 1.0 : -1.0;
    const double inverts = limb.inversion < 0 ? 0.0 : sense * body_->dof(limb.inversion).sign;
    return {&limb,
            BasicHingedLimb<S>(limb.segments),
            to_scalar<S>(setup_->start.link_rotation(foot)),
            to_scalar<S>(setup_->start.point(foot, in_foot)),
            static_cast<T>(inverts),
            static_cast<T>(sense * body_->dof(limb.hinge).sign)};
  }

  void find_paths() {
    for (std::size_t g = 0; g < paths_.size(); ++g) {
      const Vec3<S> root = to_scalar<S>(setup_->arm(g).root);
      paths_[g].resize(clip_.trunk.size());
      for (std::size_t f = 0; f < paths_[g].size(); ++f) {
        const Transform<S>& carrier = clip_.carriers[g][f];
        const Vec3<S> hand = clip_.hands[g][f] - carrier.translation;
        paths_[g][f] = transpose_times(carrier.rotation, hand) - root;
      }
    }
  }

  [[nodiscard]] LegLine leg_line(const Leg& leg, int frame) const {
    // for the base's leg they are the first dofs
    const std::span<const S> values = clip_.frame(frame);
    if (leg.limb->carries && leg.limb->inversion < 0) return {values[0], values[1], S(0)};
    if (leg.limb->carries) return {values[1], values[2], S(leg.inverts) * values[0]};
    const Vec3<S> hip = clip_.trunk[index(frame)] * to_scalar<S>(leg.limb->root);
    Vec3<S> line = transpose_times(leg.foot, hip - leg.ankle);
    S turn(0);
    if (leg.limb->inversion >= 0) {
      turn = plane_turn(line, leg.segments.across());
      turn_back(line, Axis::z, sin_cos(turn));
    }
    return {atan2(line.z, line.y), sqrt(line.y * line.y + line.z * line.z), turn};
  }

  // Sets the angles of a leg. `angles` holds those of the frame before, to continue from.
  void bend_leg(const Leg& leg, int frame, std::span<S> angles) const {
    const LegLine line = leg_line(leg, frame);
    const S knee = leg.segments.bend(line.length);
    const S ankle = line.lean - leg.segments.direction(knee);
    angles[index(leg.limb->hinge)] = knee;
    angles[index(leg.limb->ankle)] = ankle;
    Mat3<S> plane = leg.foot;
    if (leg.limb->inversion >= 0) {
      angles[index(leg.limb->inversion)] = S(leg.inverts) * line.turn;
      plane = rotated(plane, Axis::z, sin_cos(line.turn));
    }
    const Mat3<S> thigh = rotated(plane, Axis::x, sin_cos(ankle + S(leg.climbs) * knee));
    const BasicBallTurns<S> before = leg.limb->template turns_of<S>(*body_, angles);
    const Mat3<S> hip = transpose(clip_.trunk[index(frame)].rotation) * thigh;
    leg.limb->put_turns(*body_, ball_turns(hip, before), angles);
  }

  void move_by_weights(std::size_t k, std::span<const S> weights, bool freeing) {
    const std::size_t g = rollouts_[k].goal;
    ArmRollout<S>& rollout = rollouts_[k].rollout;
    arm_misses_[g] = rollout.run(paths_[g], weights, arm_angles_[g]);
    const auto off = !(arm_misses_[g] <= S(setup_->problem->reach.tolerance.path));
    if (!freeing || !any(off)) return;
    for (std::size_t d = 0; d < unlocked_.size(); ++d) freed_[d] = select(off, S(1), weights[d]);
    rollout.run(paths_[g], freed_, arm_angles_[g]);
  }

  // Moves the angles of the next frame to those of the layers.
  void expand(int frame, std::span<const S> finals) {
    const std::span<S> angles = angles_[2];
    for (std::size_t d = 0; d < angles.size(); ++d) angles[d] = angles_[1][d];
    if (!law_.empty()) follow_law(frame, angles);
    for (const Leg& leg : legs_) bend_leg(leg, frame, angles);
    for (const TrunkJoint& joint : setup_->joints) {
      angles[index(joint.of_body)] = clip_.frame(frame)[index(joint.dof)];
    }
    for (std::size_t g = 0; g < arm_angles_.size(); ++g) {
      const std::span<const int> moved(setup_->moved[g].data(), setup_->moved[g].size());
      for (std::size_t k = 0; k < moved.size(); ++k) {
        angles[index(moved[k])] = arm_angles_[g][index(frame) * moved.size() + k];
      }
    }
    const S done(minimum_jerk(static_cast<double>(frame) / steps()));
    for (std::size_t k = 0; k < finals.size(); ++k) {
      const S start(setup_->finals[k].start);
      angles[setup_->finals[k].dof] = start + (finals[k] - start) * done;
    }
    forward_kinematics<S>(*body_, angles, next());
  }

  // Moves the dofs of the posture law, from the body's placement before the step, as in a rollout
  // of the whole body.
  void follow_law(int frame, std::span<S> angles) {
    for (S& drawn : drawn_) drawn = S(0);
    // guided, as clavicles of arms with goals belong to the upper layer
    constexpr bool kGuided = true;
    law_.draw(frame, now(), angles_[1], kGuided, drawn_);
    for (std::size_t d = 0; d < drawn_.size(); ++d) angles[d] = angles[d] + drawn_[d];
  }

  // Measures the errors of hands and feet in the next frame.
  void measure(int frame, BasicReachOutcome<S>& outcome) {
    const ReachProblem& reach = setup_->problem->reach;
    for (std::size_t g = 0; g < reach.goals.size(); ++g) {
      const Effector& hand = body_->effector(reach.goals[g].effector);
      const Vec3<S> at = next().point(hand.link, hand.point);
      const Vec3d& place = setup_->upper.paths[index(frame) * reach.goals.size() + g];
      const S miss = norm(at - to_scalar<S>(place));
      outcome.path_error = counted(max(outcome.path_error, miss), miss);
      if (frame != steps()) continue;
      const S turn = reach.goals[g].turn.miss(next().link_rotation(hand.link));
      outcome.goal_error = counted(max(outcome.goal_error, max(miss, S(kTurnLength) * turn)), miss);
    }
    for (const Foot& foot : body_->feet()) {
      if (foot.link == kBaseLink) continue;
      const Vec3d place = setup_->start.point(foot.link, foot.centre);
      const S slide = norm(next().point(foot.link, foot.centre) - to_scalar<S>(place));
      const S tilt = rotation_chord(next().link_rotation(foot.link),
                                    to_scalar<S>(setup_->start.link_rotation(foot.link)));
      outcome.contact_slide = counted(max(outcome.contact_slide, slide), slide);
      outcome.contact_tilt = counted(max(outcome.contact_tilt, tilt), tilt);
    }
  }

  // Counts a NaN as far off.
  static S counted(const S& most, const S& now) { return select(now < S(1e9), most, S(1e9)); }

  const LayeredSetup* setup_;
  const BodyModel* body_;
  ReducedRollout<S> upper_;
  ReducedClip<S> clip_;
  std::vector<HandPathOf<S>> paths_;        // (goals)
  std::vector<std::vector<S>> arm_angles_;  // [goal] (frames × dofs of the arm) rad
  std::vector<S> arm_misses_;               // (goals) m
  std::vector<Swivelled> swivels_;
  std::vector<Weighted> rollouts_;
  std::vector<Leg> legs_;
  FrameDynamics<S> dynamics_;
  std::vector<Kinematics<S>> kinematics_;  // of this frame and of the next, alternating
  std::size_t now_ = 0;                    // index of this frame's
  std::vector<std::vector<S>> angles_;     // of the frame before, this one and the next
  std::vector<S> drawn_;                   // (dofs) rad, by the law
  std::vector<S> unlocked_;                // (kArmDofs)
  std::vector<S> freed_ = unlocked_;       // (kArmDofs) inverse weights of a freed arm
  PostureLaw<S> law_;
};

}  // namespace shigusa
