// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The effectors that goals can be given for beside a body's own: each named node on a link that can
// move. Joints have the words that their freedoms have, "right_elbow" of the node
// "right_lower_arm", and other nodes their own names.
[[nodiscard]] std::vector<Effector> further_effectors(const BodyDefinition& body);

// "right_elbow" of "right_lower_arm", "hips" of "pelvis"; what has no other word is as it was. A
// node "right_shoulder" is the clavicle's, and has no second name, as the joint is called so.
[[nodiscard]] std::string joint_word(std::string_view name);

}  // namespace shigusa
