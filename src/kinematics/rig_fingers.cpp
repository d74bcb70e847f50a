// SPDX-License-Identifier: MIT
#include "rig_fingers.hpp"

#include "core/index.hpp"
#include "motion/minimum_jerk.hpp"
#include "rig_drivers.hpp"

namespace shigusa {
double openness(double share) {
  if (share <= kWidestAt) return minimum_jerk(share / kWidestAt);
  return 1.0 - minimum_jerk((share - kWidestAt) / (1.0 - kWidestAt));
}

FingerMover::FingerMover(const Rig& rig, const HandPlay& hands) {
  if (!hands.fingers || rig.fingers.empty()) return;
  bone_.assign(rig.nodes.size(), -1);
  std::vector<bool> carries(rig.nodes.size(), false);
  for (const int grip : rig.grips) {
    if (grip < 0) continue;
    for (int i = rig.nodes[index(grip)].parent; i >= 0; i = rig.nodes[index(i)].parent) {
      carries[index(i)] = true;
    }
  }
  const std::vector<Transformd> rest = at_rest(rig);
  for (const FingerBone& finger : rig.fingers) {
    if (carries[index(finger.node)]) continue;
    const auto from_here = [&](HandPosture posture) {
      return flexion(posture, finger.finger, finger.joint) - finger.bent;
    };
    Bone bone{transpose_times(rest[index(finger.node)].rotation, finger.axis),
              from_here(HandPosture::open), from_here(HandPosture::relaxed), 0.0,
              hands.reaches[static_cast<std::size_t>(finger.side)]};
    if (rig.at_ease) bone.start = bone.relaxed;
    bone_[index(finger.node)] = static_cast<int>(bones_.size());
    bones_.push_back(bone);
  }
}

Quatd FingerMover::turned(std::size_t node, double share, const Quatd& rotation) const {
  const Bone& bone = bones_[index(bone_[node])];
  double angle = bone.start;
  if (bone.reaches) {
    const double first = share < kWidestAt ? bone.start : bone.relaxed;
    angle = first + openness(share) * (bone.open - first);
  }
  const SinCos<double> half = sin_cos(0.5 * angle);
  return rotation *
         Quatd{bone.axis.x * half.sin, bone.axis.y * half.sin, bone.axis.z * half.sin, half.cos};
}

}  // namespace shigusa
