// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "page.hpp"

namespace shigusa::bench {

// The text with pictures of what people do beside what is generated.
// Recorded people are read from `shared`.
[[nodiscard]] Result<Drawn> pictures_section(const std::filesystem::path& shared);

}  // namespace shigusa::bench
