// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace shigusa {

// The bytes of data/mannequin.bin: cmake/embed_mannequin.cmake.
extern const std::span<const unsigned char> kMannequinFile;

// The file's content, unpacked.
[[nodiscard]] std::string mannequin_data();

}  // namespace shigusa
