// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <string_view>

namespace shigusa {

// Changes one of a plan's parameters by an assignment as typed by a user:
//   right_shoulder.flexion.weight=12    the weight of one dof
//   right_shoulder.weight=12            of all dofs of a joint
//   right_knee.flexion.locked=true      locks (or false: frees) a dof or a joint
//   squat_deg=60, lean_rad=0.5          the value of a posture mode, in degrees or radians
//   delay=0.1, bow=0.15, skew=0.3, sway=0.1      see Timing
// and for plans with several layers:
//   legs.contraction=8                      0..15: shortening of the legs at the end
//   right_arm.right_elbow.flexion.weight=3  for the layer below that moves the arm
//   right_arm.swivel_deg=20                 outward swivel of the elbow by that layer
//   left_elbow.final_deg=40                 final angle of an idle limb
// Fails for an unknown name (the nearest is suggested), or a value out of range; then nothing is
// changed.
[[nodiscard]] Result<void> assign_parameter(const ParameterList& list, std::string_view assignment,
                                            Parameters& values);
// Changes one of the fixed values in the same way, and marks it as set; `fixed` begins as
// no_fixed_parameters.
[[nodiscard]] Result<void> fix_parameter(const ParameterList& list, std::string_view assignment,
                                         FixedParameters& fixed);

}  // namespace shigusa
