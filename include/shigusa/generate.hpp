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

/// Descriptive measures of a motion's final posture, computed from joint positions.
struct FinalPosture {
  bool sits = false;          ///< sits on a seat, where the hips cannot go down
  double knee_flexion = 0.0;  ///< rad, mean flexion of the standing legs' knees
  /// 100 (1 - drop of the hips / drop of the shoulders). In people, values below 30 are a full
  /// squat and above 90 a full stoop (after S. Schmid et al., European Spine Journal 31 (2022)).
  /// Empty if the shoulders go down by less than a tenth of the stature, or no hand to the knees.
  std::optional<double> stoop_squat_index;
  double trunk_lean = 0.0;  ///< rad, lean of the line from hips to shoulders, > 0 forwards
  /// rad, turn of the line of the shoulders about the vertical, > 0 to the left.
  double trunk_turn = 0.0;
  /// Swivel (rad) of the elbow about the line from shoulder to hand: 0 hanging down, > 0 outwards.
  /// It is that of the first goal's arm; 0 for other effectors and for a straight arm.
  double elbow_swivel = 0.0;
};

/// Stoop-squat index below which a posture is called a squat; values up to kStoopIndex are a half
/// squat.
inline constexpr double kSquatIndex = 40.0;
/// Stoop-squat index above which a posture is called a stoop.
inline constexpr double kStoopIndex = 80.0;

/// A word for a posture: its style, or an addition to it.
enum class PostureWord {
  half_squat,      ///< between squat and stoop
  sitting,         ///< on a seat
  squat,           ///< the hips go down
  stoop,           ///< the trunk bends down
  upright,         ///< none of these
  leaning,         ///< the trunk leans forwards
  knees_bent,      ///< the knees are bent
  straight_knees,  ///< straight knees in a stoop
  turned_left,     ///< turn of the shoulders' line
  turned_right,    ///< turn of the shoulders' line
  elbow_out,       ///< elbow away from the body
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

/// The words that describe a posture, its style first.
[[nodiscard]] std::vector<PostureWord> words_for(const FinalPosture& posture);

/// The words that describe a posture as text: "stoop, straight knees", "squat, turned left",
/// "upright, elbow out", "sitting, leaning".
[[nodiscard]] std::string posture_words(const FinalPosture& posture);

/// The feasibility of a motion for the body.
enum class Verdict {
  possible,    ///< within the limits of joints, strength, balance and shape
  strains,     ///< feasible for some people of this stature, mass and sex
  impossible,  ///< feasible for no one
};
/// The words of Verdict.
template <>
inline constexpr std::array kEnumWords<Verdict>{
    EnumWord{Verdict::possible, "possible"},
    EnumWord{Verdict::strains, "strains"},
    EnumWord{Verdict::impossible, "impossible"},
};

/// The kinds of reasons why a motion is hard or impossible.
enum class ReasonKind {
  strength,   ///< a joint needs more torque than its strength
  pressure,   ///< the centre of pressure lies outside the support polygon
  collision,  ///< a body part is inside another, an obstacle or the floor
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

/// One reason why a motion is hard or impossible.
struct Reason {
  ReasonKind kind = ReasonKind::strength;  ///< kind of the reason
  Verdict verdict = Verdict::strains;      ///< verdict from this reason alone
  /// Measure of the reason, by kind: torque as a share of the strength; m outside the support
  /// polygon; m of collision depth; rad beyond the limit.
  double amount = 0.0;
  std::string subject{};         ///< name of the dof or capsule; empty for pressure
  std::string other{};           ///< capsule, obstacle or "floor" that the capsule is in
  double torque = 0.0;           ///< N·m, for strength: the torque needed
  double strength = 0.0;         ///< N·m, for strength: the strength in that direction
  std::optional<double> time{};  ///< s, time of the worst moment; empty for limits
};
/// A reason in words: "right_ankle.inversion needs 213 N·m at 0.61 s, 8.5 times its strength".
[[nodiscard]] std::string reason_words(const Reason& reason);

/// The bounds of a measure for the verdicts.
struct VerdictBounds {
  double strains;     ///< above this a motion strains
  double impossible;  ///< above this a motion is impossible
};
/// Bounds of the torque as a share of a joint's strength. Strengths are those of an average person;
/// a standard deviation of a quarter of the mean is assumed within one sex, so that one person in
/// forty has 1.5 times as much. The first bound leaves a margin above 1, where the criterion
/// feasibility begins: searches end at that border, to either side of it.
inline constexpr VerdictBounds kStrengthBounds{1.02, 1.5};
/// Bounds of the torque as a share of a robot's effort limit, which its file states exactly.
inline constexpr VerdictBounds kEffortBounds{1.0, 1.0};
/// Bounds of the distance of the centre of pressure outside the support polygon (m). Soles are
/// known to a centimetre; a person who tips by 5 cm for the tenth of a second that such moments
/// last recovers by arms and hips.
inline constexpr VerdictBounds kPressureBounds{0.01, 0.05};
/// Distance outside the support polygon (m) from which texts say "far" only: with little force on
/// the floor the distance is arbitrarily large.
inline constexpr double kFarOutside = 1.0;
/// Bounds of the collision depth between body parts (m), which allow for soft tissue and for the
/// capsules' coarse shape.
inline constexpr VerdictBounds kCollisionBounds{kCollisionDepth, kFleshDepth};
/// Bounds of the collision depth in an obstacle (m).
inline constexpr VerdictBounds kHardCollisionBounds{kCollisionDepth, kHardDepth};
/// Bounds of the excess beyond a joint limit (rad): ranges of motion differ by 5° to 10° among
/// people.
inline constexpr VerdictBounds kLimitBounds{radians(3.0), radians(10.0)};

/// The verdict on a motion: that of its worst reason, and all reasons, the worst first.
struct Judgement {
  Verdict verdict = Verdict::possible;  ///< verdict of the worst reason
  std::vector<Reason> reasons;          ///< all reasons, the worst first
  /// For a motion that is impossible only because of its speed: the shortest duration (s), up to
  /// kSlowest times its own, in which it is possible, else in which it strains. For a task's
  /// candidates, a duration in which the task was searched again and a motion is feasible.
  std::optional<double> possible_in{};
};
/// Judges a motion by its measures, without possible_in.
[[nodiscard]] Judgement judge(const BodyModel& body, const MotionMeasures& measures);

/// Judges the state in which a motion begins, held still; its reasons are independent of any goal.
[[nodiscard]] Judgement judge_start(const BodyModel& body, const State& start);

/// Largest factor by which a motion is slowed down to find possible_in.
inline constexpr double kSlowest = 3.0;
/// Judges a motion, with possible_in.
[[nodiscard]] Judgement judge(const BodyModel& body, const Motion& motion,
                              const MotionMeasures& measures);

/// Whether the candidates meet their goals.
enum class ReachStatus {
  reached,      ///< every candidate meets every goal to 1 mm and 0.5°
  unsteady,     ///< reached, but every motion found is impossible: see Judgement
  unreachable,  ///< goals out of reach; candidates end at the closest point
};
/// The words of ReachStatus.
template <>
inline constexpr std::array kEnumWords<ReachStatus>{
    EnumWord{ReachStatus::reached, "reached"},
    EnumWord{ReachStatus::unsteady, "unsteady"},
    EnumWord{ReachStatus::unreachable, "unreachable"},
};

/// The kind of an effector's path to its goal.
enum class PathKind {
  straight,  ///< along the minimum-jerk line
  bowed,     ///< off that line, by the parameters bow and sway
  detour,    ///< by a via point around the body
  free,      ///< no prescribed path: the motion of the posture leads there
};
/// The words of PathKind.
template <>
inline constexpr std::array kEnumWords<PathKind>{
    EnumWord{PathKind::straight, "straight"},
    EnumWord{PathKind::bowed, "bowed"},
    EnumWord{PathKind::detour, "detour"},
    EnumWord{PathKind::free, "free"},
};

/// The orientation of a goal's effector.
struct TurnResult {
  Quatd start{};    ///< R_WE in the start posture; for the frame E see GoalAxis
  Quatd reached{};  ///< R_WE at the end of the motion
  /// Error (rad) from the goal's rotation, or between its axis and direction; empty for other
  /// goals.
  std::optional<double> error{};
};

/// The final state of a goal's effector.
struct GoalResult {
  Goal asked;                          ///< the task's goal, without its load
  std::string node;                    ///< exported skeleton's node with its origin at the effector
  Vec3d reached{};                     ///< m, world: final position
  double error = 0.0;                  ///< m, distance from the goal or its tolerance box
  PathKind path = PathKind::straight;  ///< kind of the path
  TurnResult turn;                     ///< orientation
};

/// The largest lift of a heel over all frames.
struct HeelLift {
  double angle = 0.0;   ///< rad, bend of the toes
  double height = 0.0;  ///< m, rise of the sole's rearmost point
};

/// The slide and heel lift of a planted foot.
struct ContactResult {
  std::string effector;            ///< name of the foot
  std::string node;                ///< node of the exported skeleton that moves with it
  double max_slide = 0.0;          ///< m, largest slide over all frames
  std::optional<HeelLift> heel{};  ///< empty unless the heel may lift
};

/// The contact of a resting hand.
struct RestResult {
  std::string effector;    ///< name of the hand
  std::string node;        ///< exported skeleton's node at the hand's point
  std::string on;          ///< place of the contact, see Support::on
  double max_slide = 0.0;  ///< m, largest distance from its place after arrival
  double force = 0.0;      ///< N, largest force
};

/// The collision of the goals' arms with the body (rule R11).
struct ArmCollision {
  double depth = 0.0;  ///< m, greatest depth of these arms in the body
  int searches = 0;    ///< searches of the arms in total
  bool left = false;   ///< the depth still exceeds kCollisionDepth
};

/// The pose of a thing at the end of the action that put it there.
struct PlacedThing {
  std::string name;         ///< name of the thing
  Vec3d position{};         ///< m, world: its middle
  Quatd turn{};             ///< R_WT
  double error = 0.0;       ///< m, from the place that was asked for
  double turn_error = 0.0;  ///< rad, from the turn that was asked for
};

/// One of the actions of a motion.
struct ActionResult {
  ActionKind kind = ActionKind::goals;  ///< kind of the action
  double start = 0.0;                   ///< s
  double end = 0.0;                     ///< s, when it is done and its hold is over
  std::vector<GoalResult> goals{};      ///< final states of its effectors
  std::optional<PlacedThing> placed{};  ///< of place: the thing where it was put
  Score score{};                        ///< mean over time of its motions
  Judgement judgement{};                ///< feasibility
};

/// One of the motions of a piece of work, by which it is made again.
struct WorkMotion {
  std::size_t action = 0;  ///< index of the action
  int way = 0;             ///< which of the ways to take a thing
  double duration = 0.0;   ///< s
  Parameters values;       ///< parameters that generate it
  int approach = -1;       ///< number of the approach to its goals (Candidate); -1: chosen anew
};

/// A hand's way to a goal or a thing, and its time there, by which its fingers move.
struct HandUse {
  std::string effector{};       ///< name of the hand
  std::string thing{};          ///< name of the thing that it holds; empty: it goes to a goal
  double start = 0.0;           ///< s, when it leaves
  double there = 0.0;           ///< s, when it is there, or holds the thing
  std::optional<double> end{};  ///< s, when it lets the thing go; empty: not in this motion
  /// Flexion of the fingers at the end of the way, relative to that of a relaxed hand: about a
  /// thing as far as they go until they touch it.
  double flexion = 1.0;
};

/// The way of a thing, with its poses in the frames of the motion.
struct ThingMotion {
  Thing thing;                      ///< the thing, as the task has it
  std::vector<Transformd> poses{};  ///< (frames) X_WT
};

/// One generated motion.
struct Candidate {
  Parameters parameters;          ///< parameters that generate the motion
  Motion motion;                  ///< from the start posture to the goals
  Score score;                    ///< by the task's criteria
  std::vector<GoalResult> goals;  ///< final states, in the order of the task's goals
  /// Largest distance (m) of an effector from its prescribed path.
  double path_error = 0.0;
  std::vector<ContactResult> contacts;          ///< one for each planted foot
  std::vector<RestResult> resting{};            ///< one for each resting hand
  MotionMeasures measures;                      ///< demands on the body
  Judgement judgement;                          ///< feasibility
  FinalPosture final_posture;                   ///< description of the final posture
  std::optional<ArmCollision> arm_collision{};  ///< only for presets with layers
  int approach = -1;  ///< number of the approach to the goals, of several; -1: of a preset with one
  std::vector<ActionResult> actions{};  ///< of a task with actions: each of them, in their order
  std::vector<WorkMotion> motions{};    ///< of a task with actions: motions, in their order
  std::vector<ThingMotion> things{};    ///< of a task with things: their ways
  std::vector<HandUse> hands{};         ///< of a task with actions: ways of each hand, in order
};

/// Resamples a candidate's motion to a rate (Hz), as its files hold it: between the motion's
/// frames, too, planted feet stay and effectors keep to their paths.
[[nodiscard]] Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate);
/// The ways of a candidate's things at that rate, in the frames of motion_at. Things without poses
/// are left out.
[[nodiscard]] std::vector<ThingMotion> things_at(const Candidate& candidate, double rate);
/// Pose of a thing at a frame of its motion, 0 to the last; in between by a straight line and one
/// turn.
[[nodiscard]] Transformd pose_at(const ThingMotion& way, double frame);

/// Counters of a search: effort, and motions left out by reason.
struct SearchLog {
  int evaluations = 0;   ///< motions scored by the search
  int runs = 1;          ///< runs of the preset paper, each with other random numbers; see generate
  int generations = 0;   ///< generations in all runs
  int rejected_nan = 0;  ///< motions with a NaN penalty
  int near_copies = 0;   ///< distinct genomes whose motion nearly equals a better one
  int missed = 0;        ///< final genomes that missed a goal, left the path or moved a foot
  int collided = 0;      ///< left out for collisions, as others have none or shallower ones
  int jolting = 0;       ///< left out for jolts, as others have none; see Suddenness
  int strange = 0;       ///< left out for an unnatural final posture
  int over_limit = 0;    ///< left out for exceeding joint limits, as others do not
  /// Candidates that score worse in the replay than in the search by more than kReplayTolerance.
  int replay_differs = 0;
  double replay_difference = 0.0;  ///< largest excess of a replay's score over the search's
  int cells_searched = 0;          ///< limb library cells searched, as no store had them

  /// Adds the evaluations of another search of the task.
  void spend(const SearchLog& other) {
    evaluations += other.evaluations;
    rejected_nan += other.rejected_nan;
  }
  /// Adds the counters of another run.
  void add_run(const SearchLog& other);
};

/// The result of a search for motions.
struct GenerateResult {
  ReachStatus status = ReachStatus::reached;  ///< whether the goals are met
  /// m, distance of the best candidate from its goals; 0 if reached.
  double remaining_distance = 0.0;
  /// rad, largest orientation error of the best candidate; 0 if reached.
  double remaining_turn = 0.0;
  /// At least one candidate. Feasible ones come before impossible ones; with the preset flat
  /// collision-free ones come first within each group; then by ascending score.
  std::vector<Candidate> candidates;
  Message fewer;       ///< reason for fewer candidates than requested; else empty
  Message conflict{};  ///< goals that conflict with each other, if out of reach; else empty
  /// List of the parameters in Candidate::parameters.
  std::shared_ptr<const ParameterList> parameters{};
  double duration = 0.0;  ///< s, duration of the motions
  /// Whether the duration was lengthened because no motion in the usual duration was possible, or a
  /// rise from a bent start strained; only for tasks without a duration. See played_task.
  bool slowed = false;
  /// Whether the duration was lengthened because the first candidate in the usual duration jolts
  /// (see Suddenness) or strains (then by a factor of 1.3 at most); only for tasks without a
  /// duration. See played_task.
  bool gentled = false;
  SearchLog log{};  ///< counters of the search
  /// Parameters of the best genome evaluated, delivered or not; none if the task asks for one
  /// candidate.
  std::optional<Parameters> best_seen;
  double best_seen_score = 0.0;          ///< score of best_seen
  SearchEnd end = SearchEnd::converged;  ///< why the search ended

  /// Whether the candidates meet their goals.
  [[nodiscard]] bool meets_goals() const { return status != ReachStatus::unreachable; }
};

/// The task with the duration of the generated motions, for playing them again.
[[nodiscard]] Task played_task(Task task, const GenerateResult& generation);

/// The internal form of a prepared task; opaque.
struct Problem;

/// A checked task with its precomputed data, for several searches or players. Immutable: threads
/// may share it.
class PreparedTask {
 public:
  /// Checks and prepares a task; fails as generate does.
  [[nodiscard]] static Result<PreparedTask> of(const Task& task);

  /// The task, with the goals' loads in the body's hands and the body on its contacts.
  [[nodiscard]] const Task& task() const;
  [[nodiscard]] const Problem& problem() const { return *problem_; }  ///< internal form

 private:
  explicit PreparedTask(std::shared_ptr<const Problem> problem) : problem_(std::move(problem)) {}
  std::shared_ptr<const Problem> problem_;
};

/// Searches natural motions for a task: the distinct genomes at the end of the search, ranked
/// (paper, sections 3.2 and 4). Fails where PreparedTask::of does; an unreachable goal is a status,
/// not an error. If cancelled, returns the best so far. Same task, same result. Exceptions of
/// user-defined criteria and searches are passed on.
///
/// If no motion found is possible, the presets flat and human search again: for a task without a
/// duration, in the shortest duration in which one of the motions is possible; then with three
/// times the evaluations, then with other random numbers, unless the task sets the evaluations.
/// Each Judgement::possible_in is a duration in which the task was searched again.
///
/// The preset paper is run again with other random numbers while fewer than three candidates are
/// distinct, up to Task::most_runs runs, unless the task sets the evaluations.
///
/// The preset layers follows the paper's section 3.4: only the genes of the upper layer are
/// searched, in the paper's code (paper_ga, annealing, random) or uniformly in the logarithm of the
/// weights; arms come from limb libraries. Whole-body motions are scored by the task's criteria.
/// The preset human scores each upper motion with the best of a few swivels; the upper motions kept
/// then get the best swivel of all, then the best final angles of idle arms.
[[nodiscard]] Result<GenerateResult> generate(const Task& task, const Progress& progress = {});
/// Searches natural motions for a prepared task.
[[nodiscard]] Result<GenerateResult> generate(const PreparedTask& task,
                                              const Progress& progress = {});
/// Searches natural motions for a task with actions: each begins in the state in which the one
/// before ends. The first motion is searched for several candidates, and each of them goes on in
/// its own way: candidates are whole pieces of work. A piece of one action of goals is the motion
/// of generate(). Where an action fails, the candidates hold what came before it, the status is
/// unreachable, and GenerateResult::conflict says why. Fails on things and actions that are wrong
/// in themselves or in their order, with the place "actions[2]". Of the preset flat.
[[nodiscard]] Result<GenerateResult> perform(const Task& task, const Progress& progress = {});
/// Makes a piece of work again from its motions (Candidate::motions), after some of them have been
/// changed: each begins where the one before now ends. Actions without motions are searched.
[[nodiscard]] Result<GenerateResult> perform_again(const Task& task,
                                                   std::span<const WorkMotion> motions,
                                                   const Progress& progress = {});

/// Generates for many tasks in parallel, on `threads` threads in all (0: one for each core; threads
/// of Task::batch are ignored). Returns (tasks) results in the order of the tasks, equal to those
/// of generate() for any number of threads; an invalid task fails alone. Progress covers all tasks
/// and is reported from the calling thread. When cancelled, tasks that have begun return their best
/// so far, and the others fail with ErrorCode::cancelled.
[[nodiscard]] std::vector<Result<GenerateResult>> generate_all(std::span<const Task> tasks,
                                                               int threads = 0,
                                                               const Progress& progress = {});

/// Generates motions of one task from given parameter values, without a search: the parameter
/// editor (paper, section 4.2 and figure 7). Work that depends only on the task is done once. A
/// motion does not depend on the motions played before. One thread at a time may use a player.
class MotionPlayer {
 public:
  /// Prepares a task; fails as PreparedTask::of does. `approach`: see WorkMotion.
  [[nodiscard]] static Result<MotionPlayer> of(Task task, int approach = -1);
  MotionPlayer(MotionPlayer&&) noexcept;             ///< moves the player
  MotionPlayer& operator=(MotionPlayer&&) noexcept;  ///< moves the player
  ~MotionPlayer();

  [[nodiscard]] const Task& task() const;                 ///< the task as given
  [[nodiscard]] const BodyModel& body() const;            ///< its body, with the goals' loads
  [[nodiscard]] const ParameterList& parameters() const;  ///< parameters of the task's motions
  /// Generates the motion. Effectors meet their goals, or come as near as the locked dofs allow:
  /// see GenerateResult::status. Fails where ParameterList::check does.
  [[nodiscard]] Result<GenerateResult> play(const Parameters& parameters);

 private:
  struct Made;
  explicit MotionPlayer(std::unique_ptr<Made> made);
  std::unique_ptr<Made> made_;
};

/// Generates one motion of a task from parameter values, by a MotionPlayer.
[[nodiscard]] Result<GenerateResult> regenerate(const Task& task, const Parameters& parameters);

}  // namespace shigusa
