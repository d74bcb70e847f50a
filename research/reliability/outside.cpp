// SPDX-License-Identifier: MIT
#include "outside.hpp"

#include <cmath>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>

#include "character/character_rig.hpp"
#include "document/character_export.hpp"

namespace shigusa::bench {

Transformd in_our_world(const Transformd& place, const CharacterSpec& character, double unit) {
  if (!character.rig || !character.rig->rig.placement.mirrored()) {
    return {place.rotation, place.translation * unit};
  }
  const Placement& file = character.rig->rig.placement;
  const Mat3d axes = transpose(Mat3d{file.left, file.up, file.ahead});
  return {axes * place.rotation * transpose(axes),
          file.to_world(place.translation * (unit / file.unit))};
}

double OutsideMotion::slide(const std::string& node) const {
  double most = 0.0;
  for (std::size_t f = 0; f < frames(); ++f) {
    most = std::fmax(most, norm(at(node, f).translation - at(node, 0).translation));
  }
  return most;
}

double OutsideMotion::tilt(const std::string& node) const {
  double most = 0.0;
  for (std::size_t f = 0; f < frames(); ++f) {
    most = std::fmax(most,
                     norm(rotation_vector(at(node, f).rotation * transpose(at(node, 0).rotation))));
  }
  return most;
}

double OutsideMotion::tilt(const std::string& node, const std::string& to) const {
  const auto line = [&](std::size_t f) {
    return normalized(at(to, f).translation - at(node, f).translation);
  };
  double most = 0.0;
  for (std::size_t f = 0; f < frames(); ++f) most = std::fmax(most, norm(cross(line(0), line(f))));
  return most;
}

std::string knee_of(const std::string& node) {
  if (node == "left_upper_leg") return "left_lower_leg";
  return node == "right_upper_leg" ? "right_lower_leg" : "";
}

bool OutsideMotion::finite() const {
  for (const std::vector<Transformd>& frame : places) {
    for (const Transformd& node : frame) {
      const Vec3d& p = node.translation;
      if (!std::isfinite(p.x + p.y + p.z)) return false;
    }
  }
  return true;
}

OutsideMotion motion_of_bvh(std::string_view bvh, const CharacterSpec& character,
                            const BodyModel& body) {
  const SkeletonMotion file = parse_bvh(bvh, "exported.bvh").value();
  OutsideMotion motion;
  std::map<int, std::size_t> in_file;  // by the rig's node
  if (character.rig) {
    const std::vector<int> order = bvh_order(character.rig->skeleton);
    for (std::size_t k = 0; k < order.size(); ++k) in_file[order[k]] = k;
  }
  for (const BodyNode& node : body.nodes()) {
    if (node.name.empty()) continue;
    const int index =
        character.rig ? rig_node(character, node.name) : file.skeleton.find(node.name);
    if (index < 0) continue;
    motion.nodes[node.name] = character.rig ? in_file.at(index) : static_cast<std::size_t>(index);
  }
  for (std::size_t i = 0; !character.rig && i < file.skeleton.nodes.size(); ++i) {
    const SkeletonNode& node = file.skeleton.nodes[i];
    if (!node.end_site) continue;
    motion.nodes[file.skeleton.nodes[static_cast<std::size_t>(node.parent)].name + ".end"] = i;
  }
  const double unit = character.rig ? bvh_unit(character) : BvhFormat{}.unit;
  for (int f = 0; f < file.clip.frames; ++f) {
    std::vector<Transformd> places = world_transforms(file.skeleton, file.clip, f);
    for (Transformd& place : places) place = in_our_world(place, character, unit);
    motion.places.push_back(std::move(places));
  }
  return motion;
}

OutsideMotion motion_of_robot(const std::vector<RobotTree::Places>& places) {
  OutsideMotion motion;
  for (const RobotTree::Places& row : places) {
    std::vector<Transformd>& frame = motion.places.emplace_back();
    for (const auto& [link, place] : row) {
      motion.nodes.emplace(link, frame.size());
      frame.push_back(place);
    }
  }
  return motion;
}

}  // namespace shigusa::bench
