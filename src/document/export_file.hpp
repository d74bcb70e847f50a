// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/files.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// File name of a candidate, "candidate-1.bvh" for rank 1.
[[nodiscard]] std::string candidate_file(std::size_t rank, FileFormat format);
// File name of the GLB with all candidates.
inline constexpr const char* kOneFile = "candidates.glb";

// Whether a file name is that of a candidate, or of all candidates.
[[nodiscard]] bool is_result_file(std::string_view name);

// An exported file, with the result of reading it back if it holds the motion of nodes.
struct MadeFile {
  std::string bytes;
  std::optional<ReadBack> back;
};

// A motion to export, with its settings.
struct WriteRequest {
  const CharacterSpec& character;
  const Task& task;
  const Candidate& candidate;
  const FileSettings& settings;
  const MotionCost* cost = nullptr;  // if it was computed already
};

// Writes the motion in a format; each written format (FormatInfo::written) has a specialisation.
// Precondition: the character can be exported to the format, and the rate is an export rate.
template <FileFormat format>
[[nodiscard]] Result<MadeFile> write_as(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::bvh>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::glb>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::vrma>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::csv>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::npz>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::svg>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::png>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::pdf>(const WriteRequest& request);

// A candidate's motion at a rate (Hz). Fails if it exceeds the limits of files.
[[nodiscard]] Result<Clip> clip_at_rate(const CharacterSpec& character, const Task& task,
                                        const Candidate& candidate, double rate);

// Wraps bytes that hold no motion of nodes, for write_as.
[[nodiscard]] Result<MadeFile> unread(Result<std::string> bytes);

// Fails on settings that are not available for this character in that format.
[[nodiscard]] Result<void> check_file_settings(const CharacterSpec& character, FileFormat format,
                                               const FileSettings& settings);

// Writes the motion in any format. Fails as check_formats and check_rate do, and as the writer
// does.
[[nodiscard]] Result<MadeFile> make_file(const WriteRequest& request, FileFormat format);

// A GLB of all candidates, and the result of reading each back.
struct MadeGlb {
  std::string bytes;
  std::vector<ReadBack> back;
};
[[nodiscard]] Result<MadeGlb> make_one_glb(const CharacterSpec& character, const Task& task,
                                           const std::vector<Candidate>& candidates,
                                           const FileSettings& settings);

}  // namespace shigusa
