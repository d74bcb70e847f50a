// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "kinematics/weighted_ik.hpp"
#include "motion/effector_turn.hpp"
#include "motion/minimum_jerk.hpp"

namespace shigusa {

inline constexpr double kReachTolerance = 1e-3;         // m: tolerance of goals and planted feet
inline constexpr double kTiltTolerance = radians(0.1);  // rad: of a planted foot's turn
inline constexpr double kTurnTolerance = radians(0.5);  // rad: tolerance of goals' orientations
// Distance (m) equivalent to a goal's turn of 1 rad, by the same share of the tolerance.
inline constexpr double kTurnLength = kReachTolerance / kTurnTolerance;
// Weight of the turn error before the last frame.
inline constexpr double kTurnOnWay = 0.1;
// Margin (m) inside a goal's box to aim at, so that a small error still ends inside.
inline constexpr double kBoxInset = 1e-4;

// Tolerances of goals and paths.
struct ReachTolerance {
  double goal = kReachTolerance;  // m, of effectors at the end
  double path = kReachTolerance;  // m, of effectors at each frame
};

// The way of a thing to which an effector keeps its pose; its timing is the path's.
struct CarriedWay {
  Vec3d start{};  // m, world: middle of the thing at the start
  Vec3d goal{};   // m, world: at the end
  Mat3d from{};   // R_WT at the start
  Vec3d turn{};   // rad, rotation vector, world: from there to the end
  Vec3d grip{};   // m, the effector's point in the thing's frame
  Mat3d hand{};   // R_TL of the effector's link

  // Orientation R_WT of the thing after a share of its way.
  [[nodiscard]] Mat3d turned(double share) const;
};

// One effector with its path to the goal.
struct ReachGoal {
  int effector = 0;  // see BodyModel::effector
  EffectorPath path;
  // m, world: offset of the path from its line half-way for a bow of 1 (see path_bow)
  Vec3d bow{};
  Vec3d sway{};         // m, world: the same for a sway of 1
  EffectorTurn turn{};  // target orientation
  Vec3d spin{};         // rad, world: angular velocity at the start times the duration
  // m, world axes: half the sides of the box around the path's goal in which it is met
  Vec3d tolerance{};

  std::optional<CarriedWay> carry{};  // in place of the path's line and the turn

  // The place at tau = time / duration.
  [[nodiscard]] Vec3d place_at(double tau) const;
  // The target orientation at tau, see EffectorTurn::at.
  [[nodiscard]] Mat3d turn_at(double tau) const;
  // The point of the box nearest to `at` (m, world), its sides moved inwards by `inset`.
  [[nodiscard]] Vec3d nearest(const Vec3d& at, double inset = 0.0) const;
  // Makes the nearest point of the box the goal.
  void end_nearest(const Vec3d& at) {
    if (tolerance == Vec3d{}) return;
    path.goal = nearest(at, kBoxInset);
    tolerance = {};
  }
};

// Interval in which a part of the body changes its posture, in shares of the duration.
struct TimeWindow {
  double begin = 0.0;
  double end = 1.0;

  // Share of the interval elapsed at tau; below 0 before it, above 1 after it.
  template <class S>
  [[nodiscard]] S at(const S& tau) const {
    return (tau - S(begin)) * S(1.0 / (end - begin));
  }
};

// Parts of the body with their own timing: knees with the part of hips and ankles that bends with
// them (see LegFlexions), hips and ankles otherwise, the spine; all others go with the arms.
enum class TimedPart { knees, hips, spine, arms };
inline constexpr std::size_t kTimedParts = 4;
using PartWindows = std::array<TimeWindow, kTimedParts>;

// A hand that moves to a place and rests there. Positions are relative to the place's carrier: a
// thigh, with which it moves, or the world. In each frame the hand covers a share of its remaining
// way from its present position, which depends on the arm and the trunk.
struct HandSupport {
  std::string name;             // name of the effector in the task
  int effector = 0;             // see BodyModel::effector
  int carrier = kWorldCarrier;  // link, or kWorldCarrier
  Vec3d place{};                // m, resting place of the hand's point
  Vec3d normal{0, 1, 0};        // unit vector out of the surface
  double arrives = 0.7;         // share of the duration at which the hand arrives

  // Share of the hand's way covered at tau = time / duration.
  [[nodiscard]] double done(double tau) const { return minimum_snap(tau / arrives); }
  // Distance (m) of the hand from the line to its place, along the normal.
  [[nodiscard]] double lift(double tau) const;
  // Share of its force that the hand bears, from 0 to 1.
  [[nodiscard]] double bears(double tau) const;
};

// The data shared by all motions of one search.
struct ReachProblem {
  const BodyModel* body = nullptr;  // outlives the problem
  CriteriaContext context{};        // with the start and the gaze target
  State home{};                     // of the body; final postures are described relative to it
  // (dofs, rad) or empty: the change from a bent start to standing, which is added to a motion's
  // own change of posture
  std::vector<double> rise{};
  // of the goals, the last ones, which no task asks for: ways of the hips and the neck in a rise
  std::size_t led = 0;
  std::vector<ReachGoal> goals;
  std::vector<HandSupport> supports{};
  double duration = 1.0;  // s
  int steps = kMotionSteps;
  ReachTolerance tolerance;
  // (dofs, rad) or empty: a posture to which the null space is drawn and near which the motion
  // ends; for goals that a straight path alone does not reach, such as the very edge of reach
  std::vector<double> guide;
  // false: the hands follow the guide, and meet their goals only in the last frame
  bool follow_path = true;
  PartWindows windows{};  // timing of the change of posture
  double ease = 0.0;  // haste of the whole motion, see hastened(); resting hands keep their time
  double gaze_lead =
      0.0;  // share of the duration by which the head turns earlier than kGazeArrives
  IkSettings ik;
  bool hold_limits = false;  // no joint passes a limit (see LimitGuard)
  bool posture_law = false;  // head, free arms and clavicles follow PostureLaw
  bool smooth = false;       // motions are delivered without kinks (see smoothed())
  // Limit of the feed-forward correction: a step falls short of its path as joints move on arcs.
  // The shortfall changes little from frame to frame, so the next step adds the last one's, up to
  // this limit; a larger error means a goal that the body cannot follow.
  double lead_limit = 2e-3;  // m
  // Tolerance and steps of the corrections in the last frame, where the hand is at rest at the
  // goal.
  double goal_tolerance = 1e-5;  // m
  int goal_corrections = 12;
  // Corrections in each other frame with an error above path_slack: for goals at the very edge of
  // reach, and where limits hold joints back.
  int corrections = 0;
  double path_slack = 1e-5;  // m
  // error beyond which corrections are not worth making
  double rescue_limit = 0.05;  // m
  // error of a planted foot that is corrected alone, in at most this many steps; a tilt counts as
  // the slide with the same share of its tolerance
  double contact_slack = 5e-4;  // m
  int contact_corrections = 8;

  // (dofs) rad, the velocities at the start times the duration; empty: at rest.
  [[nodiscard]] std::vector<double> momentum() const;
  // Number of the goals that the task asks for.
  [[nodiscard]] std::size_t asked() const { return goals.size() - led; }
  // The state to which postures are relative: the start, or standing in a rise from it.
  [[nodiscard]] State standing() const;
  // The state in which the motion begins.
  [[nodiscard]] const State& start() const { return context.start; }
  // Share of the motion's own time elapsed at a frame, or between two.
  [[nodiscard]] double tau(double frame) const { return hastened(frame / steps, ease); }
};

// Errors of a motion's constraints, apart from its score: goals, paths of effectors, planted feet.
template <class S>
struct BasicReachOutcome {
  S goal_error{};     // m, largest distance of an effector from its path's end, turns included
  S path_error{};     // m, largest distance from the path over all frames that follow it
  S contact_slide{};  // m, largest displacement of a planted foot over all frames
  S contact_tilt{};  // rad (see rotation_chord), largest rotation of a planted foot over all frames

  // Whether the planted feet stay in place.
  [[nodiscard]] auto stands() const {
    return (contact_slide <= S(kReachTolerance)) & (contact_tilt <= S(kTiltTolerance));
  }
  // Whether paths and planted feet are kept.
  [[nodiscard]] auto keeps_to(const ReachTolerance& tolerance) const {
    return (path_error <= S(tolerance.path)) & stands();
  }
  [[nodiscard]] auto met(const ReachTolerance& tolerance = {}) const {
    return (goal_error <= S(tolerance.goal)) & keeps_to(tolerance);
  }
};
using ReachOutcome = BasicReachOutcome<double>;

// (dofs) the index of the TimedPart of each.
[[nodiscard]] std::vector<std::size_t> timed_parts(const BodyModel& body);

// The dofs of one leg that bend together in a squat.
struct LegFlexions {
  std::size_t knee;
  std::size_t hip;
  std::size_t ankle;
};
// The flexions of the legs that have all three.
[[nodiscard]] std::vector<LegFlexions> leg_flexions(const BodyModel& body);

// The constraints of a problem: its goals, each at the end of its path, then the planted feet but
// the base, as in the start posture, then the resting hands at their places.
[[nodiscard]] std::vector<Constraint<double>> constraints(const ReachProblem& problem);

}  // namespace shigusa
