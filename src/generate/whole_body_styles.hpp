// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "island.hpp"

namespace shigusa {

// A range of a posture mode that makes a style.
struct StyleRange;

// Bounds that keep the knees' weights high where their flexion is given: light knees would follow
// the hand instead.
[[nodiscard]] Niche stiff_knees(const ParameterSpace& space);

// Plans the islands that search for styles, the alternatives to the best motion: squat, stoop, half
// squat, the other turn of the trunk, the other side of the elbow; for goals reached upright a lean
// and bent knees.
class StylePlans {
 public:
  static constexpr int kParts = 6;

  // Plans for a search on a space that outlives the object; all together have kParts times `part`
  // motions.
  StylePlans(const ParameterSpace& space, int part) : space_(&space), part_(part) {}

  // Styles that begin once the best of the first postures is known (null: none arrives).
  [[nodiscard]] std::vector<IslandPlan> early(const Archived* best);
  // The other styles, which begin at the best of more motions.
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
