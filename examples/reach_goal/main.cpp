// SPDX-License-Identifier: MIT
// The smallest use of shigusa: a body, a goal, and the motions that get there.
#include <cstdio>
#include <shigusa/shigusa.hpp>

int main() {
  shigusa::Task task(shigusa::full_body({.stature = 1.70, .mass = 65.0}));
  task.goals = {{"right_hand", {0.25, 0.55, 0.50}}};  // metres; +Y up, facing +Z, left is +X
  task.evaluations = 2000;

  const auto result = shigusa::generate(task);
  if (!result) return std::fprintf(stderr, "%s\n", result.error().to_string().c_str()), 2;
  for (const shigusa::Candidate& candidate : result->candidates) {
    std::printf("score %.4f, hand %.3f mm from its goal\n", candidate.score.total,
                1e3 * candidate.goals[0].error);
  }
  return shigusa::save("reach.bvh", {.source = "full_body"}, task, result->candidates[0]) ? 0 : 1;
}
