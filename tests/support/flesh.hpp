// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <shigusa/generate.hpp>
#include <string>
#include <vector>

#include "kinematics/skeleton_motion.hpp"

// Depth of a person's forearms and hands in head and shanks, by another geometry than the kernel's:
// an ellipsoid, and tapered limbs, sampled point by point. Sizes are in parts of the stature of
// 1.756 m, from the 1988 Anthropometric Survey of U.S. Army Personnel (men): head breadth 0.152 m
// and length 0.197 m, circumferences of calf 0.378 m, ankle 0.222 m and wrist 0.174 m; a forearm of
// 0.25 m below the elbow.
namespace shigusa::testing_support {

// Positions of a body's nodes in a clip. The nameless end below a node is "head.end".
class ClipPlaces {
 public:
  ClipPlaces(const BodyModel& body, const Clip& clip) : motion_(skeleton_motion(body, clip)) {
    for (int f = 0; f < motion_.clip.frames; ++f) {
      places_.push_back(world_transforms(motion_.skeleton, motion_.clip, f));
    }
    const auto& nodes = motion_.skeleton.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      names_[nodes[i].end_site ? nodes[static_cast<std::size_t>(nodes[i].parent)].name + ".end"
                               : nodes[i].name] = i;
    }
  }
  [[nodiscard]] std::size_t frames() const { return places_.size(); }
  [[nodiscard]] bool has(const std::string& node) const { return names_.count(node) != 0; }
  [[nodiscard]] const Transformd& at(const std::string& node, std::size_t frame) const {
    return places_[frame][names_.at(node)];
  }

 private:
  SkeletonMotion motion_;
  std::vector<std::vector<Transformd>> places_;  // [frame][node]
  std::map<std::string, std::size_t> names_;
};

// The same for positions in the form of ClipPlaces.
template <class Places>
class Flesh {
 public:
  // `stature`: m
  Flesh(const Places& places, double stature) : places_(places), size_(stature / 1.756) {}

  struct Depths {
    double head = -1.0;   // m
    double shank = -1.0;  // m
  };

  // The deepest of any frame; some way below 0 where nothing is near.
  [[nodiscard]] Depths deepest() const {
    Depths most;
    for (std::size_t f = 0; f < places_.frames(); ++f) {
      for (const std::string side : {"left_", "right_"}) {
        if (!places_.has(side + "lower_arm")) continue;
        for (const Vec3d& point : arm_surface(side, f)) {
          most.head = std::fmax(most.head, in_head(point, f));
          for (const std::string leg : {"left_", "right_"}) {
            most.shank = std::fmax(most.shank, in_shank(point, leg, f));
          }
        }
      }
    }
    return most;
  }

 private:
  [[nodiscard]] const Transformd& place(const std::string& node, std::size_t frame) const {
    return places_.at(node, frame);
  }

  // the end below a node, which has no name
  [[nodiscard]] Vec3d end_of(const std::string& node, std::size_t frame) const {
    const std::string end = node + ".end";
    return place(places_.has(end) ? end : node, frame).translation;
  }

  // Points all around the forearm from elbow to wrist, and around the hand.
  [[nodiscard]] std::vector<Vec3d> arm_surface(const std::string& side, std::size_t frame) const {
    std::vector<Vec3d> points;
    const Vec3d elbow = place(side + "lower_arm", frame).translation;
    const Vec3d wrist = place(side + "hand", frame).translation;
    const Vec3d tip = end_of(side + "hand_grip", frame);
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
  [[nodiscard]] double in_head(const Vec3d& point, std::size_t frame) const {
    const Transformd& head = place("head", frame);
    const Vec3d vertex = end_of("head", frame);
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
                                std::size_t frame) const {
    if (!places_.has(side + "lower_leg")) return -1.0;
    const Vec3d knee = place(side + "lower_leg", frame).translation;
    const Vec3d way = place(side + "foot", frame).translation - knee;
    const double along = dot(point - knee, way) / dot(way, way);
    if (along < 0.0 || along > 1.0) return -1.0;
    constexpr double kCalf = 0.378 / (2.0 * kPi);
    constexpr double kAnkle = 0.222 / (2.0 * kPi);
    const double share = std::fmax(along - 0.3, 0.0) / 0.7;
    const double radius = size_ * (kCalf + (kAnkle - kCalf) * share);
    return radius - norm(point - knee - way * along);
  }

  const Places& places_;
  double size_;
};

}  // namespace shigusa::testing_support
