// SPDX-License-Identifier: MIT
#include <shigusa/body/robot.hpp>

namespace shigusa {

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
  // feet of robots have no toes to find
  if (map) {
    std::erase_if(map->doubts, [](const std::string& doubt) {
      return doubt.starts_with("no left_toes") || doubt.starts_with("no right_toes");
    });
  }
  return map;
}

}  // namespace shigusa
