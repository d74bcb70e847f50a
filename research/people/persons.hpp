// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <string>

namespace shigusa::bench {

// Recorded persons' reaches, from a table of their figures, beside generated ones.
[[nodiscard]] Result<std::string> persons_section(const std::filesystem::path& table);

}  // namespace shigusa::bench
