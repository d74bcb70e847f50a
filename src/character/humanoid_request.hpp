// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/motion.hpp>

#include "formats/json_text.hpp"

namespace shigusa {

// Bones assigned by the user to nodes, by node name or by index in the file ("#17"). Fails on an
// unknown bone or node with the nearest name, on a repeated bone, and on a node with two bones.
// `file`: file of the nodes, for messages. `indices`: (nodes) indices in the file; empty: in order.
[[nodiscard]] Result<HumanoidMap> requested_bones(const BoneRequest& request,
                                                  const std::vector<std::string>& nodes,
                                                  const std::string& file,
                                                  const std::vector<int>& indices = {});

// Fails if a figure is unlike a person, unless the user assigned its bones.
[[nodiscard]] Result<void> check_likeness(const Landmarks& figure, const BoneRequest& request,
                                          const std::string& file);

// Returns a function that attributes an error to a file.
[[nodiscard]] inline auto within(const std::string& file) {
  return [&file](const Error& error) { return Error{error.code, error.to_message(), file}; };
}

// Parses {"right_hand": "Bone_17", …}; fails on anything but an object of strings.
[[nodiscard]] Result<BoneRequest> bone_request(const Json& json);

}  // namespace shigusa
