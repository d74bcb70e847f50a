// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <shigusa/message.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/progress.hpp>
#include <shigusa/result.hpp>
#include <shigusa/task.hpp>
#include <shigusa/verdict.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace shigusa {

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
