// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/ergonomics.hpp>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

/// Angles (rad) of the trunk, or of the head against the trunk; 0 in the body's neutral posture.
struct TrunkAngles {
  double flexion = 0.0;  ///< ahead above 0, in the sagittal plane
  double lateral = 0.0;  ///< out of the sagittal plane, to the left above 0
  double twist = 0.0;    ///< about the long axis, to the left above 0
};

/// Angles of an arm; empty where the body lacks the joints.
struct ArmAngles {
  /// rad, of the upper arm against the trunk in its sagittal plane, ahead above 0, at most 270°. An
  /// arm within 15° of the side has less and less of it, as the plane says nothing of it there.
  double flexion = 0.0;
  double abduction = 0.0;  ///< rad, of the upper arm out of that plane, away from the body above 0
  double elevation = 0.0;  ///< rad, of the upper arm from the vertical, hanging is 0
  double raised = 0.0;     ///< m, of the shoulder above neutral, along the chest
  double elbow = 0.0;      ///< rad, from straight
  double across = 0.0;   ///< m, of the wrist from the middle of the trunk, to its own side above 0
  double outside = 0.0;  ///< m, of the wrist outside its shoulder
  std::optional<double> wrist{};      ///< rad, flexion of the hand against the forearm
  std::optional<double> deviation{};  ///< rad, of the hand sideways
  std::optional<double> forearm{};    ///< share of the forearm's range of rotation, 0..1
};

/// Angles of a placed body as REBA, RULA and EN 1005-4 need them; empty where the body lacks the
/// joints. Neutral is the body's home or, where the trunk leans there by more than 20°, all angles
/// at 0.
struct PostureAngles {
  std::optional<TrunkAngles>
      trunk{};                        ///< line from the middle of the hips to C7, from the vertical
  std::optional<TrunkAngles> neck{};  ///< head against that line
  std::optional<double> head{};       ///< rad, inclination of the head from the vertical
  std::array<std::optional<ArmAngles>, 2> arms{};  ///< left, right
  std::array<std::optional<double>, 2> knees{};    ///< rad, left, right: from straight
  /// Share of the weight on the left foot, by the centre of mass; 1 or 0 if the other foot is off
  /// the floor; empty for a body without feet.
  std::optional<double> on_left{};
  bool sits = false;  ///< sits on both thighs
};

/// Measures the angles of a body at joint angles (dofs, rad).
[[nodiscard]] PostureAngles posture_angles(const BodyModel& body, const State& home,
                                           std::span<const double> angles);

/// A hand's load and what it rests on, at one moment.
struct PostureLoad {
  double mass = 0.0;                ///< kg, in both hands
  std::array<bool, 2> supported{};  ///< left, right: the arm rests on something
};

/// Sub-scores of a posture by REBA for the arm of a side; angles that the body lacks count as
/// neutral. Nothing for a body without that arm.
[[nodiscard]] std::optional<RebaParts> reba_parts(const PostureAngles& angles, Side side,
                                                  const PostureLoad& load,
                                                  const Ergonomics& ergonomics = {});
/// Sub-scores of a posture by RULA, in the same way.
[[nodiscard]] std::optional<RulaParts> rula_parts(const PostureAngles& angles, Side side,
                                                  const PostureLoad& load,
                                                  const Ergonomics& ergonomics = {});

/// The cost of one frame.
struct FrameCost {
  double time = 0.0;                               ///< s
  PostureAngles angles{};                          ///< angles of the posture
  std::array<std::optional<RebaScore>, 2> reba{};  ///< with the left arm, with the right
  std::array<std::optional<RulaScore>, 2> rula{};  ///< with the left arm, with the right
  /// N·m, moment about L5/S1 across the trunk's axis; empty for a body without a back or hips.
  std::optional<double> back_moment{};
  std::optional<BackForces> back{};  ///< forces at L5/S1; empty for a rigid trunk
};

/// The course of a score or a sub-score, of the worse side in each frame.
struct ScoreCourse {
  int worst = 0;      ///< greatest
  double mean = 0.0;  ///< weighted by time
};
/// A posture score over a motion.
struct PostureCourse {
  ScoreCourse score{};                 ///< of the worse side
  double time = 0.0;                   ///< s, of the first worst moment
  Side side = Side::right;             ///< worse side then
  std::array<ScoreCourse, 2> sides{};  ///< with the left arm, with the right
  std::array<ScoreCourse, 9> parts{};  ///< sub-scores in the order of RebaParts or RulaParts
  std::vector<double> above{};         ///< (levels) share of the time at this level or above
};

/// A part's time in the zones of EN 1005-4.
struct ZoneCourse {
  ZonePart part = ZonePart::trunk;  ///< the part
  std::optional<Side> side{};       ///< of an arm
  double greatest = 0.0;            ///< rad, greatest angle
  std::array<double, 4> shares{};   ///< share of the time in the zones -1, 0, 1, 2
  std::array<double, 4> longest{};  ///< s, longest time in each without a break
  /// Worst verdict on what is known: zones held for kHeldFrom and, with Ergonomics::moves_per_min,
  /// all zones.
  std::optional<ZoneVerdict> verdict{};
};

/// A greatest value with its time.
struct Peak {
  double value = 0.0;  ///< greatest
  double time = 0.0;   ///< s
};
/// Forces at L5/S1 over a motion.
struct BackForcesCourse {
  Peak compression{};              ///< N
  Peak shear{};                    ///< N
  double mean_compression = 0.0;   ///< N
  double above_action = 0.0;       ///< share of the time above kBackActionLimit
  double above_permissible = 0.0;  ///< share of the time above kBackPermissible
  std::optional<double> limit{};   ///< N, back_limit of age and sex, if both are known
};
/// L5/S1 over a motion.
struct BackCourse {
  Peak moment{};                             ///< N·m
  double mean_moment = 0.0;                  ///< N·m
  std::optional<BackForcesCourse> forces{};  ///< empty for a body with a rigid trunk
};

/// The torque of a joint beside the strength of people of the body's sex and mass.
struct StrengthCost {
  std::string dof{};      ///< name of the degree of freedom
  double torque = 0.0;    ///< N·m, the greatest as a share of the strength
  double strength = 0.0;  ///< N·m, mean of people
  double time = 0.0;      ///< s
  double able = 0.0;      ///< share of people who are as strong, 0..1
};

/// A lift of a thing in a motion, by frames.
struct LiftSpan {
  std::string thing{};       ///< its name
  double mass = 0.0;         ///< kg
  std::vector<int> hands{};  ///< indices of the effectors that hold it
  int taken = 0;             ///< frame in which they take it
  int put = 0;               ///< frame in which they let it go
};
/// A lift by the revised NIOSH lifting equation.
struct LiftCost {
  LiftSpan span{};                ///< the lift
  Lift origin{};                  ///< where it is taken
  Lift destination{};             ///< where it is put
  LiftIndex at_origin{};          ///< judged there
  LiftIndex at_destination{};     ///< judged there
  double limit = 0.0;             ///< kg, the lower RWL of the ends that count
  std::optional<double> index{};  ///< LI by that limit; empty if no load is allowed
  std::vector<Message> notes{};   ///< where the equation does not apply
};

/// Loads that the hands hold in a range of frames.
struct HeldSpan {
  int first = 0;                  ///< first frame
  int last = 0;                   ///< last frame, included
  std::vector<HeldLoad> loads{};  ///< the loads
};

/// A motion with what its hands hold.
struct CostInput {
  const PosedBody& posed;             ///< body without loads, and its home
  const Motion& motion;               ///< with the torques of the loads
  std::span<const HeldSpan> held{};   ///< loads, in the order of time
  std::span<const LiftSpan> lifts{};  ///< lifts
};

/// The cost of a motion to the body.
struct MotionCost {
  std::vector<FrameCost> frames{};           ///< (frames) in order
  std::optional<PostureCourse> reba{};       ///< empty for a body without arms or trunk
  std::optional<PostureCourse> rula{};       ///< empty for a body without arms or trunk
  std::vector<ZoneCourse> zones{};           ///< of the parts that the body has
  std::optional<BackCourse> back{};          ///< empty for a body without hips
  std::vector<StrengthCost> strengths{};     ///< (dofs) in the order of the body's
  std::vector<LiftCost> lifts{};             ///< in the order of CostInput
  std::optional<CompositeIndex> repeated{};  ///< of two lifts or more
  std::vector<Message> notes{};              ///< what is not known or does not apply
};

/// Computes what a motion costs.
[[nodiscard]] Result<MotionCost> motion_cost(const CostInput& input,
                                             const Ergonomics& ergonomics = {});

/// The worst score by REBA of a motion alone, MotionCost::reba.score.worst; nothing for a body
/// without arms or trunk.
[[nodiscard]] std::optional<int> worst_reba(const CostInput& input,
                                            const Ergonomics& ergonomics = {});

}  // namespace shigusa
