// SPDX-License-Identifier: MIT
#include "robot/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <shigusa/skeleton.hpp>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "person/find_humanoid.hpp"
#include "person/humanoid_names.hpp"
#include "person/landmark_points.hpp"

namespace shigusa {
namespace {

// Where neither names nor feet tell left from right, the axes do: robots have z up and y to the
// left (ROS REP 103).
void tell_sides(const Robot& robot, const std::vector<Transformd>& places, HumanoidMap& map) {
  using Bone = HumanoidBone;
  const auto guess = std::find_if(map.doubts.begin(), map.doubts.end(), [](const Message& doubt) {
    return doubt.key == "sides_guessed";
  });
  if (guess == map.doubts.end()) return;
  const auto at = [&](Bone bone) { return places[index(map[bone])].translation; };
  const Vec3d across = at(Bone::left_upper_leg) - at(Bone::right_upper_leg);
  const Vec3d up = at(Bone::left_upper_leg) - at(Bone::left_foot);
  if (!(up.z > 0.9 * norm(up)) || !(abs(across.y) > 0.9 * norm(across))) return;
  *guess = "left and right are told by the axes of '" + robot.links[0].name + "': +y is left";
  if (across.y > 0.0) return;
  for (std::size_t k = 0; k < 3; ++k) {
    std::swap(map[leg_bones(Side::left)[k]], map[leg_bones(Side::right)[k]]);
    std::swap(map[arm_bones(Side::left)[k]], map[arm_bones(Side::right)[k]]);
  }
  std::swap(map[Bone::left_toes], map[Bone::right_toes]);
  std::swap(map[Bone::left_shoulder], map[Bone::right_shoulder]);
}

// Where a forearm ends, in its link's frame: at its shapes' end, else at twice the distance of its
// centre of mass, or nowhere.
std::optional<Vec3d> forearm_end(const Robot::Link& link) {
  constexpr double kShortestFinger = 0.02;  // m
  Vec3d along = link.com;
  if (!link.corners.empty()) {
    Vec3d mean{};
    for (const Vec3d& c : link.corners) {
      mean += c * (1.0 / static_cast<double>(link.corners.size()));
    }
    double length = 0.0;
    for (const Vec3d& c : link.corners) length = max(length, dot(c, normalized(mean)));
    along = normalized(mean) * length;
  } else {
    along = along * 2.0;
  }
  return norm(along) > kShortestFinger ? std::optional(along) : std::nullopt;
}

// The joint that a link hangs on, or -1.
int carrier_of(const Robot& robot, int link) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const Robot::Joint& joint) { return joint.child == link; });
  return found == robot.joints.end() ? -1 : static_cast<int>(found - robot.joints.begin());
}

// Moves a link's frame in it; what the link has stays where it is.
void move_frame(Robot& robot, int link, const Vec3d& by) {
  Robot::Link& moved = robot.links[index(link)];
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
  const auto at = [&](int link) { return places[index(link)]; };
  const Vec3d from = at(knee.child).translation;
  const Vec3d along = normalized(at(foot).translation - from);
  double sole = 0.0;
  for (const Vec3d& corner : robot.links[index(foot)].corners) {
    sole = max(sole, dot(at(foot) * corner - from, along));
  }
  Robot::Joint& joint = robot.joints[index(fixed)];
  const Transformd child = at(joint.child);
  const double length = sole > 0.0 ? (1.0 - kAnkle) * sole : norm(at(foot).translation - from);
  move_frame(robot, joint.child,
             transpose_times(child.rotation, from + along * length - child.translation));
  joint.axis = transpose_times(child.rotation, at(knee.child).rotation * knee.axis);
  joint.turns = joint.moves = true;
  joint.name = robot.links[index(foot)].name + "_ankle";
}

bool is_toe(std::string_view link) { return read_bone_name(link).part == BonePart::toes; }

}  // namespace

std::array<Vec3d, 8> box_corners(const Vec3d& half) {
  std::array<Vec3d, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                  (k & 4) != 0 ? half.z : -half.z};
  }
  return corners;
}

void doubt_about(const std::vector<std::string>& names, const OfOne& one, const OfMany& many,
                 std::vector<Message>& doubts) {
  if (names.empty()) return;
  const std::string first = shown(names[0]);
  doubts.push_back(names.size() == 1 ? say(one, first) : say(many, names.size(), first));
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string result;
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return text.size() > kLongest ? "'" + result + "…'" : "'" + result + "'";
}

std::vector<Transformd> robot_places(const Robot& robot) {
  std::vector<const Robot::Joint*> carrier(robot.links.size(), nullptr);
  for (const Robot::Joint& joint : robot.joints) {
    carrier[index(joint.child)] = &joint;
  }
  std::vector<Transformd> places;
  for (const Robot::Joint* joint : carrier) {
    places.push_back(joint == nullptr ? Transformd{}
                                      : places[index(joint->parent)] * joint->origin);
  }
  return places;
}

Robot with_hands(Robot robot) {
  std::vector<bool> bears(robot.links.size(), false);
  for (const Robot::Joint& joint : robot.joints) bears[index(joint.parent)] = true;
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
        say("arm_ends", robot.links[i].name, Metres{norm(*end)},
            robot.links[i].corners.empty() ? say("twice_its_centre") : say("where_shapes_end")));
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
  std::vector<std::string> added;
  for (const Side side : kBothSides) {
    const auto& [thigh, shank, foot] = leg_bones(side);
    const int knee = carrier_of(robot, map[shank]);
    if (knee < 0 || !robot.joints[index(knee)].turns) continue;
    int first = -1;  // the joint by which the foot hangs on the shank
    bool turns = false;
    for (int link = map[foot]; link != map[shank];) {
      first = carrier_of(robot, link);
      if (first < 0) break;
      turns = turns || robot.joints[index(first)].turns;
      link = robot.joints[index(first)].parent;
    }
    if (first < 0 || turns) continue;
    add_ankle(robot, map[foot], robot.joints[index(knee)], first);
    added.push_back(robot.joints[index(first)].name);
  }
  if (!added.empty()) {
    robot.doubts.push_back(say("ankles_added", added[0]));
  }
  return robot;
}

Landmarks limbs_of(const Robot& robot, const HumanoidMap& map) {
  const std::vector<Transformd> places = robot_places(robot);
  const auto at = [&](HumanoidBone bone) { return places[index(map[bone])].translation; };
  Landmarks limbs;
  for (const Side side : kBothSides) {
    const auto& [hip, knee, ankle] = leg_bones(side);
    const auto& [shoulder, elbow, wrist] = arm_bones(side);
    limbs.leg(side) = {at(hip), at(knee), at(ankle), {}};
    limbs.arm(side) = {at(shoulder), at(elbow), at(wrist), {}};
  }
  return limbs;
}

Result<HumanoidMap> find_humanoid(const Robot& robot, const HumanoidMap& asked) {
  const std::vector<Transformd> places = robot_places(robot);
  std::vector<int> parent(robot.links.size(), -1);
  for (const Robot::Joint& joint : robot.joints) {
    parent[index(joint.child)] = joint.parent;
  }
  // only where a link stands tells of a person; how its axes lie does not
  Skeleton skeleton;
  std::vector<Transformd> world;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Vec3d& at = places[i].translation;
    const Vec3d from = parent[i] < 0 ? Vec3d{} : places[index(parent[i])].translation;
    skeleton.nodes.push_back({robot.links[i].name, parent[i], at - from});
    world.push_back({Mat3d{}, at});
  }
  Result<HumanoidMap> map = find_humanoid(skeleton, world, {}, asked);
  if (map) tell_sides(robot, places, *map);
  // few robots have toes: what hangs on a foot is a sensor or a sole
  if (map) {
    for (const HumanoidBone toes : {HumanoidBone::left_toes, HumanoidBone::right_toes}) {
      const int node = (*map)[toes];
      if (node >= 0 && asked[toes] < 0 && !is_toe(robot.links[index(node)].name)) {
        (*map)[toes] = -1;
      }
    }
    std::erase_if(map->doubts, [](const Message& doubt) {
      // frames on a foot point anywhere, and a robot is no mirror image
      return doubt.text.starts_with("no left_toes") || doubt.text.starts_with("no right_toes") ||
             doubt.key == "feet_backwards";
    });
  }
  return map;
}

}  // namespace shigusa
