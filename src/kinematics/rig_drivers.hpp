// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "human/human_frames.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// The body's link that moves a bone, relative to the rest posture.
struct BoneDriver {
  int link = kBaseLink;
  Transformd to_start;  // world at rest -> world in the start posture
  bool carries = true;  // whether the node is placed by the link, or else by its parent
};

// The driver of a mapped bone; none if the body has no such bone. `rest` and `start` are the frames
// of the rig's two postures.
[[nodiscard]] std::optional<BoneDriver> bone_driver(HumanoidBone bone, const BodyModel& body,
                                                    const Rig& rig, const HumanFrames& rest,
                                                    const HumanFrames& start);

// (nodes) placements at rest, in the file's world; scales affect the positions below them, and are
// not part of the rotations.
[[nodiscard]] std::vector<Transformd> at_rest(const Rig& rig);

}  // namespace shigusa
