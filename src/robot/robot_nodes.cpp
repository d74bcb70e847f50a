// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "robot_builder.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

constexpr std::array<const char*, 2> kSides{"left_", "right_"};

}  // namespace

void RobotBuilder::add_foot(std::size_t side) {
  const RobotSole& sole = soles_[side];
  // a foot in the air bears no load
  if (sole.corners[0].y > kLiftedFoot) return;
  const int end = person_.legs[side].end;
  Foot foot{.name = std::string(kSides[side]) + "foot",
            .node = robot_.links[index(end)].name,
            .link = link_of(end),
            .centre = {},
            .outline = {}};
  for (const Vec3d& corner : sole.corners) {
    foot.outline.push_back(local(foot.link, corner));
    foot.centre += foot.outline.back() * 0.25;
  }
  body_.feet.push_back(std::move(foot));
}

int RobotBuilder::hand_link(std::size_t side) const {
  const PersonLimb& arm = person_.arms[side];
  for (const char* word : {"grip", "palm", "hand"}) {
    for (const int link : members_[index(group_[index(arm.end)])]) {
      const int carrier = placed_.carrier[index(link)];
      const bool at_joint = carrier >= 0 && robot_.joints[index(carrier)].turns;
      if (at_joint && link != arm.end) continue;
      const std::string name = lower(robot_.links[index(link)].name);
      const double beyond = norm(placed_.links[index(link)].translation - wrist(side));
      const bool apart = beyond > kLeastHand * body_.stature;
      if (apart && name.find(word) != name.npos) return link;
    }
  }
  return arm.end;
}

void RobotBuilder::add_hand(std::size_t side) {
  const PersonLimb& arm = person_.arms[side];
  hands_[side] = hand_link(side);
  const int link = link_of(hands_[side]);
  body_.effectors.push_back({std::string(kSides[side]) + "hand",
                             robot_.links[index(hands_[side])].name, link,
                             local(link, placed_.links[index(hands_[side])].translation),
                             dof_of(arm.joints[arm.begins[1]])});
}

void RobotBuilder::add_nodes() {
  const Vec3d hips = (hip(0) + hip(1)) * 0.5;
  name_nodes();
  const int pelvis = group_[index(person_.pelvis)];
  node_of_.resize(members_.size());
  node_of_[index(pelvis)] = add_node("hips", -1, pelvis, hips);
  for (const PersonLimb& leg : person_.legs) add_chain(leg.joints);
  add_chain(person_.spine);
  for (const PersonLimb& arm : person_.arms) add_chain(arm.joints);
  add_chain(person_.neck);
  add_head();
  for (const std::size_t side : {0u, 1u}) {
    add_hand_nodes(side);
    add_foot_nodes(side);
  }
}

void RobotBuilder::name_nodes() {
  for (const std::size_t side : {0u, 1u}) {
    const std::string prefix = kSides[side];
    const PersonLimb& leg = person_.legs[side];
    const PersonLimb& arm = person_.arms[side];
    names_.emplace(leg.joints[0].joint, prefix + "upper_leg");
    names_.emplace(hinge(leg, 1).joint, prefix + "lower_leg");
    names_.emplace(hinge(leg, 2).joint, prefix + "foot");
    names_.emplace(arm.joints[arm.begins[1]].joint, prefix + "upper_arm");
    names_.emplace(hinge(arm, 2).joint, prefix + "lower_arm");
    if (arm.begins[3] < arm.joints.size()) {
      names_.emplace(arm.joints[arm.begins[3]].joint, prefix + "hand");
    }
    for (const int link : {hands_[side], leg.end}) {
      taken_.push_back(robot_.links[index(link)].name);
    }
  }
  if (!person_.neck.empty()) {
    names_.emplace(person_.neck.back().joint, "head");
    names_.emplace(person_.neck.front().joint, "neck");
  }
}

int RobotBuilder::add_node(const std::string& name, int parent, int group, const Vec3d& world,
                           bool end_site) {
  const int link = link_of_[index(group)];
  body_.nodes.push_back({name, parent, link, local(link, world), end_site});
  return static_cast<int>(body_.nodes.size()) - 1;
}

std::string RobotBuilder::free_name(std::string name) {
  while (std::find(taken_.begin(), taken_.end(), name) != taken_.end()) name += "_joint";
  taken_.push_back(name);
  return name;
}

void RobotBuilder::add_chain(const std::vector<PersonJoint>& joints) {
  for (const PersonJoint& j : joints) {
    const Moving& m = moving_[index(of_joint_[index(j.joint)])];
    const auto name = names_.find(j.joint);
    const Robot::Joint& joint = robot_.joints[index(j.joint)];
    node_of_[index(m.outer)] =
        add_node(free_name(name != names_.end()
                               ? name->second
                               : robot_.links[index(j.outward ? joint.child : joint.parent)].name),
                 node_of_[index(m.inner)], m.outer, centre(j));
  }
}

void RobotBuilder::add_head() {
  const RobotHead head = this->head();
  int node = node_of_[index(head.group)];
  if (!head.own_joint) node = add_node(free_name("head"), node, head.group, head.joint);
  add_node("", node, head.group, head.top, true);
}

void RobotBuilder::add_hand_nodes(std::size_t side) {
  const PersonLimb& arm = person_.arms[side];
  const int group = group_[index(arm.end)];
  const Vec3d grip = placed_.links[index(hands_[side])].translation;
  const std::string vocabulary = std::string(kSides[side]) + "hand";
  int parent = node_of_[index(group)];
  const bool has_wrist = arm.begins[3] < arm.joints.size();
  if (!has_wrist && robot_.links[index(hands_[side])].name != vocabulary) {
    parent =
        add_node(free_name(vocabulary), parent, group, placed_.links[index(arm.end)].translation);
  }
  const int node = add_node(robot_.links[index(hands_[side])].name, parent, group, grip);
  const Vec3d along = normalized(wrist(side) - elbow(side));
  add_node("", node, group, grip + along * (0.3 * F::kHand * body_.stature), true);
}

void RobotBuilder::add_foot_nodes(std::size_t side) {
  const int end = person_.legs[side].end;
  const int group = group_[index(end)];
  const int parent = node_of_[index(group)];
  add_node(robot_.links[index(end)].name, parent, group, placed_.links[index(end)].translation);
  const Vec3d toe = (soles_[side].corners[0] + soles_[side].corners[3]) * 0.5;
  add_node("", static_cast<int>(body_.nodes.size()) - 1, group, toe, true);
}

void RobotBuilder::add_robot_frame() {
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    const Robot::Joint& joint = robot_.joints[j];
    if (!joint.moves) continue;
    RobotJoint& to = frame_.joints.emplace_back();
    to.name = joint.name;
    to.angle = still_[j];
    to.slides = joint.slides;
    if (of_joint_[j] < 0) {
      if (joint.turns) still_names_.push_back(joint.name);
      continue;
    }
    const Moving& m = moving_[index(of_joint_[j])];
    to.dof = m.dof;
    to.sign = m.person->sign;
  }
  find_world();
}

void RobotBuilder::tell() {
  doubt_about(still_names_, "joint_still", "joints_still", doubts_);
  doubt_about(unlimited_, "joint_unlimited", "joints_unlimited", doubts_);
  if (!weak_.empty()) {
    doubts_.push_back(say("no_effort", weak_.size(), weak_[0]));
  }
  doubt_about(massless_, "link_massless", "links_massless", doubts_);
  if (soles_[0].guessed || soles_[1].guessed) doubts_.push_back(say("soles_guessed"));
  if (body_.feet.size() < 2) doubts_.push_back(say("foot_in_air"));
  if (spread_) doubts_.push_back(say("mass_spread", *spread_));
}

}  // namespace shigusa
