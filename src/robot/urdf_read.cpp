// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <shigusa/quat.hpp>
#include <shigusa/transform.hpp>

#include "body/link_mass.hpp"
#include "math/axes.hpp"
#include "robot/urdf.hpp"

#ifdef SHIGUSA_HAS_URDF
#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>
#endif

namespace shigusa {

#ifndef SHIGUSA_HAS_URDF

Result<Robot> parse_urdf(std::string_view, std::string_view name) {
  return fail(ErrorCode::unsupported, "this build of shigusa reads no URDF", std::string(name));
}

#else

namespace {

// Catches what urdfdom writes to its console, which is all that it tells of an error.
class Console : public console_bridge::OutputHandler {
 public:
  Console() {
    console_bridge::useOutputHandler(this);
    level_ = console_bridge::getLogLevel();
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ~Console() override {
    console_bridge::setLogLevel(level_);
    console_bridge::restorePreviousOutputHandler();
  }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    constexpr std::size_t kMost = 300;
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || said_.size() > kMost) return;
    if (!said_.empty()) said_ += "; ";
    said_ += text.substr(0, kMost);
    std::replace(said_.begin(), said_.end(), '\n', ' ');
  }
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  std::string said_;
  console_bridge::LogLevel level_;
};

// The model as urdfdom has it. Its links own each other, and go one by one: those of a cycle would
// never go, and a long chain's destructors would fill the stack.
class Model {
 public:
  explicit Model(const std::string& text) {
    // the console is the whole program's
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    Console console;
    model_ = urdf::parseURDF(text);
    said_ = console.said();
  }
  ~Model() {
    if (!model_) return;
    for (auto& [name, link] : model_->links_) {
      link->child_links.clear();
      link->child_joints.clear();
    }
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  [[nodiscard]] const urdf::ModelInterface* get() const { return model_.get(); }
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  urdf::ModelInterfaceSharedPtr model_;
  std::string said_;
};

Vec3d vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Transformd place(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  const double scale = 1.0 / sqrt(r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w);
  return {to_matrix(Quatd{r.x * scale, r.y * scale, r.z * scale, r.w * scale}),
          vector(pose.position)};
}

bool is_tame(double x) { return abs(x) <= kUrdfMaxValue; }
bool is_tame(const Vec3d& v) { return is_within(v, kUrdfMaxValue); }
bool is_tame(const Transformd& x) {
  return is_tame(x.translation) && is_within(x.rotation, kUrdfMaxValue);
}

// Corners of a box around a collision shape, link frame.
void add_corners(const urdf::Collision& collision, std::vector<Vec3d>& corners) {
  if (!collision.geometry) return;
  Vec3d half{};
  switch (collision.geometry->type) {
    case urdf::Geometry::BOX:
      half = vector(static_cast<const urdf::Box&>(*collision.geometry).dim) * 0.5;
      break;
    case urdf::Geometry::SPHERE: {
      const double r = static_cast<const urdf::Sphere&>(*collision.geometry).radius;
      half = {r, r, r};
      break;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(*collision.geometry);
      half = {cylinder.radius, cylinder.radius, 0.5 * cylinder.length};
      break;
    }
    default:
      return;
  }
  const Transformd at = place(collision.origin);
  for (const Vec3d& corner : box_corners(half)) corners.push_back(at * corner);
}

class RobotReader {
 public:
  RobotReader(const urdf::ModelInterface& model, std::string_view text, std::string_view name)
      : model_(model), name_(name) {
    robot_.name = model.getName();
    order_joints(text);
  }

  Result<Robot> read() {
    SHG_TRY(take_tree());
    for (const urdf::Joint* joint : joints_) {
      SHG_TRY(take_joint(*joint));
    }
    doubt_about(sliding_, "joint '{}' slides: it keeps its place",
                "{} joints, '{}' the first, slide: they keep their places", robot_.doubts);
    doubt_about(mimics_, "joint '{}' follows another joint: it keeps the angle 0",
                "{} joints, '{}' the first, follow other joints: they keep the angle 0",
                robot_.doubts);
    return std::move(robot_);
  }

 private:
  template <class... Args>
  [[nodiscard]] tl::unexpected<Error> wrong(fmt::format_string<Args...> format,
                                            Args&&... args) const {
    return fail(ErrorCode::parse, fmt::format(format, std::forward<Args>(args)...), name_);
  }

  // urdfdom keeps joints by name; the file's order is that of their tags, whose names may be
  // escaped
  void order_joints(std::string_view text) {
    std::map<std::string, std::size_t> place;
    for (std::size_t at = text.find("<joint"); at != text.npos; at = text.find("<joint", at + 1)) {
      const std::string_view tag = text.substr(at, text.find('>', at) - at);
      const std::size_t name = tag.find("name=");
      if (name == tag.npos || name + 6 >= tag.size()) continue;
      const char quote = tag[name + 5];
      const std::size_t end = tag.find(quote, name + 6);
      if (end == tag.npos) continue;
      place.emplace(tag.substr(name + 6, end - name - 6), place.size());
    }
    for (const auto& [name, joint] : model_.joints_) joints_.push_back(joint.get());
    const auto rank = [&](const urdf::Joint* joint) {
      const auto found = place.find(joint->name);
      return found == place.end() ? place.size() : found->second;
    };
    std::stable_sort(joints_.begin(), joints_.end(),
                     [&](const urdf::Joint* a, const urdf::Joint* b) { return rank(a) < rank(b); });
  }

  // The links, parents first. That each hangs on one joint, and none in a circle, reduced_urdf has
  // seen by the names as they are written; escaped ones come to light here.
  Result<void> take_tree() {
    std::map<std::string, std::vector<const urdf::Joint*> > below;
    for (const urdf::Joint* joint : joints_) below[joint->parent_link_name].push_back(joint);
    std::vector<const urdf::Link*> waiting{model_.getRoot().get()};
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      SHG_TRY(take_link(*waiting[i]));
      for (const urdf::Joint* joint : below[waiting[i]->name]) {
        if (waiting.size() == model_.links_.size()) {
          return wrong("link '{}' hangs on two joints; one is allowed", joint->child_link_name);
        }
        waiting.push_back(model_.getLink(joint->child_link_name).get());
      }
    }
    for (const auto& [name, link] : model_.links_) {
      if (index_.count(name) == 0) {
        return wrong("link '{}' does not hang on the root '{}'", name, waiting[0]->name);
      }
    }
    return {};
  }

  Result<void> take_link(const urdf::Link& link) {
    index_[link.name] = static_cast<int>(robot_.links.size());
    Robot::Link& to = robot_.links.emplace_back();
    to.name = link.name;
    for (const auto& collision : link.collision_array) {
      if (collision) add_corners(*collision, to.corners);
    }
    for (const Vec3d& corner : to.corners) {
      if (!is_tame(corner)) {
        return wrong("a collision shape of link '{}' reaches beyond {:g} m", link.name,
                     kUrdfMaxValue);
      }
    }
    if (!link.inertial) return {};
    const urdf::Inertial& i = *link.inertial;
    const Transformd at = place(i.origin);
    if (!is_tame(i.mass) || i.mass < 0.0) {
      return wrong("the mass of link '{}' is {} kg; allowed are 0 to {:g}", link.name, i.mass,
                   kUrdfMaxValue);
    }
    const Mat3d inertia{{i.ixx, i.ixy, i.ixz}, {i.ixy, i.iyy, i.iyz}, {i.ixz, i.iyz, i.izz}};
    if (!is_tame(at) || !is_within(inertia, kUrdfMaxValue)) {
      return wrong("the inertia of link '{}' has numbers beyond {:g}", link.name, kUrdfMaxValue);
    }
    to.mass = i.mass;
    to.com = at.translation;
    // without mass there is nothing to turn
    to.inertia = scaled(at.rotation * inertia * transpose(at.rotation), i.mass > 0.0 ? 1.0 : 0.0);
    return {};
  }

  Result<void> take_joint(const urdf::Joint& joint) {
    Robot::Joint to;
    to.name = joint.name;
    to.parent = index_[joint.parent_link_name];
    to.child = index_[joint.child_link_name];
    to.origin = place(joint.parent_to_joint_origin_transform);
    if (!is_tame(to.origin)) {
      return wrong("the origin of joint '{}' has numbers beyond {:g}", joint.name, kUrdfMaxValue);
    }
    const bool revolute = joint.type == urdf::Joint::REVOLUTE;
    to.slides = joint.type == urdf::Joint::PRISMATIC;
    to.moves = revolute || to.slides || joint.type == urdf::Joint::CONTINUOUS;
    to.turns = to.moves && !to.slides && !joint.mimic;
    if (joint.mimic) {
      mimics_.push_back(joint.name);
    } else if (!to.turns && joint.type != urdf::Joint::FIXED) {
      sliding_.push_back(joint.name);
    }
    if (to.moves) {
      const Vec3d axis = vector(joint.axis);
      if (!is_tame(axis) || !(norm(axis) > 1e-6)) {
        return wrong("the axis of joint '{}' is {} {} {}; it needs a direction", joint.name, axis.x,
                     axis.y, axis.z);
      }
      to.axis = normalized(axis);
      SHG_TRY(take_limits(joint, revolute || to.slides, to));
    }
    robot_.joints.push_back(to);
    return {};
  }

  Result<void> take_limits(const urdf::Joint& joint, bool ends, Robot::Joint& to) const {
    if (!joint.limits) return {};
    const urdf::JointLimits& limits = *joint.limits;
    if (!is_tame(limits.effort) || !is_tame(limits.lower) || !is_tame(limits.upper)) {
      return wrong("the limits of joint '{}' have numbers beyond {:g}", joint.name, kUrdfMaxValue);
    }
    to.effort = max(limits.effort, 0.0);
    if (!ends) return {};
    if (limits.lower > limits.upper) {
      return wrong("joint '{}' has the limits {} to {}; the lower one comes first", joint.name,
                   limits.lower, limits.upper);
    }
    to.limited = to.slides || limits.upper - limits.lower < kTwoPi;
    if (!to.limited) return {};
    to.lower = limits.lower;
    to.upper = limits.upper;
    // a joint that can be at one angle only
    if (to.upper - to.lower < 1e-6) to.turns = false;
    return {};
  }

  const urdf::ModelInterface& model_;
  const std::string name_;
  std::vector<const urdf::Joint*> joints_;
  std::map<std::string, int> index_;
  std::vector<std::string> sliding_;
  std::vector<std::string> mimics_;
  Robot robot_;
};

}  // namespace

Result<Robot> parse_urdf(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const std::string reduced, reduced_urdf(text, name));
  const Model model(reduced);
  if (model.get() == nullptr || !model.get()->getRoot()) {
    return fail(ErrorCode::parse,
                model.said().empty() ? "no robot that urdfdom can read" : model.said(),
                std::string(name));
  }
  return RobotReader(*model.get(), reduced, name).read();
}

#endif

}  // namespace shigusa
