// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>

namespace shigusa::app {

// Picture format by a file name's ending.
[[nodiscard]] Result<FileFormat> picture_format(const std::filesystem::path& path);

// Converts a strip figure's SVG: unchanged, or to PNG and PDF by librsvg. Fails with
// ErrorCode::unsupported if librsvg is not available.
[[nodiscard]] Result<std::string> picture_from(const std::string& svg, FileFormat format);

}  // namespace shigusa::app
