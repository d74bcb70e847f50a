// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <vector>

#include "body/skin.hpp"

namespace shigusa {

// Finds the humanoid bones of a skeleton: by the usual names, and by topology (a root with two
// legs and, above it, two arms and a head) where names say nothing or contradict it. `world` is the
// posture that tells left from right and up from down (nodes, as world_transforms gives). Neck,
// head and toes may stay unmapped, each with a doubt; any other missing bone is an error that names
// it and what was found instead.
//
// Names: motion capture (LeftUpLeg; LeftHip, LeftKnee; CMU's lfemur), Mixamo, Blender and Rigify,
// Unreal, Xsens, VRM, VRoid, 3ds Max, Poser, SMPL, Kinect and MMD, in any case and with any
// separators. A word of two meanings (LeftShoulder, LeftLeg, LeftFoot) is read by the chain that it
// stands in. Of joints at one point the bone is the first; but a hip or neck joint at the very
// place of its parent is a helper, and the next one is the bone. If the limbs' names are
// incomplete, all limbs are found by shape, and the names tell only the sides; without those the
// feet do. Hips are where legs and spine meet, or what is called so just above. Spine, chest and
// upper chest are the joints from there to where the arms part, of more than three those that stand
// nearest to kSpineShares of the way to the neck; a shoulder is the first joint from there to the
// upper arm. A skeleton without them has no doubt about it.
//
// `given`: what the file itself tells of its bones (VRM). It goes before names where it makes
// sense: a limb with all its joints, each below the one before, hips above the legs, a neck and a
// head above the arms, toes below the foot. Bones that it leaves out or contradicts are found as
// above, but for a shoulder that it leaves out; for a limb or the hips that is a doubt.
//
// `asked`: what a person says of some bones. It goes before all else; names and shape find the
// rest, but of the spine only what is asked is taken where any of it is. Fails where such a node
// does not hang where its bone does.
//
// `skin`: the mesh in the same posture; it tells where feet point on which no node hangs.
[[nodiscard]] Result<HumanoidMap> find_humanoid(const Skeleton& skeleton,
                                                const std::vector<Transformd>& world,
                                                const HumanoidMap& given = {},
                                                const HumanoidMap& asked = {},
                                                std::span<const SkinVertex> skin = {});

}  // namespace shigusa
