// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/score_clip.hpp>
#include <shigusa/shigusa.hpp>
#include <string>
#include <vector>

namespace shigusa::app {

// The candidates as a table for a person: verdicts, scores, criteria, errors, joints over their
// limits; below it why what is not possible is not.
[[nodiscard]] std::string candidate_table(const BodyModel& body, const GenerateResult& generation);

// The same of a recorded motion.
[[nodiscard]] std::string score_table(const BodyModel& body, const ClipScore& scored);

// What happened, in one line: status, body, goals, counts and time.
[[nodiscard]] std::string headline(const Task& task, const GenerateResult& generation,
                                   const RunInfo& info);

// Writes a result, prints it as the options ask, and returns the exit code.
int deliver(const std::filesystem::path& folder, const TaskFile& file, const Task& task,
            const GenerateResult& generation, const RunInfo& info, const ExportSettings& settings,
            bool json);

}  // namespace shigusa::app
