// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/check.hpp"

// An independent reader of an exported BVH: nodes and their positions, by the file's own forward
// kinematics. It knows nothing of BodyModel.
namespace shigusa::testing_support {

class ExportedMotion {
 public:
  // `unit`: m per unit of the file
  ExportedMotion(std::string_view bvh, double unit)
      : motion_(parse_bvh(bvh, "exported.bvh").value()), unit_(unit) {
    for (int f = 0; f < frames(); ++f) {
      places_.push_back(world_transforms(motion_.skeleton, motion_.clip, f));
    }
  }

  [[nodiscard]] const SkeletonMotion& motion() const { return motion_; }
  [[nodiscard]] int frames() const { return motion_.clip.frames; }

  // Where a node's origin is (m).
  [[nodiscard]] Vec3d at(const std::string& node, int frame) const {
    return transform(node, frame).translation * unit_;
  }
  [[nodiscard]] Vec3d at_end(const std::string& node) const { return at(node, frames() - 1); }

  // How a node is turned in the world.
  [[nodiscard]] const Mat3d& rotation(const std::string& node, int frame) const {
    return transform(node, frame).rotation;
  }
  [[nodiscard]] const Mat3d& rotation_at_end(const std::string& node) const {
    return rotation(node, frames() - 1);
  }

  // The largest distance (m) of a node from its place in the first frame.
  [[nodiscard]] double slide(const std::string& node) const {
    double most = 0.0;
    for (int f = 0; f < frames(); ++f) most = std::fmax(most, norm(at(node, f) - at(node, 0)));
    return most;
  }

  // The largest rotation (rad) of a node from that of the first frame.
  [[nodiscard]] double tilt(const std::string& node) const {
    double most = 0.0;
    for (int f = 0; f < frames(); ++f) {
      most = std::fmax(most, norm(rotation_vector(transform(node, f).rotation *
                                                  transpose(transform(node, 0).rotation))));
    }
    return most;
  }

  [[nodiscard]] bool finite() const {
    for (const std::vector<Transformd>& nodes : places_) {
      for (const Transformd& node : nodes) {
        const Vec3d& p = node.translation;
        if (!std::isfinite(p.x + p.y + p.z)) return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] const Transformd& transform(const std::string& node, int frame) const {
    const int index = motion_.skeleton.find(node);
    SHG_CHECK(index >= 0, "the file has a node " + node);
    return places_[static_cast<std::size_t>(frame)][static_cast<std::size_t>(index)];
  }

  SkeletonMotion motion_;
  double unit_;
  std::vector<std::vector<Transformd>> places_;  // [frame][node]
};

}  // namespace shigusa::testing_support
