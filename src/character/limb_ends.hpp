// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <vector>

#include "body/skin.hpp"
#include "formats/gltf.hpp"

namespace shigusa {

// A file whose arms end at their forearms, or its legs at their shanks, with nodes for what is
// missing, and what to say of it.
struct EndedFile {
  std::string bytes;
  std::vector<Message> doubts;
};

// Where the skeleton of a glTF file makes no person as it is, and does with an end for each joint
// that nothing follows, where the mesh bound to it ends: the file with a hand, or a foot, between
// that joint and its end, by a person's proportions. Nothing for any other file.
[[nodiscard]] std::optional<EndedFile> with_limb_ends(const std::string& bytes,
                                                      const std::string& name,
                                                      const GltfCharacter& file,
                                                      std::span<const SkinVertex> skin);

}  // namespace shigusa
