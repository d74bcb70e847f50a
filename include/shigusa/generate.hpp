// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <shigusa/criteria.hpp>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

/// Whether the candidates meet their goals.
enum class ReachStatus {
  reached,      ///< every candidate meets every goal within 1 mm and 0.5°
  unsteady,     ///< so they do, and every one that was found is impossible: see Judgement
  unreachable,  ///< the body cannot; candidates end at the closest point
};
/// The words of ReachStatus.
template <>
inline constexpr std::array kEnumWords<ReachStatus>{
    EnumWord{ReachStatus::reached, "reached"},
    EnumWord{ReachStatus::unsteady, "unsteady"},
    EnumWord{ReachStatus::unreachable, "unreachable"},
};

/// How an effector goes to its goal.
enum class PathKind {
  straight,  ///< along the minimum-jerk line
  bowed,     ///< beside that line, by bow and sway among the parameters
  detour,    ///< by way of a via point around the body
  free,      ///< as the posture takes it: no path leads there with these parameters
};
/// The words of PathKind.
template <>
inline constexpr std::array kEnumWords<PathKind>{
    EnumWord{PathKind::straight, "straight"},
    EnumWord{PathKind::bowed, "bowed"},
    EnumWord{PathKind::detour, "detour"},
    EnumWord{PathKind::free, "free"},
};

/// How a goal's effector is turned.
struct TurnResult {
  Quatd start{};    ///< R_WE in the start posture, see GoalAxis
  Quatd reached{};  ///< R_WE at the end
  /// rad, from the goal's rotation or between its axis and direction
  std::optional<double> error{};
};

/// Where a goal's effector ends.
struct GoalResult {
  Goal asked;                          ///< the task's, without a load
  std::string node;                    ///< node of the exported skeleton whose origin it is
  Vec3d reached{};                     ///< m, world
  double error = 0.0;                  ///< m, from the goal or its box
  PathKind path = PathKind::straight;  ///< how it went there
  TurnResult turn;                     ///< how it is turned
};

/// How far a heel lifts, at any frame.
struct HeelLift {
  double angle = 0.0;   ///< rad, of the toes
  double height = 0.0;  ///< m, of the hindmost place of its sole above where it stood
};

/// How well a planted foot stood.
struct ContactResult {
  std::string effector;            ///< name of the foot
  std::string node;                ///< node of the exported skeleton that moves with it
  double max_slide = 0.0;          ///< m, at any frame
  std::optional<HeelLift> heel{};  ///< of one that may lift
};

/// How one hand rests on something.
struct RestResult {
  std::string effector;    ///< name of the hand
  std::string node;        ///< node of the exported skeleton that its point is
  std::string on;          ///< what it rests on, as Support has it
  double max_slide = 0.0;  ///< m, from its place, at any frame after it has arrived
  double force = 0.0;      ///< N, the most that it presses with
};

/// How far the arms of the goals pass through the body (rule R11).
struct ArmCollision {
  double depth = 0.0;  ///< m, collision_depth of these arms, the deepest
  int searches = 0;    ///< that the arms took in all
  bool left = false;   ///< it is deeper than kCollisionDepth all the same
};

/// One motion to the goals.
struct Candidate {
  Parameters parameters;          ///< that the motion is generated from
  Motion motion;                  ///< from the start posture to the goals
  Score score;                    ///< by the task's criteria
  std::vector<GoalResult> goals;  ///< in the task's order
  /// m, largest distance from the path at any frame that follows it
  double path_error = 0.0;
  std::vector<ContactResult> contacts;          ///< of planted feet
  std::vector<RestResult> resting{};            ///< of hands that rest on something
  MotionMeasures measures;                      ///< what the motion asks of the body
  Judgement judgement;                          ///< whether the body could make the motion
  FinalPosture final_posture;                   ///< how it ends
  std::optional<ArmCollision> arm_collision{};  ///< of plans with several layers
};

/// Counts of what a search took and left out.
struct SearchLog {
  int evaluations = 0;   ///< motions scored by the search
  int runs = 1;          ///< of the preset paper: with other random numbers each, see generate
  int generations = 0;   ///< of the search, in all runs
  int rejected_nan = 0;  ///< motions that a criterion scored NaN
  int near_copies = 0;   ///< distinct genomes that move nearly as a better one
  int missed = 0;        ///< final genomes that missed a goal, left the path or moved a foot
  int collided = 0;      ///< left out as others pass through nothing, or less deep through it
  int jolting = 0;       ///< left out as others do not jolt, see Suddenness
  int strange = 0;       ///< left out as they end as nobody does who need not
  int over_limit = 0;    ///< of layers that hold limits: left out as others are within them
  /// candidates whose score in the search was off by over kReplayTolerance
  int replay_differs = 0;
  double replay_difference = 0.0;  ///< the most that a candidate's score in the search was off by
  int cells_searched = 0;          ///< of the arms' libraries, which were in no store

  /// Adds the motions that another search of the task scored.
  void spend(const SearchLog& other) {
    evaluations += other.evaluations;
    rejected_nan += other.rejected_nan;
  }
  /// Adds what another run scored, copied and missed.
  void add_run(const SearchLog& other);
};

/// The result of a search for motions.
struct GenerateResult {
  ReachStatus status = ReachStatus::reached;  ///< whether the goals are met
  double remaining_distance = 0.0;  ///< m, of the best candidate to its goals; 0 when reached
  double remaining_turn = 0.0;      ///< rad, the largest that is left of a goal's turn; the same
  /// At least one: the possible ones first, then the impossible ones; by the preset flat, of both
  /// those first that pass through nothing; each by score, the lowest first.
  std::vector<Candidate> candidates;
  Message fewer;       ///< why there are fewer than asked for; else empty
  Message conflict{};  ///< which goals are in one another's way, out of reach; else empty
  std::shared_ptr<const ParameterList> parameters{};  ///< what the candidates' values are of
  double duration = 0.0;                              ///< s
  /// The task gives no duration, and nothing that was found is possible in the usual one: this is
  /// one in which something is. See played_task.
  bool slowed = false;
  /// The task gives no duration, and in the usual one the first candidate jolts (see Suddenness) or
  /// strains: this is a longer one in which it does not, for a strain by 1.3 times at the most. See
  /// played_task.
  bool gentled = false;
  SearchLog log{};                       ///< what it took, and what was left out
  std::optional<Parameters> best_seen;   ///< the best of all genomes evaluated, kept or not
  double best_seen_score = 0.0;          ///< of that genome
  SearchEnd end = SearchEnd::converged;  ///< why the search ended

  /// Whether the candidates end at their goals.
  [[nodiscard]] bool meets_goals() const { return status != ReachStatus::unreachable; }
};

/// The task that plays a search's motions again: with the duration that it came to.
[[nodiscard]] Task played_task(Task task, const GenerateResult& generation);

/// Two motions whose joint angles never differ by more than this, root mean square over the dofs,
/// are one candidate (rad).
inline constexpr double kDistinctPosture = radians(5.0);
/// Presets other than the paper's tell candidates apart by how they end: root mean square (rad).
inline constexpr double kDistinctEnd = radians(10.0);
/// Where fewer than asked for differ by kDistinctEnd, this is enough (rad): an arm's own pose, an
/// elbow held higher.
inline constexpr double kNearEnd = radians(5.0);
/// A replay in double may bring two ends nearer by this (rad).
inline constexpr double kEndSlack = radians(0.1);
/// Candidates score at most this much worse than the best …
inline constexpr double kCandidateSpread = 0.6;
/// … but for those that make up this number of motions which could be made: people see as many
/// whatever they score.
inline constexpr int kShownLeast = 3;
/// Where the best bends down, one that is the best of its style may be worse by this: people squat
/// although it costs more, and stoop although few do.
inline constexpr double kStyleSpread = 1.5;
/// Searches score in single precision; every candidate is played again in double and scored anew.
/// Scores may differ by this without being counted: feasibility and jolts take the worst moment of
/// accelerations, which single precision puts off by some 2e-3 rad/s².
inline constexpr double kReplayTolerance = 0.05;
/// How near (m) a candidate must come to the closest point where the goal is out of reach.
inline constexpr double kEdgeTolerance = 5e-3;

/// All that a task means for its body.
struct Problem;

/// A task that was checked and made a problem once, to be searched or played.
class PreparedTask {
 public:
  /// Fails as generate would, at once.
  [[nodiscard]] static Result<PreparedTask> of(const Task& task);

  /// The task with its goals' loads in the body's hands, whose body stands on its contacts.
  [[nodiscard]] const Task& task() const;
  [[nodiscard]] const Problem& problem() const { return *problem_; }  ///< what was made of it

 private:
  explicit PreparedTask(std::shared_ptr<const Problem> problem) : problem_(std::move(problem)) {}
  std::shared_ptr<const Problem> problem_;
};

/// Finds natural motions for a task: the distinct genomes that the search ends with, ranked
/// (paper, sections 3.2 and 4). Fails where PreparedTask::of does; an unreachable
/// goal is a status. When cancelled, returns the best so far. Same task, same result. An
/// exception of a user's own criterion or search passes through.
///
/// Where nothing that was found is possible, the presets flat and human search again: in the least
/// duration in which one of the motions is, where the task gives none, then for three times as many
/// motions, and at last by other random numbers, where the task does not say how many. Times that
/// are told to be enough (Judgement::possible_in) are ones in which the task was searched again.
///
/// The preset paper runs again with other random numbers, while fewer than three candidates are
/// distinct, up to Task::most_runs in all, where the task does not say how many motions are scored.
///
/// The preset layers searches as the paper's section 3.4 has it: the genes of the upper layer
/// alone, in the paper's code (paper_ga, annealing, random) or in one even in the weights'
/// logarithms, while arms come from their libraries. Motions are those of the whole body and scored
/// by the task's criteria. The preset human does so with the best of a few swivels for each upper
/// motion; the upper motions that are kept are given the best swivel of all, then the best final
/// angles of free arms.
[[nodiscard]] Result<GenerateResult> generate(const Task& task, const Progress& progress = {});
/// The same for a task that is prepared.
[[nodiscard]] Result<GenerateResult> generate(const PreparedTask& task,
                                              const Progress& progress = {});
/// The results of generate for many tasks, in their order, several at once: on `threads` threads in
/// all (0: one for each core), whatever Task::batch says of threads. They are the same for any
/// number of threads, and a task that is wrong fails alone. Progress is of all tasks together; it
/// is told while the calling thread has one. When cancelled, tasks that have begun give the best so
/// far, and the others fail with ErrorCode::cancelled.
[[nodiscard]] std::vector<Result<GenerateResult>> generate_all(std::span<const Task> tasks,
                                                               int threads = 0,
                                                               const Progress& progress = {});

/// Makes motions of one task from given values of the plan's parameters, without a
/// search: the parameter editor (paper, section 4.2 and figure 7). Work that depends on the task
/// alone is done once: the posture that is known to arrive, and the ways around the body. A motion
/// is the same, whatever was played before it.
class MotionPlayer {
 public:
  /// Fails on a task that is wrong.
  [[nodiscard]] static Result<MotionPlayer> of(Task task);
  MotionPlayer(MotionPlayer&&) noexcept;             ///< takes over all of the other's
  MotionPlayer& operator=(MotionPlayer&&) noexcept;  ///< takes over all of the other's
  ~MotionPlayer();

  [[nodiscard]] const Task& task() const;                 ///< as it was given
  [[nodiscard]] const ParameterList& parameters() const;  ///< of the task's plan
  /// The hand still meets its goal, or comes as near as the given locks allow; the status tells.
  /// Fails where ParameterList::check does.
  [[nodiscard]] Result<GenerateResult> play(const Parameters& parameters);

 private:
  struct Made;
  explicit MotionPlayer(std::unique_ptr<Made> made);
  std::unique_ptr<Made> made_;
};

/// One motion of a MotionPlayer of the task.
[[nodiscard]] Result<GenerateResult> regenerate(const Task& task, const Parameters& parameters);

}  // namespace shigusa
