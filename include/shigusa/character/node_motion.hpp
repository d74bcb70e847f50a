// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/body/skeleton.hpp>
#include <shigusa/character/character.hpp>
#include <shigusa/motion/clip.hpp>
#include <string>
#include <vector>

namespace shigusa {

// A node that a motion moves: of the character's own file where its rig is at hand, else of the
// body's skeleton.
struct CharacterNode {
  std::string name;    // in the file
  int parent = -1;     // index of an earlier node; -1 for a root
  Vec3d offset{};      // at rest in the parent, in units of node_unit
  int file_node = -1;  // of glTF: index in the file
};

// All nodes that node_motion moves, parents before children.
[[nodiscard]] std::vector<CharacterNode> character_nodes(const CharacterSpec& character,
                                                         const BodyModel& body);
// m per unit of the nodes' translations.
[[nodiscard]] double node_unit(const CharacterSpec& character);

// (frames × nodes) each node in its parent, as a character leaves in its own file.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const BodyModel& body, const Clip& clip);

}  // namespace shigusa
