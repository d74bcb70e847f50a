// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/habit.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

/// Weight of joint_range; the paper's order is range > balance > torque (section 3.3, rule R8).
inline constexpr double kPaperRangeWeight = 0.5;
inline constexpr double kPaperBalanceWeight = 0.3;  ///< weight of balance (rule R8)
inline constexpr double kPaperTorqueWeight = 0.2;   ///< weight of torque (rule R8)

/// The built-in criteria, in the order of a score's terms.
enum class CriterionKind {
  joint_range,         ///< how far joints exceed their limits
  balance,             ///< lean: distance of the centre of mass from the feet over its height
  torque,              ///< joint torques relative to the joints' strength
  balance_zone,        ///< nearness of the centre of mass to the edge of the support polygon
  discomfort,          ///< distance of joints from neutral angles, nearness to their limits
  joint_acceleration,  ///< root-mean-square acceleration of the joints
  work,                ///< mechanical work of all joints
  low_back,            ///< moment about the lowest lumbar joint (L5/S1)
  head,                ///< height of the head, and its view of the gaze target
  collision,           ///< depth of body parts in one another, in obstacles or in the floor
  centre_of_pressure,  ///< distance of the centre of pressure outside the support polygon
  feasibility,         ///< excess of the worst moment over the body's ability
  coordination,        ///< knees out of people's proportion to the trunk
  hand_curve,          ///< deviation of hand paths from people's
  trunk_travel,        ///< travel of the trunk where the arm alone would reach
  mass_ahead,          ///< a centre of mass that does not follow the hands
  jolts,               ///< sudden changes of torques and of the centre of pressure
};

/// Excess beyond a limit, as a share of the joint's range, at which the penalty of joint_range is 1
/// (rule R8a).
inline constexpr double kRangeMargin = 0.2;
/// Lean at which the penalty of balance is 1 (rule R8b): the toes' edge is 0.13 m ahead of mid-foot
/// and the centre of mass about 1.0 m high when standing, 0.7 m when stooping.
inline constexpr double kBalanceLean = 0.20;
/// Root-mean-square share of the joints' strength at which the penalty of torque is 1 (rule R8c).
/// The penalty saturates there, as torques are heavy-tailed.
inline constexpr double kTorqueShare = 0.6;
/// Distance that people keep between the plumb line of their centre of mass and the edge of their
/// support polygon (m): some 2 to 3 cm.
inline constexpr double kBalanceReserve = 0.03;
/// Mean discomfort of the joints at which the penalty is 1: a quarter of them at the ends of their
/// range.
inline constexpr double kDiscomfortShare = 0.25;
/// Root-mean-square joint acceleration at which the penalty is 1 (rad/s²): that of turning all
/// joints by 90° in 1 s with the minimum-jerk profile, sqrt(120 / 7) · (π / 2) / (1 s)².
inline constexpr double kJointAcceleration = 6.5;
/// Work at which the penalty is 1, as a share of body weight times stature: about the work of
/// lowering a body into a deep squat and raising it again.
inline constexpr double kWorkShare = 0.4;
/// Share of the back's strength at which the penalty of low_back is 1. A share of 0.75 is about
/// 180 N·m in a man of 73 kg: with a muscle lever of 6 cm and the weight of the upper body, the
/// disc then bears the 3400 N of NIOSH's limit (Waters et al., Ergonomics 36 (1993) 749-776). The
/// penalty grows beyond that limit, so that it still distinguishes ways of lifting a heavy load.
inline constexpr double kLowBackShare = 1.0;
/// Height of the head above the pelvis, as a share of their distance, below which the penalty of
/// head begins: a trunk that leans by 60°.
inline constexpr double kHeadHeight = 0.5;
/// Collision depth (m) at which the penalty is 1.
inline constexpr double kCollisionFull = 0.05;
/// Distance outside the support polygon (m) at which the penalty of centre_of_pressure is 1.
inline constexpr double kPressureOutside = 0.10;
/// Distance of the centre of pressure outside the support polygon (m) that costs as much in
/// feasibility as a joint that needs twice its strength.
inline constexpr double kFeasibilityOutside = 0.05;
/// Half the difference (rad) of the knees from people's proportions at which the penalty of
/// coordination is 0.5.
inline constexpr double kCoordinationAngle = 0.35;
/// Deviation of a hand's path from people's, as a share of its length, at which the penalty is 0.5.
inline constexpr double kPathOffset = 0.2;
/// Distance (m) that a shoulder travels beyond the need of its goal at which the penalty is 0.5.
inline constexpr double kTravelDistance = 0.3;
/// Distance (m) of the centre of mass from its place in people's reaches at which the penalty is
/// 0.5.
inline constexpr double kMassDistance = 0.08;
/// Change of a torque or of the centre of pressure within 1/60 s at which the penalty of jolts is
/// 0.5, as a share of a visible jolt: 30 % of the strength, or 3 cm.
inline constexpr double kJoltLimit = 1.0;

/// The facts of a built-in criterion.
struct CriterionTraits {
  CriterionKind kind;           ///< the criterion
  std::string_view word;        ///< name in scores and in files
  std::string_view counts;      ///< description for users: "quick starts and stops"
  std::string_view scale_name;  ///< name of the scale in files, with its unit
  double scale;                 ///< usual reference scale
};
/// All built-in criteria, in the order of CriterionKind.
inline constexpr std::array kCriteria{
    CriterionTraits{CriterionKind::joint_range, "joint_range", "joints beyond their limits",
                    "margin", kRangeMargin},
    CriterionTraits{CriterionKind::balance, "balance", "leaning away from above the feet", "lean",
                    kBalanceLean},
    CriterionTraits{CriterionKind::torque, "torque", "effort of the joints beside their strength",
                    "share", kTorqueShare},
    CriterionTraits{CriterionKind::balance_zone, "balance_zone", "weight near the edge of the feet",
                    "margin_m", kBalanceReserve},
    CriterionTraits{CriterionKind::discomfort, "discomfort", "joints far from their easy middle",
                    "share", kDiscomfortShare},
    CriterionTraits{CriterionKind::joint_acceleration, "joint_acceleration",
                    "quick starts and stops", "acceleration_rad_s2", kJointAcceleration},
    CriterionTraits{CriterionKind::work, "work", "work of lifting and braking", "share",
                    kWorkShare},
    CriterionTraits{CriterionKind::low_back, "low_back", "load on the lower back", "share",
                    kLowBackShare},
    CriterionTraits{CriterionKind::head, "head", "head low, or eyes off the goal", "height",
                    kHeadHeight},
    CriterionTraits{CriterionKind::collision, "collision", "parts that pass through something",
                    "depth_m", kCollisionFull},
    CriterionTraits{CriterionKind::centre_of_pressure, "centre_of_pressure",
                    "pressure outside the feet", "outside_m", kPressureOutside},
    CriterionTraits{CriterionKind::feasibility, "feasibility",
                    "a worst moment beyond strength or footing", "outside_m", kFeasibilityOutside},
    CriterionTraits{CriterionKind::coordination, "coordination", "knees bent unlike people's",
                    "angle_rad", kCoordinationAngle},
    CriterionTraits{CriterionKind::hand_curve, "hand_curve", "a way of the hand unlike people's",
                    "offset", kPathOffset},
    CriterionTraits{CriterionKind::trunk_travel, "trunk_travel",
                    "a trunk that goes too far or too little", "distance_m", kTravelDistance},
    CriterionTraits{CriterionKind::mass_ahead, "mass_ahead",
                    "weight that does not go along with the hand", "distance_m", kMassDistance},
    CriterionTraits{CriterionKind::jolts, "jolts", "sudden changes of effort", "limit", kJoltLimit},
};
/// The words of CriterionKind.
template <>
inline constexpr auto kEnumWords<CriterionKind> = words_of_table(kCriteria, &CriterionTraits::kind);

/// A user-defined criterion: any scalar function of the motion, smaller is better. Its penalty is
/// value / scale, clamped to [0, 1] like those of the built-in criteria. A motion with the value
/// NaN ranks last. Its functions are called on the thread that searches, and never twice at once.
struct UserCriterion {
  std::string name;     ///< name in scores and messages
  double weight = 0.1;  ///< ≥ 0
  double scale = 1.0;   ///< value at which the penalty is 1, > 0
  /// Computes the value of a whole motion.
  std::function<double(const BodyModel&, const Motion&)> value{};
  /// Instead of `value`: the values (motions) of all motions of a step of the search, one or more
  /// of equal shapes, for functions whose call is dear.
  std::function<void(const BodyModel&, std::span<const Motion>, std::span<double>)> values{};
};

/// The setting of one built-in criterion.
struct CriterionSetting {
  double weight = 0.0;  ///< ≥ 0; a criterion of weight 0 is not computed
  double scale = 1.0;   ///< reference scale, > 0: see the criterion's constant
};

/// A mixture of criteria: score = Σ weight · penalty, lower is better. The scales are those of
/// kCriteria unless set.
struct CriteriaSettings {
  std::array<CriterionSetting, kCriteria.size()> built_in;  ///< in the order of CriterionKind
  std::vector<UserCriterion> user{};                        ///< user-defined criteria

  /// The paper's mixture, see paper_criteria.
  CriteriaSettings()
      : CriteriaSettings({{CriterionKind::joint_range, kPaperRangeWeight},
                          {CriterionKind::balance, kPaperBalanceWeight},
                          {CriterionKind::torque, kPaperTorqueWeight}}) {}
  /// A mixture of the given weights; the others are 0.
  CriteriaSettings(std::initializer_list<std::pair<CriterionKind, double>> weights) {
    for (std::size_t k = 0; k < built_in.size(); ++k) built_in[k] = {0.0, kCriteria[k].scale};
    for (const auto& [kind, weight] : weights) (*this)[kind].weight = weight;
  }
  /// The setting of a criterion.
  [[nodiscard]] const CriterionSetting& operator[](CriterionKind kind) const {
    return built_in[static_cast<std::size_t>(kind)];
  }
  /// Mutable access.
  [[nodiscard]] CriterionSetting& operator[](CriterionKind kind) {
    return built_in[static_cast<std::size_t>(kind)];
  }
};

/// A contact of a resting hand with a body part or an obstacle, which does not count as a
/// collision.
struct RestingPlace {
  int link = 0;    ///< index of the hand's link
  std::string on;  ///< name of the capsule or the obstacle
};

/// The circumstances in which a motion is scored and measured.
struct CriteriaContext {
  /// Posture from which the motion begins: the planted feet and the allowed depths of collisions
  /// are as in it. Without angles it is the motion's first frame.
  State start{};
  std::vector<int> effectors{};         ///< indices of the goals' effectors; empty: all hands
  std::optional<Vec3d> gaze{};          ///< gaze target, m, world; empty: none
  std::vector<Obstacle> obstacles{};    ///< obstacles that the body can collide with
  std::vector<RestingPlace> resting{};  ///< contacts of resting hands
  Habit habit{};                        ///< the person's way of moving
};

/// The paper's three criteria with the weights of rule R8: the default CriteriaSettings.
[[nodiscard]] CriteriaSettings paper_criteria();

/// The mixture of the presets flat and human, with weights listed in docs/criteria.md. It combines
/// the effort of posture and motion, likeness to people's reaches with large weights, and
/// collisions, pressure and feasibility, which cost nothing in a motion that is collision-free,
/// balanced and within the body's strength.
[[nodiscard]] CriteriaSettings default_criteria();

/// The mixture for Pareto fronts: discomfort, balance and torque, a third each. Discomfort near the
/// ends of the range replaces the paper's joint range, which is 0 for motions within limits.
[[nodiscard]] CriteriaSettings pareto_criteria();

/// A named mixture, as used in files and on the command line.
struct CriteriaPreset {
  std::string_view name;           ///< "default"
  CriteriaSettings (*settings)();  ///< makes the mixture
};
/// The named mixtures: "paper", "default" and "pareto".
[[nodiscard]] std::span<const CriteriaPreset> criteria_presets();

/// The names of the built-in criteria, in the table's order.
[[nodiscard]] std::vector<std::string> criterion_names();

/// One line of a score's breakdown.
struct ScoreTerm {
  std::string name;      ///< name of the criterion
  double weight = 0.0;   ///< weight of the penalty in the total
  double penalty = 0.0;  ///< 0..1
};

/// The score of one motion, lower is better, with its breakdown.
struct Score {
  double total = 0.0;  ///< Σ weight · penalty
  /// Built-in criteria of weight above 0, in the order of criterion_names, then user-defined ones.
  std::vector<ScoreTerm> terms;
};

/// The score of a motion that misses its goal, leaves its path or moves a planted foot; no score is
/// higher.
[[nodiscard]] double worst_score(const CriteriaSettings& settings);

/// Scores a whole motion with torques and a centre of mass in each frame.
[[nodiscard]] Score score_motion(const BodyModel& body, const Motion& motion,
                                 const CriteriaSettings& settings,
                                 const CriteriaContext& context = {});

/// The peak load of one joint, relative to its strength.
struct JointLoad {
  int dof = 0;          ///< index of the dof
  double torque = 0.0;  ///< N·m, at the peak
  double share = 0.0;   ///< torque over the strength in its direction
  double time = 0.0;    ///< s, of the peak
};
/// Peak loads of a whole motion: (dofs).
[[nodiscard]] std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion);

/// A joint that exceeds its limit during a motion.
struct LimitExcess {
  std::string dof;      ///< name of the dof
  double excess = 0.0;  ///< rad, the most at any frame
};
/// The joints that visibly exceed their limits, the worst first.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip);

/// World poses X_WN of the body's nodes at the angles (dofs, rad): (nodes).
[[nodiscard]] std::vector<Transformd> node_places(const BodyModel& body,
                                                  std::span<const double> angles);

/// Centres of pressure of a motion that is at rest before and after: (frames) m, on the floor, for
/// a body on its planted feet. With less than 1 N on the floor, a force of 1 N is assumed.
[[nodiscard]] std::vector<Vec3d> centres_of_pressure(const BodyModel& body, const Motion& motion);

/// The smallest distance of a point inside the support polygon during a motion, below 0 outside,
/// and its time.
struct SupportMargin {
  double distance = 0.0;  ///< m
  double time = 0.0;      ///< s, from the start
};

/// Balance of a motion: margins of the plumb line of the centre of mass and of the floor's centre
/// of pressure against the support polygon. The margin of the pressure is the moment (N·m) about an
/// edge that holds the body from tipping, over its weight; where the floor bears that weight, it is
/// the distance of the centre of pressure. No floor can provide a margin below 0. Motions faster
/// than gravity let the pressure leave the feet for a moment; a centre of mass outside the feet
/// means a fall or a step.
struct SupportMargins {
  SupportMargin centre_of_mass;  ///< margin of its plumb line
  SupportMargin pressure;        ///< margin of the centre of pressure
};

/// The balance margins in one frame (m, inside the support polygon; below 0 outside).
struct SupportFrame {
  double centre_of_mass = 0.0;  ///< m, margin of its plumb line
  double pressure = 0.0;        ///< m, margin of the centre of pressure
};

/// Balance margins of a motion that is at rest before and after: (frames). Empty for a body without
/// feet or with feet of no size.
[[nodiscard]] std::vector<SupportFrame> support_frames(const BodyModel& body, const Motion& motion);
/// The smallest balance margins of a motion; nothing where support_frames is empty.
[[nodiscard]] std::optional<SupportMargins> support_margins(const BodyModel& body,
                                                            const Motion& motion);

/// Depth below which soft tissue yields and nothing counts as a collision (m).
inline constexpr double kCollisionDepth = 0.005;
/// Largest possible depth in soft tissue (m).
inline constexpr double kFleshDepth = 0.02;
/// Largest possible depth in an obstacle (m): smaller than kFleshDepth, as only the body yields.
inline constexpr double kHardDepth = 0.01;

/// The deepest collision of a motion.
struct CollisionFound {
  double depth = 0.0;  ///< m, beyond the depth in the start posture; 0 without a collision
  std::string limb;    ///< name of the capsule, "right_forearm"
  std::string other;   ///< name of the capsule or obstacle, or "floor"
  double time = 0.0;   ///< s, from the start
  bool hard = false;   ///< `other` is an obstacle
};
/// Finds the deepest collision of a body in a clip: arms with the body, any part with obstacles,
/// arms that have a wrist with the floor.
[[nodiscard]] CollisionFound deepest_collision(const BodyModel& body, const Clip& clip,
                                               const CriteriaContext& context = {});

/// The largest change of a motion within 1/60 s. People see a jolt where the floor's centre of
/// pressure moves by more than 3 cm, or a torque changes by more than 30 % of its joint's strength
/// in both directions together, in that time.
struct Suddenness {
  double pressure = 0.0;  ///< m, displacement of the centre of pressure; 0 for a body without feet
  double torque = 0.0;    ///< change of a torque, as a share of the joint's strength

  /// Whether the motion jolts.
  [[nodiscard]] bool jolts() const;
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] Suddenness suddenness(const BodyModel& body, const Motion& motion);

/// The demands of a generated or recorded motion on the body.
struct MotionMeasures {
  std::vector<JointLoad> loads;             ///< (dofs) peak loads
  std::vector<LimitExcess> over_limit;      ///< the worst first
  std::optional<SupportMargins> support{};  ///< balance margins; empty for a body without feet
  CollisionFound collides;  ///< the deepest collision with itself, an obstacle or the floor
  Suddenness sudden;        ///< the largest change within 1/60 s
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] MotionMeasures measure_motion(const BodyModel& body, const Motion& motion,
                                            const CriteriaContext& context = {});
/// The joint with the largest load share; null for a body without joints.
[[nodiscard]] const JointLoad* most_loaded(const MotionMeasures& measures);

}  // namespace shigusa
