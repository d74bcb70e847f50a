// SPDX-License-Identifier: MIT
#include <shigusa/body/robot.hpp>

#include "humanoid_names.hpp"

namespace shigusa {
namespace {

bool is_toe(std::string_view link) { return read_bone_name(link).part == BonePart::toes; }

}  // namespace

std::vector<Transformd> robot_places(const Robot& robot) {
  std::vector<const Robot::Joint*> carrier(robot.links.size(), nullptr);
  for (const Robot::Joint& joint : robot.joints) {
    carrier[static_cast<std::size_t>(joint.child)] = &joint;
  }
  std::vector<Transformd> places;
  for (const Robot::Joint* joint : carrier) {
    places.push_back(joint == nullptr
                         ? Transformd{}
                         : places[static_cast<std::size_t>(joint->parent)] * joint->origin);
  }
  return places;
}

Result<HumanoidMap> find_humanoid(const Robot& robot) {
  const std::vector<Transformd> places = robot_places(robot);
  std::vector<int> parent(robot.links.size(), -1);
  for (const Robot::Joint& joint : robot.joints) {
    parent[static_cast<std::size_t>(joint.child)] = joint.parent;
  }
  // only where a link stands tells of a person; how its axes lie does not
  Skeleton skeleton;
  std::vector<Transformd> world;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Vec3d& at = places[i].translation;
    const Vec3d from =
        parent[i] < 0 ? Vec3d{} : places[static_cast<std::size_t>(parent[i])].translation;
    skeleton.nodes.push_back({robot.links[i].name, parent[i], at - from});
    world.push_back({Mat3d{}, at});
  }
  Result<HumanoidMap> map = find_humanoid(skeleton, world);
  // few robots have toes: what hangs on a foot is a sensor or a sole
  if (map) {
    for (const HumanoidBone toes : {HumanoidBone::left_toes, HumanoidBone::right_toes}) {
      const int node = (*map)[toes];
      if (node >= 0 && !is_toe(robot.links[static_cast<std::size_t>(node)].name)) (*map)[toes] = -1;
    }
    std::erase_if(map->doubts, [](const std::string& doubt) {
      return doubt.starts_with("no left_toes") || doubt.starts_with("no right_toes");
    });
  }
  return map;
}

}  // namespace shigusa
