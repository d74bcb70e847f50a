// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "page.hpp"

namespace shigusa::bench {

// Text and pictures that compare recorded people, read from `shared`, with generated motions.
[[nodiscard]] Result<Drawn> pictures_section(const std::filesystem::path& shared);

}  // namespace shigusa::bench
