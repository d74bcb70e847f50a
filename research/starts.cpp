// SPDX-License-Identifier: MIT
// shigusa_starts searches the start tables (src/generate/start_table.hpp) and prints the file of
// their rows.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "core/check.hpp"
#include "experiments/goal_search.hpp"
#include "generate/start_table.hpp"
#include "problem/make_problem.hpp"
#include "problem/reachability.hpp"
#include "search/cma_es.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr double kSpacing = 0.2;  // m, of the grid of goals
constexpr double kLeast = -1.3;   // m, of x and z
constexpr double kMost = 1.3;     // m
constexpr double kLowest = 0.03;  // m, of y
constexpr double kHighest = 2.3;  // m
constexpr int kFirstEvaluations = 4000;
// Rounds in which each goal is searched again from the best motions of its neighbours, so that a
// good posture found by one search spreads to the goals around it.
constexpr int kSweeps = 6;
constexpr int kSweepEvaluations = 1600;
constexpr double kSweepStep = 0.05;
constexpr double kNeighbour = 1.8 * kSpacing;  // m: of a cube's corners all 26

// A goal with its best known motion.
struct Place {
  Vec3d goal{};
  std::vector<double> point{};
  double score = 1e300;
};

bool in_reach(const PosedBody& posed, const Vec3d& goal) {
  const Task task = goal_task(posed, goal, Preset::flat, default_criteria());
  return closest_reach(make_problem(task).value()).reached();
}

std::vector<Place> places_around(const PosedBody& posed) {
  std::vector<Place> places;
  for (double y = kLowest; y <= kHighest; y += kSpacing) {
    for (double z = kLeast; z <= kMost; z += kSpacing) {
      for (double x = kLeast; x <= kMost; x += kSpacing) {
        if (in_reach(posed, {x, y, z})) places.push_back({{x, y, z}});
      }
    }
  }
  return places;
}

// Searches from the points (points × genes) for an improvement on the place's best.
void search(const PosedBody& posed, std::vector<double> starts, CmaEsSettings settings,
            Place& place) {
  GoalSearch searched(posed, place.goal);
  SearchProblem problem = searched.problem();
  const auto genes = static_cast<std::size_t>(problem.genes);
  if (!starts.empty()) {
    std::vector<double> scores(starts.size() / genes);
    problem.evaluate(starts, scores);
    const auto best = std::min_element(scores.begin(), scores.end()) - scores.begin();
    const auto at = starts.begin() + best * problem.genes;
    problem.start.assign(at, at + problem.genes);
  }
  Individual found = cma_es_search(problem, settings).best_seen;
  if (found.score < place.score) {
    place.point = std::move(found.point);
    place.score = found.score;
  }
}

void sweep(const PosedBody& posed, std::uint64_t seed, std::vector<Place>& places) {
  const std::vector<Place> before = places;
  parallel_for(static_cast<int>(places.size()), 0, [&](int i, int) {
    Place& place = places[static_cast<std::size_t>(i)];
    std::vector<double> starts;
    for (const Place& other : before) {
      if (norm(other.goal - place.goal) > kNeighbour) continue;
      starts.insert(starts.end(), other.point.begin(), other.point.end());
    }
    search(posed, std::move(starts),
           {.evaluations = kSweepEvaluations, .step = kSweepStep, .seed = seed}, place);
  });
}

std::vector<Place> searched_places(const PosedBody& posed) {
  std::vector<Place> places = places_around(posed);
  parallel_for(static_cast<int>(places.size()), 0, [&](int i, int) {
    search(posed, {}, {.evaluations = kFirstEvaluations, .seed = 1},
           places[static_cast<std::size_t>(i)]);
  });
  for (int k = 0; k < kSweeps; ++k) {
    sweep(posed, static_cast<std::uint64_t>(k) + 2, places);
    double sum = 0.0;
    for (const Place& place : places) sum += place.score;
    std::cerr << fmt::format("{}: {} places, mean score {:.4f}\n", posed.body.name(), places.size(),
                             sum / static_cast<double>(places.size()));
  }
  return places;
}

std::string digits_of(const std::vector<double>& point) {
  std::string digits;
  const double last = static_cast<double>(kStartDigits.size() - 1);
  for (const double x : point) digits += kStartDigits[static_cast<std::size_t>(x * last + 0.5)];
  return digits;
}

void print_table(const PosedBody& posed) {
  const std::vector<std::string> names = GoalSearch(posed, {-0.2, 1.2, 0.4}).space().names();
  SHG_CHECK(names.size() <= kStartCoordinates, "too many coordinates for a row");
  std::cout << fmt::format("table\t{}\t{}\t{}\n", posed.body.name(), posed.body.feet().size(),
                           fmt::join(names, " "));
  const int hand = posed.body.find_effector("right_hand").value();
  for (const Place& place : searched_places(posed)) {
    const Vec3d at = start_place(posed.body, posed.home, hand, place.goal).value() * 1000.0;
    std::cout << fmt::format("{:.0f}\t{:.0f}\t{:.0f}\t{}\n", at.x, at.y, at.z,
                             digits_of(place.point));
  }
}

}  // namespace

int main() {
  std::cout << "# Start tables, see src/generate/start_table.hpp. Written by scripts/make_starts; "
               "change research/starts.cpp, not this file.\n";
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) print_table(posed);
}
