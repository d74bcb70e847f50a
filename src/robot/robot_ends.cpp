// SPDX-License-Identifier: MIT
// Missing ends of a robot's limbs: hands and feet of terminal links, and ankles.
#include <algorithm>
#include <optional>
#include <utility>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "human/landmark_points.hpp"
#include "rig/humanoid_names.hpp"
#include "robot/robot.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Joint to the parent of a link, or -1.
int carrier_of(const Robot& robot, int link) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const Robot::Joint& joint) { return joint.child == link; });
  return found == robot.joints.end() ? -1 : static_cast<int>(found - robot.joints.begin());
}

// End of a limb's last link, in its frame, with the evidence for it.
struct LinkEnd {
  Vec3d at{};
  Message by;
};

// End of a link: that of its shapes, if beyond its centre of mass; else at twice the distance of
// that; else, without either, in proportion to the previous segment as a person's forearm to the
// upper arm; a shank would be a quarter longer.
LinkEnd end_of(const Robot& robot, int link) {
  constexpr double kShortest = 0.02;  // m
  constexpr double kAside = 0.2;      // of their reach, the shapes' middle from the joint
  constexpr double kForearm = F::kForearm / F::kUpperArm;
  const Robot::Link& l = robot.links[index(link)];
  Vec3d mean{};
  const std::vector<Vec3d> corners = l.corners();
  for (const Vec3d& c : corners) mean += c * (1.0 / static_cast<double>(corners.size()));
  double length = 0.0;
  for (const Vec3d& c : corners) length = max(length, dot(c, normalized(mean, {})));
  if (length > max(norm(l.com), kShortest) && norm(mean) > kAside * length) {
    return {normalized(mean) * length, say("where_shapes_end")};
  }
  if (2.0 * norm(l.com) > kShortest) return {l.com * 2.0, say("twice_its_centre")};
  const std::vector<Transformd> places = robot_places(robot);
  const int carrier = carrier_of(robot, link);
  if (carrier < 0 || !robot.joints[index(carrier)].turns) return {};
  for (int joint = carrier; joint >= 0;
       joint = carrier_of(robot, robot.joints[index(joint)].parent)) {
    const Vec3d before = places[index(link)].translation -
                         places[index(robot.joints[index(joint)].parent)].translation;
    if (norm(before) <= kShortest) continue;
    return {transpose_times(places[index(link)].rotation, before * kForearm),
            say("as_a_persons_would")};
  }
  return {};
}

// Moves a link's frame; its contents stay in place.
void move_frame(Robot& robot, int link, const Vec3d& by) {
  Robot::Link& moved = robot.links[index(link)];
  moved.com = moved.com - by;
  for (auto* shapes : {&moved.collides, &moved.shown}) {
    for (Robot::Shape& shape : *shapes) shape.place.translation += -by;
  }
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
  // a foot without shapes of its own has those of its shank
  const int shaped = robot.links[index(foot)].collides.empty() ? knee.child : foot;
  for (const Vec3d& corner : robot.links[index(shaped)].corners()) {
    sole = max(sole, dot(at(shaped) * corner - from, along));
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

// (links) whether a link has children other than sensors.
std::vector<bool> bearing(const Robot& robot) {
  std::vector<bool> bears(robot.links.size(), false);
  for (const Robot::Joint& joint : robot.joints) {
    const BonePart part = read_bone_name(robot.links[index(joint.child)].name).part;
    if (part != BonePart::ornament) bears[index(joint.parent)] = true;
  }
  return bears;
}

// Adds a link of that name at the end of another; false if that has no end.
bool add_end(Robot& robot, int link, const std::string& name, Message& by, double& length) {
  const LinkEnd end = end_of(robot, link);
  const bool taken = std::any_of(robot.links.begin(), robot.links.end(),
                                 [&](const Robot::Link& other) { return other.name == name; });
  if (taken || end.by.empty()) return false;
  by = end.by;
  length = norm(end.at);
  Robot::Joint fixed{.name = name + "_fixed",
                     .parent = link,
                     .child = static_cast<int>(robot.links.size()),
                     .origin = {Mat3d{}, end.at}};
  robot.links.emplace_back().name = name;
  robot.joints.push_back(std::move(fixed));
  return true;
}

}  // namespace

Robot with_hands(Robot robot) {
  const std::vector<bool> bears = bearing(robot);
  for (std::size_t i = 0; i < bears.size(); ++i) {
    const BoneName name = read_bone_name(robot.links[i].name);
    if (bears[i] || name.part != BonePart::lower_arm || name.side == NameSide::none) continue;
    const std::string hand = name.side == NameSide::left ? "left_hand" : "right_hand";
    Message by;
    double length = 0.0;
    if (!add_end(robot, static_cast<int>(i), hand, by, length)) continue;
    robot.doubts.push_back(say("arm_ends", robot.links[i].name, Metres{length}, by));
  }
  return robot;
}

std::vector<int> open_ends(const Robot& robot) {
  const std::vector<bool> bears = bearing(robot);
  std::vector<int> ends;
  for (std::size_t i = 0; i < bears.size(); ++i) {
    const int carrier = carrier_of(robot, static_cast<int>(i));
    if (bears[i] || carrier < 0 || !robot.joints[index(carrier)].turns) continue;
    ends.push_back(static_cast<int>(i));
  }
  return ends;
}

Robot with_ends(Robot robot, const std::vector<int>& links) {
  for (const int link : links) {
    const std::string name = robot.links[index(link)].name;
    Message by;
    double length = 0.0;
    if (!add_end(robot, link, name + "_end", by, length)) continue;
    robot.doubts.push_back(say("limb_ends", name, Metres{length}, by));
  }
  return robot;
}

std::vector<int> forearms_for_hands(const Robot& robot, const HumanoidMap& map) {
  constexpr double kLongest = 0.6;  // a hand, of the way from its shoulder
  const std::vector<Transformd> places = robot_places(robot);
  const std::vector<int> open = open_ends(robot);
  std::vector<int> forearms;
  for (const Side side : kBothSides) {
    const auto& [shoulder, elbow, hand] = arm_bones(side);
    const int link = map[hand];
    if (std::find(open.begin(), open.end(), link) == open.end()) continue;
    const Vec3d way = places[index(link)].translation - places[index(map[shoulder])].translation;
    if (norm(end_of(robot, link).at) >= kLongest * norm(way)) forearms.push_back(link);
  }
  return forearms.size() == 2 ? forearms : std::vector<int>();
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

}  // namespace shigusa
