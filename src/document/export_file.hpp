// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/document/export.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The name that a format is asked for by: "bvh".
[[nodiscard]] const char* format_name(ExportFormat format);

// "candidate-1.bvh" of rank 1.
[[nodiscard]] std::string candidate_file(std::size_t rank, ExportFormat format);
// All candidates in one GLB.
inline constexpr const char* kOneFile = "candidates.glb";

// Whether a file of this name is a candidate's, or all candidates'.
[[nodiscard]] bool is_result_file(std::string_view name);

// A file, read back where it holds the motion of nodes.
struct MadeFile {
  std::string bytes;
  std::optional<ReadBack> back;
};
[[nodiscard]] Result<MadeFile> make_file(const CharacterSpec& character, const Task& task,
                                         const Candidate& candidate, ExportFormat format,
                                         const FileSettings& settings);

// One GLB of all candidates, and what was read back of each.
struct MadeGlb {
  std::string bytes;
  std::vector<ReadBack> back;
};
[[nodiscard]] Result<MadeGlb> make_one_glb(const CharacterSpec& character, const Task& task,
                                           const std::vector<Candidate>& candidates, double rate);

}  // namespace shigusa
