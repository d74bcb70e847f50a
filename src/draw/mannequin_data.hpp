// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace shigusa {

// Contents of data/mannequin.bin, embedded by cmake/embed_mannequin.cmake.
extern const std::span<const unsigned char> kMannequinFile;

// Unpacked contents of the file.
[[nodiscard]] std::string mannequin_data();

}  // namespace shigusa
