// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/cost.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

struct FinishedRun;

/// Cutoff frequency (Hz) of the smoothing of recorded angles: people's motion is slower, and faster
/// changes are noise that second differences amplify (D. A. Winter, Biomechanics and Motor Control
/// of Human Movement).
inline constexpr double kMotionCutoff = 6.0;
/// Displacement (m) of a recorded foot beyond which it does not count as planted.
inline constexpr double kFootSteps = 0.03;
/// Mean distance (m) of the body's joints from the recorded ones beyond which the fit counts as
/// poor.
inline constexpr double kFollowsBadly = 0.03;

/// Settings for scoring a recorded motion.
struct ScoreSettings {
  CriteriaSettings criteria = default_criteria();  ///< criteria mixture
  int first = 0;                                   ///< first frame of the file to score
  std::optional<int> last{};  ///< last frame to score, included; empty: the file's last
  /// Cutoff of the smoothing, Hz; 0: no smoothing.
  double cutoff = kMotionCutoff;
  /// Facts that the motion does not tell, for its cost to the body; empty: no cost is computed.
  std::optional<Ergonomics> ergonomics{};
};

/// A request to score a clip, in JSON: {"criteria": "default", "first": 0, "last": 80,
/// "smoothed_hz": 6, "animation": "Take 1", "cost": true, "ergonomics": …, "character": …}; every
/// key is optional.
struct ClipRequest {
  ScoreSettings settings{};  ///< settings of the scoring
  std::string animation{};   ///< name or index of the animation in the file; empty: the first
  std::optional<CharacterSpec> character{};  ///< body for the clip; empty: the clip's own person
};
/// Parses a ClipRequest; `name` stands for the text in errors.
[[nodiscard]] Result<ClipRequest> parse_clip_request(std::string_view text, std::string_view name);

/// The score and measures of a recorded clip on a body.
struct ClipScore {
  Score score;                       ///< score by the criteria of the settings
  Motion motion;                     ///< the scored frames, smoothed, without effectors
  ClipFit fit;                       ///< the fit before smoothing, with the frames around
  MotionMeasures measures;           ///< demands on the body
  FinalPosture final_posture;        ///< description of the final posture
  std::vector<Message> doubts;       ///< warnings about the reliability of the score
  std::optional<MotionCost> cost{};  ///< cost to the body, if asked for
};

/// The relation of a skeleton to a body; opaque.
struct Rig;

/// The time of one of a motion's actions.
struct ActionTime {
  double start = 0.0;  ///< s, from the file's first frame
  double end = 0.0;    ///< s
};

/// A motion file and the body that follows it.
struct RecordedMotion : PosedBody {
  SkeletonMotion motion;  ///< motion as in the file
  /// Relation of the file's nodes to the body; set by read_recorded and parse_recorded.
  std::shared_ptr<const Rig> rig;
  std::vector<ActionTime> actions{};  ///< times of its actions; empty: the file tells none
};

/// Reads a clip: .bvh, or an animation of a .glb, .gltf, .vrm or .vrma file, sampled at 60 Hz,
/// chosen by name or index, by default the first. If character.source is the clip's path, the body
/// is the clip's person as measured in the frame character.frame; else it is the given character,
/// and the clip is scaled to its stature by the clip's person in the frame `first`. Robots are
/// refused, as their joints do not match a person's.
[[nodiscard]] Result<RecordedMotion> read_recorded(const std::filesystem::path& clip,
                                                   CharacterSpec character, int first,
                                                   const std::string& animation = {});

/// Reads a clip from memory; the ending of `name` gives the format. If character.source equals
/// `name`, the body is the clip's person.
[[nodiscard]] Result<RecordedMotion> parse_recorded(std::string_view bytes, const std::string& name,
                                                    CharacterSpec character, int first,
                                                    const std::string& animation = {});

/// A part of a clip.
struct FrameRange {
  int first = 0;              ///< first frame
  std::optional<int> last{};  ///< last frame, included; empty: the clip's last
};

/// A habit that was measured, and in how many reaches.
struct LearnedHabit {
  Habit habit{};    ///< medians over the reaches
  int reaches = 0;  ///< reaches down that were measured
};
/// Measures a person's habit in a recorded motion, in the lowest posture of each reach down, where
/// the trunk leans by more than 30°, in the given parts of the clip, or in all of it. A number that
/// no reach shows, such as a free arm's, is the default one. Fails if nobody reaches down.
[[nodiscard]] Result<LearnedHabit> learn_habit(const RecordedMotion& recorded,
                                               std::span<const FrameRange> ranges = {});

/// Scores the selected frames by the same criteria as generated motions. Speeds and accelerations
/// use the frames around them; beyond the ends of the file the motion is extrapolated. Fails if a
/// frame does not exist, or a criterion's setting is out of range.
[[nodiscard]] Result<ClipScore> score_clip(const RecordedMotion& recorded,
                                           const ScoreSettings& settings = {});

/// A hand at the thing that it takes.
struct HandAtThing {
  std::string effector{};  ///< name of the hand
  double distance = 0.0;   ///< m, of the hand's point from the thing's surface
};

/// One action of a recorded piece of work.
struct ActionScore {
  ActionResult result{};             ///< times, what was reached, score and judgement
  std::vector<HandAtThing> hands{};  ///< of a grasp: the hands that take the thing
  std::optional<double> taken{};     ///< s, of a grasp: when the hands hold the thing
};

/// The score of a recorded clip as a piece of work.
struct WorkScore {
  std::vector<ActionScore> actions;  ///< in the order of the task
  Score score;                       ///< mean over time
  Judgement judgement;               ///< of all actions
  ClipFit fit;                       ///< the fit before smoothing
  std::vector<Message> doubts;       ///< warnings about the reliability of the score
  std::optional<MotionCost> cost{};  ///< cost to the body of all actions, if asked for
};

/// Scores a clip of the actions of a task: each in its time, by the criteria, and what it reached.
/// Things stand where the task has them, and follow the hands that take them until these let go;
/// their masses count meanwhile. Times that the file does not tell are found from the motion: hands
/// are slow at a thing or its place, effectors are at their goals. Fails as score_clip does, and
/// where actions are wrong in themselves.
[[nodiscard]] Result<WorkScore> score_work(const RecordedMotion& recorded, const Task& task,
                                           const ScoreSettings& settings = {});

/// Computes what a candidate of a task costs the body, with the loads in its hands; lifts are those
/// of the things that its actions take and put down.
[[nodiscard]] Result<MotionCost> candidate_cost(const Task& task, const Candidate& candidate,
                                                const Ergonomics& ergonomics);

/// A motion of given angles as a result of one candidate, which can be measured and written as any
/// other: torques, score, verdict, series. The task gives the body, the criteria and obstacles. The
/// base foot stands, and the body is at rest before and after. There are no goals, and the
/// parameters are not those of the motion, which cannot be played again. Fails on fewer than 2
/// frames, another number of degrees of freedom, and angles that are no numbers.
[[nodiscard]] Result<GenerateResult> given_motion(const Task& task, Clip clip);

/// Centres of pressure of a candidate that is at rest before and after, with the loads in its hands
/// and on the feet that stand: (frames) m, on the floor; see centres_of_pressure of a body.
[[nodiscard]] std::vector<Vec3d> centres_of_pressure(const Task& task, const Candidate& candidate);
/// Balance margins of the same: (frames), see support_frames of a body.
[[nodiscard]] std::vector<SupportFrame> support_frames(const Task& task,
                                                       const Candidate& candidate);

/// The costs of a run's candidates that its result tells, in their order: of a task that asks for
/// them (Request::cost) and of one with actions; else empty. Fails as candidate_cost does.
[[nodiscard]] Result<std::vector<MotionCost>> candidate_costs(const FinishedRun& run);
/// The ergonomics of a request, of a person of that sex if it names none.
[[nodiscard]] Ergonomics ergonomics_of(const Request& request, Sex sex);

/// Formats the score of a piece of work as JSON, as printed by `shigusa score --json`.
[[nodiscard]] std::string format_work_score(const std::string& clip, const RecordedMotion& recorded,
                                            const ScoreSettings& settings, const WorkScore& score);

/// Formats the score as JSON, as printed by `shigusa score --json`; the names in `criteria` are
/// those of summary.json.
[[nodiscard]] std::string format_clip_score(const std::string& clip, const RecordedMotion& recorded,
                                            const ScoreSettings& settings, const ClipScore& score);

}  // namespace shigusa
