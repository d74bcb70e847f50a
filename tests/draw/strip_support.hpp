// SPDX-License-Identifier: MIT
// Figures for tests of strips, and a reader of the strips' SVG.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

namespace shigusa::strip_support {

inline constexpr double kPointsPerMm = 72.0 / 25.4;
// Rims and line widths extend beyond their paths.
inline constexpr double kLineSlack = 1.0;
// Positions have hundredths of a point: they differ by two roundings.
inline constexpr double kSamePlace = 1.01 / 100.0;
// An arc of at most 3/8 of a turn moves by 1.7 times as much as both of its ends.
inline constexpr double kSameArc = 2.0 * 1.7 * kSamePlace;

// A standing body of 1.7 m with VRM names, facing +Z, for `frames` frames.
inline SkeletonMotion standing(int frames) {
  SkeletonMotion motion;
  auto& nodes = motion.skeleton.nodes;
  const auto add = [&](const std::string& name, const std::string& parent, Vec3d offset) {
    nodes.push_back({name, motion.skeleton.find(parent), offset, false});
  };
  nodes.push_back({"hips", -1, {0, 0.93, 0}, false});
  add("spine", "hips", {0, 0.2, 0});
  add("neck", "spine", {0, 0.32, 0});
  add("head", "neck", {0, 0.09, 0.02});
  for (const std::string side : {"left_", "right_"}) {
    const double out = side == "left_" ? 1.0 : -1.0;
    add(side + "upper_leg", "hips", {0.09 * out, -0.03, 0});
    add(side + "lower_leg", side + "upper_leg", {0, -0.42, 0});
    add(side + "foot", side + "lower_leg", {0, -0.41, 0});
    add(side + "toes", side + "foot", {0, -0.07, 0.15});
    add(side + "upper_arm", "spine", {0.18 * out, 0.28, 0});
    add(side + "lower_arm", side + "upper_arm", {0, -0.28, 0});
    add(side + "hand", side + "lower_arm", {0, -0.25, 0});
    add(side + "hand_grip", side + "hand", {0, -0.09, 0});
  }
  motion.clip.frames = frames;
  for (int frame = 0; frame < frames; ++frame) {
    for (const SkeletonNode& node : nodes) motion.clip.local.push_back({node.offset, {}});
  }
  return motion;
}

inline LocalTransform& local(SkeletonMotion& motion, int frame, const std::string& node) {
  const auto nodes = motion.skeleton.nodes.size();
  return motion.clip.local[static_cast<std::size_t>(frame) * nodes +
                           static_cast<std::size_t>(motion.skeleton.find(node))];
}

// The right arm rises forward, to a right angle in the last frame.
inline SkeletonMotion reaching(int frames) {
  SkeletonMotion motion = standing(frames);
  for (int frame = 0; frame < frames; ++frame) {
    const double share = frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1.0;
    local(motion, frame, "right_upper_arm").rotation =
        axis_rotation(Axis::x, radians(-90.0 * share));
  }
  return motion;
}

// The whole motion turned about the origin.
inline SkeletonMotion turned(SkeletonMotion motion, const Quatd& turn) {
  const Mat3d matrix = to_matrix(turn);
  for (int frame = 0; frame < motion.clip.frames; ++frame) {
    LocalTransform& root = local(motion, frame, "hips");
    root = {matrix * root.translation, turn * root.rotation};
  }
  return motion;
}

// Bones a hundred times as long.
inline SkeletonMotion in_centimetres(SkeletonMotion motion) {
  for (SkeletonNode& node : motion.skeleton.nodes) node.offset = node.offset * 100.0;
  for (LocalTransform& x : motion.clip.local) x.translation = x.translation * 100.0;
  return motion;
}

inline std::vector<Vec3d> path_of(const SkeletonMotion& motion, const std::string& node) {
  std::vector<Vec3d> path;
  const auto index = static_cast<std::size_t>(motion.skeleton.find(node));
  for (int frame = 0; frame < motion.clip.frames; ++frame) {
    const auto world = world_transforms(motion.skeleton, motion.clip, frame);
    path.push_back(world[index].translation);
  }
  return path;
}

inline std::string svg(const SkeletonMotion& motion, const StripOverlay& overlay = {},
                       const StripSettings& settings = {}) {
  return draw_strip(motion, overlay, settings).value();
}

// A path or a circle: its attributes except positions, and the ends of its lines and arcs.
struct Path {
  std::string look;
  std::vector<double> x;
  std::vector<double> y;
  // of arcs too
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;

  [[nodiscard]] double left() const { return low_x; }
  [[nodiscard]] double right() const { return high_x; }
  [[nodiscard]] double top() const { return low_y; }
  [[nodiscard]] double bottom() const { return high_y; }
  [[nodiscard]] bool filled(const std::string& colour) const {
    return look.find("fill=\"" + colour + "\"") != std::string::npos;
  }
  // of the group's colour, white
  [[nodiscard]] bool has_white_stroke() const {
    return look.find(" stroke=\"") == std::string::npos;
  }

  void touch(double to_x, double to_y) {
    low_x = std::min(low_x, to_x);
    high_x = std::max(high_x, to_x);
    low_y = std::min(low_y, to_y);
    high_y = std::max(high_y, to_y);
  }
  void add(double to_x, double to_y) {
    x.push_back(to_x);
    y.push_back(to_y);
    touch(to_x, to_y);
  }
  // Clockwise on the page, at most half a turn, from the last point.
  void add_arc(double radius, double to_x, double to_y);
};

inline void Path::add_arc(double radius, double to_x, double to_y) {
  const double from_x = x.back();
  const double from_y = y.back();
  const double half_x = 0.5 * (to_x - from_x);
  const double half_y = 0.5 * (to_y - from_y);
  const double half = std::hypot(half_x, half_y);
  const double rise = std::sqrt(std::max(radius * radius - half * half, 0.0)) / half;
  const double centre_x = from_x + half_x - rise * half_y;
  const double centre_y = from_y + half_y + rise * half_x;
  const double start = std::atan2(from_y - centre_y, from_x - centre_x);
  const double turn = 2.0 * std::asin(std::min(half / radius, 1.0));
  for (int i = 1; i < 8; ++i) {
    const double angle = start + turn * i / 8.0;
    touch(centre_x + radius * std::cos(angle), centre_y + radius * std::sin(angle));
  }
  add(to_x, to_y);
}

// The next number of a path or an attribute.
inline double take_number(const char*& text) {
  // a second point starts a number, which strtod knows as well
  char* end = nullptr;
  while (*text == ' ' || *text == ',') ++text;
  const double value = std::strtod(text, &end);
  EXPECT_NE(end, text) << "no number: " << std::string(text).substr(0, 20);
  text = end;
  return value;
}

inline double attribute(const std::string& element, const std::string& name) {
  const std::size_t at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return 0.0;
  const char* text = element.c_str() + at + name.size() + 3;
  return take_number(text);
}

// Reads the output of Canvas: absolute starts, then relative lines and arcs.
inline void read_data(const std::string& data, Path& path) {
  char command = 0;
  for (const char* next = data.c_str(); *next != '\0';) {
    if (std::isalpha(static_cast<unsigned char>(*next)) != 0) command = *next++;
    if (command == 'z') continue;
    const double radius = command == 'a' ? take_number(next) : 0.0;
    for (int i = 0; command == 'a' && i < 4; ++i) (void)take_number(next);
    const double x = take_number(next);
    const double y = take_number(next);
    if (command == 'M') {
      path.add(x, y);
    } else if (command == 'l') {
      path.add(path.x.back() + x, path.y.back() + y);
    } else {
      path.add_arc(radius, path.x.back() + x, path.y.back() + y);
    }
  }
}

// The paths and circles of an SVG text, in painting order.
inline std::vector<Path> paths(const std::string& text) {
  std::vector<Path> result;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::string element = text.substr(at, text.find('>', at) - at);
    Path path;
    if (element.rfind("<path", 0) == 0) {
      const std::size_t data = element.find(" d=\"");
      path.look = element.substr(0, data);
      read_data(element.substr(data + 4, element.rfind('"') - data - 4), path);
    } else if (element.rfind("<circle", 0) == 0) {
      path.look = "circle";
      const double x = attribute(element, "cx");
      const double y = attribute(element, "cy");
      const double radius = attribute(element, "r");
      path.add(x - radius, y - radius);
      path.add(x + radius, y + radius);
    } else {
      continue;
    }
    result.push_back(path);
  }
  return result;
}

// A line of text, at its baseline.
struct Words {
  std::string text;
  double left = 0.0;
  double right = 0.0;
  double base = 0.0;
};

inline std::vector<Words> words(const std::string& text) {
  std::vector<Words> result;
  for (std::size_t at = text.find("<text"); at != std::string::npos;
       at = text.find("<text", at + 1)) {
    const std::size_t begin = text.find('>', at) + 1;
    const std::string element = text.substr(at, begin - at);
    Words line{text.substr(begin, text.find("</text>", at) - begin), 0, 0, attribute(element, "y")};
    const double length = attribute(element, "textLength");
    const double share = element.find("\"middle\"") != std::string::npos ? 0.5
                         : element.find("\"end\"") != std::string::npos  ? 1.0
                                                                         : 0.0;
    line.left = attribute(element, "x") - share * length;
    line.right = line.left + length;
    result.push_back(line);
  }
  return result;
}

inline double base_of(const std::string& svg_text, const std::string& line) {
  for (const Words& found : words(svg_text)) {
    if (found.text == line) return found.base;
  }
  ADD_FAILURE() << "no line '" << line << "'";
  return 0.0;
}

// The figures' pieces and the marks around them, which have a white rim.
inline std::vector<Path> rims(const std::string& text) {
  std::vector<Path> result = paths(text);
  std::erase_if(result, [](const Path& path) { return !path.has_white_stroke(); });
  return result;
}

inline constexpr const char* kAccent = "#a32b19";

inline std::vector<Path> filled(const std::string& text, const std::string& colour) {
  std::vector<Path> result = paths(text);
  std::erase_if(result, [&](const Path& path) { return !path.filled(colour); });
  return result;
}

// Number of groups after pieces that share a column are merged.
inline std::size_t separate_figures(const std::string& text) {
  std::vector<Path> pieces = rims(text);
  std::sort(pieces.begin(), pieces.end(),
            [](const Path& a, const Path& b) { return a.left() < b.left(); });
  std::size_t count = 0;
  double right = -1e9;
  for (const Path& piece : pieces) {
    if (piece.left() > right) ++count;
    right = std::max(right, piece.right());
  }
  return count;
}

inline void expect_same_picture(const std::string& a, const std::string& b, double tolerance) {
  const std::vector<Path> first = paths(a);
  const std::vector<Path> second = paths(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].look, second[i].look);
    ASSERT_EQ(first[i].x.size(), second[i].x.size());
    for (std::size_t k = 0; k < first[i].y.size(); ++k) {
      EXPECT_NEAR(first[i].x[k], second[i].x[k], tolerance);
      EXPECT_NEAR(first[i].y[k], second[i].y[k], tolerance);
    }
  }
}

inline double page_height(const std::string& text) {
  return attribute(text.substr(text.find("<svg")), "height");
}

inline bool within_page(const std::string& text) {
  const double width = attribute(text.substr(text.find("<svg")), "width");
  const double height = page_height(text);
  for (const Path& path : paths(text)) {
    if (!(path.left() >= -kLineSlack && path.right() <= width + kLineSlack)) return false;
    if (!(path.top() >= -kLineSlack && path.bottom() <= height + kLineSlack)) return false;
  }
  for (const Words& line : words(text)) {
    if (!(line.left >= 0.0 && line.right <= width && line.base < height)) return false;
  }
  return text.find("nan") == std::string::npos && text.find("inf") == std::string::npos;
}

inline StripOverlay full_overlay(const SkeletonMotion& motion) {
  StripOverlay overlay;
  overlay.hand_path = path_of(motion, "right_hand_grip");
  overlay.centre_of_mass = path_of(motion, "hips");
  overlay.goals = {overlay.hand_path.back()};
  overlay.caption = "Reaching forward";
  return overlay;
}

}  // namespace shigusa::strip_support
