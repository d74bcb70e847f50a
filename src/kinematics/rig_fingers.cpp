// SPDX-License-Identifier: MIT
#include "rig_fingers.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "motion/minimum_jerk.hpp"
#include "rig_drivers.hpp"

namespace shigusa {
double openness(double share) {
  if (share <= kWidestAt) return minimum_jerk(share / kWidestAt);
  return 1.0 - minimum_jerk((share - kWidestAt) / (1.0 - kWidestAt));
}

FingerKey finger_posture(std::span<const FingerKey> keys, double share) {
  if (keys.empty() || share <= keys.front().share) return {share, 1.0, 1.0};
  const auto later = [](double at, const FingerKey& key) { return at < key.share; };
  const auto next = std::upper_bound(keys.begin(), keys.end(), share, later);
  const FingerKey& before = *(next - 1);
  if (next == keys.end()) return {share, before.flexion, before.start};
  const double s = minimum_jerk((share - before.share) / (next->share - before.share));
  return {share, before.flexion + s * (next->flexion - before.flexion),
          before.start + s * (next->start - before.start)};
}

FingerMover::FingerMover(const Rig& rig, const HandPlay& hands) : keys_(hands.keys) {
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
              from_here(HandPosture::open),
              from_here(HandPosture::relaxed),
              0.0,
              finger.bent,
              hands.reaches[static_cast<std::size_t>(finger.side)],
              static_cast<std::size_t>(finger.side)};
    if (rig.at_ease) bone.start = bone.relaxed;
    bone_[index(finger.node)] = static_cast<int>(bones_.size());
    bones_.push_back(bone);
  }
}

Quatd FingerMover::turned(std::size_t node, double share, const Quatd& rotation) const {
  const Bone& bone = bones_[index(bone_[node])];
  double angle = bone.start;
  if (const auto& keys = keys_[bone.hand]; !keys.empty()) {
    const FingerKey now = finger_posture(keys, share);
    const double flexed = now.flexion * (bone.relaxed + bone.bent) - bone.bent;
    angle = flexed + now.start * (bone.start - flexed);
  } else if (bone.reaches) {
    const double first = share < kWidestAt ? bone.start : bone.relaxed;
    angle = first + openness(share) * (bone.open - first);
  }
  const SinCos<double> half = sin_cos(0.5 * angle);
  return rotation *
         Quatd{bone.axis.x * half.sin, bone.axis.y * half.sin, bone.axis.z * half.sin, half.cos};
}

}  // namespace shigusa
