// SPDX-License-Identifier: MIT
// A criterion of one's own: any scalar function of the motion. This one asks for motions that do
// not go down: it counts the height that the centre of mass loses.
#include <algorithm>
#include <cstdio>
#include <shigusa/shigusa.hpp>

namespace {

// How far (m) the centre of mass sinks below where it started.
double sinking(const shigusa::BodyModel&, const shigusa::Motion& motion) {
  const double start = motion.centre_of_mass.front().y;
  double lowest = start;
  for (const shigusa::Vec3d& com : motion.centre_of_mass) lowest = std::min(lowest, com.y);
  return start - lowest;
}

double best_sinking(const shigusa::Task& task) {
  const auto result = shigusa::generate(task);
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().to_string().c_str());
    return -1.0;
  }
  const shigusa::Candidate& best = result->candidates.front();
  for (const shigusa::ScoreTerm& term : best.score.terms) {
    std::printf("  %-12s weight %.2f  penalty %.4f\n", term.name.c_str(), term.weight,
                term.penalty);
  }
  return sinking(task.body, best.motion);
}

}  // namespace

int main() {
  shigusa::Task task(shigusa::full_body());
  task.goals = {{"right_hand", {-0.20, 0.60, 0.55}}};
  task.evaluations = 1000;

  std::printf("the default criteria:\n");
  const double without = best_sinking(task);

  task.criteria.user.push_back({.name = "sinking", .weight = 2.0, .scale = 0.3, .value = sinking});
  std::printf("with one of our own:\n");
  const double with = best_sinking(task);

  std::printf("the centre of mass sinks by %.3f m, and by %.3f m with our criterion\n", without,
              with);
  return without >= 0.0 && with >= 0.0 ? 0 : 1;
}
