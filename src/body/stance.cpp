// SPDX-License-Identifier: MIT
#include "body/stance.hpp"

#include <algorithm>
#include <utility>

#include "body/further_effectors.hpp"

namespace shigusa {

const Foot* base_foot(const BodyModel& body) {
  for (const Foot& foot : body.feet()) {
    if (foot.link == kBaseLink) return &foot;
  }
  return nullptr;
}

std::vector<const BodyNode*> base_nodes(const BodyModel& body) {
  std::vector<const BodyNode*> nodes;
  if (body.is_robot()) return nodes;
  for (const BodyNode& node : body.nodes()) {
    if (node.link == kBaseLink && !node.name.empty()) nodes.push_back(&node);
  }
  return nodes;
}

std::vector<std::string> goal_names(const BodyModel& body) {
  std::vector<std::string> names;
  for (int i = 0; i < body.effector_count(); ++i) names.push_back(body.effector(i).name);
  for (const BodyNode* node : base_nodes(body)) names.push_back(joint_word(node->name));
  return names;
}

BodyModel standing_on(const BodyModel& body, std::span<const std::string> feet) {
  BodyDefinition standing = body.definition();
  std::erase_if(standing.feet, [&](const Foot& foot) {
    return std::find(feet.begin(), feet.end(), foot.name) == feet.end();
  });
  return BodyModel(std::move(standing));
}

}  // namespace shigusa
