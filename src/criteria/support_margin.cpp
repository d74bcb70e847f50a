// SPDX-License-Identifier: MIT
#include "criteria/support_margin.hpp"

#include "replay.hpp"
#include "with_start.hpp"

namespace shigusa {

SupportMeter::SupportMeter(const BodyModel& body, const State& start)
    : stands_(!support_edges(body, start).empty()),
      per_weight_(1.0 / (body.mass() * kGravity)),
      zone_(body, start) {}

void SupportMeter::add(const PlacedFrame<double>& frame) {
  if (!stands_) return;
  const Vec3d& c = frame.centre_of_mass;
  frames_.push_back({zone_.inside({c.x, 1.0, c.z}, frame.angles),
                     zone_.inside(frame.pressure, frame.angles) * per_weight_});
  frame_time_ = frame.frame_time;
}

std::optional<SupportMargins> SupportMeter::margins() const {
  if (frames_.empty()) return std::nullopt;
  SupportMargins least{{frames_[0].centre_of_mass, 0.0}, {frames_[0].pressure, 0.0}};
  const auto take = [](SupportMargin& margin, double distance, double time) {
    if (distance < margin.distance) margin = {distance, time};
  };
  for (std::size_t f = 1; f < frames_.size(); ++f) {
    const double time = static_cast<double>(f) * frame_time_;
    take(least.centre_of_mass, frames_[f].centre_of_mass, time);
    take(least.pressure, frames_[f].pressure, time);
  }
  return least;
}

SupportMeter measure_support(const BodyModel& body, const State& start, const Motion& motion) {
  SupportMeter meter(body, start);
  show_motion(body, motion, meter);
  return meter;
}

std::vector<SupportFrame> support_frames(const BodyModel& body, const Motion& motion) {
  return measure_support(body, with_start({}, motion.clip).start, motion).frames();
}

std::optional<SupportMargins> support_margins(const BodyModel& body, const Motion& motion) {
  return measure_support(body, with_start({}, motion.clip).start, motion).margins();
}

}  // namespace shigusa
