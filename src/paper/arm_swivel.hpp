// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "motion/effector_turn.hpp"
#include "motion/minimum_jerk.hpp"
#include "paper/arm_motion.hpp"

namespace shigusa {

// Target orientation of a hand at the end of its path, in the path's frame: see EffectorTurn.
template <class S>
struct HandTurn {
  Turning kind = Turning::free;
  Mat3<S> goal{};
  Vec3<S> axis{};  // in the hand's own frame
  Vec3<S> direction{};
};

// Moves the hand of an arm_body along a path in closed form. The distance from the shoulder
// determines the elbow; the direction of the hand leaves one of the shoulder's three dofs, the
// swivel of the elbow about the line u from shoulder to hand. It is relative to a parallel
// transport of the elbow along the hand's path: the axis of the elbow, perpendicular to u, is
// transported from frame to frame by the shortest rotation from one u to the next, then turned
// about u by swivel · s(t), with s the minimum jerk of the motion. So no direction of the hand is
// singular, hanging arms included, and the elbow moves as evenly as the hand. With the upper arm
// straight sideways, the angles of a flexion-abduction-rotation joint still turn fast.
//
// A hand with an orientation has it at the end: forearm and wrist move from their start angles to
// the required ones, with minimum jerk, and in each frame the arm places the hand for the present
// wrist. The last angles are a fixed point, as the wrist displaces the hand relative to the
// forearm: the arm is placed for a wrist, the wrist is turned to the goal, and so on until both
// agree.
//
// S is double, or a pack whose lanes have separate paths and swivels. Owns scratch memory: one per
// thread. The arm outlives it.
template <class S>
class SwivelArm {
 public:
  // `limb` is the arm on the whole body.
  SwivelArm(const PosedBody& arm, const BodyLimb& limb);

  // Sets the path of all following runs. path: see ArmRollout::run; turn: of the hand, for an arm
  // with a wrist (kTurningArmDofs).
  void follow(std::span<const Vec3<S>> path, const HandTurn<S>& turn = {});
  // Moves the hand along the path with a swivel. swivel (rad, positive outwards) is that of the
  // last frame. angles: (frames × dofs of the arm) rad, the start posture first. Returns the
  // largest distance of the hand from the path (m): the excess of the path's distance over the
  // arm's range of lengths.
  S run(const S& swivel, std::vector<S>& angles);

 private:
  static constexpr int kElbow = 3;
  // The first dof beyond the elbow, and the largest number of iterations for the last wrist.
  static constexpr std::size_t kForearm = 4;
  static constexpr int kWristSteps = 60;
  static constexpr double kWristTolerance = sizeof(Element<S>) == sizeof(double) ? 1e-11 : 1e-5;

  // Direction of the hand from the shoulder, with the elbow's axis: unit vectors.
  struct Line {
    Vec3<S> along{};  // to the hand
    Vec3<S> axis{};   // of the elbow, perpendicular to `along`
    S distance{};     // m
  };
  // An arm with its hand at a given distance.
  struct Bent {
    S bend{};       // rad, of the elbow
    S reach{};      // m
    Mat3<S> own{};  // R_HU: the upper arm seen from the frame of the hand's direction and the
                    // elbow's axis
  };

  // The part of v perpendicular to the unit vector u, as a unit vector.
  static Vec3<S> square_to(const Vec3<S>& u, const Vec3<S>& v) {
    const Vec3<S> part = v - dot(u, v) * u;
    const S length = norm(part);
    const auto none = length < S(1e-12);
    const Vec3<S> unit = part * (S(1) / select(none, S(1), length));
    return select(none, Vec3<S>{S(0), S(1), S(0)}, unit);
  }
  static Mat3<S> frame_of(const Vec3<S>& along, const Vec3<S>& axis) {
    return {along, axis, cross(along, axis)};
  }
  static Vec3<S> hinge() { return {S(1), S(0), S(0)}; }

  // The vector v, perpendicular to u, after the shortest rotation from u to w; both are unit
  // vectors.
  static Vec3<S> carried(const Vec3<S>& v, const Vec3<S>& u, const Vec3<S>& w) {
    const S both = S(1) + dot(u, w);
    // for half a turn any axis is equally short, so v is kept
    const auto opposite = both < S(1e-9);
    const Vec3<S> turned = square_to(w, v - (dot(v, w) / select(opposite, S(1), both)) * (u + w));
    return select(opposite, v, turned);
  }

  // The hand in the upper arm's frame.
  static Vec3<S> hand_at(const BasicHingedLimb<S>& segments, const S& bend) {
    const S length = segments.length(bend);
    const SinCos<S> direction = sin_cos(segments.direction(bend));
    return {segments.across(), length * direction.cos, length * direction.sin};
  }

  // Turns about y, z and x, in this order, with this product; |z| ≤ 90°.
  struct WristTurns {
    S turns[3];
  };
  static WristTurns wrist_turns(const Mat3<S>& rotation) {
    const Vec3<S>& x = rotation.cx;
    const S y_turn = atan2(-x.z, x.x);
    const S z_turn = atan2(x.y, sqrt(x.x * x.x + x.z * x.z));
    const Mat3<S> turned =
        rotated(rotated(Mat3<S>{}, Axis::y, sin_cos(y_turn)), Axis::z, sin_cos(z_turn));
    const Mat3<S> rest = transpose(turned) * rotation;
    return {{y_turn, z_turn, atan2(rest.cy.z, rest.cy.y)}};
  }

  // The arm with its hand at that distance; `bend`: approximate angle of the elbow.
  static Bent bent(const BasicHingedLimb<S>& segments, const S& distance, const S& bend) {
    const S across = segments.across();
    const S square = distance * distance - across * across;
    Bent arm;
    arm.bend = unwrapped(segments.bend(sqrt(max(square, S(0)))), bend);
    const Vec3<S> hand = hand_at(segments, arm.bend);
    arm.reach = norm(hand);
    const Vec3<S> own = hand * (S(1) / arm.reach);
    arm.own = transpose(frame_of(own, square_to(own, hinge())));
    return arm;
  }
  // The upper arm in the path's frame.
  static Mat3<S> upper_arm(const Bent& arm, const Vec3<S>& along, const Vec3<S>& axis) {
    return frame_of(along, axis) * arm.own;
  }

  [[nodiscard]] std::size_t dofs() const { return arm_->dofs().size(); }
  [[nodiscard]] bool turns() const { return turn_.kind != Turning::free && dofs() > kForearm; }
  [[nodiscard]] double schedule(std::size_t frame) const {
    return minimum_jerk(static_cast<double>(frame) / static_cast<double>(lines_.size() - 1));
  }
  [[nodiscard]] SinCos<S> turn_of(std::size_t d, const S& angle) const {
    return sin_cos(arm_->dof(static_cast<int>(d)).sign < 0.0 ? -angle : angle);
  }

  // The axis of the elbow in a frame, turned by the swivel of that frame.
  Vec3<S> swivelled(std::size_t frame, const S& swivel) const {
    const Line& line = lines_[frame];
    const SinCos<S> turn = sin_cos(S(outwards_ * schedule(frame)) * swivel);
    return turn.cos * line.axis + turn.sin * cross(line.along, line.axis);
  }

  // The segments from shoulder to hand with the wrist at q (dofs, rad).
  BasicHingedLimb<S> segments_at(std::span<const S> q) const {
    Vec3<S> hand = to_scalar<S>(arm_->effectors()[0].point);
    for (std::size_t d = q.size() - 1; d >= kForearm; --d) {
      const Dof& dof = arm_->dof(static_cast<int>(d));
      turn_forth(hand, dof.axis, turn_of(d, q[d]));
      hand += to_scalar<S>(dof.offset);
    }
    const Dof& elbow = arm_->dof(kElbow);
    return BasicHingedLimb<S>(to_scalar<S>(elbow.offset), hand, elbow.sign);
  }

  Mat3<S> wrist_rotation(std::span<const S> q) const {
    Mat3<S> wrist{};
    for (std::size_t d = kForearm; d < q.size(); ++d) {
      wrist = rotated(wrist, arm_->dof(static_cast<int>(d)).axis, turn_of(d, q[d]));
    }
    return wrist;
  }

  // The target rotation of a hand with the given present rotation.
  Mat3<S> wanted(const Mat3<S>& hand) const {
    if (turn_.kind == Turning::whole) return turn_.goal;
    // the turn about the axis is free, and the wrist makes none
    return rotation_by(turn_between(hand * turn_.axis, turn_.direction)) * hand;
  }

  // Sets forearm and wrist of last_ to the hand's target orientation at the end of the path.
  void turn_hand(const S& swivel) {
    const std::size_t end = lines_.size() - 1;
    const Vec3<S> axis = swivelled(end, swivel);
    for (std::size_t d = 0; d < dofs(); ++d) last_[d] = S(start_[d]);
    const Dof& elbow = arm_->dof(kElbow);
    auto off = S(0) < S(1);
    for (int k = 0; k < kWristSteps && any(off); ++k) {
      const Bent arm = bent(segments_at(last_), lines_[end].distance, last_[kElbow]);
      const Mat3<S> forearm = rotated(upper_arm(arm, lines_[end].along, axis), Axis::x,
                                      sin_cos(elbow.sign < 0.0 ? -arm.bend : arm.bend));
      const Mat3<S> hand = forearm * wrist_rotation(last_);
      const WristTurns turns = wrist_turns(transpose(forearm) * wanted(hand));
      S change(0);
      for (std::size_t w = 0; w < 3; ++w) {
        const std::size_t d = kForearm + w;
        const bool reversed = arm_->dof(static_cast<int>(d)).sign < 0.0;
        const S next = reversed ? -turns.turns[w] : turns.turns[w];
        change = max(change, abs(next - last_[d]));
        last_[d] = select(off, next, last_[d]);
      }
      off = off & (change > S(kWristTolerance));
    }
  }

  // Sets forearm and wrist of a frame, on their way to the last angles.
  void turn_wrist(std::size_t frame) {
    const S share(schedule(frame));
    for (std::size_t d = kForearm; d < dofs(); ++d) {
      const S start(start_[d]);
      q_[d] = start + (last_[d] - start) * share;
    }
  }

  // Sets the shoulder's angles in q_.
  void turn_shoulder(const Mat3<S>& upper) {
    const auto sign = [this](int dof) { return S(arm_->dof(dof).sign); };
    const BasicBallTurns<S> near{sign(0) * q_[0], sign(1) * q_[1], sign(2) * q_[2]};
    const BasicBallTurns<S> turns = ball_turns(upper, near);
    q_[0] = sign(0) * turns.x;
    q_[1] = sign(1) * turns.z;
    q_[2] = sign(2) * turns.y;
  }

  const BodyModel* arm_;
  std::span<const double> start_;  // (dofs) rad
  BasicHingedLimb<S> segments_;    // with the wrist in its start posture
  double outwards_;                // sign of the turn about u that lifts the elbow outwards
  HandTurn<S> turn_;
  std::vector<Line> lines_;  // (frames)
  std::vector<Bent> bents_;  // (frames) for a hand without an orientation: the same for all swivels
  std::vector<S> q_;         // (dofs) rad
  std::vector<S> last_;      // (dofs) rad, for a hand with an orientation
};

template <class S>
SwivelArm<S>::SwivelArm(const PosedBody& arm, const BodyLimb& limb)
    : arm_(&arm.body),
      start_(arm.home.angles),
      segments_(limb.segments),
      outwards_(arm_->dof(1).sign),
      q_(arm_->dofs().size()),
      last_(q_) {
  SHG_CHECK(arm_->dof_count() == kArmDofs || arm_->dof_count() == kTurningArmDofs,
            "an arm has four freedoms, or seven");
}

template <class S>
void SwivelArm<S>::follow(std::span<const Vec3<S>> path, const HandTurn<S>& turn) {
  turn_ = turn;
  for (std::size_t d = 0; d < dofs(); ++d) q_[d] = S(start_[d]);
  const auto angle = [&](int dof) { return S(arm_->dof(dof).sign) * q_[index(dof)]; };
  const Mat3<S> start = ball_rotation<S>({angle(0), angle(1), angle(2)});
  const Vec3<S> hand = hand_at(segments_, q_[kElbow]);
  Vec3<S> along = start * (hand * (S(1) / norm(hand)));
  Vec3<S> axis = square_to(along, start * hinge());
  lines_.resize(path.size());
  bents_.resize(turns() ? 0 : path.size());
  lines_[0] = {along, axis, norm(path[0])};
  S bend = q_[kElbow];
  for (std::size_t f = 1; f < path.size(); ++f) {
    const S distance = norm(path[f]);
    const Vec3<S> before = along;
    // a hand in the shoulder's centre has no direction
    const auto apart = distance > S(1e-9);
    along = select(apart, path[f] * (S(1) / select(apart, distance, S(1))), before);
    axis = carried(axis, before, along);
    lines_[f] = {along, axis, distance};
    if (turns()) continue;
    bents_[f] = bent(segments_, distance, bend);
    bend = bents_[f].bend;
  }
}

template <class S>
S SwivelArm<S>::run(const S& swivel, std::vector<S>& angles) {
  angles.resize(lines_.size() * dofs());
  if (turns()) turn_hand(swivel);
  for (std::size_t d = 0; d < dofs(); ++d) angles[d] = q_[d] = S(start_[d]);
  S worst(0);
  for (std::size_t f = 1; f < lines_.size(); ++f) {
    if (turns()) turn_wrist(f);
    const Bent arm = turns() ? bent(segments_at(q_), lines_[f].distance, q_[kElbow]) : bents_[f];
    q_[kElbow] = arm.bend;
    turn_shoulder(upper_arm(arm, lines_[f].along, swivelled(f, swivel)));
    const S miss = abs(lines_[f].distance - arm.reach);
    // a NaN counts as far off
    worst = select(miss < S(1e9), max(worst, miss), S(1e9));
    for (std::size_t d = 0; d < dofs(); ++d) angles[f * dofs() + d] = q_[d];
  }
  return worst;
}

}  // namespace shigusa
