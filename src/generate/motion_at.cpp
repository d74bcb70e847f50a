// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/generate.hpp>

#include "core/index.hpp"
#include "kinematics/held_resample.hpp"
#include "math/turn_about.hpp"

namespace shigusa {

Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate) {
  std::vector<HeldPoint> held;
  for (const Foot& foot : body.feet()) {
    const auto stands = [&foot](const ContactResult& contact) {
      return contact.effector == foot.name;
    };
    const auto& contacts = candidate.contacts;
    // the base is fixed
    if (foot.link == kBaseLink || std::none_of(contacts.begin(), contacts.end(), stands)) continue;
    held.push_back({.link = foot.link, .point = foot.centre, .turns = true, .exact = true});
  }
  for (const GoalResult& goal : candidate.goals) {
    if (const auto effector = body.find_effector(goal.asked.effector)) {
      const Effector& hand = body.effector(*effector);
      held.push_back(
          {.link = hand.link, .point = hand.point, .turns = goal.asked.carry.has_value()});
    }
  }
  return resampled(body, candidate.motion.clip, rate, held);
}

Transformd pose_at(const ThingMotion& way, double frame) {
  const int last = static_cast<int>(way.poses.size()) - 1;
  const int before = std::clamp(static_cast<int>(frame), 0, last);
  const Transformd& from = way.poses[index(before)];
  const double share = frame - before;
  if (before == last || !(share > 0.0)) return from;
  const Transformd& to = way.poses[index(before + 1)];
  const Vec3d turn = rotation_vector(to.rotation * transpose(from.rotation)) * share;
  return {turn_about(normalized(turn, {0, 1, 0}), norm(turn)) * from.rotation,
          from.translation + (to.translation - from.translation) * share};
}

std::vector<ThingMotion> things_at(const Candidate& candidate, double rate) {
  const Clip& clip = candidate.motion.clip;
  const int frames = frames_at(clip.duration(), rate);
  std::vector<ThingMotion> ways;
  for (const ThingMotion& own : candidate.things) {
    if (own.poses.empty()) continue;
    ThingMotion& way = ways.emplace_back(ThingMotion{own.thing, {}});
    for (int f = 0; f < frames; ++f) {
      const double time = min(f / rate, clip.duration());
      way.poses.push_back(pose_at(own, time / clip.frame_time));
    }
  }
  return ways;
}

}  // namespace shigusa
