// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "body/anthropometry.hpp"

namespace shigusa {

// A skeleton of points with unrotated nodes: a body to map and measure.
struct StickFigure {
  struct Point {
    std::string name;  // empty: an end site
    int parent = -1;
    Vec3d at;
  };
  std::vector<Point> points;

  [[nodiscard]] int find(std::string_view name) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].name == name) return static_cast<int>(i);
    }
    return -1;
  }
  Point& operator[](std::string_view name) { return points[static_cast<std::size_t>(find(name))]; }

  void add(std::string_view name, std::string_view parent, const Vec3d& at) {
    points.push_back({std::string(name), find(parent), at});
  }
  // Moves a node and all below it.
  void move(std::string_view name, const Vec3d& by) {
    std::vector<bool> moved(points.size());
    const std::size_t first = static_cast<std::size_t>(find(name));
    for (std::size_t i = first; i < points.size(); ++i) {
      const int parent = points[i].parent;
      moved[i] = i == first || (parent >= 0 && moved[static_cast<std::size_t>(parent)]);
      if (moved[i]) points[i].at += by;
    }
  }
  // The figure without a node and all below it.
  [[nodiscard]] StickFigure without(std::string_view name) const {
    StickFigure rest;
    std::vector<int> place(points.size(), -1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const int parent = points[i].parent;
      const int new_parent = parent < 0 ? -1 : place[static_cast<std::size_t>(parent)];
      if (points[i].name == name || (parent >= 0 && new_parent < 0)) continue;
      place[i] = static_cast<int>(rest.points.size());
      rest.points.push_back({points[i].name, new_parent, points[i].at});
    }
    return rest;
  }
  // Each point p becomes m · p.
  [[nodiscard]] StickFigure transformed(const Mat3d& m) const {
    StickFigure figure = *this;
    for (Point& point : figure.points) point.at = m * point.at;
    return figure;
  }
  [[nodiscard]] StickFigure nameless() const {
    StickFigure figure = *this;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].name.empty()) figure.points[i].name = "node" + std::to_string(i);
    }
    return figure;
  }

  [[nodiscard]] Skeleton skeleton() const {
    Skeleton result;
    for (const Point& point : points) {
      const Vec3d from =
          point.parent < 0 ? Vec3d{} : points[static_cast<std::size_t>(point.parent)].at;
      result.nodes.push_back({point.name, point.parent, point.at - from, point.name.empty()});
    }
    return result;
  }
  [[nodiscard]] std::vector<Transformd> world() const {
    std::vector<Transformd> result;
    for (const Point& point : points) result.push_back({{}, point.at});
    return result;
  }
};

// An upright person of 1.7 m with arms to the sides, in shigusa's world; every length is the
// stature's fraction in anthropometry.hpp, names are those of motion capture.
inline StickFigure standing_figure() {
  using F = StatureFractions;
  const double h = 1.7;
  const double ankle = F::kAnkleHeight * h;
  const double knee = ankle + F::kShank * h;
  const double hip = knee + F::kThigh * h;
  const double neck = h - F::kHeadLength * h;
  StickFigure figure;
  figure.add("Hips", "", {0, hip, 0});
  figure.add("Spine", "Hips", {0, hip + 0.2, 0});
  figure.add("Neck", "Spine", {0, neck, 0});
  figure.add("Head", "Neck", {0, neck + 0.1, 0});
  figure.add("", "Head", {0, h, 0});
  for (const std::string side : {"Left", "Right"}) {
    const double x = side == "Left" ? 1.0 : -1.0;
    figure.add(side + "UpLeg", "Hips", {0.085 * x, hip, 0});
    figure.add(side + "Leg", side + "UpLeg", {0.085 * x, knee, 0});
    figure.add(side + "Foot", side + "Leg", {0.085 * x, ankle, 0});
    figure.add(side + "ToeBase", side + "Foot", {0.085 * x, 0.02, 0.12});
    figure.add("", side + "ToeBase", {0.085 * x, 0.01, 0.19});
  }
  for (const std::string side : {"Left", "Right"}) {
    const double x = side == "Left" ? 1.0 : -1.0;
    const double shoulder = F::kShoulderHeight * h;
    const double out = F::kShoulderHalfBreadth * h;
    const double elbow = out + F::kUpperArm * h;
    const double wrist = elbow + F::kForearm * h;
    figure.add(side + "Shoulder", "Spine", {0.02 * x, shoulder, 0});
    figure.add(side + "Arm", side + "Shoulder", {out * x, shoulder, 0});
    figure.add(side + "ForeArm", side + "Arm", {elbow * x, shoulder, 0});
    figure.add(side + "Hand", side + "ForeArm", {wrist * x, shoulder, 0});
    figure.add("", side + "Hand", {(wrist + F::kHand * h) * x, shoulder, 0});
  }
  return figure;
}

}  // namespace shigusa
