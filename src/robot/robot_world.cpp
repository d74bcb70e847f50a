// SPDX-License-Identifier: MIT
// The world in a robot's file: a massless link above the root, and the joints between them.
#include <algorithm>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "robot_builder.hpp"
#include "root_joints.hpp"

namespace shigusa {
namespace {

bool is_world(const std::string& link) {
  const std::string name = lower(link);
  constexpr std::string_view kWords[] = {"odom", "map", "universe", "ground", "floor", "static"};
  return name.starts_with("world") || name.ends_with("world") || contains(kWords, name);
}

// x ahead, y to the left, z up
Vec3d in_robot_world(const Vec3d& v) { return {v.z, v.x, v.y}; }

// Whether the joints move the root in all directions and about all axes.
bool carry(const RobotFrame& frame) {
  const Transformd rest = [&] {
    Transformd at = frame.world;
    for (const RootJoint& joint : frame.carriers) at = at * joint.origin;
    return at;
  }();
  for (int k = 0; k < 3; ++k) {
    Transformd moved = rest;
    moved.translation[k] += 0.3;
    Vec3d columns[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int next = (k + 1) % 3;
    const int last = (k + 2) % 3;
    const SinCos<double> turn = sin_cos(0.4);
    columns[next][next] = columns[last][last] = turn.cos;
    columns[next][last] = turn.sin;
    columns[last][next] = -turn.sin;
    moved.rotation = Mat3d{columns[0], columns[1], columns[2]} * rest.rotation;
    if (!root_values(frame, moved, {})) return false;
  }
  return true;
}

}  // namespace

void RobotBuilder::find_world() {
  int root = 0;
  int world = 0;  // the link that the carriers begin at
  std::string bolt;
  std::vector<std::string> floating;
  Transformd before;  // from the last of the carriers
  for (int link = 0; link != person_.pelvis && placed_.below[index(link)].size() == 1;) {
    const Robot::Link& above = robot_.links[index(link)];
    const bool bare = !(above.mass > 0.0) && above.collides.empty() && above.shown.empty();
    const auto j = index(placed_.below[index(link)][0]);
    const Robot::Joint& joint = robot_.joints[j];
    const bool follows = joint.moves && !joint.turns && !joint.slides;
    if ((!bare && !is_world(above.name)) || of_joint_[j] >= 0 || follows) break;
    link = joint.child;
    before = before * joint.origin;
    if (joint.moves) {
      const auto same = [&](const RobotJoint& each) { return each.name == joint.name; };
      const auto found = std::find_if(frame_.joints.begin(), frame_.joints.end(), same);
      frame_.carriers.push_back({static_cast<std::size_t>(found - frame_.joints.begin()), before,
                                 joint.axis, joint.slides});
      before = {};
      carrying_.push_back(joint.name);
      root = link;
    } else if (joint.floats || is_world(above.name)) {
      if (joint.floats) floating.push_back(joint.name);
      bolt = joint.floats ? "" : joint.name;
      frame_.carriers.clear();
      carrying_.clear();
      before = {};
      root = world = link;
    }
  }
  const Transformd& top = placed_.links[index(world)];
  const Mat3d& turn = top.rotation;
  frame_.world.rotation = {in_robot_world(turn.cx), in_robot_world(turn.cy),
                           in_robot_world(turn.cz)};
  const Transformd& at = placed_.links[index(root)];
  frame_.root = robot_.links[index(root)].name;
  frame_.link = link_of(root);
  frame_.root_in_link = {at.rotation, local(frame_.link, at.translation)};
  if (carrying_.empty() && floating.empty() && bolt.empty()) return;
  tell_of_world(robot_.links[index(world)].name, bolt, floating);
}

// Replaces doubts about the joints between the world and the root; other joints keep theirs.
void RobotBuilder::tell_of_world(const std::string& world, const std::string& bolt,
                                 const std::vector<std::string>& floating) {
  const bool bolted = carrying_.empty() && !bolt.empty();
  if (bolted) doubts_.push_back(say("root_bolted", shown(bolt), shown(frame_.root)));
  if (!carrying_.empty() && carry(frame_)) {
    doubts_.push_back(say("root_carried", carrying_.size(), shown(carrying_[0]), shown(world)));
  } else if (!carrying_.empty()) {
    frame_.carriers.clear();
    doubts_.push_back(
        say("root_not_carried", carrying_.size(), shown(carrying_[0]), shown(frame_.root)));
  }
  std::erase_if(doubts_, [](const Message& doubt) {
    return doubt.key == "joint_slides" || doubt.key == "joints_slide";
  });
  std::vector<std::string> sliding;
  for (const Robot::Joint& joint : robot_.joints) {
    const bool slides = joint.slides || joint.floats;
    if (slides && !contains(carrying_, joint.name) && !contains(floating, joint.name)) {
      sliding.push_back(joint.name);
    }
  }
  doubt_about(sliding, "joint_slides", "joints_slide", doubts_);
  std::erase_if(still_names_, [&](const std::string& name) { return contains(carrying_, name); });
}

}  // namespace shigusa
