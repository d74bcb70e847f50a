// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/landmarks.hpp>
#include <shigusa/skeleton.hpp>

#include "character_file.hpp"

namespace shigusa {

// A person in a file, measured, and the posture that they start from.
struct PersonStart {
  HumanoidMap map;
  FilePose measured;      // the pose that the person is measured in …
  MeasuredPerson person;  // … and what was measured
  FilePose posed;         // the pose that the motion starts from, as the file has it …
  MeasuredPerson start;   // … and the person in it; with all doubts
  bool eased = false;     // they stand at ease from there
};

// Finds and measures the person of a file in the pose that the spec asks for.
[[nodiscard]] Result<PersonStart> find_person(const CharacterFile& file, const CharacterSpec& spec);

}  // namespace shigusa
