// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/hierarchy/arm_feedback.hpp>
#include <shigusa/hierarchy/generator.hpp>
#include <shigusa/hierarchy/layered_player.hpp>
#include <shigusa/hierarchy/limb_library.hpp>
#include <vector>

namespace shigusa {

struct LayeredSettings {
  LayerReading reading = LayerReading::shared_contractions;
  // How the arms' layers are searched; threads and SIMD set are the task's.
  LimbSearch limb_search = LimbSearch::ladder;
  // Where the arms' libraries are kept; without it they are searched anew, with the same result.
  LimbStore store{};
  // Searches of an arm that passes through the body (arm_feedback.hpp); 0: none.
  int feedback_rounds = kCollisionRounds;
};

// What a layered motion is generated from.
struct LayeredParameters {
  LayerParameters upper;         // trunk and limb lengths
  std::vector<ArmWeights> arms;  // (goals)

  friend bool operator==(const LayeredParameters&, const LayeredParameters&) = default;
};

// One way to get there. What it is generated from is `layered`; the whole body's own parameters
// are empty.
struct LayeredCandidate : Candidate {
  LayeredParameters layered;
  double collision = 0.0;       // m, collision_depth of the goals' arms, the deepest
  int feedback_rounds = 0;      // searches that its arms took in all
  bool collision_left = false;  // it is deeper than kCollisionDepth all the same
};

// What a layered search came to; fields as those of Generation.
struct LayeredGeneration {
  ReachStatus status = ReachStatus::reached;
  double remaining_distance = 0.0;  // m
  // at least one; lowest score first, but those with a collision left after those without
  std::vector<LayeredCandidate> candidates;
  double duration = 0.0;  // s
  int evaluations = 0;    // motions scored by the upper search
  int generations = 0;
  int rejected_nan = 0;
  int near_copies = 0;
  int missed = 0;
  double best_seen_score = 0.0;  // of all that the upper search saw
  int cells_searched = 0;        // of the arms' libraries, which were in no store
  SearchEnd end = SearchEnd::converged;
};

// The problem that a task poses to layers; points into the task. Fails where make_problem or
// paper_layers does.
[[nodiscard]] Result<LayeredProblem> make_layered_problem(const Task& task,
                                                          const LayeredSettings& settings = {});

// Finds natural motions for a task by the paper's hierarchical search (section 3.4): the task's
// search, or the paper's genetic algorithm where it names none, goes over the genes of the upper
// layer, in the paper's code (paper_ga, annealing, random) or in decode_layer_point's. Motions are
// those of the whole body and scored by the task's criteria. "Unreachable" is said where no motion
// of the layers arrives. Fails where make_layered_problem does. Same task, same result.
[[nodiscard]] Result<LayeredGeneration> generate_layered(const Task& task,
                                                         const LayeredSettings& settings = {},
                                                         const Progress& progress = {});

// Generates one motion from given parameters, without a search: the paper's editor (section 4.2,
// figure 7). Fails on a task that is wrong and on parameters of another body: counts, weights that
// are not in kWeightMin..kWeightMax, contractions not in 0..1.
[[nodiscard]] Result<LayeredGeneration> regenerate_layered(const Task& task,
                                                           const LayeredParameters& parameters,
                                                           const LayeredSettings& settings = {});

}  // namespace shigusa
