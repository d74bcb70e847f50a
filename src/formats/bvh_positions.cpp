// SPDX-License-Identifier: MIT
#include "bvh_positions.hpp"

#include <algorithm>

#include "core/index.hpp"

namespace shigusa {

void add_offsets(BvhFile& file) {
  constexpr double kZero = 1e-3;  // of the OFFSET
  constexpr int kNearlyAll = 10;  // nine of ten
  const std::vector<SkeletonNode>& nodes = file.motion.skeleton.nodes;
  SkeletonClip& clip = file.motion.clip;
  const auto is_placed = [&](std::size_t i) {
    const auto moves = [](const BvhChannel& channel) { return !channel.rotates; };
    return nodes[i].parent >= 0 && norm(nodes[i].offset) > 0.0 &&
           std::count_if(file.channels[i].begin(), file.channels[i].end(), moves) == 3;
  };
  int placed = 0;
  int at_zero = 0;
  for (std::size_t i = 0; i < nodes.size() && clip.frames > 0; ++i) {
    if (!is_placed(i)) continue;
    ++placed;
    if (norm(clip.local[i].translation) <= kZero * norm(nodes[i].offset)) ++at_zero;
  }
  if (at_zero < kFewestPlaced || kNearlyAll * at_zero < (kNearlyAll - 1) * placed) return;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_placed(i)) continue;
    for (int frame = 0; frame < clip.frames; ++frame) {
      clip.local[index(frame) * nodes.size() + i].translation += nodes[i].offset;
    }
    std::erase_if(file.channels[i], [](const BvhChannel& channel) { return !channel.rotates; });
  }
}

}  // namespace shigusa
