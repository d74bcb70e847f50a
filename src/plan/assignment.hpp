// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <string_view>

namespace shigusa {

// Changes one of a plan's parameters by an assignment as a person writes it:
//   right_shoulder.flexion.weight=12    the weight of one freedom
//   right_shoulder.weight=12            of all freedoms of a joint
//   right_knee.flexion.locked=true      lock (or false: free) a freedom or a joint
//   squat_deg=60, lean_rad=0.5          the value of a posture mode, in degrees or radians
//   delay=0.1, bow=0.15, skew=0.3, sway=0.1      see Timing
// and of plans with several layers:
//   legs.contraction=8                      0..15: how much shorter the legs end
//   right_arm.right_elbow.flexion.weight=3  of the layer below that moves the arm
//   right_arm.swivel_deg=20                 how far that layer swivels the elbow outwards
//   left_elbow.final_deg=40                 the angle at which a limb ends that no goal moves
// Fails on an unknown name (the nearest is suggested), or a value that is not allowed; then nothing
// is changed.
[[nodiscard]] Result<void> assign_parameter(const ParameterList& list, std::string_view assignment,
                                            Parameters& values);
// Changes one of the fixed values so, and notes which were set; `fixed` begins as
// no_fixed_parameters.
[[nodiscard]] Result<void> fix_parameter(const ParameterList& list, std::string_view assignment,
                                         FixedParameters& fixed);

}  // namespace shigusa
