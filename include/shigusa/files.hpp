// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/cost.hpp>
#include <shigusa/error.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// Newest version of the task format: tasks of actions. Tasks of goals are written as version 1.
inline constexpr int kTaskVersion = 2;
/// Size limit of a task file (bytes); a larger file is refused.
inline constexpr std::size_t kTaskMaxBytes = std::size_t{1} << 20;

/// A task as stored in its JSON file (schema: docs/task.schema.json).
struct TaskFile : Request {
  CharacterSpec character{};  ///< the moving character
};

/// Parses the value of "character" in a task: a JSON object, or a JSON text that is the source
/// alone. `name` stands for the text in errors.
[[nodiscard]] Result<CharacterSpec> parse_character_spec(std::string_view text,
                                                         std::string_view name);

/// Parses a task. Errors state the place ("task.json: goals[0].position_m"), the value seen and the
/// values allowed; for a misspelt key they suggest the nearest one.
[[nodiscard]] Result<TaskFile> parse_task(std::string_view text, std::string_view name);
/// Reads a task file.
[[nodiscard]] Result<TaskFile> read_task(const std::filesystem::path& path);

/// Formats a task as JSON. parse_task gives the same task again, bit for bit, except names that are
/// not UTF-8 and fields that a built-in body does not use.
[[nodiscard]] std::string format_task(const TaskFile& task);

/// Parses a habit as `shigusa habit` prints it, the value of "habit" in a task: a name in quotes,
/// or an object of numbers. `name` stands for the text in errors.
[[nodiscard]] Result<Habit> parse_habit(std::string_view text, std::string_view name);
/// Reads a file of a habit.
[[nodiscard]] Result<Habit> read_habit(const std::filesystem::path& path);
/// Formats a habit as such a text.
[[nodiscard]] std::string format_habit(const Habit& habit);

/// Ergonomics after assignments by the keys of files, with commas between:
/// "coupling=poor,lifts_per_min=4,thresholds.upright_rad=0.1". Fails on a key or a value that is
/// not allowed.
[[nodiscard]] Result<Ergonomics> with_assignments(const Ergonomics& ergonomics,
                                                  std::string_view assignments);

/// The JSON schema of task files; docs/task.schema.json holds it.
[[nodiscard]] std::string task_schema();

/// Builds the task's body, on a base foot without a goal if its character stands on two feet. The
/// character must be measured or built in; fails as build_character does.
[[nodiscard]] Result<PosedBody> build_body(const TaskFile& file);

/// Adds the obstacles and things of the task's scene (Request::scene, relative to `folder`) to the
/// task, which then no longer names the file. Nodes that actions grasp are things, unless the task
/// has a thing of that name. Returns notes on what was left out; fails as read_scene does.
[[nodiscard]] Result<std::vector<Message>> add_scene(TaskFile& file,
                                                     const std::filesystem::path& folder);

/// Adds the scene (see add_scene), measures the character if needed (see measure_character;
/// `folder` is where relative paths start) and makes the Task for generate().
[[nodiscard]] Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder);

/// Version of the result format that is written.
inline constexpr int kResultVersion = 1;
/// Size limit of a result file (bytes); a larger file is refused.
inline constexpr std::size_t kResultMaxBytes = std::size_t{64} << 20;
/// Largest number of candidates in a result that is read.
inline constexpr std::size_t kResultMaxCandidates = 1000;
/// Name of the result's main file in its folder.
inline constexpr const char* kSummaryName = "summary.json";

/// Facts about a run that a result file records; they do not affect the motions.
struct RunInfo {
  double elapsed_ms = 0.0;      ///< duration of the search
  int threads = 1;              ///< number of threads
  std::string simd = "scalar";  ///< name of the SIMD set
  /// Word of the search; "edit" if parameters were given instead of searched.
  std::string search = "paper_ga";
};

/// The RunInfo of a search that began at `begin` and ends now.
[[nodiscard]] RunInfo search_info(const Task& task, std::chrono::steady_clock::time_point begin);
/// The RunInfo of a run from given parameters that began at `begin` and ends now; `how` is stored
/// in place of the search's word.
[[nodiscard]] RunInfo replay_info(std::string how, std::chrono::steady_clock::time_point begin);

/// A completed run, from which a result is written. It refers to task file, task and motions, which
/// must outlive it.
struct FinishedRun {
  const TaskFile& file;              ///< task file
  const Task& task;                  ///< make_task of the file
  const GenerateResult& generation;  ///< the motions
  RunInfo info{};                    ///< facts about the run
  /// candidate_costs, if they were computed already; else they are where a result tells them.
  std::span<const MotionCost> costs{};
};

/// The largest deviation over all frames of a written file from the motion, measured by reading the
/// file back.
struct ReadBack {
  double effector = 0.0;  ///< m, nodes of the goals' effectors
  double feet = 0.0;      ///< m, nodes of planted feet
  double turn = 0.0;      ///< rad, planted feet and effectors with a goal rotation
  Message off{};          ///< deviations beyond the format's precision; empty: none
};

/// A copy of the task file with the duration of the motions, if they were slowed down.
[[nodiscard]] TaskFile played_task(TaskFile file, const GenerateResult& generation);

/// A file written for a candidate.
struct CandidateFile {
  std::string name;      ///< name in the result's folder: "candidate-1.bvh"
  std::string sha256{};  ///< SHA-256 of its bytes, 64 hexadecimal digits
  /// Deviation from the motion; empty for formats without moving nodes.
  std::optional<ReadBack> read_back{};
};
/// Files of a candidate by the word of their format, "bvh".
using CandidateFiles = std::map<std::string, CandidateFile>;

/// The files written with a result.
struct ResultFiles {
  double rate = kUsualRate;  ///< Hz, frame rate of BVH, GLB and VRMA
  /// Files of each candidate; empty if no files are written.
  std::vector<CandidateFiles> candidates{};
  std::string character{};       ///< path of the character's file relative to the result's folder;
                                 ///< empty: unknown
  std::vector<Message> notes{};  ///< messages about files that were not written or deviate slightly
};

/// Formats a result as JSON, the content of summary.json (schema: docs/result.schema.json). It
/// includes the task with the measured character, so that the result can be edited without any
/// other file.
[[nodiscard]] std::string format_result(const FinishedRun& run, const ResultFiles& files = {});

/// A result read from its file: everything needed to generate its motions again and to edit them.
struct StoredResult {
  TaskFile task;                       ///< the task, with its measured character
  std::vector<Parameters> candidates;  ///< parameters of the candidates, in rank order
  /// Motions of the candidates' actions, for a task with actions.
  std::vector<std::vector<WorkMotion>> motions{};
  std::vector<CandidateFiles> files{};  ///< files of each candidate, without ReadBack
  std::string character{};              ///< see ResultFiles::character
  double rate = kUsualRate;             ///< Hz, see ResultFiles::rate
};

/// Parses a result. Errors state the place, the value seen and the values allowed.
[[nodiscard]] Result<StoredResult> parse_result(std::string_view text, std::string_view name);
/// Reads a result from summary.json or from the folder that holds it. Checks the files of
/// `candidate` (from 1; 0: of none) against their SHA-256: a changed file is an error, a missing
/// one is not.
[[nodiscard]] Result<StoredResult> read_result(const std::filesystem::path& path,
                                               int candidate = 0);

/// Parses a list of output formats, such as "bvh,csv,png"; an empty text is an empty list.
[[nodiscard]] Result<std::vector<FileFormat>> parse_formats(std::string_view list);

/// The default output formats of a character: those of kFileFormats with `usual` whose NeededFile
/// is available. GLB is not among them for built-in bodies.
[[nodiscard]] std::vector<FileFormat> usual_formats(const CharacterSpec& character);

/// Fails on a format in which this character's motions cannot be written (FormatInfo::needs), or
/// that is not an output format.
[[nodiscard]] Result<void> check_formats(const CharacterSpec& character,
                                         const std::vector<FileFormat>& formats);

/// Creates the folder if needed and checks that files can be written to it.
[[nodiscard]] Result<void> prepare_folder(const std::filesystem::path& folder);

/// The naming convention of a built-in body's joints in BVH and GLB files. Characters from files
/// keep their own names.
enum class JointNames {
  own,      ///< VRM names in snake_case: "left_upper_arm"
  mixamo,   ///< Mixamo: "mixamorig:LeftArm"
  unreal,   ///< Unreal's mannequins: "upperarm_l"
  humanik,  ///< HumanIK, of MotionBuilder and Maya: "LeftArm"
};
/// The words of JointNames.
template <>
inline constexpr std::array kEnumWords<JointNames>{
    EnumWord{JointNames::own, "own"}, EnumWord{JointNames::mixamo, "mixamo"},
    EnumWord{JointNames::unreal, "unreal"}, EnumWord{JointNames::humanik, "humanik"}};

/// A caller's function that converts the SVG of a strip figure to PNG or PDF, since the library
/// draws SVG only. It may be called on any thread.
using PictureMaker = std::function<Result<std::string>(const std::string& svg, FileFormat format)>;

/// Settings for writing a result to a folder.
struct ExportSettings {
  std::vector<FileFormat> formats;  ///< formats written for each candidate
  /// Writes all candidates into candidates.glb instead of one GLB each.
  bool one_file = false;
  /// Hz, frame rate of rated formats and of a robot's CSV: kRateMin..kRateMax; empty: that of each
  /// format (FormatInfo::rate).
  std::optional<double> rate{};
  /// Path of the character's file, recorded in the result; may be empty.
  std::filesystem::path character{};
  std::string clip{};                  ///< see FileSettings::animation; empty: named by rank
  JointNames names = JointNames::own;  ///< see FileSettings::names
  bool in_place = false;               ///< see FileSettings::in_place
  bool only_this_clip = false;         ///< see FileSettings::only_this_clip
  PictureMaker from_svg{};             ///< see FileSettings::from_svg
};

/// The outcome of write_result.
struct WrittenResult {
  std::string summary;         ///< text of summary.json
  std::vector<Message> notes;  ///< see ResultFiles::notes
};

/// Writes each candidate in each format ("candidate-1.bvh", …) and summary.json into an existing
/// folder. The folder is replaced atomically: if the program ends early or several programs write
/// at once, it holds either no summary or one with its own complete files. Files of an older result
/// are removed, other files stay. Returns the text of summary.json and the notes in it.
///
/// A character with a rig (CharacterSpec::rig) is written on its own skeleton, in the world of the
/// goals: BVH has the file's nodes and, for a character from BVH, its channels and unit; GLB is the
/// character's file with the new animations ("shigusa candidate 1", …) before its own; VRMA suits
/// any VRM character. GLB of a built-in body is the studio's mannequin, with hands that open and
/// close. Things of a piece of work are root nodes of a GLB, each with a mesh of its shape; in GLB
/// and VRMA its actions are "shigusa_actions" of the animation's extras.
///
/// BVH, GLB and VRMA have the requested rate: frame k is the motion at k / rate, and the last
/// frame, the first at or after the motion's end, is its final posture. Their bytes are read back
/// before they are written: a file whose nodes deviate by more than 1 mm or 0.1° is left out with a
/// note, and a file that deviates less, but beyond its format's precision, gets a note. Fails if
/// all files are left out. CSV and figures have the motion's own frames, but the CSV of a robot has
/// a requested rate too. NPZ is for controllers of robots (docs/robot_references.md).
[[nodiscard]] Result<WrittenResult> write_result(const std::filesystem::path& folder,
                                                 const FinishedRun& run,
                                                 const ExportSettings& settings);

/// Settings for writing one motion.
struct FileSettings {
  std::optional<double> rate{};        ///< Hz, see ExportSettings::rate
  std::string animation = "shigusa";   ///< name of the animation in GLB and VRMA
  JointNames names = JointNames::own;  ///< joint names of a built-in body in BVH and GLB
  /// Keeps the hips in place horizontally in BVH, GLB and VRMA, for game engines that move the
  /// character themselves. Planted feet then slide.
  bool in_place = false;
  /// Leaves the existing animations of a character's file out of its GLB.
  bool only_this_clip = false;
  PictureMaker from_svg{};  ///< converter for PNG and PDF, which fail without it
};

/// Transforms of all nodes relative to the parent, (frames × nodes), as node_motion for a body,
/// with the task's finger play. `clip`: the candidate's motion at any rate.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const Task& task, const Candidate& candidate,
                                                      const Clip& clip,
                                                      MotionPlace place = MotionPlace::world);

/// Parses FileSettings from JSON such as {"fps": 24, "clip": "Reach", "joint_names": "mixamo",
/// "in_place": true, "only_this_clip": true}; missing keys have the values of `usual`.
[[nodiscard]] Result<FileSettings> parse_file_settings(std::string_view text, std::string_view name,
                                                       FileSettings usual = {});

/// The bytes of a file with one candidate on the body's own skeleton. BVH: in centimetres. CSV:
/// joint angles, torques, centre of mass and hand path over time; for a robot, the file's joints
/// and the pose of its root link in the robot's world, z up and x ahead. NPZ: these at a rate, with
/// velocities and the bodies' poses. SVG, PNG, PDF: strip figure. Fails as write_result does.
[[nodiscard]] Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                                   FileFormat format,
                                                   const FileSettings& settings = {});

/// The bytes of a file with one candidate, on the character's own skeleton if its rig is loaded.
/// Fails as check_formats and write_result do.
[[nodiscard]] Result<std::string> export_candidate(const CharacterSpec& character, const Task& task,
                                                   const Candidate& candidate, FileFormat format,
                                                   const FileSettings& settings = {});

/// Writes one candidate to a file, whose name's ending states the format: "reach.glb". Fails as
/// export_candidate does, and where the file cannot be written.
[[nodiscard]] Result<void> save(const std::filesystem::path& path, const CharacterSpec& character,
                                const Task& task, const Candidate& candidate,
                                const FileSettings& settings = {});

/// An unused name for an animation in a character's file: "Reach", or "Reach (2)" if the file
/// already has "Reach".
[[nodiscard]] std::string free_animation(const CharacterSpec& character, const std::string& clip);
/// The name of the animation of a candidate by its rank, from 1: "shigusa candidate 1", or "… (2)"
/// if the file already has that name.
[[nodiscard]] std::string candidate_animation(const CharacterSpec& character, std::size_t rank);

/// The bytes of one GLB with all candidates as animations, named by candidate_animation, or, with
/// FileSettings::animation, by that name and the rank: "Reach 1". Fails as check_formats and
/// write_result do.
[[nodiscard]] Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                                             const std::vector<Candidate>& candidates,
                                             const FileSettings& settings = {.animation = {}});

/// Fails on a rate outside kRateMin..kRateMax; `place` is the Error's place.
[[nodiscard]] Result<void> check_rate(double rate, std::string_view place);

/// Size limit of a limb library's file (bytes); a full one has 13.9 kB.
inline constexpr std::size_t kMaxLimbFile = 1 << 16;

/// A map of reach as CSV (RFC 4180): a row for each place with its position (m), verdict or
/// `unreachable`, score, largest share of a joint's strength, that joint, the duration (s)
/// and the worst score by REBA.
[[nodiscard]] std::string map_csv(const BodyModel& body, const ReachMap& map);
/// A map of reach as a NumPy archive: `x`, `y`, `z` (m, world), and of each place (x, y, z) its
/// `verdict`, an index into `verdicts` or -1 out of reach, `score`, `strength` (share of the
/// strength of the joint that needs the largest one), `reba`, the worst score by REBA or -1, and
/// `joint`, that joint's index into `joints`.
[[nodiscard]] Result<std::string> map_npz(const BodyModel& body, const ReachMap& map);
/// A map of reach as a GLB file: a bead at each place in reach, in a mesh for each verdict,
/// coloured by verdict and score, with the worst score by REBA as the attribute `_REBA`, 0 for
/// none; metres, the body's world.
[[nodiscard]] std::string map_glb(const ReachMap& map);
/// A section of a map of reach as SVG: the places in the plane nearest to a coordinate (m) on an
/// axis, with the body in its start posture. Fails if no plane is that near.
[[nodiscard]] Result<std::string> map_section(const PosedBody& body, const ReachMap& map, Axis axis,
                                              double at);

/// The limit of a task for a person.
struct PersonLimit {
  std::string person{};  ///< "female p5", or the name of the body
  Limit limit{};         ///< the limit
};
/// Limits as a JSON list.
[[nodiscard]] std::string format_limits(std::span<const PersonLimit> limits);

/// The cache folder: $SHIGUSA_CACHE, else shigusa in $XDG_CACHE_HOME, else in ~/.cache. Nothing if
/// none of these is an absolute path.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder();

/// A store that keeps limb libraries as files in a folder, created when first needed. Files are
/// written under a temporary name and renamed, so that concurrent programs see whole files only. A
/// folder that cannot be read or written acts as an empty store.
[[nodiscard]] LimbStore limb_store(const std::filesystem::path& folder);

/// A store in cache_folder(); empty functions if there is no such folder.
[[nodiscard]] LimbStore limb_store();

}  // namespace shigusa
