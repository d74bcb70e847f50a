// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>

#include "formats/json_reader.hpp"

namespace shigusa {

// Conversion of a task to JSON and back; result files use it too.
[[nodiscard]] Json task_to_json(const TaskFile& task);
[[nodiscard]] Result<TaskFile> task_from_json(const Json& json, const std::string& place);

}  // namespace shigusa
