// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/motion_measures.hpp>
#include <shigusa/words.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The posture that a motion ends in, as a person would describe it, measured on the places of
/// joints.
struct FinalPosture {
  bool sits = false;          ///< on a seat, from where the hips cannot come down
  double knee_flexion = 0.0;  ///< rad, mean of the knees that stand
  /// 100 (1 - drop of the hips / drop of the shoulders), people's bending: below 30 a full squat,
  /// above 90 a full stoop (after S. Schmid et al., European Spine Journal 31 (2022)); none where
  /// the shoulders come down by less than a tenth of the stature
  std::optional<double> stoop_squat_index;
  double trunk_lean = 0.0;  ///< rad, of the line from hips to shoulders, forwards is > 0
  double trunk_turn = 0.0;  ///< rad, of the line of the shoulders about the vertical, left is > 0
  /// rad, of the elbow about the line from shoulder to hand: 0 hangs down, > 0 points outwards; of
  /// the first goal's arm, 0 for a hand that is no arm's or an arm that is straight
  double elbow_swivel = 0.0;
};

/// A stoop-squat index below this is called a squat; half way between squat and stoop is neither.
inline constexpr double kSquatIndex = 40.0;
/// A stoop-squat index above this is called a stoop.
inline constexpr double kStoopIndex = 80.0;

/// A word for a posture: of the style, or of what comes beside it.
enum class PostureWord {
  half_squat,      ///< between squat and stoop
  sitting,         ///< on a seat
  squat,           ///< the hips come down
  stoop,           ///< the trunk comes down
  upright,         ///< none of these
  leaning,         ///< the trunk leans forwards
  knees_bent,      ///< they give way
  straight_knees,  ///< of a stoop
  turned_left,     ///< of the shoulders' line
  turned_right,    ///< of the shoulders' line
  elbow_out,       ///< away from the body
};
/// The words of PostureWord.
template <>
inline constexpr std::array kEnumWords<PostureWord>{
    EnumWord{PostureWord::half_squat, "half squat"},
    EnumWord{PostureWord::sitting, "sitting"},
    EnumWord{PostureWord::squat, "squat"},
    EnumWord{PostureWord::stoop, "stoop"},
    EnumWord{PostureWord::upright, "upright"},
    EnumWord{PostureWord::leaning, "leaning"},
    EnumWord{PostureWord::knees_bent, "knees bent"},
    EnumWord{PostureWord::straight_knees, "straight knees"},
    EnumWord{PostureWord::turned_left, "turned left"},
    EnumWord{PostureWord::turned_right, "turned right"},
    EnumWord{PostureWord::elbow_out, "elbow out"},
};

/// The words for a posture: its style comes first.
[[nodiscard]] std::vector<PostureWord> words_for(const FinalPosture& posture);

/// "stoop, straight knees", "squat, turned left", "upright, elbow out", "sitting, leaning": the
/// words for a posture as people read them.
[[nodiscard]] std::string posture_words(const FinalPosture& posture);

/// Whether the body could make a motion.
enum class Verdict {
  possible,    ///< within what its joints, its balance and its shape allow
  strains,     ///< some people of its stature, mass and sex could
  impossible,  ///< nobody could
};
/// The words of Verdict.
template <>
inline constexpr std::array kEnumWords<Verdict>{
    EnumWord{Verdict::possible, "possible"},
    EnumWord{Verdict::strains, "strains"},
    EnumWord{Verdict::impossible, "impossible"},
};

/// The kinds of reasons that make a motion hard, or impossible.
enum class ReasonKind {
  strength,   ///< a joint needs more than it has
  pressure,   ///< the floor would have to press outside what the feet stand on
  collision,  ///< a part is in another one, an obstacle or the floor
  limit,      ///< a joint is beyond its range
};
/// The words of ReasonKind.
template <>
inline constexpr std::array kEnumWords<ReasonKind>{
    EnumWord{ReasonKind::strength, "strength"},
    EnumWord{ReasonKind::pressure, "pressure"},
    EnumWord{ReasonKind::collision, "collision"},
    EnumWord{ReasonKind::limit, "limit"},
};

/// One reason why a motion is hard.
struct Reason {
  ReasonKind kind = ReasonKind::strength;  ///< what it is about
  Verdict verdict = Verdict::strains;      ///< how hard that alone makes the motion
  /// what is asked for: a share of the joint's strength; else m outside the feet, m deep, or rad
  /// beyond the limit
  double amount = 0.0;
  std::string subject{};         ///< freedom, or capsule; empty of the pressure
  std::string other{};           ///< what the capsule is in
  double torque = 0.0;           ///< N·m, of strength: that the joint needs
  double strength = 0.0;         ///< N·m, of strength: that the joint has, in that direction
  std::optional<double> time{};  ///< s, of the worst moment; none of limits
};
/// "right_ankle.inversion needs 213 N·m at 0.61 s, 8.5 times its strength".
[[nodiscard]] std::string reason_words(const Reason& reason);

/// From where on a motion strains, and from where on it is impossible.
struct VerdictBounds {
  double strains;     ///< above this a motion strains
  double impossible;  ///< above this a motion is impossible
};
/// Share of a joint's strength. Strengths are those of an average person. A standard deviation of a
/// quarter of the mean is assumed among people of one sex, so that one in forty has 1.5 times as
/// much.
inline constexpr VerdictBounds kStrengthBounds{1.0, 1.5};
/// A robot's file tells the most that its drives give.
inline constexpr VerdictBounds kEffortBounds{1.0, 1.0};
/// How far outside the feet (m). Soles are known to a centimetre; a person who tips over the edge
/// by five for the tenth of a second that such moments last catches it by arms and hips.
inline constexpr VerdictBounds kPressureBounds{0.01, 0.05};
/// Beyond this (m) words say "far" alone: where the floor hardly presses, it would have to press at
/// any distance.
inline constexpr double kFarOutside = 1.0;
/// Depth (m). Flesh gives way, and capsules are not flesh.
inline constexpr VerdictBounds kCollisionBounds{kCollisionDepth, kFleshDepth};
/// Depth in an obstacle (m).
inline constexpr VerdictBounds kHardCollisionBounds{kCollisionDepth, kHardDepth};
/// Beyond a joint's range (rad): ranges of motion differ by 5° to 10° among people.
inline constexpr VerdictBounds kLimitBounds{radians(3.0), radians(10.0)};

/// The verdict on a motion: that of its worst reason, and all reasons, the worst first.
struct Judgement {
  Verdict verdict = Verdict::possible;  ///< of the worst reason
  std::vector<Reason> reasons;          ///< the worst first
  /// s: where the motion is impossible, and only for its haste, the least duration in which it is
  /// possible or, if none up to kSlowest times its own is, in which it strains; of a task's
  /// candidates one in which the task was searched again and something is
  std::optional<double> possible_in{};
};
/// Judges a motion by what was measured of it, without possible_in.
[[nodiscard]] Judgement judge(const BodyModel& body, const MotionMeasures& measures);

/// Judges the start posture as one that is held still: what is wrong with that, no goal is at fault
/// for.
[[nodiscard]] Judgement judge_start(const BodyModel& body);

/// A motion that is slower than this many times its duration is another motion.
inline constexpr double kSlowest = 3.0;
/// Judges a motion that is at hand, with possible_in.
[[nodiscard]] Judgement judge(const BodyModel& body, const Motion& motion,
                              const MotionMeasures& measures);

}  // namespace shigusa
