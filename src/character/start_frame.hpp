// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "character_file.hpp"

namespace shigusa {

// Functions that measure the person of a file: in a frame of its motion, and in its rest pose, at
// ease.
struct FilePoses {
  std::function<Result<PersonStart>(int)> in_frame;
  std::function<Result<PersonStart>()> at_rest;
};

// The requested frame, or the first frame that is a posture; empty for a file without one. Fails if
// the requested frame is no posture.
[[nodiscard]] Result<std::optional<int>> frame_of(const CharacterFile& file,
                                                  const CharacterSpec& spec);

// Chooses the start posture from a file that has such a frame. A requested frame is used as it is,
// standing or, with a seat, sitting; a lying person is refused, and an unstable posture gives a
// doubt. Without a request: the first frame in which the person stands still on both feet; else
// the rest pose; if that does not stand either, the first frame in which they stand while moving,
// or `frame`. Without a seat, a start other than frame 0 is reported. `known`: the person, measured
// in any of the poses.
[[nodiscard]] Result<PersonStart> choose_start(const CharacterFile& file, const CharacterSpec& spec,
                                               const PersonStart& known, int frame,
                                               const FilePoses& poses);

// Whether the person stands still on both feet in the first frame of a file's motion.
[[nodiscard]] bool begins_standing(const CharacterFile& file, const CharacterSpec& spec,
                                   const PersonStart& known);

}  // namespace shigusa
