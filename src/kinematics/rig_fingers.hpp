// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kinematics/rig.hpp"
#include "rig/finger_bones.hpp"

namespace shigusa {

// Share of the open posture in a reaching hand, relative to the relaxed one, at a share of the
// motion's time: 0 at both ends and 1 at kWidestAt, by two minimum-jerk curves with a continuous
// second derivative. Source: M. Jeannerod, "The timing of natural prehension movements", 1984: the
// aperture is widest at 60 to 70 % of the transport.
inline constexpr double kWidestAt = 0.65;
[[nodiscard]] double openness(double share);

// Posture at a share of the motion's time: minimum jerk from key to key, and as at the start
// before them.
[[nodiscard]] FingerKey finger_posture(std::span<const FingerKey> keys, double share);

// Rotations of a rig's fingers, frame by frame.
class FingerMover {
 public:
  // Fingers that carry the node of a hand's grip stay, as the goal refers to that node.
  FingerMover(const Rig& rig, const HandPlay& hands);

  // The rotation of a node in its parent at a share of the motion's time; `rotation` is without the
  // finger's turn.
  [[nodiscard]] Quatd turned(std::size_t node, double share, const Quatd& rotation) const;
  [[nodiscard]] bool turns(std::size_t node) const { return !bones_.empty() && bone_[node] >= 0; }

 private:
  struct Bone {
    Vec3d axis{};       // unit, the node's own axes
    double open = 0.0;  // rad, relative to the rig
    double relaxed = 0.0;
    double start = 0.0;  // in the first frame
    double bent = 0.0;   // flexion in the rig
    bool reaches = false;
    std::size_t hand = 0;  // index in keys_
  };

  std::array<std::vector<FingerKey>, 2> keys_;
  std::vector<Bone> bones_;
  std::vector<int> bone_;  // (nodes) index in bones_, or -1
};

}  // namespace shigusa
