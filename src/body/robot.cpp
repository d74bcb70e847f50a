// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/body/robot.hpp>
#include <utility>

#include "humanoid_names.hpp"

namespace shigusa {
namespace {

// Where neither names nor feet tell left from right, the axes do: robots have z up and y to the
// left (ROS REP 103).
void tell_sides(const Robot& robot, const std::vector<Transformd>& places, HumanoidMap& map) {
  using Bone = HumanoidBone;
  const auto guess = std::find_if(map.doubts.begin(), map.doubts.end(), [](const auto& doubt) {
    return doubt.starts_with("left and right are a guess");
  });
  if (guess == map.doubts.end()) return;
  const auto at = [&](Bone bone) {
    return places[static_cast<std::size_t>(map[bone])].translation;
  };
  const Vec3d across = at(Bone::left_upper_leg) - at(Bone::right_upper_leg);
  const Vec3d up = at(Bone::left_upper_leg) - at(Bone::left_foot);
  if (!(up.z > 0.9 * norm(up)) || !(abs(across.y) > 0.9 * norm(across))) return;
  *guess = "left and right are told by the axes of '" + robot.links[0].name + "': +y is left";
  if (across.y > 0.0) return;
  for (const auto& [left, right] :
       {std::pair(Bone::left_upper_leg, Bone::right_upper_leg),
        std::pair(Bone::left_lower_leg, Bone::right_lower_leg),
        std::pair(Bone::left_foot, Bone::right_foot), std::pair(Bone::left_toes, Bone::right_toes),
        std::pair(Bone::left_upper_arm, Bone::right_upper_arm),
        std::pair(Bone::left_lower_arm, Bone::right_lower_arm),
        std::pair(Bone::left_hand, Bone::right_hand),
        std::pair(Bone::left_shoulder, Bone::right_shoulder)}) {
    std::swap(map[left], map[right]);
  }
}

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

Result<HumanoidMap> find_humanoid(const Robot& robot, const HumanoidMap& asked) {
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
  Result<HumanoidMap> map = find_humanoid(skeleton, world, {}, asked);
  if (map) tell_sides(robot, places, *map);
  // few robots have toes: what hangs on a foot is a sensor or a sole
  if (map) {
    for (const HumanoidBone toes : {HumanoidBone::left_toes, HumanoidBone::right_toes}) {
      const int node = (*map)[toes];
      if (node >= 0 && asked[toes] < 0 &&
          !is_toe(robot.links[static_cast<std::size_t>(node)].name)) {
        (*map)[toes] = -1;
      }
    }
    std::erase_if(map->doubts, [](const std::string& doubt) {
      return doubt.starts_with("no left_toes") || doubt.starts_with("no right_toes");
    });
  }
  return map;
}

}  // namespace shigusa
