// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/result.hpp>
#include <string>

namespace shigusa::bench {

// What `regularities.py` found, from a folder of its JSON files: `0.json` by default options, the
// others named "N OPTIONS.json".
[[nodiscard]] Result<std::string> regularities_section(const std::filesystem::path& folder);

}  // namespace shigusa::bench
