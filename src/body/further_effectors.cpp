// SPDX-License-Identifier: MIT
#include "further_effectors.hpp"

#include <algorithm>
#include <array>
#include <shigusa/motion.hpp>
#include <utility>

#include "body/joint_name.hpp"

namespace shigusa {
namespace {

struct Words {
  std::string_view node;
  std::string_view joint;
};
// of one side
constexpr std::array<Words, 6> kLimbWords{{{"upper_arm", "shoulder"},
                                           {"lower_arm", "elbow"},
                                           {"upper_leg", "hip"},
                                           {"lower_leg", "knee"},
                                           {"ankle", "foot"},
                                           {"hand", "wrist"}}};

// "left_", "right_" or nothing
std::string_view side_of(std::string_view name) {
  return name.substr(0, name.size() - without_side(name).size());
}

bool moves(const BodyDefinition& body, int dof, int link) {
  for (; link != kBaseLink; link = body.dofs[static_cast<std::size_t>(link)].parent) {
    if (link == dof) return true;
  }
  return false;
}

// First degree of freedom of a link's limb: shoulder or hip, or the neck; for the trunk and the
// standing leg that of the base.
int limb_root(const BodyDefinition& body, int link) {
  int pelvis = kBaseLink;
  for (const BodyNode& node : body.nodes) {
    if (node.name == humanoid_bone_name(HumanoidBone::hips)) pelvis = node.link;
  }
  const int count = static_cast<int>(body.dofs.size());
  for (int d = 0; d < count; ++d) {
    const JointKind joint = body.dofs[static_cast<std::size_t>(d)].part.joint_kind;
    const bool root =
        joint == JointKind::shoulder || joint == JointKind::hip || joint == JointKind::neck;
    if (root && moves(body, d, link) && !moves(body, d, pelvis)) return d;
  }
  int first = link;
  while (body.dofs[static_cast<std::size_t>(first)].parent != kBaseLink) {
    first = body.dofs[static_cast<std::size_t>(first)].parent;
  }
  return first;
}

// Goal name of a node. A foot is its sole's node; if that is below an ankle of several links, as in
// robots, the node of its name is the ankle's.
std::string word_of_node(const BodyDefinition& body, const std::string& node) {
  const std::string side(side_of(node));
  if (!side.empty() && node.substr(side.size()) == "shoulder") return side + "clavicle";
  for (const Foot& foot : body.feet) {
    if (foot.node == node) return foot.name;
    if (foot.name == node) return side + "ankle";
  }
  return joint_word(node);
}

}  // namespace

std::string joint_word(std::string_view name) {
  if (name == "pelvis") return "hips";
  const std::string_view side = side_of(name);
  for (const Words& words : kLimbWords) {
    if (side.empty() || name.substr(side.size()) != words.node) continue;
    return std::string(side) + std::string(words.joint);
  }
  return std::string(name);
}

std::vector<Effector> further_effectors(const BodyDefinition& body) {
  std::vector<Effector> further;
  const auto known = [&](const std::string& name, const std::string& node) {
    const auto same = [&](const Effector& e) { return e.name == name || e.node == node; };
    return std::any_of(body.effectors.begin(), body.effectors.end(), same) ||
           std::any_of(further.begin(), further.end(), same);
  };
  for (const BodyNode& node : body.nodes) {
    if (node.name.empty() || node.link == kBaseLink) continue;
    const std::string name = word_of_node(body, node.name);
    if (known(name, node.name)) continue;
    further.push_back({.name = name,
                       .node = node.name,
                       .link = node.link,
                       .point = node.point,
                       .limb_root = limb_root(body, node.link),
                       .part = parse_joint_name(name)});
    for (const NodePlace& place : body.places) {
      if (place.node == node.name) further.back().point = place.point;
    }
  }
  return further;
}

}  // namespace shigusa
