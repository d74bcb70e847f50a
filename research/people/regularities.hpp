// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <string>

namespace shigusa::bench {

// The findings of `regularities.py`, from a folder of its JSON files: `0.json` has those by default
// options, the others are named "N OPTIONS.json".
[[nodiscard]] Result<std::string> regularities_section(const std::filesystem::path& folder);

}  // namespace shigusa::bench
