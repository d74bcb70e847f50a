// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>
#include <vector>

#include "measure/measure_person.hpp"
#include "rig/finger_bones.hpp"
#include "rig/twist_bones.hpp"

namespace shigusa {

// A node of a character's file as it stands at rest in its parent: translation · rotation · scale,
// in the file's units and axes.
struct RigNode {
  int parent = -1;  // index of an earlier node
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};
};

// The tie between a character's own skeleton and its body.
struct Rig {
  std::vector<RigNode> nodes;
  HumanoidMap bones;                  // index in `nodes`
  std::array<int, 2> grips{-1, -1};   // left, right: the nodes that goals are given for
  Placement placement;                // of the nodes at rest
  Landmarks rest;                     // joints of the nodes at rest, in shigusa's world …
  Landmarks start;                    // … and in the body's start posture
  std::vector<TwistBone> twists{};    // of the nodes, in any order
  std::vector<FingerBone> fingers{};  // of the nodes, in any order; axes as the nodes stand at rest
  bool at_ease = false;               // hands too are at ease in the start posture
};

// The play of hands beside the motion of the body.
struct HandPlay {
  bool fingers = false;           // they are laid in a posture, else they stay as the rig has them
  std::array<bool, 2> reaches{};  // left, right: it opens on the way and closes at the end
};

// How a rig's nodes move.
struct RigMotion {
  double frame_time = 1.0 / 60.0;  // s
  int frames = 0;
  std::vector<LocalTransform> local;  // (frames × nodes) each in its parent, in the rig's units
  std::vector<bool> turns;            // (nodes) the rotation is not that of rest in every frame
  std::vector<bool> moves;            // (nodes) the translation is not: the hips, mostly
};

// A clip of the body as a motion of the rig: joints stand exactly where the body's do, in
// shigusa's world divided by the rig's unit. (Of a mirrored rig they stand in the file's own axes,
// as no rotation leads out of a mirror.)
//
// Each mapped bone goes rigidly with the link of the body's node of that name, from where it stands
// at rest: R_node(t) = R_link(t) R_link(0)ᵀ F_start F_restᵀ R_node(rest), F the segment's frames
// in the two postures. A bone whose name the body has not goes with the bone above
// it, and so do all nodes between bones; what stands above the hips stays. Twist bones have a share
// of their limb's twist by their place along it: next to a shoulder or hip none of its turn about
// the limb's line, at an elbow none of the forearm's, and at hand and foot all of it. Forearms with
// such bones, and upper limbs with some between their bone and the next one, go without a twist
// themselves; joints, hands and feet stand where they would. Of a half body, whose
// left leg goes as its right one, the left bones turn as the right ones and stay on one another.
//
// Below a scale that is not the same along its axes a turned bone would be sheared, which no
// rotation tells: joints and grips stand exactly all the same, as translations make up for it.
//
// Fingers are turned on top of that, see rig_fingers.hpp: no goal and no criterion knows them.
[[nodiscard]] RigMotion rig_motion(const BodyModel& body, const Clip& clip, const Rig& rig,
                                   const HandPlay& hands = {});

}  // namespace shigusa
