// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>

namespace shigusa::app {

// The format that a picture's file has by its ending.
[[nodiscard]] Result<FileFormat> picture_format(const std::filesystem::path& path);

// A strip figure's SVG in one of its formats: as it is, or PNG and PDF by librsvg. Fails with
// ErrorCode::unsupported on these where there is no librsvg.
[[nodiscard]] Result<std::string> picture_from(const std::string& svg, FileFormat format);

}  // namespace shigusa::app
