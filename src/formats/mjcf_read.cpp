// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "formats/mjcf.hpp"
#include "math/axes.hpp"
#include "mjcf_geom.hpp"
#include "mjcf_keys.hpp"
#include "rig/humanoid_names.hpp"

namespace shigusa {
namespace {

bool is(const XmlElement& element, std::string_view tag) { return tag == element.name; }
bool is_joint(const XmlElement& element) {
  return is(element, "joint") || is(element, "freejoint");
}

bool is_tame(std::span<const Vec3d> points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Vec3d& v) { return is_within(v, kMjcfMaxValue); });
}

// An element that may set the default class of its contents, within one of that class.
MjcfPart in_class(const XmlElement& element, std::string_view childclass) {
  const char* named = element.attribute("childclass");
  return {element, named != nullptr ? named : childclass};
}

// An element of a body, in the body's frame or in that of a nested <frame>.
struct Inside {
  MjcfPart part;
  Transformd frame;  // in the body
};

class ModelReader {
 public:
  ModelReader(MjcfFiles& files, std::string_view name)
      : files_(files), values_(files), actuators_(files, values_), name_(name) {}

  Result<Robot> read() {
    read_robot();
    if (files_.error()) return tl::unexpected(*files_.error());
    if (!root_) return fail(ErrorCode::parse, say("mjcf_no_body"), name_);
    follow_equalities();
    mend_limits(robot_);
    robot_.keyframes = read_keyframes(files_, values_, joint_of_, robot_);
    scale_masses();
    SHG_TRY(check_numbers());
    tell();
    return std::move(robot_);
  }

 private:
  // A body with the data of its parent needed to attach it.
  struct Hung {
    Inside inside;
    int parent = -1;     // link
    Vec3d parent_shift;  // of the parent link's frame in its body's
    int depth = 0;
  };

  void read_robot();
  void find_root(const Inside& world, int depth);
  int count_joints(const XmlElement& body, int depth);
  bool too_deep(const XmlElement& element, int depth);
  void take_body(const Hung& body);
  void list(const Inside& inside, int depth, std::vector<Inside>& content);
  int add_link(const std::string& name, const XmlElement& at);
  std::string free_name(std::set<std::string>& taken, std::string name);
  [[nodiscard]] std::string name_of(const XmlElement& element, const std::string& otherwise);
  Vec3d add_joints(const Hung& body, const std::vector<Inside>& joints, const std::string& name);
  std::vector<Robot::Joint> read_joint(const Inside& inside, const std::string& body);
  std::vector<Robot::Joint> read_ball(const Inside& inside, Robot::Joint joint);
  void read_ends(const MjcfPart& part, Robot::Joint& joint, bool ball);
  void add_masses(const std::vector<Inside>& content, const Vec3d& shift, Robot::Link& link);
  void add_hand(const std::vector<Inside>& content, const Vec3d& shift, int forearm);
  void follow_equalities();
  void scale_masses();
  [[nodiscard]] Result<void> check_numbers() const;
  void tell();

  MjcfFiles& files_;
  MjcfValues values_;
  MjcfActuators actuators_;
  const std::string name_;
  Robot robot_;
  std::optional<Inside> root_;
  int root_joints_ = -1;
  std::vector<std::string> other_bodies_;
  std::vector<std::string> root_held_by_;
  std::vector<std::string> sliding_;
  std::vector<std::string> following_;
  std::vector<std::string> meshes_;   // bodies with masses from meshes
  std::vector<std::string> unknown_;  // elements that make bodies and are not read
  std::map<std::string, std::size_t> joints_by_name_;
  std::map<const XmlElement*, std::size_t> joint_of_;  // the first of an element's
  std::set<std::string> links_taken_;
  std::set<std::string> joints_taken_;
};

void ModelReader::read_robot() {
  if (files_.root() == nullptr) return;
  const char* model = files_.root()->attribute("model");
  robot_.name = model == nullptr ? name_ : model;
  files_.each(*files_.root(), [&](const XmlElement& e) {
    if (is(e, "worldbody")) find_root({{e, {}}, {}}, 0);
  });
  if (root_ && !files_.error()) take_body({*root_, -1, {}, 0});
}

// The body of the world with the most joints.
void ModelReader::find_root(const Inside& world, int depth) {
  if (too_deep(world.part.element, depth)) return;
  files_.each(world.part.element, [&](const XmlElement& e) {
    const Inside inside{in_class(e, world.part.childclass), {}};
    if (is(e, "frame")) find_root(inside, depth + 1);
    if (!is(e, "body")) return;
    const int joints = count_joints(e, 0);
    if (root_) {
      other_bodies_.push_back(name_of(joints > root_joints_ ? root_->part.element : e, "body"));
    }
    if (joints <= root_joints_) return;
    root_.emplace(inside);
    root_joints_ = joints;
  });
}

bool ModelReader::too_deep(const XmlElement& element, int depth) {
  if (depth <= kMjcfMaxDepth) return false;
  files_.wrong(element, say("nested_deeper", kMjcfMaxDepth));
  return true;
}

int ModelReader::count_joints(const XmlElement& body, int depth) {
  if (too_deep(body, depth)) return 0;
  int count = 0;
  files_.each(body, [&](const XmlElement& e) {
    if (is_joint(e)) ++count;
    if (is(e, "body") || is(e, "frame")) count += count_joints(e, depth + 1);
  });
  return count;
}

// Lists the elements of a body, including those in its frames.
void ModelReader::list(const Inside& inside, int depth, std::vector<Inside>& content) {
  constexpr std::string_view kMakers[] = {"attach", "composite", "flexcomp", "replicate"};
  files_.each(inside.part.element, [&](const XmlElement& e) {
    const MjcfPart part{e, inside.part.childclass};
    if (is(e, "frame")) {
      const MjcfPart frame = in_class(e, part.childclass);
      if (too_deep(e, depth + 1)) return;
      return list({frame, inside.frame * values_.place(frame)}, depth + 1, content);
    }
    if (contains(kMakers, e.name)) unknown_.push_back(e.name);
    content.push_back({part, inside.frame});
  });
}

void ModelReader::take_body(const Hung& body) {
  const XmlElement& element = body.inside.part.element;
  if (too_deep(element, body.depth)) return;
  std::vector<Inside> content;
  list({body.inside.part, {}}, body.depth, content);
  const std::string name = name_of(element, fmt::format("body_{}", robot_.links.size()));
  std::vector<Inside> joints;
  for (const Inside& each : content) {
    if (is_joint(each.part.element)) joints.push_back(each);
  }
  Vec3d shift{};
  if (body.parent >= 0) {
    shift = add_joints(body, joints, name);
  } else {
    for (const Inside& joint : joints) {
      const std::string_view type = values_.word(joint.part, "type");
      if (is(joint.part.element, "freejoint") || type == "free") continue;
      root_held_by_.push_back(name_of(joint.part.element, name + "_joint"));
    }
    add_link(name, element);
  }
  if (files_.error()) return;
  const int link = static_cast<int>(robot_.links.size()) - 1;
  add_masses(content, shift, robot_.links[index(link)]);
  add_hand(content, shift, link);
  for (const Inside& child : content) {
    if (!is(child.part.element, "body") || files_.error()) continue;
    const MjcfPart part = in_class(child.part.element, child.part.childclass);
    take_body({{part, child.frame}, link, shift, body.depth + 1});
  }
}

std::string ModelReader::free_name(std::set<std::string>& taken, std::string name) {
  // names are written to XML and tables
  for (char& c : name) {
    const bool odd = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (odd || std::string_view("&<>\"'").find(c) != std::string_view::npos) c = '_';
  }
  std::string free = name;
  for (int k = 2; !taken.insert(free).second; ++k) free = fmt::format("{}_{}", name, k);
  return free;
}

int ModelReader::add_link(const std::string& name, const XmlElement& at) {
  if (static_cast<int>(robot_.links.size()) >= kMjcfMaxLinks) {
    files_.wrong(at, say("bodies_most", kMjcfMaxLinks));
    return 0;
  }
  robot_.links.emplace_back().name = free_name(links_taken_, name);
  return static_cast<int>(robot_.links.size()) - 1;
}

std::string ModelReader::name_of(const XmlElement& element, const std::string& otherwise) {
  const char* name = element.attribute("name");
  if (name == nullptr || *name == '\0') return otherwise;
  constexpr std::size_t kLongest = 256;
  if (std::string_view(name).size() > kLongest) {
    files_.wrong(element, say("long_name", kLongest));
    return otherwise;
  }
  return name;
}

// Adds links and joints from the parent to the body; returns the origin of the body's link in the
// body's frame.
Vec3d ModelReader::add_joints(const Hung& body, const std::vector<Inside>& joints,
                              const std::string& name) {
  Transformd place = body.inside.frame * values_.place(body.inside.part);
  place.translation += -body.parent_shift;
  Vec3d shift{};
  int parent = body.parent;
  std::vector<Robot::Joint> chain;
  std::vector<Vec3d> anchors;
  std::vector<const XmlElement*> elements;
  for (const Inside& each : joints) {
    const std::vector<Robot::Joint> read = read_joint(each, name);
    const Vec3d anchor = each.frame * values_.vector(each.part, "pos");
    chain.insert(chain.end(), read.begin(), read.end());
    anchors.insert(anchors.end(), read.size(), anchor);
    elements.insert(elements.end(), read.size(), &each.part.element);
  }
  if (chain.empty()) {
    chain.emplace_back().name = name + "_fixed";
    anchors.emplace_back();
  }
  for (std::size_t k = 0; k < chain.size() && !files_.error(); ++k) {
    const bool last = k + 1 == chain.size();
    Robot::Joint& joint = chain[k];
    joint.parent = parent;
    joint.child = parent = add_link(last ? name : joint.name, body.inside.part.element);
    const Mat3d turn = joint.origin.rotation;  // of the reference angle
    joint.origin =
        k == 0 ? place * Transformd{Mat3d{}, anchors[k]} : Transformd{Mat3d{}, anchors[k] - shift};
    joint.origin.rotation = joint.origin.rotation * turn;
    shift = anchors[k];
    joints_by_name_.emplace(joint.name, robot_.joints.size());
    if (k < elements.size()) joint_of_.emplace(elements[k], robot_.joints.size());
    joint.name = free_name(joints_taken_, joint.name);
    robot_.joints.push_back(joint);
  }
  return shift;
}

std::vector<Robot::Joint> ModelReader::read_ball(const Inside& inside, Robot::Joint joint) {
  read_ends(inside.part, joint, true);
  std::vector<Robot::Joint> three(3, joint);
  constexpr std::array kAxes{"_x", "_y", "_z"};
  for (std::size_t k = 0; k < 3; ++k) {
    three[k].name += kAxes[k];
    three[k].axis = inside.frame.rotation.column(static_cast<int>(k));
    three[k].effort = actuators_.effort(joint.name, inside.part, k);
  }
  return three;
}

// A hinge or a slide, or the three hinges of a ball; the origin is that at angle 0.
std::vector<Robot::Joint> ModelReader::read_joint(const Inside& inside, const std::string& body) {
  const MjcfPart& part = inside.part;
  const std::string name = name_of(part.element, body + "_joint");
  std::string_view type = values_.word(part, "type");
  if (type.empty()) type = "hinge";
  if (is(part.element, "freejoint") || type == "free") {
    files_.wrong(part.element, say("free_joint_within"));
    return {};
  }
  Robot::Joint joint;
  joint.name = name;
  joint.moves = true;
  joint.slides = type == "slide";
  joint.turns = !joint.slides;
  if (type == "ball") return read_ball(inside, joint);
  if (type != "hinge" && type != "slide") {
    files_.wrong(part.element, say("joint_type", shown(type)));
  }
  const Vec3d axis = values_.vector(part, "axis", {0, 0, 1});
  if (!(norm(axis) > 1e-6)) {
    files_.wrong(part.element, say("mjcf_axis", shown(name), shown(values_.word(part, "axis"))));
    return {};
  }
  joint.axis = inside.frame.rotation * normalized(axis);
  joint.effort = actuators_.effort(name, part, 0);
  read_ends(part, joint, false);
  const double reference = values_.number(part, "ref", 0.0);
  if (joint.slides) {
    sliding_.push_back(name);
  } else if (reference != 0.0) {
    joint.origin.rotation = turned_about(joint.axis, -values_.angle(reference));
  }
  return {joint};
}

void ModelReader::read_ends(const MjcfPart& part, Robot::Joint& joint, bool ball) {
  std::optional<std::array<double, 2> > ends = values_.range(part, "range", "limited");
  if (!ends) {
    if (joint.slides) joint.lower = joint.upper = 0.0;
    return;
  }
  if (!joint.slides) *ends = {values_.angle((*ends)[0]), values_.angle((*ends)[1])};
  // the range of a ball is its largest rotation about any axis
  if (ball) (*ends)[0] = -(*ends)[1];
  constexpr double kFarthest = 1000.0;  // rad, m
  const bool endless = !is_finite((*ends)[1] - (*ends)[0]);
  for (double& end : *ends) end = clamp(end, -kFarthest, kFarthest);
  const double length = (*ends)[1] - (*ends)[0];
  if (!joint.slides && !ball) joint.ends = *ends;
  joint.limited = !endless && (joint.slides || length < kTwoPi);
  if (joint.limited) {
    joint.lower = (*ends)[0];
    joint.upper = (*ends)[1];
  }
  // a joint with a single possible angle
  if (joint.limited && length < 1e-6) joint.turns = false;
}

void ModelReader::add_masses(const std::vector<Inside>& content, const Vec3d& shift,
                             Robot::Link& link) {
  const MjcfSettings& settings = values_.settings();
  std::optional<LinkMass> inertial;
  LinkMass shapes;
  bool mesh = false;
  for (const Inside& each : content) {
    if (is(each.part.element, "inertial") && settings.from_inertial) {
      inertial = read_inertial(files_, values_, each.part);
    }
    if (!is(each.part.element, "geom")) continue;
    const MjcfGeom geom = read_geom(files_, values_, each.part);
    mesh = mesh || geom.mesh;
    if (!geom.solid) continue;
    if (geom.mass.mass > 0.0) {
      const MassProperties own = geom.mass.in_frame(Mat3d{}, {});
      const Mat3d& turn = each.frame.rotation;
      shapes.add(
          LinkMass::of(own.mass, each.frame * own.com, turn * own.inertia * transpose(turn)));
    }
    Robot::Shape shape = geom.shape;
    shape.place = each.frame * shape.place;
    shape.place.translation += -shift;
    if (geom.collides) {
      link.collides.push_back(shape);
    } else if (is_tame(shape.corners())) {
      link.shown.push_back(shape);
    }
  }
  if (!inertial && settings.from_geoms) inertial = shapes;
  if (!inertial || !(inertial->mass > 0.0)) {
    if (mesh) meshes_.push_back(link.name);
    return;
  }
  const MassProperties own = inertial->in_frame(Mat3d{}, {});
  link.mass = own.mass;
  link.com = own.com - shift;
  link.inertia = own.inertia;
}

// Gives a forearm without a child body a hand if it has a shape with that name, as in many models.
void ModelReader::add_hand(const std::vector<Inside>& content, const Vec3d& shift, int forearm) {
  const auto is_body = [](const Inside& each) { return is(each.part.element, "body"); };
  const std::string& name = robot_.links[index(forearm)].name;
  if (read_bone_name(name).part != BonePart::lower_arm) return;
  if (std::any_of(content.begin(), content.end(), is_body)) return;
  for (const Inside& each : content) {
    const std::string shape = name_of(each.part.element, "");
    const bool hand = is(each.part.element, "geom") &&
                      read_bone_name(shape).part == BonePart::hand &&
                      read_bone_name(shape).side == read_bone_name(name).side;
    if (!hand) continue;
    Robot::Joint fixed;
    fixed.name = free_name(joints_taken_, shape + "_fixed");
    fixed.parent = forearm;
    fixed.child = add_link(shape, each.part.element);
    fixed.origin.translation = each.frame * values_.place(each.part).translation - shift;
    robot_.joints.push_back(fixed);
    return;
  }
}

void ModelReader::follow_equalities() {
  files_.each(*files_.root(), [&](const XmlElement& section) {
    if (!is(section, "equality")) return;
    files_.each(section, [&](const XmlElement& e) {
      const char* joint = e.attribute("joint1");
      if (!is(e, "joint") || joint == nullptr || e.attribute("joint2") == nullptr) return;
      const auto found = joints_by_name_.find(joint);
      if (found == joints_by_name_.end()) return;
      robot_.joints[found->second].turns = false;
      following_.push_back(joint);
    });
  });
}

void ModelReader::scale_masses() {
  double sum = 0.0;
  for (const Robot::Link& link : robot_.links) sum += link.mass;
  const double total = values_.settings().total_mass;
  if (!(total > 0.0) || !(sum > 0.0)) return;
  const double scale = total / sum;
  for (Robot::Link& link : robot_.links) {
    link.mass *= scale;
    link.inertia = scaled(link.inertia, scale);
  }
}

// Checks numbers derived from those of the file.
Result<void> ModelReader::check_numbers() const {
  const auto tame = [](const Vec3d& v) { return is_within(v, kMjcfMaxValue); };
  const auto beyond = [&](const Sentence<std::string, double>& sentence, const std::string& link) {
    return fail(ErrorCode::parse,
                say("maybe_millimetres", say(sentence, shown(link), kMjcfMaxValue)), name_);
  };
  for (const Robot::Joint& joint : robot_.joints) {
    if (tame(joint.origin.translation)) continue;
    return beyond("body_place_beyond", robot_.links[index(joint.child)].name);
  }
  for (const Robot::Link& link : robot_.links) {
    if (!is_tame(link.corners())) return beyond("body_size_beyond", link.name);
    if (!tame(link.com)) return beyond("body_centre_beyond", link.name);
    if (!(abs(link.mass) <= kMjcfMaxValue)) return beyond("body_mass_beyond", link.name);
    if (!is_within(link.inertia, kMjcfMaxValue)) return beyond("body_inertia_beyond", link.name);
  }
  return {};
}

void ModelReader::tell() {
  const auto doubt = [&](const std::vector<std::string>& names, const OfOne& one,
                         const OfMany& many) { doubt_about(names, one, many, robot_.doubts); };
  if (!files_.absent().empty()) robot_.doubts.push_back(files_.doubt_of_absent());
  doubt(unknown_, "element_left_out", "elements_left_out");
  doubt(other_bodies_, "body_apart", "bodies_apart");
  doubt(root_held_by_, "root_held", "roots_held");
  doubt(sliding_, "joint_slides", "joints_slide");
  doubt(following_, "joint_follows", "joints_follow");
  doubt(meshes_, "mesh_mass", "mesh_masses");
}

}  // namespace

Result<Robot> parse_mjcf(std::string_view text, std::string_view name, const MjcfInclude& include) {
  MjcfFiles files(text, name, include);
  Result<Robot> robot = ModelReader(files, name).read();
  if (robot || files.absent().empty()) return robot;
  return tl::unexpected(after_absent({files.doubt_of_absent()}, robot.error()));
}

}  // namespace shigusa
