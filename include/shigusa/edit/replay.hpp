// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/progress.hpp>
#include <shigusa/document/result_file.hpp>
#include <shigusa/generate/generator.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Parses a JSON list of assignments: ["squat_deg=60", "right_knee.weight=3"].
[[nodiscard]] Result<std::vector<std::string>> parse_assignments(std::string_view text,
                                                                 std::string_view name);

// Motions of stored parameters; `task` is make_task of the result's. Candidates count from 1; these
// fail where there is none of that number, naming how many there are.

// One candidate's anew from what the assignments (see assign_parameter) make of its parameters,
// which stay changed.
[[nodiscard]] Result<Generation> replay(const Task& task, StoredResult& stored, int candidate,
                                        std::span<const std::string> assignments = {});
// All of them, in the result's order. Fails with ErrorCode::cancelled where it is stopped between
// two of them; scores that it reports are of the first.
[[nodiscard]] Result<Generation> replay_all(const Task& task, StoredResult& stored,
                                            const Progress& progress = {});

// Takes task and parameters to the other side (see mirror.hpp). What stands of files stays, and is
// of the motions that there were.
[[nodiscard]] Result<void> mirror_result(StoredResult& stored);

// A result as it would be read back from its file.
[[nodiscard]] StoredResult stored_result(const TaskFile& file, const Generation& generation);

}  // namespace shigusa
