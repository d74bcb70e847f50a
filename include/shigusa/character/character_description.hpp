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

// What is told of a twist bone of the file: whose twist it shares.
struct TwistShare {
  std::string node;
  std::string bone;
  double share = 0.0;
};
[[nodiscard]] std::vector<TwistShare> twist_shares(const CharacterSpec& spec);

// What was understood of a character, as JSON text: the object that `shigusa body --json` prints,
// whose `nodes` are those of node_motion.
[[nodiscard]] std::string format_character(const CharacterSpec& spec, const BodyModel& body);

}  // namespace shigusa
