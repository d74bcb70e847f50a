// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf_files.hpp"

namespace shigusa {

// An element of a model, with the default class of the surrounding bodies.
struct MjcfPart {
  const XmlElement& element;
  std::string_view childclass;
};

// Settings of <compiler>, for the whole model.
struct MjcfSettings {
  bool degrees = true;
  bool autolimits = true;           // a range is a limit
  bool from_inertial = true;        // whether a body's <inertial> counts
  bool from_geoms = true;           // whether missing ones come from the shapes
  std::array<int, 2> groups{0, 5};  // of shapes that have mass
  double total_mass = 0.0;          // kg; 0: not scaled
  std::string euler = "xyz";        // order of the angles; capitals: about fixed axes
};

// Reader of attributes: from the element, its class, and surrounding classes. Errors are recorded
// in the files; a malformed value keeps the given one.
class MjcfValues {
 public:
  // Reads settings and classes.
  explicit MjcfValues(MjcfFiles& files);

  [[nodiscard]] const MjcfSettings& settings() const { return settings_; }

  // Text of an attribute; "" if absent.
  [[nodiscard]] std::string_view word(const MjcfPart& part, const char* attribute) const;
  [[nodiscard]] bool has(const MjcfPart& part, const char* attribute) const;

  // Reads up to the given number of values, at least `least`; returns their number, 0 if the
  // attribute is absent.
  std::size_t numbers(const MjcfPart& part, const char* attribute, std::span<double> values,
                      std::size_t least);
  double number(const MjcfPart& part, const char* attribute, double otherwise);
  Vec3d vector(const MjcfPart& part, const char* attribute, const Vec3d& otherwise = {});

  // Both ends of a limiting range, by `limited` or by its presence; none if they are infinite.
  std::optional<std::array<double, 2>> range(const MjcfPart& part, const char* attribute,
                                             const char* limited);

  // From pos and from quat, axisangle, euler, xyaxes or zaxis, of the nearest class with one of
  // them.
  Transformd place(const MjcfPart& part);

  // rad
  [[nodiscard]] double angle(double written) const {
    return settings_.degrees ? radians(written) : written;
  }

 private:
  struct Class {
    std::string above;  // "" of the outermost
    std::vector<const XmlElement*> elements;
  };
  struct Found {
    const XmlElement* at = nullptr;  // the element with the attribute
    const char* text = nullptr;
    int distance = 0;  // classes from the element's own words
  };

  void read_compiler(const XmlElement& compiler);
  void read_class(const XmlElement& element, const std::string& above, int depth);
  [[nodiscard]] Found find(const MjcfPart& part, const char* attribute) const;
  std::size_t parse(const Found& found, const char* attribute, std::span<double> values,
                    std::size_t least, double most);
  Mat3d orientation(const MjcfPart& part);
  Mat3d euler(const Vec3d& written) const;
  Vec3d direction(const Found& found, const char* attribute, const Vec3d& v);

  MjcfFiles& files_;
  MjcfSettings settings_;
  std::map<std::string, Class, std::less<>> classes_;
  std::string main_ = "main";  // the outermost class
};

// Forces of a model's actuators on its joints' axes.
class MjcfActuators {
 public:
  MjcfActuators(MjcfFiles& files, MjcfValues& values);

  // Largest actuator torque (N·m) or force (N) about an axis of a joint, limited by
  // actuatorfrcrange; 0 without a limit or without an actuator.
  [[nodiscard]] double effort(const std::string& joint, const MjcfPart& part, std::size_t axis);

 private:
  void read(const MjcfPart& part);

  MjcfValues& values_;
  std::map<std::string, std::array<double, 3>> sums_;  // by joint; infinite: no limit
};

// Rotation about a unit vector.
[[nodiscard]] Mat3d turned_about(const Vec3d& axis, double angle);

// Shortest rotation from +z to a unit vector.
[[nodiscard]] Mat3d turned_to(const Vec3d& z);

}  // namespace shigusa
