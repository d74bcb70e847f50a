// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>
#include <vector>

#include "human_frames.hpp"

namespace shigusa {

// Part of a pair on that side, given the left one, such as BodyPart::left_thigh.
[[nodiscard]] constexpr BodyPart of_side(BodyPart left, Side side) {
  return side == Side::left ? left : static_cast<BodyPart>(static_cast<int>(left) + 1);
}

// A part's own frame (see PartShape) in the person's posture.
[[nodiscard]] Transformd part_frame(BodyPart part, const Landmarks& person,
                                    const HumanFrames& frames);

// Head joint of a person: their own, or at kHeadJointShare of the way to the vertex.
[[nodiscard]] Vec3d head_joint(const Landmarks& person);

// Length (m) of a limb's part: to the next joint, or for a hand to the fingertip.
[[nodiscard]] double limb_length(BodyPart part, const Landmarks& person);

// Shape of a part: from the person's mesh, or else by stature (m) and the tables of
// anthropometry.hpp; for a foot from its sole.
[[nodiscard]] PartShape part_shape(BodyPart part, const Landmarks& person,
                                   const HumanFrames& frames, double stature);

// Shape of a part as capsules in the world, two for a flat part. Their link is not set.
[[nodiscard]] std::vector<Capsule> part_capsules(BodyPart part, const Landmarks& person,
                                                 const HumanFrames& frames, double stature);

// Outer part of a capsule along an upper arm, which is certainly outside the trunk.
[[nodiscard]] Capsule beyond_trunk(Capsule upper_arm);

// Pieces of a person's trunk, from below: one if the spine has no joints.
[[nodiscard]] std::vector<BodyPart> trunk_parts(const Landmarks& person);

// Ends of a piece of the trunk (m, world): the joints below and above it, or for the last piece the
// midpoint of the shoulders.
struct TrunkPiece {
  Vec3d from{};
  Vec3d to{};
  bool last = true;
};
[[nodiscard]] TrunkPiece trunk_piece(BodyPart part, const Landmarks& person);

}  // namespace shigusa
