// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "character_file.hpp"

namespace shigusa {

// How the person of a file is measured: in a frame of its motion, and in its rest pose, at ease.
struct FilePoses {
  std::function<Result<PersonStart>(int)> in_frame;
  std::function<Result<PersonStart>()> at_rest;
};

// The frame that a spec asks for, or the first that is a posture; nothing of a file that has none.
// Fails where the one that is asked for is none.
[[nodiscard]] Result<std::optional<int>> frame_of(const CharacterFile& file,
                                                  const CharacterSpec& spec);

// The posture that a motion starts from in a file with such a frame. The frame that a spec asks for
// as it is, of one who stands or, with a seat, sits: a person who lies in it is refused, and of one
// who could not hold still is told. Where none is asked for, the first frame in which the person
// stands still on both feet; else the rest pose; where that does not stand either, the first in
// which they stand and move, or `frame`. Without a seat another start than frame 0 is told.
// `known`: the person, measured in any of the poses.
[[nodiscard]] Result<PersonStart> choose_start(const CharacterFile& file, const CharacterSpec& spec,
                                               const PersonStart& known, int frame,
                                               const FilePoses& poses);

// Whether in the first frame of a file's motion the person stands still on both feet.
[[nodiscard]] bool begins_standing(const CharacterFile& file, const CharacterSpec& spec,
                                   const PersonStart& known);

}  // namespace shigusa
