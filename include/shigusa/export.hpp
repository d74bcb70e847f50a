// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/result_file.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// Parses a list of formats that are written, such as "bvh,csv,png"; an empty one is no format.
[[nodiscard]] Result<std::vector<FileFormat>> parse_formats(std::string_view list);

/// The formats that a character gets when none are asked for: the usual ones of kFileFormats whose
/// file, if they need one, is at hand.
[[nodiscard]] std::vector<FileFormat> usual_formats(const CharacterSpec& character);

/// Fails on a format that this character cannot leave in (FormatInfo::needs), or nothing can.
[[nodiscard]] Result<void> check_formats(const CharacterSpec& character,
                                         const std::vector<FileFormat>& formats);

/// Makes the folder, if need be, and makes sure that files can be written to it.
[[nodiscard]] Result<void> prepare_folder(const std::filesystem::path& folder);

/// How a result is written to a folder.
struct ExportSettings {
  std::vector<FileFormat> formats;  ///< of each candidate
  /// all candidates in candidates.glb, in place of a GLB for each
  bool one_file = false;
  double rate = kUsualRate;  ///< Hz, of BVH, GLB and VRMA: kRateMin to kRateMax
  /// the file that the character came from, so that the result can tell where it is; or empty
  std::filesystem::path character{};
};

/// Writes each candidate in each format ("candidate-1.bvh", …) and the result as summary.json into
/// the folder, which must be there. Whatever ends the program, and however many write at once, the
/// folder has no summary or one whose files are whole and its own: an older result there is
/// replaced as one, with its files of ranks or formats that this one has not. Other files stay.
/// Returns the text of summary.json.
///
/// A character whose file is at hand (CharacterSpec::rig) leaves on its own skeleton, in the world
/// that goals are given in: BVH has the file's nodes, of a BVH also its channels and unit; GLB is
/// the file with animations added ("shigusa candidate 1", …); VRMA is for any VRM character.
///
/// BVH, GLB and VRMA are at the rate that is asked for: frame k is the motion at k / rate, and the
/// last one, the first that is not before its end, is exactly its last. They are read back before
/// they are written; where their nodes are not with the motion, this fails and writes nothing. CSV
/// and figures have the frames of the motion itself.
[[nodiscard]] Result<std::string> write_result(const std::filesystem::path& folder,
                                               const FinishedRun& run,
                                               const ExportSettings& settings);

/// How one motion is written.
struct FileSettings {
  double rate = kUsualRate;           ///< Hz, as ExportSettings has it
  std::string animation = "shigusa";  ///< its name in GLB and VRMA
};

/// A candidate's motion at a rate (Hz), as files of it have it: planted feet stay and the goals'
/// effectors keep to their paths between the motion's own frames too.
[[nodiscard]] Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate);

/// (frames × nodes) each node in its parent, as node_motion of a body, with the fingers that the
/// task asks for.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const Task& task, const Clip& clip);

/// Parses {"fps": 24}.
[[nodiscard]] Result<FileSettings> parse_file_settings(std::string_view text,
                                                       std::string_view name);

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

/// The animation that the candidate of a rank (from 1) is called by: "shigusa candidate 1", or "…
/// (2)" where the character's file has one of that name.
[[nodiscard]] std::string candidate_animation(const CharacterSpec& character, std::size_t rank);

/// All candidates as animations of one GLB. Fails as check_formats and write_result do.
[[nodiscard]] Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                                             const std::vector<Candidate>& candidates,
                                             double rate = kUsualRate);

/// Fails on a rate that motions cannot leave at; `place` names its source.
[[nodiscard]] Result<void> check_rate(double rate, std::string_view place);

}  // namespace shigusa
