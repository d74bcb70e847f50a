// SPDX-License-Identifier: MIT
#include "measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace shigusa::bench {
namespace {

Vec3d middle(const Joints& joints, Joint a, Joint b) { return 0.5 * (joints[a] + joints[b]); }

double knee_flexion(const Joints& joints, Joint hip, Joint knee, Joint ankle) {
  const Vec3d thigh = normalized(joints[knee] - joints[hip]);
  const Vec3d shank = normalized(joints[ankle] - joints[knee]);
  return std::acos(std::clamp(dot(thigh, shank), -1.0, 1.0));
}

double final_place(const Joints& a, const Joints& b) {
  double sum = 0.0;
  for (const Joint j : {right_shoulder, right_elbow, right_hip, right_knee})
    sum += norm(a[j] - b[j]);
  return sum / 4.0;
}

// The nine of the right side, in the order of table 1 of the paper.
std::vector<bool> nine_of(const BodyModel& body) {
  constexpr std::array kNine{
      "right_ankle.flexion",      "right_knee.flexion",      "right_hip.flexion",
      "right_hip.abduction",      "right_hip.rotation",      "right_shoulder.flexion",
      "right_shoulder.abduction", "right_shoulder.rotation", "right_elbow.flexion"};
  std::vector<bool> nine(body.dofs().size());
  for (const char* name : kNine) nine[static_cast<std::size_t>(body.find_dof(name).value())] = true;
  return nine;
}

}  // namespace

double trunk_lean(const Joints& joints) {
  const Vec3d trunk =
      middle(joints, right_shoulder, left_shoulder) - middle(joints, right_hip, left_hip);
  return std::atan2(trunk.z, trunk.y);
}

double mean_knee(const Joints& joints) {
  return 0.5 * (knee_flexion(joints, right_hip, right_knee, right_ankle) +
                knee_flexion(joints, left_hip, left_knee, left_ankle));
}

double forward_bow(const Track& track, Joint joint) {
  const Vec3d from = track.joints.front()[joint];
  const Vec3d along = normalized(track.joints.back()[joint] - from);
  Vec3d farthest{};
  for (const Joints& joints : track.joints) {
    const Vec3d gone = joints[joint] - from;
    const Vec3d off = gone - along * dot(gone, along);
    if (norm(off) > norm(farthest)) farthest = off;
  }
  return farthest.z;
}

Looks looks_of(const Track& track) {
  Looks looks;
  const Joints& first = track.joints.front();
  const Joints& last = track.joints.back();
  const Vec3d hips = middle(last, right_hip, left_hip);
  const Vec3d trunk = middle(last, right_shoulder, left_shoulder) - hips;
  looks.trunk = std::acos(std::clamp(trunk.y / norm(trunk), -1.0, 1.0));
  looks.knee = mean_knee(last);
  const Vec3d moved = hips - middle(first, right_hip, left_hip);
  looks.drop = -moved.y;
  looks.back = -moved.z;
  double path = 0.0;
  for (std::size_t f = 1; f < track.joints.size(); ++f) {
    path += norm(track.joints[f][right_grip] - track.joints[f - 1][right_grip]);
    if (f + 1 == track.joints.size()) continue;
    const Vec3d step = track.joints[f + 1][right_grip] - track.joints[f - 1][right_grip];
    const double speed = norm(step) / (2.0 * track.frame_time);
    if (speed <= looks.peak_speed) continue;
    looks.peak_speed = speed;
    looks.peak_time = static_cast<double>(f) / static_cast<double>(track.joints.size() - 1);
  }
  looks.bow = forward_bow(track, right_grip);
  looks.path_ratio = path / norm(last[right_grip] - first[right_grip]);
  return looks;
}

double angle_difference(const Clip& recorded, const Clip& generated,
                        const std::vector<bool>& chosen) {
  std::vector<double> squares(chosen.size());
  for (int f = 0; f < recorded.frames; ++f) {
    // between the two generated frames nearest in time
    const double at = static_cast<double>(f) * (generated.frames - 1) / (recorded.frames - 1);
    const int k = std::min(static_cast<int>(at), generated.frames - 2);
    const double share = at - k;
    for (std::size_t d = 0; d < chosen.size(); ++d) {
      if (!chosen[d]) continue;
      const double angle =
          generated.frame(k)[d] * (1.0 - share) + generated.frame(k + 1)[d] * share;
      const double off = recorded.frame(f)[d] - angle;
      squares[d] += off * off;
    }
  }
  double sum = 0.0;
  for (const double square : squares) sum += std::sqrt(square / recorded.frames);
  return sum / static_cast<double>(std::count(chosen.begin(), chosen.end(), true));
}

Apart apart(const Recorded& reach, const Track& generated) {
  const Track& record = reach.track;
  const std::vector<bool> all(reach.posed.body.dofs().size(), true);
  return {final_place(record.joints.back(), generated.joints.back()),
          angle_difference(record.angles, generated.angles, nine_of(reach.posed)),
          angle_difference(record.paper_angles, generated.paper_angles, nine_of(reach.paper)),
          angle_difference(record.angles, generated.angles, all)};
}

Apart apart(const Recorded& a, const Recorded& b) { return apart(a, b.track); }

}  // namespace shigusa::bench
