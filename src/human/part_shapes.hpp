// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>
#include <vector>

#include "human_frames.hpp"

namespace shigusa {

// The part of that side of two such as BodyPart::left_thigh.
[[nodiscard]] constexpr BodyPart of_side(BodyPart left, Side side) {
  return side == Side::left ? left : static_cast<BodyPart>(static_cast<int>(left) + 1);
}

// A part's own frame (see PartShape) in the person's posture.
[[nodiscard]] Transformd part_frame(BodyPart part, const Landmarks& person,
                                    const HumanFrames& frames);

// Where a person's head has its joint: their own, or at kHeadJointShare of the way to the vertex.
[[nodiscard]] Vec3d head_joint(const Landmarks& person);

// How long (m) a limb's part is, from its joint to the next, or of a hand to the fingertip.
[[nodiscard]] double limb_length(BodyPart part, const Landmarks& person);

// A part's shape: that of the person's mesh, or else by stature (m) and the tables of
// anthropometry.hpp; a foot has that of its sole.
[[nodiscard]] PartShape part_shape(BodyPart part, const Landmarks& person,
                                   const HumanFrames& frames, double stature);

// The same as capsules in the world: of a flat part two. Their link is not told.
[[nodiscard]] std::vector<Capsule> part_capsules(BodyPart part, const Landmarks& person,
                                                 const HumanFrames& frames, double stature);

// Of a capsule along an upper arm the outer part, which is out of the trunk for certain.
[[nodiscard]] Capsule beyond_trunk(Capsule upper_arm);

// The pieces that a person's trunk is, from below: one where the spine has no joints.
[[nodiscard]] std::vector<BodyPart> trunk_parts(const Landmarks& person);

// The lengthwise ends of a piece of the trunk (m, world): the joints below and above it, or for the
// last one the middle of the shoulders.
struct TrunkPiece {
  Vec3d from{};
  Vec3d to{};
  bool last = true;
};
[[nodiscard]] TrunkPiece trunk_piece(BodyPart part, const Landmarks& person);

}  // namespace shigusa
