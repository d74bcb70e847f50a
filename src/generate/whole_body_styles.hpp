// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "island.hpp"

namespace shigusa {

// A range of a posture mode that is a style of its own.
struct StyleRange;

// The knees' weights where their flexion is given: they go by it, as light ones would bend as the
// hand has it.
[[nodiscard]] Niche stiff_knees(const ParameterSpace& space);

// Plans the islands that look for styles: what people do otherwise than the best does. Squat,
// stoop, half squat, the other turn of the trunk, the other side of the elbow; or for what is met
// upright a lean and bent knees.
class StylePlans {
 public:
  static constexpr int kParts = 6;

  // For a search on a space that outlives it; all plans together have kParts times `part` motions.
  StylePlans(const ParameterSpace& space, int part) : space_(&space), part_(part) {}

  // Styles that may begin when the best of the first postures is known (null: none arrives).
  [[nodiscard]] std::vector<IslandPlan> early(const Archived* best);
  // The others, which begin at the best of more motions.
  [[nodiscard]] std::vector<IslandPlan> late(const Archived* best);

 private:
  [[nodiscard]] Niche niche_of(const StyleRange& style) const;
  void add(const StyleRange& style, const Archived* best, std::vector<IslandPlan>& plans);

  const ParameterSpace* space_;
  int part_;
  int left_ = kParts;
  std::vector<const StyleRange*> planned_;
};

}  // namespace shigusa
