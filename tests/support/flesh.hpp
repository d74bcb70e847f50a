// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <shigusa/generate.hpp>
#include <string>
#include <vector>

#include "kinematics/skeleton_motion.hpp"

// How deep a person's forearms and hands are in head and shanks, by another geometry than the
// kernel's: an ellipsoid, and limbs that taper, sampled point by point. Sizes are in parts of
// the stature of 1.756 m, from the 1988 Anthropometric Survey of U.S. Army Personnel (men): head
// breadth 0.152 m and length 0.197 m, circumferences of calf 0.378 m, ankle 0.222 m and wrist
// 0.174 m; a forearm of 0.25 m below the elbow.
namespace shigusa::testing_support {

class Flesh {
 public:
  Flesh(const BodyModel& body, const Clip& clip)
      : motion_(skeleton_motion(body, clip)), size_(body.stature() / 1.756) {}

  struct Depths {
    double head = -1.0;   // m
    double shank = -1.0;  // m
  };

  // The deepest of any frame; some way below 0 where nothing is near.
  [[nodiscard]] Depths deepest() const {
    Depths most;
    for (int f = 0; f < motion_.clip.frames; ++f) {
      const auto world = world_transforms(motion_.skeleton, motion_.clip, f);
      for (const std::string side : {"left_", "right_"}) {
        if (motion_.skeleton.find(side + "lower_arm") < 0) continue;
        for (const Vec3d& point : arm_surface(side, world)) {
          most.head = std::fmax(most.head, in_head(point, world));
          for (const std::string leg : {"left_", "right_"}) {
            most.shank = std::fmax(most.shank, in_shank(point, leg, world));
          }
        }
      }
    }
    return most;
  }

 private:
  using World = std::vector<Transformd>;

  [[nodiscard]] const Transformd& place(const std::string& node, const World& world) const {
    return world[static_cast<std::size_t>(motion_.skeleton.find(node))];
  }

  // the end below a node, which has no name
  [[nodiscard]] Vec3d end_of(const std::string& node, const World& world) const {
    const auto& nodes = motion_.skeleton.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].end_site && nodes[i].parent == motion_.skeleton.find(node)) {
        return world[i].translation;
      }
    }
    return place(node, world).translation;
  }

  // Points all around the forearm from elbow to wrist, and around the hand.
  [[nodiscard]] std::vector<Vec3d> arm_surface(const std::string& side, const World& world) const {
    std::vector<Vec3d> points;
    const Vec3d elbow = place(side + "lower_arm", world).translation;
    const Vec3d wrist = place(side + "hand", world).translation;
    const Vec3d tip = end_of(side + "hand_grip", world);
    add_rings(elbow, wrist, 0.250 / (2.0 * kPi), 0.174 / (2.0 * kPi), points);
    add_rings(wrist, tip, 0.014, 0.010, points);
    return points;
  }

  void add_rings(const Vec3d& from, const Vec3d& to, double first, double last,
                 std::vector<Vec3d>& points) const {
    constexpr int kRings = 12;
    constexpr int kRound = 8;
    const Vec3d way = to - from;
    const Vec3d across = normalized(
        cross(way, std::fabs(way.y) > 0.9 * norm(way) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const Vec3d other = normalized(cross(way, across));
    for (int i = 0; i <= kRings; ++i) {
      const double share = static_cast<double>(i) / kRings;
      const double radius = size_ * (first + (last - first) * share);
      for (int k = 0; k < kRound; ++k) {
        const double turn = 2.0 * kPi * k / kRound;
        points.push_back(from + way * share +
                         (across * std::cos(turn) + other * std::sin(turn)) * radius);
      }
    }
  }

  // An ellipsoid between vertex and chin: how far in on the way to its middle.
  [[nodiscard]] double in_head(const Vec3d& point, const World& world) const {
    const Transformd& head = place("head", world);
    const Vec3d vertex = end_of("head", world);
    const Vec3d up = normalized(vertex - head.translation);
    const Vec3d left = normalized(head.rotation.cx - up * dot(head.rotation.cx, up));
    const double half = 0.5 * (1.0 - 0.870) * 1.756 * size_;
    const Vec3d d = point - (vertex - up * half);
    const Vec3d p{dot(d, left) / (0.076 * size_), dot(d, up) / half,
                  dot(d, cross(left, up)) / (0.0985 * size_)};
    const double share = norm(p);
    return share < 1e-6 ? half : norm(d) * (1.0 / share - 1.0);
  }

  // A limb that is thickest at three tenths of the way from the knee.
  [[nodiscard]] double in_shank(const Vec3d& point, const std::string& side,
                                const World& world) const {
    if (motion_.skeleton.find(side + "lower_leg") < 0) return -1.0;
    const Vec3d knee = place(side + "lower_leg", world).translation;
    const Vec3d way = place(side + "foot", world).translation - knee;
    const double along = dot(point - knee, way) / dot(way, way);
    if (along < 0.0 || along > 1.0) return -1.0;
    constexpr double kCalf = 0.378 / (2.0 * kPi);
    constexpr double kAnkle = 0.222 / (2.0 * kPi);
    const double share = std::fmax(along - 0.3, 0.0) / 0.7;
    const double radius = size_ * (kCalf + (kAnkle - kCalf) * share);
    return radius - norm(point - knee - way * along);
  }

  SkeletonMotion motion_;
  double size_;
};

}  // namespace shigusa::testing_support
