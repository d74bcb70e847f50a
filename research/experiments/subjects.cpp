// SPDX-License-Identifier: MIT
#include "subjects.hpp"

#include <shigusa/human.hpp>

#include "core/check.hpp"
#include "independent_reach.hpp"

namespace shigusa::bench {
namespace {

constexpr int kStarts = 8;

}  // namespace

Plan quick_plan() {
  return {.quick = true,
          .goals = 3,
          .seeds = 2,
          .few_seeds = 1,
          .slow_seeds = 1,
          .motions = 40,
          .human_goals = 40};
}

std::vector<Place> named_places() {
  return {{"low front-left", {0.25, 0.55, 0.50}},
          {"at the feet", {-0.05, 0.10, 0.30}},
          {"high right", {-0.45, 1.75, 0.35}}};
}

Vec3d random_place(Random& random) {
  const double x = random.uniform(-1.3, 1.3);
  const double y = random.uniform(0.0, 2.3);
  return {x, y, random.uniform(-1.3, 1.3)};
}

std::vector<Vec3d> reachable_goals(const PosedBody& posed, int count, std::uint64_t seed) {
  IndependentReach reach(posed, "right_hand");
  Random places(seed, 1);
  Random starts(seed, 2);
  std::vector<Vec3d> goals;
  while (static_cast<int>(goals.size()) < count) {
    const Vec3d goal = random_place(places);
    if (reach.posture(goal, kStarts, starts)) goals.push_back(goal);
  }
  return goals;
}

Subject make_subject(const Plan& plan, const PosedBody& posed) {
  Subject subject{posed, {}, static_cast<std::size_t>(plan.goals)};
  for (const Vec3d& goal : reachable_goals(posed, plan.goals, plan.goal_seed)) {
    subject.places.push_back({"drawn", goal});
  }
  IndependentReach reach(posed, "right_hand");
  Random starts(plan.goal_seed, 3);
  for (const Place& place : named_places()) {
    SHG_CHECK(reach.posture(place.position, kStarts, starts), place.name + " is out of reach");
    subject.places.push_back(place);
  }
  return subject;
}

std::vector<Subject> make_subjects(const Plan& plan) {
  return {make_subject(plan, half_body()), make_subject(plan, full_body())};
}

std::vector<double> of_drawn(const Subject& subject, const std::vector<double>& of_places) {
  return {of_places.begin(), of_places.begin() + static_cast<std::ptrdiff_t>(subject.drawn)};
}

}  // namespace shigusa::bench
