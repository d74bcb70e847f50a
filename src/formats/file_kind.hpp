// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Fails where the bytes of a file are clearly of another kind than its name's ending tells, by what
// they begin with: an archive, a page of HTML, a pointer of Git LFS, another format. The error
// names that kind and says what to do.
[[nodiscard]] Result<void> check_file_kind(std::string_view bytes, const std::string& name);

}  // namespace shigusa
