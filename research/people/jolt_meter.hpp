// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>

#include "criteria/jolts.hpp"

namespace shigusa::bench {

// Cause of a jolt: the first of these that applies.
enum class JoltEvent {
  first_frames,  // the motion begins
  last_frames,   // it ends
  to_limit,      // a joint is stopped by its limit
  from_limit,    // a joint leaves its limit at once
  kink,          // a joint's step changes at once
  smooth,        // none of these: the whole body moves strongly
};
inline constexpr std::array kJoltEvents{"frames 1–2",     "frames 59–60", "stopped by a limit",
                                        "leaves a limit", "a kink",       "smooth, but strong"};

// Greatest change of one kind between consecutive frames of a motion.
struct Jolt {
  double size = 0.0;  // m of the pressure, or the share of a strength
  int frame = 0;      // the later of the two
  int joint = -1;     // degree of freedom with the torque; -1 for the pressure
  int driver = -1;    // degree of freedom whose acceleration contributes most
  JoltEvent event = JoltEvent::smooth;
};
struct Jolts {
  Jolt pressure;
  Jolt torque;

  [[nodiscard]] bool pressure_jolts() const { return pressure.size > kPressureJolt; }
  [[nodiscard]] bool torque_jolts() const { return torque.size > kTorqueJolt; }
  [[nodiscard]] bool any() const { return pressure_jolts() || torque_jolts(); }
};
[[nodiscard]] Jolts jolts_of(const BodyModel& body, const Motion& motion);

}  // namespace shigusa::bench
