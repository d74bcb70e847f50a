// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "body/skin.hpp"

namespace shigusa {

enum class Finger { thumb, index, middle, ring, little };
inline constexpr int kFingerCount = 5;
// A finger's joints from the palm on: 1 is the knuckle (metacarpophalangeal joint), 2 and 3 those
// between phalanges; of the thumb 1 is the joint at the wrist (carpometacarpal).
inline constexpr int kFingerJoints = 3;

// Bone of a finger: the node at its proximal joint, about which it bends.
struct FingerBone {
  int node = -1;
  Side side = Side::left;
  Finger finger = Finger::index;
  int joint = 1;      // 1..kFingerJoints
  Vec3d axis{};       // unit, file's world: rotation axis of positive flexion, towards the palm
  double bent = 0.0;  // rad, flexion of the joint in the given posture
};

// VRM 1.0 name of a finger's bone, such as "leftIndexProximal" or "leftThumbMetacarpal".
[[nodiscard]] std::string vrm_finger_name(const FingerBone& bone);

// Bones of a skeleton's fingers with their bending axes, in the posture `world` (nodes, in the
// file's axes, in any unit). `mirrored`: whether left and right are exchanged in them.
//
// A hand has fingers if two or more besides the thumb are below its node and have names (index,
// pinky, "Finger11", "左人指"); `named` (VRM) has priority over names. Metacarpals are left out.
//
// The palm is the plane through the wrist and the knuckles. Its inner side follows from the side of
// the body and the direction from the little finger to the index, so that the bones' own axes are
// not used. A finger bends about the axis in that plane perpendicular to itself. The thumb bends
// about the axis that brings it to a point before the first knuckles, at half a palm's length
// (opposition).
[[nodiscard]] std::vector<FingerBone> find_finger_bones(
    const Skeleton& skeleton, const std::vector<Transformd>& world, const HumanoidMap& map,
    const std::vector<std::pair<std::string, int>>& named, bool mirrored);

// The two postures of hands.
enum class HandPosture {
  open,     // greatest opening of a hand on its way to a goal
  relaxed,  // grip about an object of some 4 cm: the functional position
};

// Flexion of a joint (rad), 0 for a straight finger; for the thumb's joint at the wrist relative to
// the character's posture.
//
// Relaxed: knuckles 45, the next joints 30, the last 20 degrees, as splints hold a hand in its
// functional position (Stedman's Medical Dictionary, "functional hand position"), as the mean of
// four fingers, which are "more and more flexed from index to little finger" (Taylor and Schwarz
// 1955, "The anatomy and mechanics of the human hand"); the thumb is opposed. Open: a fifth of it.
[[nodiscard]] double flexion(HandPosture posture, Finger finger, int joint);
// Mean of all joints of a hand.
[[nodiscard]] double mean_flexion(HandPosture posture);
// The open posture's flexions relative to the relaxed one's.
inline constexpr double kOpenShare = 0.2;

// Vertices of the mesh with the hands' fingers in their relaxed posture; `fingers` and the mesh
// belong to the posture `world` (nodes).
[[nodiscard]] std::vector<SkinVertex> relaxed_hands(const Skeleton& skeleton,
                                                    const std::vector<Transformd>& world,
                                                    const HumanoidMap& map,
                                                    const std::vector<FingerBone>& fingers,
                                                    std::span<const SkinVertex> skin);

}  // namespace shigusa
