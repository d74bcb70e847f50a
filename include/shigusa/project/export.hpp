// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/project/result_file.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// What a candidate can be written as.
enum class ExportFormat { bvh, csv, svg, png, pdf };

// Parses a list such as "bvh,csv,png"; an empty one is no format.
[[nodiscard]] Result<std::vector<ExportFormat>> parse_formats(std::string_view list);

// Makes the folder, if need be, and makes sure that files can be written to it.
[[nodiscard]] Result<void> prepare_folder(const std::filesystem::path& folder);

// Writes each candidate in each format ("candidate-1.bvh", …) and the result as summary.json into
// the folder. Candidates' files of an earlier result there are removed where this one has none of
// that rank or format. Returns the text of summary.json.
[[nodiscard]] Result<std::string> write_result(const std::filesystem::path& folder,
                                               const TaskFile& file, const Task& task,
                                               const Generation& generation, const RunInfo& info,
                                               const std::vector<ExportFormat>& formats);

// One candidate as a file's bytes. BVH: body_skeleton in centimetres. CSV: joint angles, torques,
// centre of mass and hand path against time; of a robot its file's joints, its root link's place,
// and all of it in the robot's world, z up and x ahead. SVG, PNG, PDF: the strip figure.
[[nodiscard]] Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                                   ExportFormat format);

}  // namespace shigusa
