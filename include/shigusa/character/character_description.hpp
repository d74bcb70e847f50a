// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/character/character.hpp>
#include <string>
#include <utility>
#include <vector>

namespace shigusa {

// (effectors) m, world: where goals can be given for, in the start posture.
[[nodiscard]] std::vector<Vec3d> start_places(const BodyModel& body);

// The file's joint that a freedom of a robot is; empty of a person's.
[[nodiscard]] std::string file_joint(const BodyModel& body, int dof);

// The angles (rad) that a freedom never passes: its upper limit is that of the most that another
// angle lets it grow to (LimitCoupling).
[[nodiscard]] std::pair<double, double> widest_limits(const BodyModel& body, int dof);

// A twist bone of the file, and whose twist it shares.
struct TwistShare {
  std::string node;    // of the file
  std::string bone;    // humanoid bone whose twist it shares
  double share = 0.0;  // of the way along that bone, 0..1
};
// The twist bones of the character's file; none without its rig.
[[nodiscard]] std::vector<TwistShare> twist_shares(const CharacterSpec& spec);

// The character as it was understood, as JSON text: the object that `shigusa body --json` prints,
// whose `nodes` are those of node_motion.
[[nodiscard]] std::string format_character(const CharacterSpec& spec, const BodyModel& body);

}  // namespace shigusa
