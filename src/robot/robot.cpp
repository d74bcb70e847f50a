// SPDX-License-Identifier: MIT
#include "robot/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/motion.hpp>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "human/landmark_points.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/humanoid_names.hpp"

namespace shigusa {
namespace {

// Determines left and right by the axes if neither names nor feet do: robots have z up and y to the
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

// Hand of an arm without a named one: robots have joints within the forearm, and the hand is the
// last link, or the first of those at one wrist.
int hand_beyond(const Robot& robot, const std::vector<Transformd>& places, int elbow, int hand) {
  constexpr double kOneWrist = 0.35;  // of the way from the elbow to the last link
  constexpr double kForearm = 0.5;
  const auto apart = [&](int a, int b) {
    return norm(places[index(a)].translation - places[index(b)].translation);
  };
  std::vector<int> links{hand};
  for (bool goes_on = true; goes_on;) {
    std::vector<int> next;
    for (const Robot::Joint& joint : robot.joints) {
      if (joint.parent != links.back() || !joint.turns) continue;
      const std::string& name = robot.links[index(joint.child)].name;
      if (read_bone_name(name).part != BonePart::ornament) next.push_back(joint.child);
    }
    goes_on = next.size() == 1 && !is_digit(robot.links[index(next[0])].name);
    if (goes_on) links.push_back(next[0]);
  }
  const double length = apart(elbow, links.back());
  std::size_t wrist = links.size() - 1;
  while (wrist > 0 && apart(links[wrist - 1], links[wrist]) <= kOneWrist * length &&
         apart(elbow, links[wrist - 1]) >= kForearm * length) {
    --wrist;
  }
  return links[wrist];
}

// First link of a foot's ankle: its joints nearly coincide, and a name may mark only the last of
// them.
int ankle_of(const std::vector<Transformd>& places, const std::vector<int>& parent, int shank,
             int foot) {
  constexpr double kOneAnkle = 0.1;  // of the shank
  const auto apart = [&](int a, int b) {
    return norm(places[index(a)].translation - places[index(b)].translation);
  };
  const double near = kOneAnkle * apart(shank, foot);
  int ankle = foot;
  for (int i = parent[index(foot)]; i >= 0 && i != shank; i = parent[index(i)]) {
    if (apart(i, foot) <= near) ankle = i;
  }
  return ankle;
}

bool is_toe(std::string_view link) { return read_bone_name(link).part == BonePart::toes; }

}  // namespace

bool is_digit(const std::string& link) {
  const std::string name = lower(link);
  for (const char* word : {"grip", "finger", "thumb", "jaw"}) {
    if (name.find(word) != name.npos) return true;
  }
  return false;
}

std::array<Vec3d, 8> box_corners(const Vec3d& half) {
  std::array<Vec3d, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                  (k & 4) != 0 ? half.z : -half.z};
  }
  return corners;
}

std::array<Vec3d, 8> Robot::Shape::corners() const {
  std::array<Vec3d, 8> corners = box_corners(half);
  for (Vec3d& corner : corners) corner = place * corner;
  return corners;
}

std::vector<Vec3d> Robot::Link::corners() const {
  std::vector<Vec3d> all;
  for (const Shape& shape : collides) {
    const auto eight = shape.corners();
    all.insert(all.end(), eight.begin(), eight.end());
  }
  return all;
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
  // only the positions of links are comparable with a person's; their axes are not
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
  for (const Side side : kBothSides) {
    const auto& [hip, knee, ankle] = leg_bones(side);
    if (map && asked[ankle] < 0) {
      (*map)[ankle] = ankle_of(places, parent, (*map)[knee], (*map)[ankle]);
    }
    const auto& [shoulder, elbow, hand] = arm_bones(side);
    if (!map || asked[hand] >= 0) continue;
    int& end = (*map)[hand];
    const BonePart named = read_bone_name(robot.links[index(end)].name).part;
    if (named != BonePart::hand && named != BonePart::palm) {
      end = hand_beyond(robot, places, (*map)[elbow], end);
    }
  }
  // few robots have toes: children of a foot are sensors or soles
  if (map) {
    for (const HumanoidBone toes : {HumanoidBone::left_toes, HumanoidBone::right_toes}) {
      const int node = (*map)[toes];
      if (node >= 0 && asked[toes] < 0 && !is_toe(robot.links[index(node)].name)) {
        (*map)[toes] = -1;
      }
    }
    std::erase_if(map->doubts, [](const Message& doubt) {
      // frames on a foot have arbitrary directions, and a robot is no mirror image
      return doubt.text.starts_with("no left_toes") || doubt.text.starts_with("no right_toes") ||
             doubt.key == "feet_backwards";
    });
  }
  return map;
}

}  // namespace shigusa
