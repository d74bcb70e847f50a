// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/request.hpp>

#include "paper/layered_player.hpp"
#include "planner.hpp"

namespace shigusa {

// The layered problem of a body with limbs, for the layers of its plan.
[[nodiscard]] LayeredProblem in_layers(const ReachProblem& reach, const Plan& plan);

// Approaches with layers, in the order in which they are tried. Reach is the same for all presets
// (closest_reach): goals out of reach for the layers are left to the whole body.
enum class LayeredApproach {
  layers,  // trunk and limb lengths first, then the limbs
  body,    // all joints of the whole body at once, with the layers' weights
};

// The motion on the first approach, up to `last`, on which the parameters arrive. The same
// parameters always give the same motion.
[[nodiscard]] std::optional<Arrival> layered_arrival(const LayeredProblem& problem,
                                                     const LayeredValues& parameters,
                                                     LayeredApproach last);
// The motion on LayeredApproach::body, if the parameters arrive on it.
[[nodiscard]] std::optional<Arrival> body_arrival(const LayeredProblem& problem,
                                                  const LayeredValues& parameters);
// The motion on the first approach on which the parameters arrive; else the nearest motion.
[[nodiscard]] Arrival nearest_layered_arrival(const LayeredProblem& problem,
                                              const LayeredValues& parameters);

}  // namespace shigusa
