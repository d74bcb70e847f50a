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

// A node of a character's file at rest in its parent: translation · rotation · scale, in the file's
// units and axes.
struct RigNode {
  int parent = -1;  // index of an earlier node
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};
};

// Mapping between a character's own skeleton and its body.
struct Rig {
  std::vector<RigNode> nodes;
  HumanoidMap bones;                  // index in `nodes`
  std::array<int, 2> grips{-1, -1};   // left, right: the nodes to which goals refer
  Placement placement;                // of the nodes at rest
  Landmarks rest;                     // joints of the nodes at rest, in shigusa's world
  Landmarks start;                    // joints in the body's start posture
  std::vector<TwistBone> twists{};    // of the nodes, in any order
  std::vector<FingerBone> fingers{};  // of the nodes, in any order; axes of the nodes at rest
  bool at_ease = false;               // hands, too, are at ease in the start posture
};

// Posture of a hand's fingers at a share of the motion's time.
struct FingerKey {
  double share = 0.0;
  double flexion = 1.0;  // relative to that of HandPosture::relaxed
  double start = 0.0;    // share of the posture in which the motion starts, instead of that flexion
};

// Finger movement beside the motion of the body.
struct HandPlay {
  bool fingers = false;           // fingers take a posture; otherwise they stay as in the rig
  std::array<bool, 2> reaches{};  // left, right: the hand opens on the way and closes at the end
  // left, right: postures in the order of time, instead of `reaches`
  std::array<std::vector<FingerKey>, 2> keys{};
};

// Motion of a rig's nodes.
struct RigMotion {
  double frame_time = 1.0 / 60.0;  // s
  int frames = 0;
  std::vector<LocalTransform> local;  // (frames × nodes) each in its parent, in the rig's units
  std::vector<bool> turns;            // (nodes) whether the rotation ever differs from rest
  std::vector<bool> moves;  // (nodes) whether the translation ever differs, mostly for the hips
};

// A clip of the body as a motion of the rig: joint positions are exactly the body's, in shigusa's
// world divided by the rig's unit. (For a mirrored rig they are in the file's own axes, as no
// rotation undoes a mirror.) `in_file`: where the rig stands in its file instead, in its axes.
//
// Each mapped bone moves rigidly with the link of the body's node of that name, from its rest pose:
// R_node(t) = R_link(t) R_link(0)ᵀ F_start F_restᵀ R_node(rest), F the segment's frames in the two
// postures. A bone with a name unknown to the body moves with the bone above it, as do all nodes
// between bones; nodes above the hips stay. Twist bones have a share of their limb's twist by their
// position along it: next to a shoulder or hip none of its turn about the limb's line, at an elbow
// none of the forearm's, and at hand and foot all of it. Forearms with such bones, and upper limbs
// with some between their bone and the next one, have no twist of their own; joints, hands and feet
// are unaffected. For a half body, whose left leg moves with its right one, the left bones turn as
// the right ones do and stay connected.
//
// Below a non-uniform scale a turned bone would be sheared, which no rotation expresses:
// translations still place joints and grips exactly.
//
// Finger turns are added, see rig_fingers.hpp: no goal and no criterion depends on them.
[[nodiscard]] RigMotion rig_motion(const PosedBody& body, const Clip& clip, const Rig& rig,
                                   const HandPlay& hands = {}, bool in_file = false);

}  // namespace shigusa
