// SPDX-License-Identifier: MIT
#include "robot/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <shigusa/skeleton.hpp>
#include <utility>

#include "person/find_humanoid.hpp"
#include "person/humanoid_names.hpp"

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

// Where a forearm ends, in its link's frame: at its shapes' end, else at twice the distance of its
// centre of mass, or nowhere.
std::optional<Vec3d> forearm_end(const Robot::Link& link) {
  constexpr double kShortest = 0.02;  // m
  Vec3d along = link.com;
  if (!link.corners.empty()) {
    Vec3d mean{};
    for (const Vec3d& c : link.corners)
      mean += c * (1.0 / static_cast<double>(link.corners.size()));
    double length = 0.0;
    for (const Vec3d& c : link.corners) length = max(length, dot(c, normalized(mean)));
    along = normalized(mean) * length;
  } else {
    along = along * 2.0;
  }
  return norm(along) > kShortest ? std::optional(along) : std::nullopt;
}

// The joint that a link hangs on, or -1.
int carrier_of(const Robot& robot, int link) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const Robot::Joint& joint) { return joint.child == link; });
  return found == robot.joints.end() ? -1 : static_cast<int>(found - robot.joints.begin());
}

// Moves a link's frame in it; what the link has stays where it is.
void move_frame(Robot& robot, int link, const Vec3d& by) {
  Robot::Link& moved = robot.links[static_cast<std::size_t>(link)];
  moved.com = moved.com - by;
  for (Vec3d& corner : moved.corners) corner = corner - by;
  for (Robot::Joint& joint : robot.joints) {
    if (joint.parent == link) joint.origin.translation += -by;
    if (joint.child == link) joint.origin.translation += joint.origin.rotation * by;
  }
}

// Makes a fixed joint between shank and foot an ankle that turns about the knee's axis.
void add_ankle(Robot& robot, int foot, const Robot::Joint& knee, int fixed) {
  constexpr double kAnkle = 0.137;  // of the way from a person's knee to the sole, from the sole
  const std::vector<Transformd> places = robot_places(robot);
  const auto at = [&](int link) { return places[static_cast<std::size_t>(link)]; };
  const Vec3d from = at(knee.child).translation;
  const Vec3d along = normalized(at(foot).translation - from);
  double sole = 0.0;
  for (const Vec3d& corner : robot.links[static_cast<std::size_t>(foot)].corners) {
    sole = max(sole, dot(at(foot) * corner - from, along));
  }
  Robot::Joint& joint = robot.joints[static_cast<std::size_t>(fixed)];
  const Transformd child = at(joint.child);
  const double length = sole > 0.0 ? (1.0 - kAnkle) * sole : norm(at(foot).translation - from);
  move_frame(robot, joint.child,
             transpose_times(child.rotation, from + along * length - child.translation));
  joint.axis = transpose_times(child.rotation, at(knee.child).rotation * knee.axis);
  joint.turns = joint.moves = true;
  joint.name = robot.links[static_cast<std::size_t>(foot)].name + "_ankle";
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

Robot with_hands(Robot robot) {
  std::vector<bool> bears(robot.links.size(), false);
  for (const Robot::Joint& joint : robot.joints)
    bears[static_cast<std::size_t>(joint.parent)] = true;
  const auto taken = [&](const std::string& name) {
    return std::any_of(robot.links.begin(), robot.links.end(),
                       [&](const Robot::Link& link) { return link.name == name; });
  };
  for (std::size_t i = 0; i < bears.size(); ++i) {
    const BoneName name = read_bone_name(robot.links[i].name);
    if (bears[i] || name.part != BonePart::lower_arm || name.side == NameSide::none) continue;
    const std::string hand = name.side == NameSide::left ? "left_hand" : "right_hand";
    const std::optional<Vec3d> end = forearm_end(robot.links[i]);
    if (!end || taken(hand)) continue;
    robot.doubts.push_back(
        fmt::format("link '{}' ends its arm: the hand is taken to be {:.2f} m on, {}",
                    robot.links[i].name, norm(*end),
                    robot.links[i].corners.empty() ? "twice as far as its centre of mass"
                                                   : "where its shapes end"));
    Robot::Joint fixed{.name = hand + "_fixed",
                       .parent = static_cast<int>(i),
                       .child = static_cast<int>(robot.links.size()),
                       .origin = {Mat3d{}, *end}};
    robot.links.emplace_back().name = hand;
    robot.joints.push_back(std::move(fixed));
  }
  return robot;
}

Robot with_ankles(Robot robot, const HumanoidMap& map) {
  using Bone = HumanoidBone;
  std::vector<std::string> added;
  for (const auto& [shank, foot] : {std::pair(Bone::left_lower_leg, Bone::left_foot),
                                    std::pair(Bone::right_lower_leg, Bone::right_foot)}) {
    const int knee = carrier_of(robot, map[shank]);
    if (knee < 0 || !robot.joints[static_cast<std::size_t>(knee)].turns) continue;
    int first = -1;  // the joint by which the foot hangs on the shank
    bool turns = false;
    for (int link = map[foot]; link != map[shank];) {
      first = carrier_of(robot, link);
      if (first < 0) break;
      turns = turns || robot.joints[static_cast<std::size_t>(first)].turns;
      link = robot.joints[static_cast<std::size_t>(first)].parent;
    }
    if (first < 0 || turns) continue;
    add_ankle(robot, map[foot], robot.joints[static_cast<std::size_t>(knee)], first);
    added.push_back(robot.joints[static_cast<std::size_t>(first)].name);
  }
  if (!added.empty()) {
    robot.doubts.push_back(fmt::format(
        "the legs have no ankles: joints that the file lacks, '{}' the first, are added, about the "
        "axes of the knees",
        added[0]));
  }
  return robot;
}

Landmarks limbs_of(const Robot& robot, const HumanoidMap& map) {
  const std::vector<Transformd> places = robot_places(robot);
  const auto at = [&](HumanoidBone bone) {
    return places[static_cast<std::size_t>(map[bone])].translation;
  };
  using Bone = HumanoidBone;
  Landmarks limbs;
  limbs.left_leg = {at(Bone::left_upper_leg), at(Bone::left_lower_leg), at(Bone::left_foot), {}};
  limbs.right_leg = {
      at(Bone::right_upper_leg), at(Bone::right_lower_leg), at(Bone::right_foot), {}};
  limbs.left_arm = {at(Bone::left_upper_arm), at(Bone::left_lower_arm), at(Bone::left_hand), {}};
  limbs.right_arm = {
      at(Bone::right_upper_arm), at(Bone::right_lower_arm), at(Bone::right_hand), {}};
  return limbs;
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
      // frames on a foot point anywhere, and a robot is no mirror image
      return doubt.starts_with("no left_toes") || doubt.starts_with("no right_toes") ||
             doubt.starts_with("the feet point backwards");
    });
  }
  return map;
}

}  // namespace shigusa
