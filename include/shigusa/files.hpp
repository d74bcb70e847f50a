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
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The version of the format that is written.
inline constexpr int kTaskVersion = 1;
/// A larger file is refused.
inline constexpr std::size_t kTaskMaxBytes = std::size_t{1} << 20;

/// A task as its JSON file holds it; docs/task.schema.json is its schema.
struct TaskFile : Request {
  CharacterSpec character{};  ///< the one who moves
};

/// Parses what stands under "character" in a task: an object, or a source alone as a JSON text.
[[nodiscard]] Result<CharacterSpec> parse_character_spec(std::string_view text,
                                                         std::string_view name);

/// Parses a task. Errors name the place ("task.json: goals[0].position_m"), the value seen and what
/// is allowed; a misspelt key gets the nearest one suggested.
[[nodiscard]] Result<TaskFile> parse_task(std::string_view text, std::string_view name);
/// Reads and parses a task's file.
[[nodiscard]] Result<TaskFile> read_task(const std::filesystem::path& path);

/// The task as JSON text: parse_task of it gives the same task, bit for bit (names that are not
/// UTF-8 and what a built-in body does not use excepted).
[[nodiscard]] std::string format_task(const TaskFile& task);

/// The JSON schema of task files, as docs/task.schema.json has it.
[[nodiscard]] std::string task_schema();

/// The task's body, standing on a foot that no goal moves where its character has two to stand on.
/// The character must have been measured; fails as build_character.
[[nodiscard]] Result<BodyModel> build_body(const TaskFile& file);

/// Measures the character where needed (see measure_character) and makes the task to be generated.
[[nodiscard]] Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder);

/// The version of the format that is written.
inline constexpr int kResultVersion = 1;
/// A larger file is refused.
inline constexpr std::size_t kResultMaxBytes = std::size_t{64} << 20;
/// A result of more candidates is refused.
inline constexpr std::size_t kResultMaxCandidates = 1000;
/// The name of a result's own file in its folder.
inline constexpr const char* kSummaryName = "summary.json";

/// Facts about a run that stand in a result beside the motions; none of them changes a motion.
struct RunInfo {
  double elapsed_ms = 0.0;          ///< of the search
  int threads = 1;                  ///< that it had
  std::string simd = "scalar";      ///< name of its SIMD set
  std::string search = "paper_ga";  ///< "edit" where parameters were given instead of searched
};

/// The facts of a search of the task that began then and has just ended.
[[nodiscard]] RunInfo search_info(const Task& task, std::chrono::steady_clock::time_point begin);
/// The facts of a run from given parameters; `how` stands in the place of the search.
[[nodiscard]] RunInfo replay_info(std::string how, std::chrono::steady_clock::time_point begin);

/// The run of a task, which a result is written of. Borrows everything except the facts.
struct FinishedRun {
  const TaskFile& file;              ///< the task as its file has it
  const Task& task;                  ///< make_task of that file
  const GenerateResult& generation;  ///< the motions
  RunInfo info{};                    ///< facts beside them
};

/// How far a written file's nodes are from the motion, as they were read back: the most in any
/// frame.
struct ReadBack {
  double effector = 0.0;  ///< m, of goals' nodes
  double feet = 0.0;      ///< m, of planted feet's nodes
  double turn = 0.0;      ///< rad, of planted feet, and of effectors whose goal says how they turn
  Message off{};  ///< what is off by more than the format's digits explain; empty: nothing is
};

/// The task's file with the duration that its motions have, where they were slowed down.
[[nodiscard]] TaskFile played_task(TaskFile file, const GenerateResult& generation);

/// A file of a candidate.
struct CandidateFile {
  std::string name;                     ///< in the result's folder: "candidate-1.bvh"
  std::string sha256{};                 ///< of its bytes, 64 hexadecimal digits
  std::optional<ReadBack> read_back{};  ///< of those that hold the motion of nodes
};
/// By format: "bvh".
using CandidateFiles = std::map<std::string, CandidateFile>;

/// The files that are written beside a result.
struct ResultFiles {
  double rate = kUsualRate;                  ///< Hz, of BVH, GLB and VRMA
  std::vector<CandidateFiles> candidates{};  ///< one for each, or none where nothing is written
  std::string character{};  ///< the character's file, from the result's folder; empty: not known
  std::vector<Message> notes{};  ///< files that could not be written, and those a little off
};

/// The result as JSON text, the object of summary.json; docs/result.schema.json is its schema. The
/// task stands in it with the measured character, so that the result can be edited without any
/// other file.
[[nodiscard]] std::string format_result(const FinishedRun& run, const ResultFiles& files = {});

/// A result as read back: enough to generate its motions again and to edit them.
struct StoredResult {
  TaskFile task;                        ///< that it is the result of
  std::vector<Parameters> candidates;   ///< in rank order
  std::vector<CandidateFiles> files{};  ///< of each candidate, without ReadBack
  std::string character{};              ///< as ResultFiles has it
  double rate = kUsualRate;             ///< Hz, as ResultFiles has it
};

/// Parses a result. Errors name the place, the value seen and what is allowed.
[[nodiscard]] Result<StoredResult> parse_result(std::string_view text, std::string_view name);
/// Reads a result: summary.json itself, or the folder that holds it. Fails where a file of that
/// candidate (from 1; 0: of none) is there and is not the one that the summary describes; one that
/// is not there is no failure.
[[nodiscard]] Result<StoredResult> read_result(const std::filesystem::path& path,
                                               int candidate = 0);

/// Parses a list of formats that are written, such as "bvh,csv,png"; an empty one is no format.
[[nodiscard]] Result<std::vector<FileFormat>> parse_formats(std::string_view list);

/// The formats that a character gets when none are asked for: the usual ones of kFileFormats whose
/// file, if they need one, is at hand. GLB of built-in bodies is none of them.
[[nodiscard]] std::vector<FileFormat> usual_formats(const CharacterSpec& character);

/// Fails on a format that this character cannot leave in (FormatInfo::needs), or nothing can.
[[nodiscard]] Result<void> check_formats(const CharacterSpec& character,
                                         const std::vector<FileFormat>& formats);

/// Makes the folder, if need be, and makes sure that files can be written to it.
[[nodiscard]] Result<void> prepare_folder(const std::filesystem::path& folder);

/// Whose names the joints of a built-in body have in files. Characters from files keep their own.
enum class JointNames {
  own,      ///< VRM's in snake_case: "left_upper_arm"
  mixamo,   ///< "mixamorig:LeftArm"
  unreal,   ///< of Unreal's mannequins: "upperarm_l"
  humanik,  ///< of MotionBuilder and Maya: "LeftArm"
};
/// The words of JointNames.
template <>
inline constexpr std::array kEnumWords<JointNames>{
    EnumWord{JointNames::own, "own"}, EnumWord{JointNames::mixamo, "mixamo"},
    EnumWord{JointNames::unreal, "unreal"}, EnumWord{JointNames::humanik, "humanik"}};

/// Makes a PNG or a PDF of a strip figure's SVG, on any thread: a program's own function, as the
/// library draws SVG alone.
using PictureMaker = std::function<Result<std::string>(const std::string& svg, FileFormat format)>;

/// How a result is written to a folder.
struct ExportSettings {
  std::vector<FileFormat> formats;  ///< of each candidate
  /// all candidates in candidates.glb, in place of a GLB for each
  bool one_file = false;
  double rate = kUsualRate;  ///< Hz, of BVH, GLB and VRMA: kRateMin to kRateMax
  /// the file that the character came from, so that the result can tell where it is; or empty
  std::filesystem::path character{};
  std::string clip{};                  ///< as FileSettings::animation; empty: by the rank
  JointNames names = JointNames::own;  ///< as FileSettings::names
  bool in_place = false;               ///< as FileSettings::in_place
  bool only_this_clip = false;         ///< as FileSettings::only_this_clip
  PictureMaker from_svg{};             ///< as FileSettings::from_svg
};

/// A result that was written.
struct WrittenResult {
  std::string summary;         ///< the text of summary.json
  std::vector<Message> notes;  ///< as ResultFiles::notes
};

/// Writes each candidate in each format ("candidate-1.bvh", …) and the result as summary.json into
/// the folder, which must be there. Whatever ends the program, and however many write at once, the
/// folder has no summary or one whose files are whole and its own: an older result there is
/// replaced as one, with its files of ranks or formats that this one has not. Other files stay.
/// Returns the text of summary.json and the notes in it.
///
/// A character whose file is at hand (CharacterSpec::rig) leaves on its own skeleton, in the world
/// that goals are given in: BVH has the file's nodes, of a BVH also its channels and unit; GLB is
/// the file with animations added ("shigusa candidate 1", …), before its own; VRMA is for any VRM
/// character. A built-in body leaves in GLB as the mannequin of the studio, with hands that open
/// and close.
///
/// BVH, GLB and VRMA are at the rate that is asked for: frame k is the motion at k / rate, and the
/// last one, the first that is not before its end, is exactly its last. They are read back before
/// they are written: a file whose nodes are off the motion by more than 1 mm or 0.1° is left out,
/// with a note, and one that is off by less, and by more than its digits explain, has a note. Fails
/// where all files are left out. CSV and figures have the frames of the motion itself.
[[nodiscard]] Result<WrittenResult> write_result(const std::filesystem::path& folder,
                                                 const FinishedRun& run,
                                                 const ExportSettings& settings);

/// How one motion is written.
struct FileSettings {
  double rate = kUsualRate;            ///< Hz, as ExportSettings has it
  std::string animation = "shigusa";   ///< its name in GLB and VRMA
  JointNames names = JointNames::own;  ///< in BVH and GLB, of a built-in body
  /// The hips keep their place along the floor in BVH, GLB and VRMA: games that move the character
  /// themselves want what it travels left out. Feet that stand slide then.
  bool in_place = false;
  /// The animations that a character's file has are left out of its GLB.
  bool only_this_clip = false;
  PictureMaker from_svg{};  ///< makes PNG and PDF, which are refused without it
};

/// A candidate's motion at a rate (Hz), as files of it have it: planted feet stay and the goals'
/// effectors keep to their paths between the motion's own frames too.
[[nodiscard]] Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate);

/// (frames × nodes) each node in its parent, as node_motion of a body, with the fingers that the
/// task asks for.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const Task& task, const Clip& clip);

/// Parses {"fps": 24, "clip": "Reach", "joint_names": "mixamo", "in_place": true, "only_this_clip":
/// true}; what is missing is as in `usual`.
[[nodiscard]] Result<FileSettings> parse_file_settings(std::string_view text, std::string_view name,
                                                       FileSettings usual = {});

/// One candidate on the body's own skeleton as a file's bytes. BVH: in centimetres.
/// CSV: joint angles, torques, centre of mass and hand path against time; of a robot its file's
/// joints, its root link's place, and all of it in the robot's world, z up and x ahead. SVG, PNG,
/// PDF: the strip figure. Fails as write_result does.
[[nodiscard]] Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                                   FileFormat format,
                                                   const FileSettings& settings = {});

/// One candidate on the character's own skeleton where its file is at hand. Fails as check_formats
/// and write_result do.
[[nodiscard]] Result<std::string> export_candidate(const CharacterSpec& character, const Task& task,
                                                   const Candidate& candidate, FileFormat format,
                                                   const FileSettings& settings = {});

/// Writes one candidate to a file, whose name's ending states the format: "reach.glb". Fails as
/// export_candidate does, and where the file cannot be written.
[[nodiscard]] Result<void> save(const std::filesystem::path& path, const CharacterSpec& character,
                                const Task& task, const Candidate& candidate,
                                const FileSettings& settings = {});

/// The name of a clip's animation in a character's file: "Reach", or "Reach (2)" where the file has
/// one of that name.
[[nodiscard]] std::string free_animation(const CharacterSpec& character, const std::string& clip);
/// The animation that the candidate of a rank (from 1) is called by: "shigusa candidate 1", or "…
/// (2)" as above.
[[nodiscard]] std::string candidate_animation(const CharacterSpec& character, std::size_t rank);

/// All candidates as animations of one GLB, each called by candidate_animation, or by a clip's name
/// that is given and its rank: "Reach 1". Fails as check_formats and write_result do.
[[nodiscard]] Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                                             const std::vector<Candidate>& candidates,
                                             const FileSettings& settings = {.animation = {}});

/// Fails on a rate that motions cannot leave at; `place` names its source.
[[nodiscard]] Result<void> check_rate(double rate, std::string_view place);

/// No library is larger: a full one has 13.9 kB.
inline constexpr std::size_t kMaxLimbFile = 1 << 16;

/// The folder for what can be made again: $SHIGUSA_CACHE, or shigusa in $XDG_CACHE_HOME or in
/// ~/.cache. Nothing where none of these is an absolute path.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder();

/// Keeps limb libraries as files of a folder, which is made when there is something to keep. Files
/// are written beside their place and renamed, so that programs at the same time see whole ones. A
/// folder that cannot be read or written is as good as none.
[[nodiscard]] LimbStore limb_store(const std::filesystem::path& folder);

/// A store in cache_folder(); an empty one without it.
[[nodiscard]] LimbStore limb_store();

}  // namespace shigusa
