// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/body/obstacle.hpp>
#include <shigusa/motion/motion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The paper's order of importance, range > balance > torque (section 3.3), with rule R8's weights.
inline constexpr double kPaperRangeWeight = 0.5;
inline constexpr double kPaperBalanceWeight = 0.3;
inline constexpr double kPaperTorqueWeight = 0.2;

// Share of a joint's range by which a limit may be passed until the penalty is full (rule R8a).
inline constexpr double kRangeMargin = 0.2;
struct JointRangeSettings {
  double margin = kRangeMargin;  // share of the range, > 0
};

// Lean at which the penalty is full (rule R8b): the toes' edge is 0.13 m ahead of mid-foot and the
// centre of mass about 1.0 m high standing, 0.7 m stooping.
inline constexpr double kBalanceLean = 0.20;
struct BalanceSettings {
  double lean = kBalanceLean;  // horizontal over vertical, > 0
};

// Root mean square share of the joints' strength at which the penalty is full (rule R8c). It
// saturates there: torque is heavy-tailed.
inline constexpr double kTorqueShare = 0.6;
struct TorqueSettings {
  double share = kTorqueShare;  // of strength, > 0
};

// What people keep between the plumb line of their centre of mass and the edge of what they stand
// on (m): some 2 to 3 cm.
inline constexpr double kBalanceReserve = 0.03;
struct BalanceZoneSettings {
  double margin = kBalanceReserve;  // m, > 0
};

// Mean discomfort of the joints at which the penalty is full: a quarter of them at the ends of
// their range.
inline constexpr double kDiscomfortShare = 0.25;
struct DiscomfortSettings {
  double share = kDiscomfortShare;  // of the joints at their ends, > 0
};

// Root mean square joint acceleration at which the penalty is full (rad/s²): that of a turn by 90°
// in 1 s with the minimum-jerk profile, sqrt(120 / 7) · (π / 2) / (1 s)², were all joints to make
// it.
inline constexpr double kJointAcceleration = 6.5;
struct JointAccelerationSettings {
  double acceleration = kJointAcceleration;  // rad/s², > 0
};

// Work at which the penalty is full, as a share of the body's weight times its stature: about what
// it takes to lower a body into a deep squat, and as much again.
inline constexpr double kWorkShare = 0.4;
struct WorkSettings {
  double share = kWorkShare;  // of weight times stature, > 0
};

// Share of strength at which the penalty is full: all of it. 0.75 is about 180 N·m in that man:
// with a muscle lever of 6 cm and the upper body's own weight the disc then bears the 3400 N that
// NIOSH takes for the limit of what is harmless (Waters et al., Ergonomics 36 (1993) 749-776). The
// penalty grows on beyond it, or a heavy load would say nothing about how to lift it.
inline constexpr double kLowBackShare = 1.0;
struct LowBackSettings {
  double share = kLowBackShare;  // of strength, > 0
};

// Height of the head above the pelvis, as a share of their distance, from which on nothing is
// amiss: a trunk that leans by 60°.
inline constexpr double kHeadHeight = 0.5;
struct HeadSettings {
  double height = kHeadHeight;  // share, > 0
  // m, world: what the eyes are on. A task's first goal where none is given; without one only the
  // head's height counts.
  std::optional<Vec3d> gaze_target{};
};

// Depth (m) of a collision at which the penalty is full.
inline constexpr double kCollisionFull = 0.05;
struct CollisionSettings {
  double full = kCollisionFull;       // m, > 0
  std::vector<Obstacle> obstacles{};  // of the task
};

// How far outside the support polygon (m) the penalty is full.
inline constexpr double kPressureOutside = 0.10;
struct PressureSettings {
  double outside = kPressureOutside;  // m, > 0
};

// How far outside the support polygon (m) a pressure weighs as much as a joint that needs twice its
// strength.
inline constexpr double kFeasibilityOutside = 0.05;
struct FeasibilitySettings {
  double outside = kFeasibilityOutside;  // m, > 0
};

// A criterion of the user's own: any scalar function of the motion; smaller is better. Its penalty
// is value / scale, held to [0, 1] as the built-in ones are. NaN makes the motion the worst of all.
struct UserCriterion {
  std::string name;
  double weight = 0.1;  // ≥ 0
  double scale = 1.0;   // value at which the penalty is full, > 0
  std::function<double(const BodyModel&, const Motion&)> value{};
};

// What a motion is scored by: score = Σ weight · penalty, lower is better. Weights are 0 or more;
// what has a weight of 0 is not computed.
struct CriteriaSettings {
  double joint_range_weight = kPaperRangeWeight;
  double balance_weight = kPaperBalanceWeight;
  double torque_weight = kPaperTorqueWeight;
  double balance_zone_weight = 0.0;
  double discomfort_weight = 0.0;
  double joint_acceleration_weight = 0.0;
  double work_weight = 0.0;
  double low_back_weight = 0.0;
  double head_weight = 0.0;
  double collision_weight = 0.0;
  double pressure_weight = 0.0;
  double feasibility_weight = 0.0;
  JointRangeSettings joint_range{};
  BalanceSettings balance{};
  TorqueSettings torque{};
  BalanceZoneSettings balance_zone{};
  DiscomfortSettings discomfort{};
  JointAccelerationSettings joint_acceleration{};
  WorkSettings work{};
  LowBackSettings low_back{};
  HeadSettings head{};
  CollisionSettings collision{};
  PressureSettings pressure{};
  FeasibilitySettings feasibility{};
  std::vector<UserCriterion> user{};
};

// The paper's three by rule R8's weights: what CriteriaSettings is by default.
[[nodiscard]] CriteriaSettings paper_criteria();

// The mixture that came nearest to a recorded man's reaches to the floor among those tried, with
// more of the low back (docs/criteria.md): joint range 0.25, balance zone 0.20, discomfort 0.27,
// joint acceleration 0.22, low back 0.20; and, of no weight against what is free, stands and is
// within the body's strength, collision 0.5, centre of pressure 0.35 and feasibility 1.
[[nodiscard]] CriteriaSettings default_criteria();

// What a Pareto view weighs against each other: joint range, as discomfort near its ends (no motion
// within limits has any of the paper's own), balance and torque, a third each.
[[nodiscard]] CriteriaSettings pareto_criteria();

// A mixture that files and the command line call by its name.
struct CriteriaPreset {
  std::string_view name;
  CriteriaSettings (*settings)();
};
// "paper", "default" and "pareto".
[[nodiscard]] std::span<const CriteriaPreset> criteria_presets();

// One line of a score's breakdown.
struct ScoreTerm {
  std::string name;
  double weight = 0.0;
  double penalty = 0.0;  // 0..1
};

struct Score {
  double total = 0.0;  // Σ weight · penalty
  // the built-in criteria whose weight is above 0, in the table's order, then the user's in theirs
  std::vector<ScoreTerm> terms;
};

// The score that a motion gets which misses its goal, leaves its path or moves a planted foot: no
// other is worse.
[[nodiscard]] double worst_score(const CriteriaSettings& settings);

// Scores a whole motion.
[[nodiscard]] Score score_motion(const BodyModel& body, const Motion& motion,
                                 const CriteriaSettings& settings);

}  // namespace shigusa
