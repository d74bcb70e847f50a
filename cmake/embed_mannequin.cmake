# SPDX-License-Identifier: MIT
# The page's mannequin within the library: its file's bytes as a source.
set(mannequin_file ${PROJECT_SOURCE_DIR}/data/mannequin.bin)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${mannequin_file})
file(READ ${mannequin_file} mannequin_bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," mannequin_bytes ${mannequin_bytes})
file(CONFIGURE OUTPUT mannequin_file.cpp @ONLY CONTENT [[
#include "figure/mannequin_data.hpp"

namespace shigusa {
namespace {
constexpr unsigned char kBytes[] = {@mannequin_bytes@};
}  // namespace
const std::span<const unsigned char> kMannequinFile = kBytes;
}  // namespace shigusa
]])
target_sources(shigusa PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/mannequin_file.cpp)
