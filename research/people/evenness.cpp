// SPDX-License-Identifier: MIT
#include "evenness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "../experiments/report.hpp"
#include "measures.hpp"

namespace shigusa::bench {
namespace {

constexpr double kStep = 0.04;          // m, between neighbours
constexpr std::array kGrid{2, 10, 10};  // sideways, heights, distances
constexpr int kGoals = 200;
static_assert(kGrid[0] * kGrid[1] * kGrid[2] == kGoals);
constexpr Vec3d kCorner{-0.16, 0.08, 0.24};  // m, the lowest and nearest
constexpr double kOtherStyle = radians(40.0);
constexpr double kUneven = radians(20.0);
constexpr std::size_t kPairsShown = 5;

// A goal of the grid and the end of its first choice.
struct Ended {
  Vec3d goal{};
  bool met = false;
  double knee = 0.0;   // rad
  double trunk = 0.0;  // rad
};

Ended ended(const PosedBody& posed, const Vec3d& goal, const std::function<void(Task&)>& change) {
  Task task(posed);
  task.goals = {{"right_hand", goal}};
  change(task);
  task.batch.threads = 1;
  const GenerateResult generation = generate(task).value();
  const Looks looks = looks_of(joints_track(posed, generation.candidates.front().motion.clip));
  return {goal, generation.meets_goals(), looks.knee, looks.trunk};
}

// Index of the grid's goal.
std::size_t at(int x, int y, int z) {
  return static_cast<std::size_t>((x * kGrid[1] + y) * kGrid[2] + z);
}

std::vector<Ended> all_ended(const std::function<void(Task&)>& change) {
  const PosedBody posed = human_body();
  std::vector<Ended> ends(kGoals);
  parallel_for(kGoals, 0, [&](int i, int) {
    const int z = i % kGrid[2];
    const int y = i / kGrid[2] % kGrid[1];
    const int x = i / (kGrid[2] * kGrid[1]);
    const Vec3d off{kStep * x, kStep * y, kStep * z};
    ends[static_cast<std::size_t>(i)] = ended(posed, kCorner + off, change);
  });
  return ends;
}

// Two neighbouring goals.
struct Pair {
  const Ended* a;
  const Ended* b;
  int axis;  // along which they are
  [[nodiscard]] double jump() const { return std::fabs(a->knee - b->knee); }
};

std::vector<Pair> neighbours(const std::vector<Ended>& ends) {
  std::vector<Pair> pairs;
  for (int x = 0; x < kGrid[0]; ++x) {
    for (int y = 0; y < kGrid[1]; ++y) {
      for (int z = 0; z < kGrid[2]; ++z) {
        const Ended& here = ends[at(x, y, z)];
        if (x + 1 < kGrid[0]) pairs.push_back({&here, &ends[at(x + 1, y, z)], 0});
        if (y + 1 < kGrid[1]) pairs.push_back({&here, &ends[at(x, y + 1, z)], 1});
        if (z + 1 < kGrid[2]) pairs.push_back({&here, &ends[at(x, y, z + 1)], 2});
      }
    }
  }
  const auto missed = [](const Pair& pair) { return !pair.a->met || !pair.b->met; };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), missed), pairs.end());
  return pairs;
}

std::string words(const Ended& end) {
  return fmt::format("{:.2f}, {:.2f}, {:.2f}", end.goal.x, end.goal.y, end.goal.z);
}

std::string largest(std::vector<Pair> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.jump() > b.jump(); });
  Table table({"goal, m", "its neighbour", "knee, °", "trunk, °"});
  for (std::size_t i = 0; i < std::min(pairs.size(), kPairsShown); ++i) {
    const Pair& pair = pairs[i];
    table.add({words(*pair.a), words(*pair.b),
               fmt::format("{:.0f}, {:.0f}", degrees(pair.a->knee), degrees(pair.b->knee)),
               fmt::format("{:.0f}, {:.0f}", degrees(pair.a->trunk), degrees(pair.b->trunk))});
  }
  return table.text();
}

}  // namespace

Evenness evenness_of(const std::function<void(Task&)>& change) {
  const std::vector<Ended> ends = all_ended(change);
  Evenness evenness;
  for (const Pair& pair : neighbours(ends)) {
    ++evenness.pairs;
    if (pair.jump() > kUneven) ++evenness.uneven;
    evenness.worst = std::fmax(evenness.worst, pair.jump());
  }
  return evenness;
}

std::string evenness_section() {
  const std::vector<Ended> ends = all_ended([](Task&) {});
  const std::vector<Pair> pairs = neighbours(ends);
  const auto beyond = [&](double angle) {
    return std::count_if(pairs.begin(), pairs.end(),
                         [angle](const Pair& pair) { return pair.jump() > angle; });
  };
  const auto jumps = beyond(kOtherStyle);
  double worst = 0.0;
  for (const Pair& pair : pairs) worst = std::fmax(worst, pair.jump());
  const Vec3d far = ends.back().goal;
  std::string text = fmt::format(
      "## Evenness\n\nGoals {:.0f} cm apart from one another should be reached alike. A grid of {} "
      "goals of the right hand of `human`, {:.2f} to {:.2f} m high, {:.2f} to {:.2f} m ahead and "
      "{:.2f} to {:.2f} m to the right; first choices of the default preset. Of {} pairs of "
      "neighbours that are reached, the knees of {} end more than {:.0f}° apart: {}; of {} more "
      "than {:.0f}°. The largest "
      "jump is {:.0f}°.\n\n",
      100.0 * kStep, kGoals, kCorner.y, far.y, kCorner.z, far.z, -far.x, -kCorner.x, pairs.size(),
      jumps, degrees(kOtherStyle),
      percent(static_cast<double>(jumps), static_cast<double>(pairs.size())), beyond(kUneven),
      degrees(kUneven), degrees(worst));
  return text + largest(pairs);
}

}  // namespace shigusa::bench
