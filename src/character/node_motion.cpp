// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>

#include "character/character_rig.hpp"
#include "kinematics/rig.hpp"
#include "kinematics/skeleton_motion.hpp"

namespace shigusa {

std::vector<CharacterNode> character_nodes(const CharacterSpec& character, const BodyModel& body) {
  std::vector<CharacterNode> nodes;
  if (!character.rig) {
    for (const SkeletonNode& node : body_skeleton(body).nodes) {
      nodes.push_back({node.name, node.parent, node.offset});
    }
    return nodes;
  }
  const CharacterRig& rig = *character.rig;
  for (std::size_t i = 0; i < rig.rig.nodes.size(); ++i) {
    const int file_node = i < rig.file_node.size() ? rig.file_node[i] : -1;
    nodes.push_back({rig.skeleton.nodes[i].name, rig.rig.nodes[i].parent,
                     rig.rig.nodes[i].translation, file_node});
  }
  return nodes;
}

double node_unit(const CharacterSpec& character) {
  return character.rig ? character.rig->rig.placement.unit : 1.0;
}

std::vector<LocalTransform> node_motion(const CharacterSpec& character, const BodyModel& body,
                                        const Clip& clip) {
  if (!character.rig) return skeleton_motion(body, clip).clip.local;
  return rig_motion(body, clip, character.rig->rig).local;
}

}  // namespace shigusa
