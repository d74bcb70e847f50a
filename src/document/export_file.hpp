// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/files.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// "candidate-1.bvh" of rank 1.
[[nodiscard]] std::string candidate_file(std::size_t rank, FileFormat format);
// All candidates in one GLB.
inline constexpr const char* kOneFile = "candidates.glb";

// Whether a file of this name is a candidate's, or all candidates'.
[[nodiscard]] bool is_result_file(std::string_view name);

// A file, read back where it holds the motion of nodes.
struct MadeFile {
  std::string bytes;
  std::optional<ReadBack> back;
};

// A motion that is to leave, and how.
struct WriteRequest {
  const CharacterSpec& character;
  const Task& task;
  const Candidate& candidate;
  const FileSettings& settings;
};

// The motion in a format; each that is written (FormatInfo::written) has one. The character can
// leave in it, and the rate is one that motions leave at.
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
Result<MadeFile> write_as<FileFormat::svg>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::png>(const WriteRequest& request);
template <>
Result<MadeFile> write_as<FileFormat::pdf>(const WriteRequest& request);

// The file of bytes that hold no motion of nodes, for write_as.
[[nodiscard]] Result<MadeFile> unread(Result<std::string> bytes);

// Fails on settings that this character cannot leave with in that format.
[[nodiscard]] Result<void> check_file_settings(const CharacterSpec& character, FileFormat format,
                                               const FileSettings& settings);

// The motion in any format. Fails as check_formats and check_rate do, and where it is made.
[[nodiscard]] Result<MadeFile> make_file(const WriteRequest& request, FileFormat format);

// One GLB of all candidates, and what was read back of each.
struct MadeGlb {
  std::string bytes;
  std::vector<ReadBack> back;
};
[[nodiscard]] Result<MadeGlb> make_one_glb(const CharacterSpec& character, const Task& task,
                                           const std::vector<Candidate>& candidates,
                                           const FileSettings& settings);

}  // namespace shigusa
