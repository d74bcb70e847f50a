// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Fails if the first bytes of a file are clearly those of another kind than its name's ending: an
// archive, an HTML page, a Git LFS pointer, another format. The error names that kind and suggests
// a remedy.
[[nodiscard]] Result<void> check_file_kind(std::string_view bytes, const std::string& name);

}  // namespace shigusa
