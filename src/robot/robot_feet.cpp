// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "core/text.hpp"
#include "rig/humanoid_names.hpp"
#include "robot_builder.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Height (m) above the lowest corner within which corners touch the floor.
constexpr double kSoleSlack = 0.01;
// Size of a sole, as a share of the stature, below which shapes are not a foot's.
constexpr double kLeastSole = 0.02;

struct Bounds {
  double left = 0.0;
  double right = 0.0;
  double front = 0.0;
  double back = 0.0;
};

// Bounds of the corners up to that height.
Bounds bounds_below(const std::vector<Vec3d>& corners, double height) {
  constexpr double kNone = 1e9;
  Bounds b{-kNone, kNone, -kNone, kNone};
  for (const Vec3d& c : corners) {
    if (c.y > height) continue;
    b = {max(b.left, c.x), min(b.right, c.x), max(b.front, c.z), min(b.back, c.z)};
  }
  return b;
}

RobotSole rectangle(const Bounds& b, double y, bool guessed) {
  return {{Vec3d{b.left, y, b.front}, Vec3d{b.left, y, b.back}, Vec3d{b.right, y, b.back},
           Vec3d{b.right, y, b.front}},
          guessed};
}

// Heights of a foot's sole (m, world) from its frames and masses, if any.
struct SoleMarks {
  std::optional<double> called;  // the lowest frame that is fixed to it and is called a sole's
  std::optional<double> frame;   // of any other frame, sensors excepted
  std::optional<double> mass;    // the bottom of the boxes that weigh and turn as its links do
};

void lower_to(std::optional<double>& lowest, double y) { lowest = lowest ? min(*lowest, y) : y; }

bool is_called_sole(const std::string& link) {
  const std::string name = lower(link);
  for (const char* word : {"sole", "foot", "feet", "toe", "heel", "contact", "ground"}) {
    if (name.find(word) != name.npos) return true;
  }
  return false;
}

// Lowest corner of a box with the link's mass and inertia about its centre of mass; empty if it is
// not flat as a foot is, and without inertia.
std::optional<double> bottom_of_box(const Robot::Link& link, const Transformd& place) {
  constexpr double kFlattest = 0.6;  // of its length
  const Mat3d& i = link.inertia;
  if (!(min(min(i.cx.x, i.cy.y), i.cz.z) > 0.0)) return {};
  const double sum = i.cx.x + i.cy.y + i.cz.z;
  const auto half = [&](double own) { return sqrt(max(1.5 * (sum - 2.0 * own) / link.mass, 0.0)); };
  const Vec3d box{half(i.cx.x), half(i.cy.y), half(i.cz.z)};
  if (min(min(box.x, box.y), box.z) > kFlattest * max(max(box.x, box.y), box.z)) return {};
  double lowest = 1e9;
  for (const Vec3d& corner : box_corners(box)) {
    lowest = min(lowest, (place * (link.com + corner)).y);
  }
  return lowest;
}

SoleMarks sole_marks(const Robot& robot, const PlacedRobot& placed, const std::vector<int>& links) {
  SoleMarks marks;
  for (const int link : links) {
    const auto i = index(link);
    const Robot::Link& l = robot.links[i];
    const auto box = l.mass > 0.0 ? bottom_of_box(l, placed.links[i]) : std::nullopt;
    if (box) lower_to(marks.mass, *box);
    const int carrier = placed.carrier[i];
    // a joint's own frame is at its axis
    if (carrier < 0 || robot.joints[index(carrier)].turns) continue;
    const bool sensor = read_bone_name(l.name).part == BonePart::ornament;
    if (is_called_sole(l.name) && !sensor) {
      lower_to(marks.called, placed.links[i].translation.y);
    } else if (!sensor) {
      lower_to(marks.frame, placed.links[i].translation.y);
    }
  }
  return marks;
}

}  // namespace

RobotSole robot_sole(const Robot& robot, const PlacedRobot& placed, const std::vector<int>& links,
                     const Vec3d& ankle, double stature) {
  std::vector<Vec3d> corners;
  for (const int link : links) {
    const auto i = index(link);
    for (const Vec3d& corner : robot.links[i].corners())
      corners.push_back(placed.links[i] * corner);
  }
  const double length = F::kFootLength * stature;
  const double half = 0.5 * F::kFootBreadth * stature;
  const Bounds person{ankle.x + half, ankle.x - half, ankle.z + (1.0 - kHeelShare) * length,
                      ankle.z - kHeelShare * length};
  if (!corners.empty()) {
    double y = corners[0].y;
    for (const Vec3d& c : corners) y = min(y, c.y);
    const double least = kLeastSole * stature;
    const auto is_sole = [&](const Bounds& b) {
      return b.left - b.right > least && b.front - b.back > least;
    };
    // the sole is at the end of the shapes: if the lowest points give no outline, all of the foot's
    // do
    for (const double slack : {kSoleSlack, ankle.y - y}) {
      const Bounds b = bounds_below(corners, y + slack);
      if (is_sole(b)) return rectangle(b, y, false);
    }
    if (y < ankle.y) return rectangle(person, y, true);
  }
  const SoleMarks marks = sole_marks(robot, placed, links);
  for (const std::optional<double>& mark : {marks.called, marks.mass, marks.frame}) {
    const double drop = mark ? ankle.y - *mark : 0.0;
    if (drop > 0.01 * stature && drop < 0.15 * stature) return rectangle(person, *mark, true);
  }
  return rectangle(person, ankle.y - F::kAnkleHeight * stature, true);
}

}  // namespace shigusa
