// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "kinematics/weighted_ik.hpp"
#include "motion/effector_turn.hpp"
#include "motion/minimum_jerk.hpp"

namespace shigusa {

inline constexpr double kReachTolerance = 1e-3;  // m: what counts as met, of goals and planted feet
inline constexpr double kTiltTolerance = radians(0.1);  // rad: what a planted foot may turn
inline constexpr double kTurnTolerance = radians(0.5);  // rad: what counts as met, of goals' turns
// m/rad: a goal's turn counts as the distance that has the same share of its tolerance …
inline constexpr double kTurnLength = kReachTolerance / kTurnTolerance;
// … and by this share of it before the last frame, where nobody asks for it.
inline constexpr double kTurnOnWay = 0.1;
// A goal's box is aimed at this far within its sides (m), so that the end is inside however
// little it misses.
inline constexpr double kBoxInset = 1e-4;

// The distances within which goals and paths count as met.
struct ReachTolerance {
  double goal = kReachTolerance;  // m, of effectors at the end
  double path = kReachTolerance;  // m, of effectors at each frame
};

// One effector with its path to the goal.
struct ReachGoal {
  int effector = 0;  // see BodyModel::effector
  EffectorPath path;
  // m, world: how far the path leaves its line half-way for a bow of 1 (see path_bow)
  Vec3d bow{};
  Vec3d sway{};         // m, world: and for a sway of 1
  EffectorTurn turn{};  // what it also turns to
  // m, world axes: half the sides of the box about the path's goal of which any place will do
  Vec3d tolerance{};

  // The place of the box that is nearest to `at` (m, world), its sides moved inwards by `inset`.
  [[nodiscard]] Vec3d nearest(const Vec3d& at, double inset = 0.0) const;
  // Makes the nearest place of the box the goal itself.
  void end_nearest(const Vec3d& at) {
    if (tolerance == Vec3d{}) return;
    path.goal = nearest(at, kBoxInset);
    tolerance = {};
  }
};

// A part of the time in which a part of the body changes its posture, as shares of the duration.
struct TimeWindow {
  double begin = 0.0;
  double end = 1.0;

  // How much of its own time is over at tau; below 0 before it, above 1 after it.
  template <class S>
  [[nodiscard]] S at(const S& tau) const {
    return (tau - S(begin)) * S(1.0 / (end - begin));
  }
};

// The parts of the body that keep their own time: knees with what bends in hips and ankles as they
// do (see LegFlexions), hips and ankles otherwise, the spine; all that is none of these goes with
// the arms.
enum class TimedPart { knees, hips, spine, arms };
inline constexpr std::size_t kTimedParts = 4;
using PartWindows = std::array<TimeWindow, kTimedParts>;

// A hand that goes to a place and rests there. All of it is as seen from the place's carrier: a
// thigh, with which it moves, or the world. In each frame the hand makes a share of what is left of
// its way: where it is meanwhile, its arm and the trunk decide.
struct HandSupport {
  std::string name;             // of the effector, as the task has it
  int effector = 0;             // see BodyModel::effector
  int carrier = kWorldCarrier;  // link, or kWorldCarrier
  Vec3d place{};                // m, where the hand's point rests
  Vec3d normal{0, 1, 0};        // unit vector out of the surface
  double arrives = 0.7;         // share of the duration after which the hand is there

  // The share of the hand's way that is done at tau = time / duration.
  [[nodiscard]] double done(double tau) const { return minimum_snap(tau / arrives); }
  // How far the hand is off the line to its place then (m), along the normal.
  [[nodiscard]] double lift(double tau) const;
  // How much of its force the hand bears then, from 0 to 1.
  [[nodiscard]] double bears(double tau) const;
};

// Everything that is the same for all motions of one search.
struct ReachProblem {
  const BodyModel* body = nullptr;  // outlives the problem
  std::vector<ReachGoal> goals;
  std::vector<HandSupport> supports{};
  double duration = 1.0;  // s
  int steps = kMotionSteps;
  ReachTolerance tolerance;
  // (dofs, rad) or empty: a posture that the null space is drawn to and the motion ends near; for
  // goals that a straight path alone does not lead to, such as the very edge of reach
  std::vector<double> guide;
  // false: the hands go where the guide takes them, and only the last frame has them at their goals
  bool follow_path = true;
  PartWindows windows{};  // of the change of posture
  double ease =
      0.0;  // the haste of the whole motion, see hastened(); resting hands keep their time
  double gaze_lead =
      0.0;  // share of the duration by which the head turns earlier than kGazeArrives
  IkSettings ik;
  bool hold_limits = false;     // no joint passes a limit (see LimitGuard)
  bool posture_law = false;     // head, free arms and clavicles follow PostureLaw
  bool smooth = false;          // motions are delivered without kinks (see smoothed())
  std::optional<Vec3d> gaze{};  // m, world: what the head turns to by that law
  // A step falls short of its path by what joints on arcs leave the straight line. The shortfall
  // changes little from frame to frame, so the next step allows for the last one's, up to this
  // much; farther off, the goal is one that the body cannot follow.
  double lead_limit = 2e-3;  // m
  // the last frame has the hand at rest: there the goal itself is to be met, by this many steps …
  double goal_tolerance = 1e-5;  // m
  int goal_corrections = 12;
  // … and by this many in every other frame that is off by more than path_slack: for goals at the
  // very edge of reach, and where limits hold joints back …
  int corrections = 0;
  double path_slack = 1e-5;  // m
  // … but where more than this is missed, nothing is to be gained
  double rescue_limit = 0.05;  // m
  // where a planted foot is off by more than this after all, this many steps at most correct it
  // alone; a tilt counts as the slide that has the same share of its tolerance
  double contact_slack = 5e-4;  // m
  int contact_corrections = 8;

  // The share of the motion's own time that is over at a frame, or between two.
  [[nodiscard]] double tau(double frame) const { return hastened(frame / steps, ease); }
};

// How well a motion keeps what it must, whatever its score: met goals, effectors on their paths,
// planted feet.
template <class S>
struct BasicReachOutcome {
  S goal_error{};     // m, largest distance of an effector from its path's end, turns included
  S path_error{};     // m, largest distance from the path at any frame that follows it
  S contact_slide{};  // m, largest displacement of a planted foot at any frame
  S contact_tilt{};   // rad (see rotation_chord), largest rotation of a planted foot at any frame

  // The planted feet stay where they are.
  [[nodiscard]] auto stands() const {
    return (contact_slide <= S(kReachTolerance)) & (contact_tilt <= S(kTiltTolerance));
  }
  // Paths and planted feet are kept.
  [[nodiscard]] auto keeps_to(const ReachTolerance& tolerance) const {
    return (path_error <= S(tolerance.path)) & stands();
  }
  [[nodiscard]] auto met(const ReachTolerance& tolerance = {}) const {
    return (goal_error <= S(tolerance.goal)) & keeps_to(tolerance);
  }
};
using ReachOutcome = BasicReachOutcome<double>;

// (dofs) the number of the TimedPart of each.
[[nodiscard]] std::vector<std::size_t> timed_parts(const BodyModel& body);

// The freedoms of one leg that bend together in a squat.
struct LegFlexions {
  std::size_t knee;
  std::size_t hip;
  std::size_t ankle;
};
// Of the legs that have all three.
[[nodiscard]] std::vector<LegFlexions> leg_flexions(const BodyModel& body);

// The supports of weighted IK for a problem, at the places where the hands rest.
[[nodiscard]] std::vector<IkSupport<double>> ik_supports(const ReachProblem& problem);

// The targets of weighted IK for a problem: its goals, then each planted foot but the base, held
// where it stands in the start posture.
[[nodiscard]] std::vector<IkTarget<double>> ik_targets(const ReachProblem& problem);

}  // namespace shigusa
