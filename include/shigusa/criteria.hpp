// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The paper's order of importance, range > balance > torque (section 3.3), with rule R8's weights.
inline constexpr double kPaperRangeWeight = 0.5;
inline constexpr double kPaperBalanceWeight = 0.3;  ///< of the balance
inline constexpr double kPaperTorqueWeight = 0.2;   ///< of the torque

/// Share of a joint's range by which a limit may be passed until the penalty is full (rule R8a).
inline constexpr double kRangeMargin = 0.2;
/// Sets the scale of the criterion joint_range: how far joints pass their limits.
struct JointRangeSettings {
  double margin = kRangeMargin;  ///< share of the range, > 0
};

/// Lean at which the penalty is full (rule R8b): the toes' edge is 0.13 m ahead of mid-foot and the
/// centre of mass about 1.0 m high standing, 0.7 m stooping.
inline constexpr double kBalanceLean = 0.20;
/// Sets the scale of the criterion balance: how far the centre of mass leans from the feet.
struct BalanceSettings {
  double lean = kBalanceLean;  ///< horizontal over vertical, > 0
};

/// Root mean square share of the joints' strength at which the penalty is full (rule R8c). It
/// saturates there: torque is heavy-tailed.
inline constexpr double kTorqueShare = 0.6;
/// Sets the scale of the criterion torque: how much of their strength the joints need.
struct TorqueSettings {
  double share = kTorqueShare;  ///< of strength, > 0
};

/// People keep so much between the plumb line of their centre of mass and the edge of what they
/// stand on (m): some 2 to 3 cm.
inline constexpr double kBalanceReserve = 0.03;
/// Sets the scale of the criterion balance_zone: how near the plumb line of the centre of mass
/// comes to the edge of the feet's support polygon.
struct BalanceZoneSettings {
  double margin = kBalanceReserve;  ///< m, > 0
};

/// Mean discomfort of the joints at which the penalty is full: a quarter of them at the ends of
/// their range.
inline constexpr double kDiscomfortShare = 0.25;
/// Sets the scale of the criterion discomfort: how far joints are from neutral, and how near their
/// ends.
struct DiscomfortSettings {
  double share = kDiscomfortShare;  ///< of the joints at their ends, > 0
};

/// Root mean square joint acceleration at which the penalty is full (rad/s²): that of a turn by 90°
/// in 1 s with the minimum-jerk profile, sqrt(120 / 7) · (π / 2) / (1 s)², were all joints to make
/// it.
inline constexpr double kJointAcceleration = 6.5;
/// Sets the scale of the criterion joint_acceleration: how hard joints are sped up and slowed down.
struct JointAccelerationSettings {
  double acceleration = kJointAcceleration;  ///< rad/s², > 0
};

/// Work at which the penalty is full, as a share of the body's weight times its stature: about what
/// it takes to lower a body into a deep squat, and as much again.
inline constexpr double kWorkShare = 0.4;
/// Sets the scale of the criterion work: the mechanical work of all joints.
struct WorkSettings {
  double share = kWorkShare;  ///< of weight times stature, > 0
};

/// Share of strength at which the penalty is full: all of it. 0.75 is about 180 N·m in a man of 73
/// kg: with a muscle lever of 6 cm and the upper body's own weight the disc then bears the 3400 N
/// that NIOSH takes for the limit of what is harmless (Waters et al., Ergonomics 36 (1993)
/// 749-776). The penalty grows on beyond it, or a heavy load would say nothing about how to lift
/// it.
inline constexpr double kLowBackShare = 1.0;
/// Sets the scale of the criterion low_back: the moment about the lowest lumbar joint.
struct LowBackSettings {
  double share = kLowBackShare;  ///< of strength, > 0
};

/// Height of the head above the pelvis, as a share of their distance, from which on nothing is
/// amiss: a trunk that leans by 60°.
inline constexpr double kHeadHeight = 0.5;
/// Sets the scale of the criterion head: whether the head stays up and can look at the goal.
struct HeadSettings {
  double height = kHeadHeight;  ///< share, > 0
  /// m, world: the point that the eyes are on. A task without one looks at its goals; where there
  /// are none only the head's height counts.
  std::optional<Vec3d> gaze_target{};
};

/// Depth (m) of a collision at which the penalty is full.
inline constexpr double kCollisionFull = 0.05;
/// A hand that rests on a part of the body or on an obstacle touches it, which is no collision.
struct RestingPlace {
  int link = 0;    ///< of the hand
  std::string on;  ///< name of the part or the obstacle
};
/// Sets the scale of the criterion collision: how deep parts are in one another, in obstacles or in
/// the floor.
struct CollisionSettings {
  double full = kCollisionFull;         ///< m, > 0
  std::vector<Obstacle> obstacles{};    ///< of the task
  std::vector<RestingPlace> resting{};  ///< of the task's supports
};

/// How far outside the support polygon (m) the penalty is full.
inline constexpr double kPressureOutside = 0.10;
/// Sets the scale of the criterion centre_of_pressure: how far the floor would press outside the
/// feet.
struct PressureSettings {
  double outside = kPressureOutside;  ///< m, > 0
};

/// How far outside the support polygon (m) a pressure weighs as much as a joint that needs twice
/// its strength.
inline constexpr double kFeasibilityOutside = 0.05;
/// Sets the scale of the criterion feasibility: whether the body could make the motion at all.
struct FeasibilitySettings {
  double outside = kFeasibilityOutside;  ///< m, > 0
};

/// Half the difference (rad) of the knees from people's proportions at which half of the penalty is
/// reached.
inline constexpr double kCoordinationAngle = 0.35;
/// Sets the scale of the criterion coordination: whether knees bend along with the trunk as
/// people's do.
struct CoordinationSettings {
  double angle = kCoordinationAngle;  ///< rad, > 0
  std::vector<int> effectors{};       ///< of the task's goals; all hands where none are given
};

/// Share of its length by which a hand's path is off people's where half of the penalty is reached.
inline constexpr double kPathOffset = 0.2;
/// Sets the scale of the criterion hand_curve: how far hands leave the ways that people's take.
struct HandCurveSettings {
  double offset = kPathOffset;   ///< of the way's length, > 0
  std::vector<int> effectors{};  ///< of the task's goals; all hands where none are given
};

/// Way (m) of a shoulder beyond what its goal needs at which half of the penalty is reached.
inline constexpr double kTravelDistance = 0.3;
/// Sets the scale of the criterion trunk_travel: how far the trunk goes where the arm would do.
struct TrunkTravelSettings {
  double distance = kTravelDistance;  ///< m, > 0
  std::vector<int> effectors{};       ///< of the task's goals; all hands where none are given
};

/// Distance (m) of the centre of mass from where people have it at which half of the penalty is
/// reached.
inline constexpr double kMassDistance = 0.08;
/// Sets the scale of the criterion mass_ahead: whether the centre of mass goes along with the
/// hands.
struct MassAheadSettings {
  double distance = kMassDistance;  ///< m, > 0
  std::vector<int> effectors{};     ///< of the task's goals; all hands where none are given
};

/// Change of a torque or of the floor's pressure within 1/60 s at which half of the penalty is
/// reached, as a share of what counts as a jolt: 30 % of the strength, or 3 cm.
inline constexpr double kJoltLimit = 1.0;
/// Sets the scale of the criterion jolts: how suddenly torques and the floor's pressure change.
struct JoltsSettings {
  double limit = kJoltLimit;  ///< of a jolt, > 0
};

/// A criterion of the user's own: any scalar function of the motion; smaller is better. Its penalty
/// is value / scale, held to [0, 1] as the built-in ones are. NaN makes the motion the worst of
/// all.
struct UserCriterion {
  std::string name;     ///< in scores and messages
  double weight = 0.1;  ///< ≥ 0
  double scale = 1.0;   ///< value at which the penalty is full, > 0
  /// gives the value of a whole motion; called from one thread at a time
  std::function<double(const BodyModel&, const Motion&)> value{};
};

/// The criteria that a motion is scored by: score = Σ weight · penalty, lower is better. Weights
/// are 0 or more; a criterion whose weight is 0 is not computed.
struct CriteriaSettings {
  double joint_range_weight = kPaperRangeWeight;   ///< of joints beyond their limits
  double balance_weight = kPaperBalanceWeight;     ///< of the lean from the feet
  double torque_weight = kPaperTorqueWeight;       ///< of the torque
  double balance_zone_weight = 0.0;                ///< of the way to the edge of the feet
  double discomfort_weight = 0.0;                  ///< of joints far from neutral
  double joint_acceleration_weight = 0.0;          ///< of joint accelerations
  double work_weight = 0.0;                        ///< of mechanical work
  double low_back_weight = 0.0;                    ///< of the moment about L5/S1
  double head_weight = 0.0;                        ///< of the head's height and gaze
  double collision_weight = 0.0;                   ///< of collisions
  double pressure_weight = 0.0;                    ///< of a pressure outside the feet
  double feasibility_weight = 0.0;                 ///< of what the body cannot do
  double coordination_weight = 0.0;                ///< of knees out of proportion
  double hand_curve_weight = 0.0;                  ///< of ways that hands do not take
  double trunk_travel_weight = 0.0;                ///< of a trunk that moves where the arm would do
  double mass_ahead_weight = 0.0;                  ///< of a centre of mass held back
  double jolts_weight = 0.0;                       ///< of sudden torques
  JointRangeSettings joint_range{};                ///< scale of joint_range
  BalanceSettings balance{};                       ///< scale of balance
  TorqueSettings torque{};                         ///< scale of torque
  BalanceZoneSettings balance_zone{};              ///< scale of balance_zone
  DiscomfortSettings discomfort{};                 ///< scale of discomfort
  JointAccelerationSettings joint_acceleration{};  ///< scale of joint_acceleration
  WorkSettings work{};                             ///< scale of work
  LowBackSettings low_back{};                      ///< scale of low_back
  HeadSettings head{};                             ///< scale of head
  CollisionSettings collision{};                   ///< scale of collision
  PressureSettings pressure{};                     ///< scale of centre_of_pressure
  FeasibilitySettings feasibility{};               ///< scale of feasibility
  CoordinationSettings coordination{};             ///< scale of coordination
  HandCurveSettings hand_curve{};                  ///< scale of hand_curve
  TrunkTravelSettings trunk_travel{};              ///< scale of trunk_travel
  MassAheadSettings mass_ahead{};                  ///< scale of mass_ahead
  JoltsSettings jolts{};                           ///< scale of jolts
  std::vector<UserCriterion> user{};               ///< the user's own
};

/// Tells the criteria that look at reaching hands which effectors those are.
void set_reaching(CriteriaSettings& settings, const std::vector<int>& effectors);

/// The paper's three by rule R8's weights: what CriteriaSettings is by default.
[[nodiscard]] CriteriaSettings paper_criteria();

/// The mixture of the presets flat and human (docs/criteria.md has its weights): what a posture and
/// a motion cost a body; of large weight what people's reaches look like; and, of no weight against
/// what is free, stands and is within the body's strength, collisions, pressure and feasibility.
[[nodiscard]] CriteriaSettings default_criteria();

/// The criteria that a Pareto view weighs against each other: joint range, as discomfort near its
/// ends (no motion within limits has any of the paper's own), balance and torque, a third each.
[[nodiscard]] CriteriaSettings pareto_criteria();

/// A mixture that files and the command line call by its name.
struct CriteriaPreset {
  std::string_view name;           ///< "default"
  CriteriaSettings (*settings)();  ///< makes the mixture
};
/// "paper", "default" and "pareto".
[[nodiscard]] std::span<const CriteriaPreset> criteria_presets();

/// The names of the built-in criteria, in the table's order.
[[nodiscard]] std::vector<std::string> criterion_names();

/// One line of a score's breakdown.
struct ScoreTerm {
  std::string name;      ///< of the criterion
  double weight = 0.0;   ///< of the penalty in the total
  double penalty = 0.0;  ///< 0..1
};

/// The score of one motion, lower is better, with its breakdown.
struct Score {
  double total = 0.0;  ///< Σ weight · penalty
  /// the built-in criteria whose weight is above 0, in the table's order, then the user's in theirs
  std::vector<ScoreTerm> terms;
};

/// The score that a motion gets which misses its goal, leaves its path or moves a planted foot: no
/// other is worse.
[[nodiscard]] double worst_score(const CriteriaSettings& settings);

/// Scores a whole motion, which has torques and a centre of mass for each frame.
[[nodiscard]] Score score_motion(const BodyModel& body, const Motion& motion,
                                 const CriteriaSettings& settings);

/// The share of its strength that a joint needs at most, and when.
struct JointLoad {
  int dof = 0;          ///< freedom of the body
  double torque = 0.0;  ///< N·m, then
  double share = 0.0;   ///< of the strength in its direction
  double time = 0.0;    ///< s
};
/// (dofs) the loads of a whole motion.
[[nodiscard]] std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion);

/// A joint that passes its limit during a motion.
struct LimitExcess {
  std::string dof;      ///< name of the freedom
  double excess = 0.0;  ///< rad, the most at any frame
};
/// The joints that pass their limits by more than anyone sees, the worst first.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip);

/// (nodes) X_WN, the place of each node of the body in the world, by its angles: (dofs) rad.
[[nodiscard]] std::vector<Transformd> node_places(const BodyModel& body,
                                                  std::span<const double> angles);

/// (frames) m, on the floor: the centre of pressure of a whole motion that is at rest before and
/// after, of a body on the feet that stand. Where nothing presses, it is that of a force of 1 N.
[[nodiscard]] std::vector<Vec3d> centres_of_pressure(const BodyModel& body, const Motion& motion);

/// How far (m) inside the support polygon something stays at least, less than 0 outside it, and
/// when (s, from the motion's beginning).
struct SupportMargin {
  double distance = 0.0;  ///< m
  double time = 0.0;      ///< s
};

/// Whether a person could stand through a motion: the plumb line of the centre of mass, and the
/// floor's centre of pressure, both against the support polygon. The pressure's is the moment (N·m)
/// by which the body is held from tipping, over its weight: where the floor bears that weight, the
/// distance of the centre of pressure; no floor gives less than 0. Motions faster than gravity let
/// it leave the feet for a moment; a centre of mass that leaves them is a fall or a step.
struct SupportMargins {
  SupportMargin centre_of_mass;  ///< of its plumb line
  SupportMargin pressure;        ///< of the centre of pressure
};

/// Both in one frame (m, inside the support polygon; less than 0 outside).
struct SupportFrame {
  double centre_of_mass = 0.0;  ///< m, of its plumb line
  double pressure = 0.0;        ///< m, of the centre of pressure
};

/// (frames) both in each frame of a whole motion that is at rest before and after. None of a body
/// without feet, or with feet of no size.
[[nodiscard]] std::vector<SupportFrame> support_frames(const BodyModel& body, const Motion& motion);
/// The least of both in such a motion; nothing where support_frames has none.
[[nodiscard]] std::optional<SupportMargins> support_margins(const BodyModel& body,
                                                            const Motion& motion);

/// Flesh gives way by so much (m): less is no collision.
inline constexpr double kCollisionDepth = 0.005;
/// Greater depths in flesh are impossible (m).
inline constexpr double kFleshDepth = 0.02;
/// Greater depths in an obstacle are impossible (m): of both, only the body yields.
inline constexpr double kHardDepth = 0.01;

/// Where a motion collides most.
struct CollisionFound {
  double depth = 0.0;  ///< m, beyond what the start posture has; 0 where nothing collides
  std::string limb;    ///< capsule, "right_forearm"
  std::string other;   ///< capsule, obstacle or "floor"
  double time = 0.0;   ///< s
  bool hard = false;   ///< `other` is an obstacle
};
/// Finds the deepest collision of a body in a clip: arms with the body, any part with obstacles,
/// arms that have a wrist with the floor.
[[nodiscard]] CollisionFound deepest_collision(const BodyModel& body, const Clip& clip,
                                               const CollisionSettings& settings = {});

/// How suddenly a motion changes at most from one of its frames to the next, as if it had 60 of
/// them. A person sees a jolt where the floor's centre of pressure moves by more than 3 cm then, or
/// a torque by more than 30 % of its joint's strength both ways together.
struct Suddenness {
  double pressure = 0.0;  ///< m, by which the centre of pressure moves; 0 of a body without feet
  double torque = 0.0;    ///< share of the strength, by which a torque changes

  /// Whether the motion jolts.
  [[nodiscard]] bool jolts() const;
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] Suddenness suddenness(const BodyModel& body, const Motion& motion);

/// The demands of a motion, generated or recorded, on its body.
struct MotionMeasures {
  std::vector<JointLoad> loads;             ///< (dofs)
  std::vector<LimitExcess> over_limit;      ///< the worst first
  std::optional<SupportMargins> support{};  ///< of a body that stands
  CollisionFound collides;  ///< the deepest at any frame, with itself, an obstacle or the floor
  Suddenness sudden;        ///< the most from frame to frame
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] MotionMeasures measure_motion(const BodyModel& body, const Motion& motion,
                                            const CollisionSettings& collision);
/// The joint that needs most of its strength; null of a body without joints.
[[nodiscard]] const JointLoad* most_loaded(const MotionMeasures& measures);

}  // namespace shigusa
