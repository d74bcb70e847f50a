// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/human.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <vector>

#include "plan/held_input.hpp"
#include "problem/make_problem.hpp"
#include "rollout/reach_problem.hpp"

// Benchmark problem: the paper's first experiment, with random genomes of its code.
namespace shigusa::bench {

inline constexpr int kMotions = 480;  // full lanes in every set

inline constexpr Vec3d kLowFrontLeft{0.25, 0.55, 0.50};  // m

struct Measured {
  Task task;
  ReachProblem problem;
  std::vector<Parameters> parameters;  // (motions)
  std::vector<float> inverse_weights;  // (motions × dofs), of the same motions

  Measured(const char* character, int motions)
      : task(with_preset(Task(build(character)), Preset::paper)) {
    task.goals = {{"right_hand", kLowFrontLeft}};
    problem = make_problem(task).value();
    Random random(7);
    for (int i = 0; i < motions; ++i) {
      std::vector<std::uint16_t> genes;
      for (int d = 0; d < task.body.dof_count(); ++d) {
        genes.push_back(static_cast<std::uint16_t>(random.below(16)));
      }
      parameters.push_back(decode_paper_genes(task.body, genes));
      const std::vector<float> inverse = inverse_weights_of_genes(genes);
      inverse_weights.insert(inverse_weights.end(), inverse.begin(), inverse.end());
    }
  }
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

  static PosedBody build(const std::string& character) {
    return character == "half_body" ? half_body() : full_body();
  }
};

}  // namespace shigusa::bench
