// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/motion/motion.hpp>

namespace shigusa {

// The same postures one after the other in another duration (s, > 0), with the torques that they
// take then. The motion begins and ends at rest.
[[nodiscard]] Motion retimed(const BodyModel& body, const Motion& motion, double duration);

}  // namespace shigusa
