// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <shigusa/character.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/gltf.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// A character's own skeleton, on which motions are exported.
struct CharacterRig {
  std::filesystem::path file;                // name of the file
  std::shared_ptr<const std::string> bytes;  // glTF: the whole file, to which motions are added
  FileFormat format = FileFormat::bvh;       // bvh, glb or vrm, by its contents
  Skeleton skeleton;                         // names; offsets in the file's units
  Rig rig;                                   // its nodes as in the measured frame
  std::vector<GltfPlace> places;             // glTF: (nodes) at rest
  std::vector<LocalTransform> posed;         // skeleton in the measured frame, rotated from rest
  BvhChannels channels;                      // BVH only
  Vec3d ahead{0, 0, 1};                      // glTF: facing direction at rest, in its axes
  std::vector<int> file_node;                // glTF: (nodes) indices in the file
  std::vector<std::pair<std::string, int>> vrm_bones;  // VRM only
  std::vector<std::string> animations;                 // glTF: names of its animations
  int frames = 0;                // of the BVH motion, or of the animation that the start comes from
  bool stature_guessed = false;  // no unit gives a human stature
  Message not_glb;  // reason why its glTF file cannot be exported with animations; empty if it can
};

// Node of the character's file for a node of the body ("right_foot", "right_hand_grip"), or -1 if
// there is none or the spec has no rig.
[[nodiscard]] int rig_node(const CharacterSpec& spec, std::string_view body_node);

}  // namespace shigusa
