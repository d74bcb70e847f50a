// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/criteria/support_zone.hpp>
#include <shigusa/motion/motion.hpp>
#include <vector>

namespace shigusa {

// How far (m) inside the support polygon something stays at least, less than 0 outside it, and when
// (s, from the motion's beginning).
struct SupportMargin {
  double distance = 0.0;
  double time = 0.0;
};

// Whether a person could stand through a motion: the plumb line of the centre of mass, and the
// floor's centre of pressure, both against the support polygon. The pressure's is the moment (N·m)
// by which the body is held from tipping, over its weight: where the floor bears that weight, the
// distance of the centre of pressure; no floor gives less than 0. Motions faster than gravity let
// it leave the feet for a moment; a centre of mass that leaves them is a fall or a step.
struct SupportMargins {
  SupportMargin centre_of_mass;
  SupportMargin pressure;
};

// Both in one frame (m, inside the support polygon; less than 0 outside).
struct SupportFrame {
  double centre_of_mass = 0.0;
  double pressure = 0.0;
};

// Takes a motion frame by frame.
class SupportMeter {
 public:
  explicit SupportMeter(const BodyModel& body);

  void add(const PlacedFrame<double>& frame);

  // (frames), or none of a body without feet, or with feet of no size.
  [[nodiscard]] const std::vector<SupportFrame>& frames() const { return frames_; }
  // The least of each. Nothing of a body without feet, or with feet of no size.
  [[nodiscard]] std::optional<SupportMargins> margins() const;

 private:
  bool stands_;
  double per_weight_;  // 1/N
  SupportZone<double> zone_;
  std::vector<SupportFrame> frames_;
  double frame_time_ = 0.0;  // s
};

// Of a whole motion that is at rest before and after.
[[nodiscard]] SupportMeter measure_support(const BodyModel& body, const Motion& motion);
[[nodiscard]] std::optional<SupportMargins> support_margins(const BodyModel& body,
                                                            const Motion& motion);

}  // namespace shigusa
