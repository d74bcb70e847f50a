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

// A file to which missing hands or feet were added, with the doubts to report.
struct EndedFile {
  std::string bytes;
  std::vector<Message> doubts;
};

// Adds hands or feet to a glTF file whose limbs end at forearms or shanks: if its skeleton makes no
// person as it is, but does with a tip for each terminal joint at the end of its mesh. The added
// joint lies between, by human proportions. Empty for any other file.
[[nodiscard]] std::optional<EndedFile> with_limb_ends(const std::string& bytes,
                                                      const std::string& name,
                                                      const GltfCharacter& file,
                                                      std::span<const SkinVertex> skin);

}  // namespace shigusa
