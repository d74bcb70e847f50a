// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/support_zone.hpp"

namespace shigusa {

// Measures the support margins of a motion frame by frame.
class SupportMeter {
 public:
  SupportMeter(const BodyModel& body, const State& start);

  void add(const PlacedFrame<double>& frame);

  // (frames), or empty for a body without feet, or with feet of no size.
  [[nodiscard]] const std::vector<SupportFrame>& frames() const { return frames_; }
  // The least margin of each kind. None for a body without feet, or with feet of no size.
  [[nodiscard]] std::optional<SupportMargins> margins() const;

 private:
  bool stands_;
  double per_weight_;  // 1/N
  SupportZone<double> zone_;
  std::vector<SupportFrame> frames_;
  double frame_time_ = 0.0;  // s
};

// Measures a whole motion from its start, at rest before and after.
[[nodiscard]] SupportMeter measure_support(const BodyModel& body, const State& start,
                                           const Motion& motion);

}  // namespace shigusa
