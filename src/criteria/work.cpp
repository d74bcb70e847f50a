// SPDX-License-Identifier: MIT
#include <shigusa/criteria/work.hpp>
#include <shigusa/dynamics/inverse_dynamics.hpp>

#include "replay.hpp"

namespace shigusa {

double full_work(const BodyModel& body, const WorkSettings& settings) {
  return settings.share * body.mass() * kGravity * body.stature();
}

double work_penalty(const BodyModel& body, const Motion& motion, const WorkSettings& settings) {
  return replayed(body, motion, Work<double>(body, settings));
}

}  // namespace shigusa
