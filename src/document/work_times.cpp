// SPDX-License-Identifier: MIT
#include "work_times.hpp"

#include <algorithm>

namespace shigusa {
namespace {

// Distance (m) that counts as near, and speed (m/s) that counts as rest.
constexpr double kNear = 0.06;
constexpr double kSlow = 0.1;

}  // namespace

Kinematics<double> RecordedWay::placed(int frame) const {
  Kinematics<double> placed(body_);
  forward_kinematics<double>(body_, clip_.frame(frame), placed);
  return placed;
}

Transformd RecordedWay::place(int effector, int frame) const {
  const int link = body_.effector(effector).link;
  const Kinematics<double> now = placed(frame);
  return {now.link_rotation(link), now.link_origin(link)};
}

Vec3d RecordedWay::at(int effector, int frame) const {
  return place(effector, frame) * body_.effector(effector).point;
}

double RecordedWay::speed(std::span<const int> effectors, int frame) const {
  const int before = std::max(frame - 1, 0);
  const int after = std::min(frame + 1, clip_.frames - 1);
  double fastest = 0.0;
  for (const int effector : effectors) {
    fastest = max(fastest, norm(at(effector, after) - at(effector, before)));
  }
  return after > before ? fastest / ((after - before) * clip_.frame_time) : 0.0;
}

int RecordedWay::settles(std::span<const int> effectors, Frames frames, bool rests,
                         const std::function<double(int)>& distance) const {
  int nearest = frames.from;
  double least = distance(frames.from);
  for (int frame = frames.from; frame <= frames.to; ++frame) {
    const double now = distance(frame);
    if (now < least) {
      least = now;
      nearest = frame;
    }
    if (!rests || now > kNear) continue;
    double slow = speed(effectors, frame);
    if (slow > kSlow) continue;
    // on to where they are slowest
    while (frame < frames.to) {
      const double next = speed(effectors, frame + 1);
      if (!(next < slow)) break;
      slow = next;
      ++frame;
    }
    return frame;
  }
  return nearest;
}

std::vector<int> RecordedWay::upright_parts() const {
  std::vector<int> parts;
  for (const HumanoidBone bone : {HumanoidBone::hips, HumanoidBone::head}) {
    if (const auto part = body_.find_effector(humanoid_bone_name(bone))) parts.push_back(*part);
  }
  return parts;
}

int RecordedWay::rise(const PosedBody& posed, Frames frames) const {
  const std::vector<int> parts = upright_parts();
  Kinematics<double> home(body_);
  forward_kinematics<double>(body_, posed.home.angles, home);
  return settles(parts, frames, true, [&](int frame) {
    double lowest = 0.0;
    for (const int part : parts) {
      const Effector& effector = body_.effector(part);
      const double full = home.point(effector.link, effector.point).y;
      lowest = max(lowest, full - at(part, frame).y);
    }
    return lowest;
  });
}

}  // namespace shigusa
