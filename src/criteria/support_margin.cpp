// SPDX-License-Identifier: MIT
#include <shigusa/criteria/support_margin.hpp>

#include "replay.hpp"

namespace shigusa {

SupportMeter::SupportMeter(const BodyModel& body)
    : stands_(!support_edges(body).empty()),
      per_weight_(1.0 / (body.mass() * kGravity)),
      zone_(body) {}

void SupportMeter::add(const MotionFrame<double>& frame) {
  if (!stands_) return;
  const Vec3d& c = frame.centre_of_mass;
  const double mass = zone_.inside({c.x, 1.0, c.z}, frame.angles);
  const double pressure = zone_.inside(frame.pressure, frame.angles) * per_weight_;
  if (!seen_ || mass < least_.centre_of_mass.distance) least_.centre_of_mass = {mass, time_};
  if (!seen_ || pressure < least_.pressure.distance) least_.pressure = {pressure, time_};
  seen_ = true;
  time_ += frame.frame_time;
}

std::optional<SupportMargins> SupportMeter::margins() const {
  return seen_ ? std::optional(least_) : std::nullopt;
}

std::optional<SupportMargins> support_margins(const BodyModel& body, const Motion& motion) {
  SupportMeter meter(body);
  show_motion(body, motion, true, meter);
  return meter.margins();
}

}  // namespace shigusa
