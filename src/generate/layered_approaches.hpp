// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/request.hpp>

#include "paper/layered_player.hpp"
#include "planner.hpp"

namespace shigusa {

// The problem of a body with limbs as the layers of its plan have it.
[[nodiscard]] LayeredProblem in_layers(const ReachProblem& reach, const Plan& plan);

// The approaches of layers, in the order in which they are tried. How far the body reaches is one
// answer for all presets (closest_reach): where layers do not get there, the whole body goes by the
// approaches that it has without layers.
enum class LayeredApproach {
  layers,  // trunk and limb lengths first, then the limbs
  body,    // all joints of the whole body at once, with the layers' weights
};

// The motion on the first approach on which the parameters arrive, as long as that is not after
// `last`. The same parameters always give the same motion.
[[nodiscard]] std::optional<Arrival> layered_arrival(const LayeredProblem& problem,
                                                     const LayeredValues& parameters,
                                                     LayeredApproach last);
// The motion on LayeredApproach::body, where the parameters arrive on it.
[[nodiscard]] std::optional<Arrival> body_arrival(const LayeredProblem& problem,
                                                  const LayeredValues& parameters);
// The motion on the first of all approaches on which the parameters arrive; where they arrive on
// none, the nearest one.
[[nodiscard]] Arrival nearest_layered_arrival(const LayeredProblem& problem,
                                              const LayeredValues& parameters);

}  // namespace shigusa
