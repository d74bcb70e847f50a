// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/shigusa.hpp>
#include <string>
#include <vector>

namespace shigusa::app {

// The candidates as a table for a person: scores, criteria, errors, joints over their limits.
[[nodiscard]] std::string candidate_table(const Generation& generation);

// The same of a motion that is no candidate.
[[nodiscard]] std::string score_table(const Score& score, const FinalPosture& ends,
                                      const std::vector<LimitExcess>& over_limit,
                                      const std::optional<SupportMargins>& support);

// What happened, in one line: status, body, goals, counts and time.
[[nodiscard]] std::string headline(const Task& task, const Generation& generation,
                                   const RunInfo& info);

// Writes a result, prints it as the options ask, and returns the exit code.
int deliver(const std::filesystem::path& folder, const TaskFile& file, const Task& task,
            const Generation& generation, const RunInfo& info, const ExportSettings& settings,
            bool json);

}  // namespace shigusa::app
