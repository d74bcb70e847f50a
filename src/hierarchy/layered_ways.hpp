// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/hierarchy/layered_parameters.hpp>
#include <shigusa/hierarchy/layered_player.hpp>

namespace shigusa {

// As far as layers get to the goals: on the whole way or, where nothing arrives there, on one that
// ends before.
struct LayeredEdge {
  LayeredProblem problem;
  bool whole = false;            // the way is the problem's own
  LayeredParameters parameters;  // that arrive
};

// Ways of layers to the goals, in the order in which they are tried.
enum class LayeredWay {
  whole,  // to the goals
  edge,   // to where LayeredEdge ends
  own,    // as far as the parameters themselves lead
};

struct LayeredArrival {
  ReachProblem way;
  RolledOut rolled;
};

// What leads how far. The problem outlives it.
class LayeredWays {
 public:
  explicit LayeredWays(const LayeredProblem& problem) : problem_(&problem) {}

  // Found when it is first asked for, by trying weights of 1, and some with a joint that gives way
  // less, with all sorts of limb lengths: searches that begin anywhere find few motions at the
  // edge, where limbs must be as long as they get.
  [[nodiscard]] const LayeredEdge& edge();

  // The motion on the first way on which the parameters arrive, as long as that is not after
  // `last`. The same parameters always give the same motion.
  [[nodiscard]] std::optional<LayeredArrival> arrival(const LayeredParameters& parameters,
                                                      LayeredWay last);
  // The same of all ways; where the parameters arrive on none, the motion on the first.
  [[nodiscard]] LayeredArrival any_arrival(const LayeredParameters& parameters);

 private:
  const LayeredProblem* problem_;
  std::optional<LayeredEdge> edge_;
};

}  // namespace shigusa
