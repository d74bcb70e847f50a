// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Effectors for goals beyond a body's own: each named node on a movable link. Joints are named as
// their degrees of freedom are, "right_elbow" for the node "right_lower_arm"; other nodes keep
// their names.
[[nodiscard]] std::vector<Effector> further_effectors(const BodyDefinition& body);

// Goal name of a node: "right_elbow" for "right_lower_arm", "hips" for "pelvis"; other names are
// unchanged. A node "right_shoulder" is the clavicle's and is unchanged too, as that name is the
// joint's.
[[nodiscard]] std::string joint_word(std::string_view name);

}  // namespace shigusa
