// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <vector>

namespace shigusa {

/// Parts of a posture that REBA, RULA and EN 1005-4 judge by an angle.
enum class PosturePart {
  neck,       ///< flexion of the head against the trunk, below 0 extension
  trunk,      ///< flexion from upright, below 0 extension
  upper_arm,  ///< flexion against the trunk
  lower_arm,  ///< flexion of the elbow from straight
  wrist,      ///< flexion of the hand against the forearm, below 0 extension
};
/// The words of PosturePart.
template <>
inline constexpr std::array kEnumWords<PosturePart>{
    EnumWord{PosturePart::neck, "neck"}, EnumWord{PosturePart::trunk, "trunk"},
    EnumWord{PosturePart::upper_arm, "upper_arm"}, EnumWord{PosturePart::lower_arm, "lower_arm"},
    EnumWord{PosturePart::wrist, "wrist"}};

/// A method that scores postures.
enum class PostureMethod {
  reba,  ///< S. Hignett and L. McAtamney, Applied Ergonomics 31 (2000) 201-205
  rula,  ///< L. McAtamney and E. N. Corlett, Applied Ergonomics 24 (1993) 91-99
};
/// The words of PostureMethod.
template <>
inline constexpr std::array kEnumWords<PostureMethod>{EnumWord{PostureMethod::reba, "reba"},
                                                      EnumWord{PostureMethod::rula, "rula"}};

/// The edition of RULA's table A; they differ in 31 of 144 cells.
enum class RulaEdition {
  present,  ///< of present worksheets and programs
  older,    ///< of older worksheets
};
/// The words of RulaEdition.
template <>
inline constexpr std::array kEnumWords<RulaEdition>{EnumWord{RulaEdition::present, "present"},
                                                    EnumWord{RulaEdition::older, "older"}};

/// Thresholds that the methods leave open. A border belongs to the lower band.
struct PostureThresholds {
  double upright = radians(5.0);          ///< rad, trunk that counts as upright
  double straight_wrist = radians(5.0);   ///< rad, wrist that counts as neutral in RULA
  double neck_extends = radians(5.0);     ///< rad, beyond it the neck counts as extended
  double trunk_aside = radians(10.0);     ///< rad, trunk bent sideways or twisted
  double neck_aside = radians(15.0);      ///< rad, neck bent sideways or twisted
  double arm_abducted = radians(30.0);    ///< rad, upper arm out of the sagittal plane
  double shoulder_raised = 0.025;         ///< m, of the shoulder above neutral
  double wrist_deviates = radians(10.0);  ///< rad, hand bent sideways
  double forearm_end = 0.25;  ///< share of the forearm's range at either end, which is its end
  double one_foot = 0.75;     ///< share of the weight above which one foot bears it
  double gravity_helps = radians(20.0);  ///< rad, of a hanging upper arm from the vertical
  double hand_across = 0.0;              ///< m, of a hand beyond the middle
  double hand_out = 0.10;                ///< m, of a hand outside its shoulder
  friend bool operator==(const PostureThresholds&, const PostureThresholds&) = default;
};

/// Score of a part by its angle (rad) alone, without additions. RULA scores an upright trunk as 1.
[[nodiscard]] int base_score(PostureMethod method, PosturePart part, double angle,
                             const PostureThresholds& thresholds = {});

/// Sub-scores of a posture by REBA, of one arm.
struct RebaParts {
  int neck = 1;       ///< 1..3; 4 reads as 3
  int trunk = 1;      ///< 1..5
  int legs = 1;       ///< 1..4
  int load = 0;       ///< 0..3
  int upper_arm = 1;  ///< 1..6
  int lower_arm = 1;  ///< 1..2
  int wrist = 1;      ///< 1..3
  int coupling = 0;   ///< 0 good to 3 unacceptable
  int activity = 0;   ///< 0..3
  friend bool operator==(const RebaParts&, const RebaParts&) = default;
};
/// A posture's score by REBA.
struct RebaScore {
  RebaParts parts{};  ///< sub-scores
  int table_a = 0;    ///< neck, trunk and legs
  int score_a = 0;    ///< with the load
  int table_b = 0;    ///< arm
  int score_b = 0;    ///< with the coupling
  int table_c = 0;    ///< both
  int score = 0;      ///< 1..15, with the activity
  int level = 0;      ///< 0 negligible, 1 low, 2 medium, 3 high, 4 very high
};
/// Scores a posture by REBA. PreconditionError for a sub-score out of its range.
[[nodiscard]] RebaScore reba_score(const RebaParts& parts);
/// Number of REBA's levels.
inline constexpr int kRebaLevels = 5;

/// Sub-scores of a posture by RULA, of one arm.
struct RulaParts {
  int upper_arm = 1;    ///< 1..6
  int lower_arm = 1;    ///< 1..3
  int wrist = 1;        ///< 1..4
  int wrist_twist = 1;  ///< 1..2
  int muscle = 0;       ///< 0..1
  int force = 0;        ///< 0..3
  int neck = 1;         ///< 1..6
  int trunk = 1;        ///< 1..6
  int legs = 1;         ///< 1..2
  friend bool operator==(const RulaParts&, const RulaParts&) = default;
};
/// A posture's score by RULA.
struct RulaScore {
  RulaParts parts{};  ///< sub-scores
  int table_a = 0;    ///< arm and wrist
  int score_c = 0;    ///< with muscle use and force
  int table_b = 0;    ///< neck, trunk and legs
  int score_d = 0;    ///< with muscle use and force
  int score = 0;      ///< 1..7
  int level = 0;      ///< 1 acceptable, 2 investigate, 3 investigate and change soon, 4 change now
};
/// Scores a posture by RULA. PreconditionError for a sub-score out of its range.
[[nodiscard]] RulaScore rula_score(const RulaParts& parts,
                                   RulaEdition edition = RulaEdition::present);
/// Number of RULA's levels.
inline constexpr int kRulaLevels = 4;

/// Parts that EN 1005-4 judges.
enum class ZonePart {
  trunk,             ///< lean from the vertical, ahead above 0
  trunk_aside,       ///< bend sideways or twist, whichever is greater
  upper_arm,         ///< elevation from hanging, in any direction
  head,              ///< flexion of head and neck
  head_inclination,  ///< lean of the head from the vertical, by ISO 11226
};
/// The words of ZonePart.
template <>
inline constexpr std::array kEnumWords<ZonePart>{
    EnumWord{ZonePart::trunk, "trunk"}, EnumWord{ZonePart::trunk_aside, "trunk_aside"},
    EnumWord{ZonePart::upper_arm, "upper_arm"}, EnumWord{ZonePart::head, "head"},
    EnumWord{ZonePart::head_inclination, "head_inclination"}};
/// Number of the zones' parts.
inline constexpr std::size_t kZoneParts = 5;

/// How often a posture recurs.
enum class Recurrence {
  held,      ///< for 4 s or longer
  rare,      ///< less than 2 movements a minute
  frequent,  ///< 2 movements a minute or more
};
/// The words of Recurrence.
template <>
inline constexpr std::array kEnumWords<Recurrence>{EnumWord{Recurrence::held, "held"},
                                                   EnumWord{Recurrence::rare, "rare"},
                                                   EnumWord{Recurrence::frequent, "frequent"}};
/// Time (s) from which a posture is held.
inline constexpr double kHeldFrom = 4.0;
/// Movements a minute from which a posture is frequent.
inline constexpr double kFrequentFrom = 2.0;

/// A zone's verdict.
enum class ZoneVerdict {
  acceptable,      ///< acceptable
  conditional,     ///< acceptable on conditions, such as a limited time or a support
  not_acceptable,  ///< not acceptable
  unknown,         ///< no source at hand states it
};
/// The words of ZoneVerdict.
template <>
inline constexpr std::array kEnumWords<ZoneVerdict>{
    EnumWord{ZoneVerdict::acceptable, "acceptable"},
    EnumWord{ZoneVerdict::conditional, "conditional"},
    EnumWord{ZoneVerdict::not_acceptable, "not_acceptable"},
    EnumWord{ZoneVerdict::unknown, "unknown"}};

/// A part's zone: -1 below 0°, 0, 1 or 2, of which a part may have fewer. A border belongs to the
/// lower zone, and lying back by up to 5° counts as upright.
[[nodiscard]] int zone_of(ZonePart part, double angle);
/// Verdict on a zone.
[[nodiscard]] ZoneVerdict zone_verdict(ZonePart part, int zone, Recurrence recurrence);

/// Quality of the grip on a load.
enum class Coupling {
  good,          ///< handles or a comfortable grip
  fair,          ///< acceptable handles, or fingers bent by 90° under the load
  poor,          ///< neither
  unacceptable,  ///< no handle, awkward or unsafe, in REBA; the lifting equation has it as poor
};
/// The words of Coupling.
template <>
inline constexpr std::array kEnumWords<Coupling>{
    EnumWord{Coupling::good, "good"}, EnumWord{Coupling::fair, "fair"},
    EnumWord{Coupling::poor, "poor"}, EnumWord{Coupling::unacceptable, "unacceptable"}};

/// Duration of lifting, with its rest.
enum class LiftingTime {
  brief,     ///< up to 1 h, then a rest as long
  moderate,  ///< 1 to 2 h, then a rest of 0.3 of the time
  lengthy,   ///< 2 to 8 h
};
/// The words of LiftingTime.
template <>
inline constexpr std::array kEnumWords<LiftingTime>{EnumWord{LiftingTime::brief, "short"},
                                                    EnumWord{LiftingTime::moderate, "moderate"},
                                                    EnumWord{LiftingTime::lengthy, "long"}};

/// Constants of the revised NIOSH lifting equation in one system of units.
struct LiftConstants {
  double load;            ///< greatest load
  double near;            ///< hands nearer than that count as there
  double far;             ///< hands farther than that lift nothing
  double knuckles;        ///< height of the hands of the factor 1
  double high;            ///< hands higher than that lift nothing
  double per_height;      ///< loss of the factor by a unit of height
  double least_travel;    ///< a shorter way counts as that
  double longest_travel;  ///< a longer way lifts nothing
  double of_travel;       ///< numerator of the factor
};
/// Metric constants, in kg and m.
inline constexpr LiftConstants kMetricLift{23.0, 0.25, 0.63, 0.75, 1.75, 0.3, 0.25, 1.75, 0.045};
/// US constants, in lb and in; they are no conversions of the metric ones.
inline constexpr LiftConstants kUsLift{51.0, 10.0, 25.0, 30.0, 70.0, 0.0075, 10.0, 70.0, 1.8};

/// A lift, judged at its origin or its destination. Lengths are in the unit of the constants.
struct Lift {
  double load = 0.0;         ///< mass, ≥ 0
  double horizontal = 0.25;  ///< H: hands from the middle of the ankles, ≥ 0
  double vertical = 0.75;    ///< V: hands above the floor, ≥ 0
  double travel = 0.25;      ///< D: between the heights of origin and destination, ≥ 0
  double asymmetry = 0.0;    ///< A: rad, hands from the sagittal plane, ≥ 0
  double frequency = 0.2;    ///< F: lifts a minute, ≥ 0
  LiftingTime time = LiftingTime::brief;  ///< duration of lifting
  double origin_vertical = 0.75;          ///< V at the origin, which selects the column of F
  Coupling coupling = Coupling::fair;     ///< grip
};
/// A lift by the revised NIOSH lifting equation.
struct LiftIndex {
  double horizontal = 0.0;        ///< HM
  double vertical = 0.0;          ///< VM
  double travel = 0.0;            ///< DM
  double asymmetry = 0.0;         ///< AM
  double frequency = 0.0;         ///< FM
  double coupling = 0.0;          ///< CM
  double limit = 0.0;             ///< RWL, recommended weight limit, in the constants' unit of load
  double free_limit = 0.0;        ///< FIRWL, the limit of a rare lift, whose FM is 1
  std::optional<double> index{};  ///< LI = load / RWL; empty if no load is allowed
  bool between = false;  ///< FM lies between a row and a row of 0, where the manual is silent
  std::vector<Message> notes{};  ///< why no load is allowed, and where the manual is silent
};
/// Judges a lift. Source: T. Waters, V. Putz-Anderson and A. Garg, Applications Manual for the
/// Revised NIOSH Lifting Equation, DHHS (NIOSH) 94-110, revised 2021. Fails for a number that is
/// negative or not finite.
[[nodiscard]] Result<LiftIndex> lift_index(const Lift& lift,
                                           const LiftConstants& constants = kMetricLift);

/// One of several lifts that are repeated.
struct LiftTask {
  double free_limit = 0.0;                ///< FIRWL
  double greatest = 0.0;                  ///< greatest load
  double mean = 0.0;                      ///< mean load
  double frequency = 0.2;                 ///< lifts a minute
  LiftingTime time = LiftingTime::brief;  ///< duration of lifting
  double origin_vertical = 0.75;          ///< V at the origin
};
/// One lift's part of a composite index.
struct LiftTaskIndex {
  std::size_t task = 0;     ///< index of the task
  double frequency = 0.0;   ///< FM
  double limit = 0.0;       ///< STRWL = FIRWL · FM
  double free_index = 0.0;  ///< FILI = greatest load / FIRWL
  double index = 0.0;       ///< STLI = mean load / STRWL
  double added = 0.0;       ///< what it adds to the composite index
};
/// The composite lifting index of repeated lifts.
struct CompositeIndex {
  std::optional<double> index{};       ///< CLI; empty if it is undefined
  std::vector<LiftTaskIndex> tasks{};  ///< by falling STLI, then by falling frequency
  std::vector<Message> notes{};        ///< why it is undefined
};
/// Computes the composite index; the added task's duration and height select its column. Fails for
/// a number that is negative or not finite.
[[nodiscard]] Result<CompositeIndex> composite_index(std::span<const LiftTask> tasks,
                                                     const LiftConstants& constants = kMetricLift);

/// Compression (N) at L5/S1 of the action limit. Source: NIOSH 81-122.
inline constexpr double kBackActionLimit = 3400.0;
/// Compression (N) at L5/S1 of the maximum permissible limit. Source: NIOSH 81-122.
inline constexpr double kBackPermissible = 6400.0;
/// Shear (N) at L5/S1 that is tolerated at times. Source: S. Gallagher and W. Marras, Clinical
/// Biomechanics 27 (2012).
inline constexpr double kBackShearRare = 1000.0;
/// Shear (N) at L5/S1 that is tolerated often, by the same.
inline constexpr double kBackShearOften = 700.0;
/// Lever (m) of the back's muscles in the model of one muscle; texts have 0.05 to 0.07.
inline constexpr double kBackLever = 0.05;

/// Forces at L5/S1 by one muscle that balances a moment.
struct BackForces {
  double muscle = 0.0;       ///< N, moment / lever
  double compression = 0.0;  ///< N, muscle + weight · cos(lean)
  double shear = 0.0;        ///< N, weight · sin(lean)
};
/// Computes the forces of a moment (N·m) that the muscle bears, of a weight (N) above L5/S1 and of
/// a lean (rad) of the trunk. Abdominal pressure and opposing muscles do not count.
[[nodiscard]] BackForces back_forces(double moment, double weight, double lean,
                                     double lever = kBackLever);

/// Recommended limit (N) of compression by age (years) and sex: revised Dortmund values (M. Jäger,
/// EXCLI Journal 17 (2018) 362-385) of 20 and of 60 years, linear between them, which is a guess.
[[nodiscard]] double back_limit(double age, Sex sex);

/// Facts that a motion does not tell, and thresholds that methods leave open.
struct Ergonomics {
  Coupling coupling = Coupling::good;  ///< grip on the load
  bool held = false;                   ///< a part of the body is held for more than a minute
  bool repeated = false;               ///< small-range actions recur more than 4 times a minute
  bool rapid = false;                  ///< rapid large changes of posture, or an unstable base
  bool shock = false;                  ///< forces build up rapidly
  double lifts_per_min = 0.2;          ///< recurrence of each lift of the motion
  LiftingTime lifting_time = LiftingTime::brief;  ///< duration of lifting in a shift
  bool placed_with_care = true;  ///< lifts end with control, so that both ends count
  /// Recurrence of the motion (1/min), for EN 1005-4; empty: only held postures are judged.
  std::optional<double> moves_per_min{};
  std::optional<double> age{};                      ///< years, for the limit of compression
  std::optional<Sex> sex{};                         ///< for that limit; empty: the character's
  double back_lever = kBackLever;                   ///< m, of the back's muscles about L5/S1
  RulaEdition rula_edition = RulaEdition::present;  ///< of table A
  PostureThresholds thresholds{};                   ///< where methods name none
  friend bool operator==(const Ergonomics&, const Ergonomics&) = default;
};

}  // namespace shigusa
