// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "layers/layered_player.hpp"
#include "planner.hpp"

namespace shigusa {

// Ways of layers to the goals, in the order in which they are tried.
enum class LayeredApproach {
  layers,  // trunk and limb lengths first, then the limbs
  body,  // all joints of the whole body at once, with the layers' weights: what layers cannot reach
};

// What leads how far. How far the body reaches is one answer for all presets (closest_reach): where
// layers do not get there, the whole body goes by the ways that it goes without layers. The problem
// outlives it.
class LayeredApproaches {
 public:
  explicit LayeredApproaches(const LayeredProblem& problem) : problem_(&problem) {}

  // The motion on the first way on which the parameters arrive, as long as that is not after
  // `last`. The same parameters always give the same motion.
  [[nodiscard]] std::optional<Arrival> arrival(const Parameters& parameters,
                                               LayeredApproach last) const;
  // The same by the whole body alone.
  [[nodiscard]] std::optional<Arrival> body_arrival(const Parameters& parameters) const;
  // The same of all ways; where the parameters arrive on none, the nearest motion.
  [[nodiscard]] Arrival any_arrival(const Parameters& parameters) const;

 private:
  const LayeredProblem* problem_;
};

}  // namespace shigusa
