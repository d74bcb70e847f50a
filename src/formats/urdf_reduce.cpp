// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include "core/say.hpp"
#include "core/text.hpp"
#include "formats/urdf.hpp"

namespace shigusa {
namespace {

// Elements that are kept, each after its parent.
constexpr std::pair<std::string_view, std::string_view> kKept[] = {
    {"robot", "link"},       {"robot", "joint"},       {"link", "inertial"},
    {"inertial", "origin"},  {"inertial", "mass"},     {"inertial", "inertia"},
    {"link", "collision"},   {"collision", "origin"},  {"collision", "geometry"},
    {"geometry", "box"},     {"geometry", "sphere"},   {"geometry", "cylinder"},
    {"geometry", "capsule"}, {"link", "visual"},       {"visual", "origin"},
    {"visual", "geometry"},  {"joint", "origin"},      {"joint", "parent"},
    {"joint", "child"},      {"joint", "axis"},        {"joint", "limit"},
    {"joint", "mimic"},      {"robot", "group_state"}, {"group_state", "joint"}};

// Whether a value is infinite, NaN or at least kUrdfMaxValue.
bool is_no_limit(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n+-");
  if (begin == text.npos) return false;
  const char first = lower(text[begin]);
  if (first == 'i' || first == 'n') return true;
  const auto read = xml_numbers(text, 1);
  return read && abs(read->front()) >= kUrdfMaxValue;
}

// Copies a joint's limits. Infinite, NaN and huge values mean no limit.
XmlElement reduced_limit(const XmlElement& limit) {
  XmlElement reduced{limit.name, {}, {}, limit.line};
  for (const char* name : {"lower", "upper", "effort", "velocity"}) {
    const bool angle = name[0] == 'l' || name[0] == 'u';
    const char* written = limit.attribute(name);
    const std::string value = written != nullptr && *written != '\0' ? written : angle ? "" : "0";
    if (value.empty()) continue;
    const char* none = !angle ? "0" : value.find('-') != value.npos ? "-1000" : "1000";
    reduced.attributes.emplace_back(name, is_no_limit(value) ? none : value);
  }
  return reduced;
}

// Copies the elements that are kept, and counts them.
class Reducer {
 public:
  explicit Reducer(std::string_view name) : name_(name) {}

  Result<XmlElement> reduce(const XmlElement& element) {
    if (element.name == "limit") return reduced_limit(element);
    // a capsule without its round ends is a cylinder
    XmlElement reduced{element.name == "capsule" ? "cylinder" : element.name,
                       element.attributes,
                       {},
                       element.line};
    for (const XmlElement& child : element.children) {
      if (child.name.starts_with("xacro:")) {
        return fail_at(child, name_, say("xacro", child.name.substr(0, 60)));
      }
      if (!contains(kKept, std::pair<std::string_view, std::string_view>(element.name, child.name)))
        continue;
      if (element.name == "robot") SHG_TRY(count(child));
      SHG_TRY_ASSIGN(XmlElement kept, reduce(child));
      // meshes are not read
      const bool shape = kept.name == "collision" || kept.name == "visual";
      const XmlElement* geometry = shape ? kept.child("geometry") : nullptr;
      if (shape && (geometry == nullptr || geometry->children.empty())) continue;
      reduced.children.push_back(std::move(kept));
    }
    return reduced;
  }

 private:
  Result<void> count(const XmlElement& element) {
    if (element.name == "link" && ++links_ > kUrdfMaxLinks) {
      return fail_at(element, name_, say("links_most", kUrdfMaxLinks));
    }
    if (element.name == "joint" && ++joints_ > kUrdfMaxLinks) {
      return fail_at(element, name_, say("joints_most", kUrdfMaxLinks));
    }
    return {};
  }

  std::string_view name_;
  int links_ = 0;
  int joints_ = 0;
};

}  // namespace

Result<XmlElement> reduced_urdf(std::string_view text, std::string_view name) {
  const XmlLimits limits{kUrdfMaxBytes, kUrdfMaxTags, kUrdfMaxDepth};
  SHG_TRY_ASSIGN(const XmlElement robot, parse_xml(text, limits, name));
  if (robot.name != "robot") {
    return fail_at(robot, name, say("no_urdf", robot.name.substr(0, 60)));
  }
  return Reducer(name).reduce(robot);
}

}  // namespace shigusa
