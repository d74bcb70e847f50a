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

// An element of a model, and the class of the bodies around it.
struct MjcfPart {
  const XmlElement& element;
  std::string_view childclass;
};

// The settings of <compiler>, for all the model.
struct MjcfSettings {
  bool degrees = true;
  bool autolimits = true;           // a range is a limit
  bool from_inertial = true;        // a body's <inertial> counts …
  bool from_geoms = true;           // … and where it has none, its shapes do
  std::array<int, 2> groups{0, 5};  // of shapes that have mass
  double total_mass = 0.0;          // kg; 0: as it is
  std::string euler = "xyz";        // order of the angles; capitals: about fixed axes
};

// Reads the attributes of a model's elements, by their own words, their class's and those of the
// classes around it. Errors are noted in the files; a wrong value leaves the one that was given.
class MjcfValues {
 public:
  // Reads settings and classes.
  explicit MjcfValues(MjcfFiles& files);

  [[nodiscard]] const MjcfSettings& settings() const { return settings_; }

  // The text of an attribute; "" where there is none.
  [[nodiscard]] std::string_view word(const MjcfPart& part, const char* attribute) const;
  [[nodiscard]] bool has(const MjcfPart& part, const char* attribute) const;

  // Fills as many numbers as there are, `least` at least; how many, 0 where there is no attribute.
  std::size_t numbers(const MjcfPart& part, const char* attribute, std::span<double> values,
                      std::size_t least);
  double number(const MjcfPart& part, const char* attribute, double otherwise);
  Vec3d vector(const MjcfPart& part, const char* attribute, const Vec3d& otherwise = {});

  // The two ends of a range, where it limits: by `limited`, or by being there. Infinite ends are
  // none.
  std::optional<std::array<double, 2>> range(const MjcfPart& part, const char* attribute,
                                             const char* limited);

  // By pos and by quat, axisangle, euler, xyaxes or zaxis; the nearest class with one decides.
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
    const XmlElement* at = nullptr;  // the element that has it
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

// How much the actuators of a model can do about the axes of its joints.
class MjcfActuators {
 public:
  MjcfActuators(MjcfFiles& files, MjcfValues& values);

  // N·m, or N: what the actuators of a joint come to about its axis of that index, no more than
  // actuatorfrcrange allows; 0 where there is no limit, or nothing that drives it.
  [[nodiscard]] double effort(const std::string& joint, const MjcfPart& part, std::size_t axis);

 private:
  void read(const MjcfPart& part);

  MjcfValues& values_;
  std::map<std::string, std::array<double, 3>> sums_;  // by joint; infinite: no limit
};

// The rotation about a unit vector.
[[nodiscard]] Mat3d turned_about(const Vec3d& axis, double angle);

// The shortest rotation of +z to a direction, a unit vector.
[[nodiscard]] Mat3d turned_to(const Vec3d& z);

}  // namespace shigusa
