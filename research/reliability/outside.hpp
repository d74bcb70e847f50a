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

// A motion read from its exported file: placements of the nodes by the file's own forward
// kinematics, in shigusa's world (m).
class OutsideMotion {
 public:
  // Names are those of the body; for a robot those of its file's links. The unnamed end below a
  // node of a built-in body is "head.end".
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
  // Largest displacement (m) and rotation (rad) of a node since the first frame.
  [[nodiscard]] double slide(const std::string& node) const;
  [[nodiscard]] double tilt(const std::string& node) const;
  // distance to the line to another node
  [[nodiscard]] double tilt(const std::string& node, const std::string& to) const;
  [[nodiscard]] bool finite() const;
};

// Node below a thigh; empty for others.
[[nodiscard]] std::string knee_of(const std::string& node);

// Transform from a character's file to shigusa's world; a mirrored file keeps its own axes.
[[nodiscard]] Transformd in_our_world(const Transformd& place, const CharacterSpec& character,
                                      double unit);

// A person's motion from the exported BVH.
[[nodiscard]] OutsideMotion motion_of_bvh(std::string_view bvh, const CharacterSpec& character,
                                          const BodyModel& body);
// Named nodes from the exported GLB of a character's own glTF file.
[[nodiscard]] OutsideMotion motion_of_glb(std::string_view glb, const CharacterSpec& character,
                                          const std::vector<std::string>& nodes);
// A robot's motion from the exported CSV and its file's own tree.
[[nodiscard]] OutsideMotion motion_of_robot(const std::vector<RobotTree::Places>& places);

}  // namespace shigusa::bench
