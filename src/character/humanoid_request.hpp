// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/motion.hpp>

#include "formats/json_text.hpp"

namespace shigusa {

// The nodes that a person says some bones are, by the names of the nodes or by their places in the
// file ("#17"). Fails on an unknown bone or node with the nearest name, on a bone that comes
// twice, and on a node for two bones. `file`: where the nodes are, for messages. `indices`: (nodes)
// their places in the file; empty: as they come.
[[nodiscard]] Result<HumanoidMap> requested_bones(const BoneRequest& request,
                                                  const std::vector<std::string>& nodes,
                                                  const std::string& file,
                                                  const std::vector<int>& indices = {});

// Refuses a figure that is unlike a person. A person's own word on its bones goes before that.
[[nodiscard]] Result<void> check_likeness(const Landmarks& figure, const BoneRequest& request,
                                          const std::string& file);

// Takes an error to one of that file.
[[nodiscard]] inline auto within(const std::string& file) {
  return [&file](const Error& error) { return Error{error.code, error.to_message(), file}; };
}

// {"right_hand": "Bone_17", …}; fails on anything but an object of texts.
[[nodiscard]] Result<BoneRequest> bone_request(const Json& json);

}  // namespace shigusa
