// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <vector>

#include "body/skin.hpp"

namespace shigusa {

// Finds the humanoid bones of a skeleton: by the usual names, and by topology (a root with two legs
// and, above it, two arms and a head) if names are missing or contradict it. `world` is the posture
// (nodes, as from world_transforms) that determines left and right, up and down. Neck, head and
// toes may stay unmapped, each with a doubt; any other missing bone is an error that names it and
// the joints found instead.
//
// Names: motion capture (LeftUpLeg; LeftHip, LeftKnee; CMU's lfemur), Mixamo, Blender and Rigify,
// Unreal, Xsens, VRM, VRoid, 3ds Max, Poser, SMPL, Kinect and MMD, in any case and with any
// separators. An ambiguous word (LeftShoulder, LeftLeg, LeftFoot) is interpreted by its chain. Of
// coinciding joints the first is the bone; but a hip or neck joint at the position of its parent is
// a helper, and the next one is the bone. If the limbs' names are incomplete, all limbs are found
// by shape, and names only determine the sides; without names the feet do. Hips are the junction of
// legs and spine, or a bone of that name just above. Spine, chest and upper chest are the joints
// from there to the junction of the arms, of more than three those nearest to kSpineShares of the
// distance to the neck; a shoulder is the first joint from there to the upper arm. A skeleton
// without these causes no doubt.
//
// `given`: bones stated by the file itself (VRM). They have priority over names if consistent: a
// limb with all its joints, each below the one before, hips above the legs, a neck and a head above
// the arms, toes below the foot. Omitted or contradicted bones are found as above, except for an
// omitted shoulder; for a limb or the hips this is reported as a doubt.
//
// `asked`: bones assigned by the user. They have priority over everything else; names and shape
// determine the rest, but if any spine bone is assigned, other spine bones stay unmapped. Fails if
// an assigned node has the wrong place in the hierarchy.
//
// `skin`: the mesh in the same posture; it determines the direction of feet without children.
[[nodiscard]] Result<HumanoidMap> find_humanoid(const Skeleton& skeleton,
                                                const std::vector<Transformd>& world,
                                                const HumanoidMap& given = {},
                                                const HumanoidMap& asked = {},
                                                std::span<const SkinVertex> skin = {});

}  // namespace shigusa
