// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "robot_tree.hpp"
#include "table.hpp"

namespace shigusa::bench {

// A motion as its exported file tells it: where the nodes are, by the file's own forward
// kinematics, in shigusa's world (m).
class OutsideMotion {
 public:
  // Names are those of the body; of a robot those of its file's links. The end below a node of a
  // built-in body, which has no name, is "head.end".
  std::map<std::string, std::size_t> nodes;
  std::vector<std::vector<Transformd>> places;  // [frame][node]

  [[nodiscard]] std::size_t frames() const { return places.size(); }
  [[nodiscard]] bool has(const std::string& node) const { return nodes.count(node) != 0; }
  [[nodiscard]] const Transformd& at(const std::string& node, std::size_t frame) const {
    return places[frame][nodes.at(node)];
  }
  [[nodiscard]] const Transformd& at_end(const std::string& node) const {
    return at(node, frames() - 1);
  }
  // The largest distance (m) and rotation (rad) of a node from those of the first frame.
  [[nodiscard]] double slide(const std::string& node) const;
  [[nodiscard]] double tilt(const std::string& node) const;
  // of the line to another node
  [[nodiscard]] double tilt(const std::string& node, const std::string& to) const;
  [[nodiscard]] bool finite() const;
};

// The node below a thigh; of others none.
[[nodiscard]] std::string knee_of(const std::string& node);

// A place of a character's file in shigusa's world; a mirrored file keeps its own axes.
[[nodiscard]] Transformd in_our_world(const Transformd& place, const CharacterSpec& character,
                                      double unit);

// A person's motion by the exported BVH.
[[nodiscard]] OutsideMotion motion_of_bvh(std::string_view bvh, const CharacterSpec& character,
                                          const BodyModel& body);
// The nodes named, by the exported GLB of a character's own glTF file.
[[nodiscard]] OutsideMotion motion_of_glb(std::string_view glb, const CharacterSpec& character,
                                          const std::vector<std::string>& nodes);
// A robot's motion by the exported CSV and its file's own tree.
[[nodiscard]] OutsideMotion motion_of_robot(const std::vector<RobotTree::Places>& places);

}  // namespace shigusa::bench
