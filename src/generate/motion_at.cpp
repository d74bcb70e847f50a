// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/generate.hpp>

#include "kinematics/held_resample.hpp"

namespace shigusa {

Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate) {
  Held held;
  for (const Foot& foot : body.feet()) {
    const auto stands = [&foot](const ContactResult& contact) {
      return contact.effector == foot.name;
    };
    const auto& contacts = candidate.contacts;
    // the base is fixed
    if (foot.link == kBaseLink || std::none_of(contacts.begin(), contacts.end(), stands)) continue;
    held.feet.push_back(foot);
  }
  for (const GoalResult& goal : candidate.goals) {
    if (const auto effector = body.find_effector(goal.asked.effector)) {
      held.effectors.push_back(body.effector(*effector));
    }
  }
  return resampled(body, candidate.motion.clip, rate, held);
}

}  // namespace shigusa
