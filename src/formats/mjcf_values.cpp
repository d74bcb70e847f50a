// SPDX-License-Identifier: MIT
#include "mjcf_values.hpp"

#include <algorithm>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kShortest = 1e-9;  // of a direction or a quaternion
// Attributes are looked up in all surrounding classes.
constexpr int kMaxClassDepth = 10;
constexpr std::size_t kMaxClassElements = 24;

// All actuators share the defaults of their classes.
bool is_actuator(std::string_view tag) {
  constexpr std::string_view kTags[] = {"general",  "motor",       "position",
                                        "velocity", "intvelocity", "damper",
                                        "cylinder", "muscle",      "adhesion"};
  return contains(kTags, tag);
}

bool same_kind(std::string_view tag, std::string_view other) {
  return tag == other || (is_actuator(tag) && is_actuator(other));
}

double farther(const std::array<double, 2>& ends) { return max(abs(ends[0]), abs(ends[1])); }

}  // namespace

Mat3d turned_about(const Vec3d& axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return to_matrix(Quatd{axis.x * half.sin, axis.y * half.sin, axis.z * half.sin, half.cos});
}

Mat3d turned_to(const Vec3d& z) {
  const Vec3d across = cross(Vec3d{0, 0, 1}, z);
  const double sine = norm(across);
  const Vec3d axis = sine < kShortest ? Vec3d{1, 0, 0} : across * (1.0 / sine);
  return turned_about(axis, atan2(sine, z.z));
}

MjcfValues::MjcfValues(MjcfFiles& files) : files_(files) {
  classes_[main_] = {};
  if (files.root() == nullptr) return;
  bool first = true;
  files.each(*files.root(), [&](const XmlElement& e) {
    if (e.name != "default") return;
    const char* name = e.attribute("class");
    if (first && name != nullptr) {
      classes_.erase(main_);
      main_ = name;
    }
    first = false;
    read_class(e, "", 1);
  });
  files.each(*files.root(), [&](const XmlElement& e) {
    if (e.name == "compiler") read_compiler(e);
  });
}

void MjcfValues::read_compiler(const XmlElement& compiler) {
  const MjcfPart part{compiler, {}};
  const auto word = [&](const char* attribute, std::string_view yes, std::string_view no,
                        bool& value) {
    const char* text = compiler.attribute(attribute);
    if (text == nullptr) return;
    if (text != yes && text != no) {
      files_.wrong(compiler, say("one_of_two", attribute, shown(text), yes, no));
    }
    value = text == yes;
  };
  word("angle", "degree", "radian", settings_.degrees);
  word("autolimits", "true", "false", settings_.autolimits);
  bool local = true;
  word("coordinate", "local", "global", local);
  if (!local) files_.wrong(compiler, say("coordinate_global"));
  if (const char* text = compiler.attribute("inertiafromgeom")) {
    settings_.from_inertial = std::string_view(text) != "true";
    settings_.from_geoms = std::string_view(text) != "false";
  }
  if (const char* text = compiler.attribute("eulerseq")) {
    settings_.euler = text;
    const auto is_axis = [](char c) { return std::string_view("xyzXYZ").find(c) < 6; };
    if (settings_.euler.size() != 3 ||
        !std::all_of(settings_.euler.begin(), settings_.euler.end(), is_axis)) {
      files_.wrong(compiler, say("eulerseq", shown(text)));
      settings_.euler = "xyz";
    }
  }
  std::array<double, 2> groups{0, 5};
  numbers(part, "inertiagrouprange", groups, 2);
  settings_.groups = {static_cast<int>(groups[0]), static_cast<int>(groups[1])};
  settings_.total_mass = max(number(part, "settotalmass", settings_.total_mass), 0.0);
}

void MjcfValues::read_class(const XmlElement& element, const std::string& above, int depth) {
  if (depth > kMaxClassDepth) {
    return files_.wrong(element, say("classes_deep", kMaxClassDepth));
  }
  const char* text = element.attribute("class");
  if (text == nullptr && depth > 1) return files_.wrong(element, say("default_no_class"));
  const std::string name = text == nullptr ? main_ : text;
  Class& read = classes_[name];
  if (name != main_) read.above = above.empty() ? main_ : above;
  files_.each(element, [&](const XmlElement& e) {
    if (e.name == "default") {
      read_class(e, name, depth + 1);
      return;
    }
    std::vector<const XmlElement*>& elements = classes_[name].elements;
    if (elements.size() >= kMaxClassElements) {
      files_.wrong(e, say("class_elements", shown(name), kMaxClassElements));
    }
    elements.push_back(&e);
  });
}

MjcfValues::Found MjcfValues::find(const MjcfPart& part, const char* attribute) const {
  const XmlElement& element = part.element;
  if (const char* text = element.attribute(attribute)) return {&element, text, 0};
  const char* own = element.attribute("class");
  std::string_view name = own != nullptr ? own : part.childclass;
  if (name.empty()) name = main_;
  // a class that contains itself has no end
  for (int distance = 1; distance <= kMaxClassDepth && !name.empty(); ++distance) {
    const auto found = classes_.find(name);
    if (found == classes_.end()) {
      if (distance == 1) files_.wrong(element, say("class_undefined", shown(name)));
      return {};
    }
    const auto& list = found->second.elements;
    for (auto e = list.rbegin(); e != list.rend(); ++e) {
      const char* text = (*e)->attribute(attribute);
      if (text != nullptr && same_kind((*e)->name, element.name)) return {*e, text, distance};
    }
    name = found->second.above;
  }
  return {};
}

std::string_view MjcfValues::word(const MjcfPart& part, const char* attribute) const {
  const Found found = find(part, attribute);
  return found.text == nullptr ? std::string_view{} : found.text;
}

bool MjcfValues::has(const MjcfPart& part, const char* attribute) const {
  return find(part, attribute).text != nullptr;
}

std::size_t MjcfValues::parse(const Found& found, const char* attribute, std::span<double> values,
                              std::size_t least, double most) {
  if (found.text == nullptr) return 0;
  const auto numbers = xml_numbers(found.text, values.size());
  const auto is_tame = [&](double x) { return abs(x) <= kMjcfMaxValue || abs(x) == most; };
  if (!numbers || !std::all_of(numbers->begin(), numbers->end(), is_tame)) {
    files_.wrong(*found.at,
                 say("numbers_up_to", attribute, shown(found.text), values.size(), kMjcfMaxValue));
    return 0;
  }
  const std::size_t count = numbers->size();
  std::copy(numbers->begin(), numbers->end(), values.begin());
  if (count < least) {
    files_.wrong(*found.at, say("takes_numbers", attribute, shown(found.text), least));
  }
  return count;
}

std::size_t MjcfValues::numbers(const MjcfPart& part, const char* attribute,
                                std::span<double> values, std::size_t least) {
  return parse(find(part, attribute), attribute, values, least, kMjcfMaxValue);
}

double MjcfValues::number(const MjcfPart& part, const char* attribute, double otherwise) {
  numbers(part, attribute, {&otherwise, 1}, 1);
  return otherwise;
}

Vec3d MjcfValues::vector(const MjcfPart& part, const char* attribute, const Vec3d& otherwise) {
  std::array<double, 3> v{otherwise.x, otherwise.y, otherwise.z};
  numbers(part, attribute, v, 3);
  return {v[0], v[1], v[2]};
}

std::optional<std::array<double, 2>> MjcfValues::range(const MjcfPart& part, const char* attribute,
                                                       const char* limited) {
  const Found found = find(part, attribute);
  std::string_view limits = word(part, limited);
  if (limits.empty() || limits == "auto") {
    limits = settings_.autolimits && found.text != nullptr ? "true" : "false";
  }
  if (limits == "false") return std::nullopt;
  if (limits != "true") {
    files_.wrong(part.element, say("true_false_auto", limited, shown(limits)));
  }
  if (found.text == nullptr) {
    files_.wrong(part.element, say("limited_without", limited, attribute));
  }
  std::array<double, 2> ends{};
  parse(found, attribute, ends, 2, kInfinity);
  if (ends[0] > ends[1]) {
    files_.wrong(*found.at, say("lower_first", attribute, shown(found.text)));
  }
  return ends;
}

Transformd MjcfValues::place(const MjcfPart& part) {
  return {orientation(part), vector(part, "pos")};
}

Vec3d MjcfValues::direction(const Found& found, const char* attribute, const Vec3d& v) {
  const double length = norm(v);
  if (length > kShortest) return v * (1.0 / length);
  files_.wrong(*found.at, say("no_direction", attribute, shown(found.text)));
  return {0, 0, 1};
}

Mat3d MjcfValues::orientation(const MjcfPart& part) {
  constexpr std::array kForms{"quat", "axisangle", "euler", "xyaxes", "zaxis"};
  const char* form = nullptr;
  Found nearest;
  for (const char* each : kForms) {
    const Found found = find(part, each);
    // within one element, MuJoCo applies quat last
    const bool nearer = nearest.text == nullptr || found.distance <= nearest.distance;
    if (found.text == nullptr || !nearer) continue;
    nearest = found;
    form = each;
  }
  if (form == nullptr) return {};
  std::array<double, 6> v{};
  const std::string_view name = form;
  const std::size_t count = name == "xyaxes" ? 6 : name == "quat" || name == "axisangle" ? 4 : 3;
  parse(nearest, form, std::span(v).first(count), count, kMjcfMaxValue);
  const Vec3d first{v[0], v[1], v[2]};
  if (name == "euler") return euler(first);
  if (name == "zaxis") return turned_to(direction(nearest, form, first));
  if (name == "axisangle") {
    return turned_about(direction(nearest, form, first), angle(v[3]));
  }
  if (name == "xyaxes") {
    const Vec3d x = direction(nearest, form, first);
    const Vec3d other{v[3], v[4], v[5]};
    const Vec3d y = direction(nearest, form, other - x * dot(x, other));
    return {x, y, cross(x, y)};
  }
  const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  if (!(length > kShortest)) {
    files_.wrong(*nearest.at, say("no_rotation", shown(nearest.text)));
    return {};
  }
  return to_matrix(Quatd{v[1] / length, v[2] / length, v[3] / length, v[0] / length});
}

Mat3d MjcfValues::euler(const Vec3d& written) const {
  Mat3d turn;
  for (int k = 0; k < 3; ++k) {
    const char axis = settings_.euler[index(k)];
    const bool fixed = axis >= 'X' && axis <= 'Z';
    const Vec3d about{axis == 'x' || axis == 'X' ? 1.0 : 0.0,
                      axis == 'y' || axis == 'Y' ? 1.0 : 0.0,
                      axis == 'z' || axis == 'Z' ? 1.0 : 0.0};
    const Mat3d one = turned_about(about, angle(written[k]));
    turn = fixed ? one * turn : turn * one;
  }
  return turn;
}

MjcfActuators::MjcfActuators(MjcfFiles& files, MjcfValues& values) : values_(values) {
  if (files.root() == nullptr) return;
  files.each(*files.root(), [&](const XmlElement& section) {
    if (section.name != "actuator") return;
    files.each(section, [&](const XmlElement& e) { read({e, {}}); });
  });
}

void MjcfActuators::read(const MjcfPart& part) {
  std::string_view joint = values_.word(part, "joint");
  if (joint.empty()) joint = values_.word(part, "jointinparent");
  if (joint.empty()) return;
  std::array<double, 6> gear{1.0};
  values_.numbers(part, "gear", gear, 1);
  double force = kInfinity;
  if (const auto ends = values_.range(part, "forcerange", "forcelimited")) force = farther(*ends);
  const std::string_view tag = part.element.name;
  const std::string_view bias = values_.word(part, "biastype");
  const std::string_view gain_type = values_.word(part, "gaintype");
  const bool plain =
      (bias.empty() || bias == "none") && (gain_type.empty() || gain_type == "fixed");
  if (tag == "motor" || (tag == "general" && plain)) {
    std::array<double, 10> gain{1.0};
    if (tag == "general") values_.numbers(part, "gainprm", gain, 1);
    if (const auto ends = values_.range(part, "ctrlrange", "ctrllimited")) {
      force = min(force, abs(gain[0]) * farther(*ends));
    }
  }
  std::array<double, 3>& sum = sums_[std::string(joint)];
  for (std::size_t k = 0; k < 3; ++k) {
    if (gear[k] != 0.0) sum[k] += abs(gear[k]) * force;
  }
}

double MjcfActuators::effort(const std::string& joint, const MjcfPart& part, std::size_t axis) {
  const auto found = sums_.find(joint);
  double effort = found == sums_.end() ? 0.0 : found->second[axis];
  if (const auto ends = values_.range(part, "actuatorfrcrange", "actuatorfrclimited")) {
    effort = effort > 0.0 ? min(effort, farther(*ends)) : farther(*ends);
  }
  return effort <= kMjcfMaxValue ? effort : 0.0;
}

}  // namespace shigusa
