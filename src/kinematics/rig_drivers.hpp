// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "human/human_frames.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// The link of the body that moves a bone, from the posture at rest on.
struct BoneDriver {
  int link = kBaseLink;
  Transformd to_start;  // world at rest -> world in the start posture
  bool carries = true;  // the node stands where the link takes it, or on its parent
};

// The driver of a mapped bone, or nothing where the body has no such bone. `rest` and `start` are
// the frames of the rig's two postures.
[[nodiscard]] std::optional<BoneDriver> bone_driver(HumanoidBone bone, const BodyModel& body,
                                                    const Rig& rig, const HumanFrames& rest,
                                                    const HumanFrames& start);

// (nodes) where they stand at rest, in the file's world; a scale moves what is below it, and
// rotations are without.
[[nodiscard]] std::vector<Transformd> at_rest(const Rig& rig);

}  // namespace shigusa
