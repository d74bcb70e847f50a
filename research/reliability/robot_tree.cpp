// SPDX-License-Identifier: MIT
#include "robot_tree.hpp"

#include <cmath>
#include <cstdlib>
#include <shigusa/math.hpp>
#include <sstream>
#include <stdexcept>

#include "formats/xml.hpp"

namespace shigusa::bench {
namespace {

Vec3d numbers(const XmlElement* element, const char* name, Vec3d usual = {}) {
  const char* text = element != nullptr ? element->attribute(name) : nullptr;
  if (text == nullptr) return usual;
  std::istringstream in(text);
  in >> usual.x >> usual.y >> usual.z;
  return usual;
}

double number(const XmlElement* element, const char* name, double usual = 0.0) {
  const char* text = element != nullptr ? element->attribute(name) : nullptr;
  return text == nullptr ? usual : std::strtod(text, nullptr);
}

std::string word(const XmlElement* element, const char* name) {
  const char* text = element != nullptr ? element->attribute(name) : nullptr;
  return text == nullptr ? "" : text;
}

Mat3d about(const Vec3d& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return to_matrix(Quatd{axis.x * s, axis.y * s, axis.z * s, std::cos(0.5 * angle)});
}

// Rotation by roll, pitch and yaw about fixed axes.
Transformd origin_of(const XmlElement& element) {
  const XmlElement* origin = element.child("origin");
  const Vec3d rpy = numbers(origin, "rpy");
  return {about({0, 0, 1}, rpy.z) * about({0, 1, 0}, rpy.y) * about({1, 0, 0}, rpy.x),
          numbers(origin, "xyz")};
}

RobotTree::Link link_of(const XmlElement& element) {
  RobotTree::Link link;
  link.name = word(&element, "name");
  const XmlElement* inertial = element.child("inertial");
  if (inertial == nullptr) return link;
  link.mass = number(inertial->child("mass"), "value");
  link.inertial = origin_of(*inertial);
  const XmlElement* of = inertial->child("inertia");
  const auto entry = [&](const char* name) { return number(of, name); };
  link.inertia = {{entry("ixx"), entry("ixy"), entry("ixz")},
                  {entry("ixy"), entry("iyy"), entry("iyz")},
                  {entry("ixz"), entry("iyz"), entry("izz")}};
  return link;
}

RobotTree::Joint joint_of(const XmlElement& element) {
  RobotTree::Joint joint;
  joint.name = word(&element, "name");
  joint.child = word(element.child("child"), "link");
  joint.parent = word(element.child("parent"), "link");
  joint.origin = origin_of(element);
  joint.axis = normalized(numbers(element.child("axis"), "xyz", {1, 0, 0}));
  const std::string type = word(&element, "type");
  joint.turns = type == "revolute" || type == "continuous";
  joint.slides = type == "prismatic";
  if (const XmlElement* limit = element.child("limit"); limit != nullptr && type == "revolute") {
    joint.lower = number(limit, "lower");
    joint.upper = number(limit, "upper");
  }
  if (const XmlElement* mimic = element.child("mimic")) {
    joint.follows = word(mimic, "joint");
    joint.times = number(mimic, "multiplier", 1.0);
    joint.plus = number(mimic, "offset");
  }
  return joint;
}

// Converts x ahead, y left, z up of a robot's world to z, x, y of shigusa's.
Vec3d in_our_world(const Vec3d& p) { return {p.y, p.z, p.x}; }

Transformd in_our_world(const Transformd& place) {
  const Mat3d& r = place.rotation;
  return {{in_our_world(r.cx), in_our_world(r.cy), in_our_world(r.cz)},
          in_our_world(place.translation)};
}

}  // namespace

Transformd root_place(const Table& table, std::size_t row) {
  const auto at = [&](const char* name) { return table.at(std::string("root.") + name, row); };
  return in_our_world(Transformd{to_matrix(Quatd{at("qx"), at("qy"), at("qz"), at("qw")}),
                                 {at("x [m]"), at("y [m]"), at("z [m]")}});
}

RobotTree::RobotTree(std::string_view urdf) {
  const auto root = parse_xml(urdf, {16 << 20, 1'000'000, 1000}, "robot");
  if (!root) throw std::runtime_error(root.error().to_string());
  for (const XmlElement& element : root->children) {
    if (element.name == "link") {
      links_.push_back(bench::link_of(element));
      link_of_[links_.back().name] = links_.size() - 1;
    }
    if (element.name == "joint" && element.child("child") != nullptr) {
      joints_.push_back(bench::joint_of(element));
      above_[joints_.back().child] = joints_.size() - 1;
      joint_of_[joints_.back().name] = joints_.size() - 1;
    }
  }
}

const RobotTree::Joint* RobotTree::joint_above(const std::string& link) const {
  const auto found = above_.find(link);
  return found == above_.end() ? nullptr : &joints_[found->second];
}

bool RobotTree::hangs_on(const std::string& link, const std::string& above) const {
  if (link == above) return true;
  const Joint* joint = joint_above(link);
  return joint != nullptr && hangs_on(joint->parent, above);
}

double RobotTree::value_of(const Joint& joint, const Table& table, std::size_t row) const {
  const std::string name = joint.name + (joint.slides ? " [m]" : " [rad]");
  if (table.has(name)) return table.at(name, row);
  const auto leader = joint_of_.find(joint.follows);
  if (leader == joint_of_.end()) return 0.0;
  return joint.times * value_of(joints_[leader->second], table, row) + joint.plus;
}

std::vector<RobotTree::Places> RobotTree::places(const std::string& root,
                                                 const Table& table) const {
  std::vector<Places> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Places& places = rows.emplace_back();
    places[root] = root_place(table, row);
    std::vector<std::string> open{root};
    while (!open.empty()) {
      const std::string parent = open.back();
      open.pop_back();
      for (const Joint& joint : joints_) {
        if (joint.parent != parent) continue;
        Transformd own;
        if (joint.turns) own.rotation = about(joint.axis, value_of(joint, table, row));
        if (joint.slides) own.translation = joint.axis * value_of(joint, table, row);
        places[joint.child] = places[parent] * joint.origin * own;
        open.push_back(joint.child);
      }
    }
  }
  return rows;
}

MovingBody RobotTree::pieces(const std::string& root, const std::vector<Places>& places,
                             const std::vector<std::string>& feet, double frame_time) const {
  MovingBody moving;
  moving.frame_time = frame_time;
  moving.frames = static_cast<int>(places.size());
  std::vector<std::string> names;
  for (const Link& link : links_) {
    if (!(link.mass > 0.0) || !hangs_on(link.name, root)) continue;
    names.push_back(link.name);
    MovingPiece& piece = moving.pieces.emplace_back();
    piece.mass = link.mass;
    piece.inertia = link.inertia;
    for (const Places& frame : places) {
      const Transformd at = frame.at(link.name) * link.inertial;
      piece.centre.push_back(at.translation);
      piece.turn.push_back(at.rotation);
    }
  }
  for (const Joint& joint : joints_) {
    bool free = joint.turns && joint.child != root && hangs_on(joint.child, root);
    for (const std::string& foot : feet) free = free && !hangs_on(foot, joint.child);
    if (!free) continue;
    MovingHinge& hinge = moving.hinges.emplace_back();
    hinge.name = joint.name;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (hangs_on(names[k], joint.child)) hinge.carries.push_back(k);
    }
    for (const Places& frame : places) {
      const Transformd& at = frame.at(joint.child);
      hinge.at.push_back(at.translation);
      hinge.axis.push_back(at.rotation * joint.axis);
    }
  }
  return moving;
}

}  // namespace shigusa::bench
