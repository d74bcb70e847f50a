// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <shigusa/math.hpp>
#include <utility>

#include "body/link_mass.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "formats/urdf.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

constexpr std::string_view kJointTypes[] = {"revolute", "continuous", "prismatic",
                                            "fixed",    "planar",     "floating"};

bool is_tame(double x) { return abs(x) <= kUrdfMaxValue; }
bool is_tame(const Vec3d& v) { return is_within(v, kUrdfMaxValue); }
bool is_tame(const Robot::Shape& shape) {
  const auto corners = shape.corners();
  return std::all_of(corners.begin(), corners.end(), [](const Vec3d& v) { return is_tame(v); });
}

// R = Rz(yaw) Ry(pitch) Rx(roll)
Mat3d turned(const Vec3d& roll_pitch_yaw) {
  const SinCos<double> x = sin_cos(0.5 * roll_pitch_yaw.x);
  const SinCos<double> y = sin_cos(0.5 * roll_pitch_yaw.y);
  const SinCos<double> z = sin_cos(0.5 * roll_pitch_yaw.z);
  return to_matrix(Quatd{x.sin * y.cos * z.cos - x.cos * y.sin * z.sin,
                         x.cos * y.sin * z.cos + x.sin * y.cos * z.sin,
                         x.cos * y.cos * z.sin - x.sin * y.sin * z.cos,
                         x.cos * y.cos * z.cos + x.sin * y.sin * z.sin});
}

class UrdfReader {
 public:
  explicit UrdfReader(std::string_view name) : name_(name) {}

  Result<Robot> read(const XmlElement& robot) {
    SHG_TRY_ASSIGN(robot_.name, name_of(robot));
    SHG_TRY(gather(robot));
    take_states(robot);
    SHG_TRY(take_tree());
    for (const Hung& joint : joints_) {
      SHG_TRY(take_joint(joint));
    }
    mend_limits(robot_);
    doubt_about(sliding_, "joint_slides", "joints_slide", robot_.doubts);
    doubt_about(mimics_, "joint_follows", "joints_follow", robot_.doubts);
    return std::move(robot_);
  }

 private:
  // A joint with the links that it connects.
  struct Hung {
    const XmlElement* joint;
    std::string parent;
    std::string child;
  };

  [[nodiscard]] Result<std::string> name_of(const XmlElement& element) const {
    const char* name = element.attribute("name");
    if (name == nullptr || *name == '\0')
      return fail_at(element, name_, say("element_no_name", element.name));
    return name;
  }

  // Numbers of an attribute, `count` of them; `otherwise` if it is absent.
  Result<void> read_numbers(const XmlElement& element, const char* attribute, std::size_t count,
                            double* numbers) const {
    const char* text = element.attribute(attribute);
    if (text == nullptr) return {};
    const auto read = xml_numbers(text, count);
    if (!read || read->size() != count) {
      const std::string_view cut = std::string_view(text).substr(0, 60);
      return fail_at(element, name_,
                     count == 1 ? say("takes_one_number", attribute, element.name, cut)
                                : say("takes_n_numbers", attribute, element.name, cut, count));
    }
    std::copy(read->begin(), read->end(), numbers);
    return {};
  }

  [[nodiscard]] Result<Vec3d> vector(const XmlElement& element, const char* attribute,
                                     const Vec3d& otherwise = {}) const {
    double v[] = {otherwise.x, otherwise.y, otherwise.z};
    SHG_TRY(read_numbers(element, attribute, 3, v));
    return Vec3d{v[0], v[1], v[2]};
  }

  [[nodiscard]] Result<double> number(const XmlElement& element, const char* attribute,
                                      std::optional<double> otherwise = std::nullopt) const {
    if (!otherwise && element.attribute(attribute) == nullptr) {
      return fail_at(element, name_, say("element_without", element.name, attribute));
    }
    double value = otherwise.value_or(0.0);
    SHG_TRY(read_numbers(element, attribute, 1, &value));
    return value;
  }

  // Transform of an element's <origin>; the identity if absent.
  [[nodiscard]] Result<Transformd> place_of(const XmlElement& element) const {
    const XmlElement* origin = element.child("origin");
    if (origin == nullptr) return Transformd{};
    SHG_TRY_ASSIGN(const Vec3d at, vector(*origin, "xyz"));
    SHG_TRY_ASSIGN(const Vec3d rpy, vector(*origin, "rpy"));
    if (!is_tame(at) || !is_tame(rpy)) {
      return fail_at(*origin, name_, say("origin_beyond", kUrdfMaxValue));
    }
    return Transformd{turned(rpy), at};
  }

  // Reads named postures in the form of SRDF; incomplete ones are left out.
  void take_states(const XmlElement& robot) {
    for (const XmlElement& element : robot.children) {
      if (element.name != "group_state") continue;
      Robot::Keyframe frame;
      bool whole = true;
      if (const char* name = element.attribute("name")) frame.name = name;
      for (const XmlElement& joint : element.children) {
        const char* name = joint.attribute("name");
        const char* value = joint.attribute("value");
        const auto number = xml_numbers(value == nullptr ? "" : value, 1);
        whole = whole && name != nullptr && number && number->size() == 1 && is_tame((*number)[0]);
        if (whole) frame.angles.emplace_back(name, (*number)[0]);
      }
      if (whole) robot_.keyframes.push_back(std::move(frame));
    }
  }

  // Indexes links and joints by name. Each link has at most one parent joint.
  Result<void> gather(const XmlElement& robot) {
    std::map<std::string, const XmlElement*> joints;
    for (const XmlElement& element : robot.children) {
      if (element.name == "group_state") continue;
      SHG_TRY_ASSIGN(const std::string name, name_of(element));
      auto& taken = element.name == "link" ? links_ : joints;
      if (!taken.emplace(name, &element).second) {
        return fail_at(element, name_, say("there_twice", element.name, name));
      }
    }
    for (const XmlElement& element : robot.children) {
      if (element.name != "joint") continue;
      Hung hung{&element, {}, {}};
      SHG_TRY_ASSIGN(hung.parent, link_of(element, "parent"));
      SHG_TRY_ASSIGN(hung.child, link_of(element, "child"));
      if (!above_.emplace(hung.child, hung.parent).second) {
        return fail_at(element, name_, say("link_twice", hung.child));
      }
      joints_.push_back(std::move(hung));
    }
    return {};
  }

  // Parent or child link of a joint.
  [[nodiscard]] Result<std::string> link_of(const XmlElement& joint, const char* end) const {
    const XmlElement* found = nullptr;
    for (const XmlElement& child : joint.children) {
      if (child.name != end) continue;
      if (found != nullptr) return fail_at(child, name_, say("joint_second", end));
      found = &child;
    }
    SHG_TRY_ASSIGN(const std::string name, name_of(joint));
    if (found == nullptr) return fail_at(joint, name_, say("joint_without", name, end));
    const char* link = found->attribute("link");
    if (link == nullptr || *link == '\0') return fail_at(*found, name_, say("names_no_link", end));
    if (links_.count(link) == 0) {
      return fail_at(*found, name_, say("link_absent", name, link));
    }
    return link;
  }

  // Orders the links, parents first.
  Result<void> take_tree() {
    std::map<std::string, std::vector<std::string>> below;
    for (const Hung& joint : joints_) below[joint.parent].push_back(joint.child);
    std::vector<std::string> order;
    for (const auto& [name, link] : links_) {
      if (above_.count(name) == 0) order.push_back(name);
    }
    const std::size_t roots = order.size();
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::vector<std::string>& children = below[order[i]];
      order.insert(order.end(), children.begin(), children.end());
    }
    if (links_.empty()) return fail(ErrorCode::parse, say("no_links"), name_);
    for (const auto& [name, link] : links_) {
      if (contains(order, name)) continue;
      return fail_at(*link, name_, say("link_circle", name));
    }
    if (roots > 1) {
      return fail_at(*links_[order[1]], name_, say("two_roots", order[0], order[1]));
    }
    for (const std::string& name : order) {
      SHG_TRY(take_link(name, *links_[name]));
    }
    return {};
  }

  Result<void> take_link(const std::string& name, const XmlElement& link) {
    index_[name] = static_cast<int>(robot_.links.size());
    Robot::Link& to = robot_.links.emplace_back();
    to.name = name;
    for (const XmlElement& child : link.children) {
      if (child.name == "visual") {
        // errors in visual shapes are ignored
        const Result<Robot::Shape> shape = shape_of(child);
        if (shape && is_tame(*shape)) to.shown.push_back(*shape);
      } else if (child.name == "collision") {
        SHG_TRY_ASSIGN(const Robot::Shape shape, shape_of(child));
        if (!is_tame(shape)) {
          return fail_at(link, name_, say("shape_beyond", name, kUrdfMaxValue));
        }
        to.collides.push_back(shape);
      }
    }
    const XmlElement* inertial = link.child("inertial");
    return inertial == nullptr ? Result<void>{} : take_mass(*inertial, to);
  }

  // Shape of a <collision> or <visual>.
  [[nodiscard]] Result<Robot::Shape> shape_of(const XmlElement& element) const {
    const XmlElement& shape = element.child("geometry")->children[0];
    using Kind = Robot::Shape::Kind;
    Vec3d half{};
    Kind kind = Kind::box;
    if (shape.name == "box") {
      if (shape.attribute("size") == nullptr) return fail_at(shape, name_, say("box_no_size"));
      SHG_TRY_ASSIGN(const Vec3d size, vector(shape, "size"));
      half = size * 0.5;
    } else {
      SHG_TRY_ASSIGN(const double radius, number(shape, "radius"));
      half = {radius, radius, radius};
      kind = Kind::ball;
    }
    if (shape.name == "cylinder") {
      kind = Kind::cylinder;
      SHG_TRY_ASSIGN(const double length, number(shape, "length"));
      half.z = 0.5 * length;
    }
    SHG_TRY_ASSIGN(const Transformd at, place_of(element));
    return Robot::Shape{kind, half, at};
  }

  Result<void> take_mass(const XmlElement& inertial, Robot::Link& to) const {
    const XmlElement* mass = inertial.child("mass");
    const XmlElement* inertia = inertial.child("inertia");
    if (mass == nullptr || inertia == nullptr) {
      return fail_at(inertial, name_,
                     say("inertial_without", to.name, mass == nullptr ? "mass" : "inertia"));
    }
    SHG_TRY_ASSIGN(to.mass, number(*mass, "value"));
    if (!is_tame(to.mass) || to.mass < 0.0) {
      return fail_at(*mass, name_, say("link_mass", to.name, to.mass, kUrdfMaxValue));
    }
    double i[6] = {};
    constexpr const char* kMoments[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    for (std::size_t k = 0; k < 6; ++k) {
      SHG_TRY_ASSIGN(i[k], number(*inertia, kMoments[k]));
    }
    const Mat3d moments{{i[0], i[1], i[2]}, {i[1], i[3], i[4]}, {i[2], i[4], i[5]}};
    if (!is_within(moments, kUrdfMaxValue)) {
      return fail_at(*inertia, name_, say("inertia_beyond", to.name, kUrdfMaxValue));
    }
    SHG_TRY_ASSIGN(const Transformd at, place_of(inertial));
    to.com = at.translation;
    // a massless link needs no inertia
    to.inertia = scaled(at.rotation * moments * transpose(at.rotation), to.mass > 0.0 ? 1.0 : 0.0);
    return {};
  }

  Result<void> take_joint(const Hung& hung) {
    const XmlElement& joint = *hung.joint;
    Robot::Joint to;
    SHG_TRY_ASSIGN(to.name, name_of(joint));
    to.parent = index_[hung.parent];
    to.child = index_[hung.child];
    SHG_TRY_ASSIGN(to.origin, place_of(joint));
    const char* written = joint.attribute("type");
    const std::string_view type = written == nullptr ? "" : written;
    if (!contains(kJointTypes, type)) {
      return fail_at(joint, name_,
                     say("urdf_joint_type", to.name, type.substr(0, 60),
                         fmt::format("{}", fmt::join(kJointTypes, ", "))));
    }
    const bool revolute = type == "revolute";
    const bool mimics = joint.child("mimic") != nullptr;
    to.slides = type == "prismatic";
    to.floats = type == "floating" || type == "planar";
    to.moves = revolute || to.slides || type == "continuous";
    to.turns = to.moves && !to.slides && !mimics;
    if (mimics) {
      mimics_.push_back(to.name);
    } else if (!to.turns && type != "fixed") {
      sliding_.push_back(to.name);
    }
    if (to.moves) {
      SHG_TRY(take_axis(joint, to));
      SHG_TRY(take_limits(joint, revolute || to.slides, to));
    }
    robot_.joints.push_back(to);
    return {};
  }

  Result<void> take_axis(const XmlElement& joint, Robot::Joint& to) const {
    const XmlElement* element = joint.child("axis");
    if (element == nullptr) return {};
    SHG_TRY_ASSIGN(const Vec3d axis, vector(*element, "xyz", to.axis));
    if (!is_tame(axis) || !(norm(axis) > 1e-6)) {
      return fail_at(*element, name_, say("urdf_axis", to.name, axis.x, axis.y, axis.z));
    }
    to.axis = normalized(axis);
    return {};
  }

  Result<void> take_limits(const XmlElement& joint, bool ends, Robot::Joint& to) const {
    const XmlElement* limit = joint.child("limit");
    if (limit == nullptr) {
      if (!ends) return {};
      return fail_at(joint, name_, say("joint_no_limit", to.name));
    }
    SHG_TRY_ASSIGN(const double effort, number(*limit, "effort", 0.0));
    SHG_TRY_ASSIGN(const double lower, number(*limit, "lower", 0.0));
    SHG_TRY_ASSIGN(const double upper, number(*limit, "upper", 0.0));
    if (!is_tame(effort) || !is_tame(lower) || !is_tame(upper)) {
      return fail_at(*limit, name_, say("limits_beyond", to.name, kUrdfMaxValue));
    }
    to.effort = max(effort, 0.0);
    if (!ends) return {};
    if (lower > upper) {
      return fail_at(*limit, name_, say("limits_order", to.name, lower, upper));
    }
    if (!to.slides) to.ends = {lower, upper};
    to.limited = to.slides || upper - lower < kTwoPi;
    if (!to.limited) return {};
    to.lower = lower;
    to.upper = upper;
    // a joint with a single possible angle
    if (to.upper - to.lower < 1e-6) to.turns = false;
    return {};
  }

  const std::string name_;
  std::map<std::string, const XmlElement*> links_;
  std::vector<Hung> joints_;                  // in the file's order
  std::map<std::string, std::string> above_;  // parent link of each link
  std::map<std::string, int> index_;          // of links in the robot
  std::vector<std::string> sliding_;
  std::vector<std::string> mimics_;
  Robot robot_;
};

}  // namespace

Result<Robot> robot_of_urdf(const XmlElement& reduced, std::string_view name) {
  return UrdfReader(name).read(reduced);
}

Result<Robot> parse_urdf(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const XmlElement reduced, reduced_urdf(text, name));
  return robot_of_urdf(reduced, name);
}

}  // namespace shigusa
