// SPDX-License-Identifier: MIT
#include "body/stance.hpp"

#include <algorithm>
#include <utility>

namespace shigusa {

const Foot* base_foot(const BodyModel& body) {
  for (const Foot& foot : body.feet()) {
    if (foot.link == kBaseLink) return &foot;
  }
  return nullptr;
}

BodyModel standing_on(const BodyModel& body, std::span<const std::string> feet) {
  BodyDefinition standing = body.definition();
  std::erase_if(standing.feet, [&](const Foot& foot) {
    return std::find(feet.begin(), feet.end(), foot.name) == feet.end();
  });
  return BodyModel(std::move(standing));
}

}  // namespace shigusa
