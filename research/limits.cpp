// SPDX-License-Identifier: MIT
// Compares a map of reach and limits with searches: shigusa_limits CELLS.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <shigusa/shigusa.hpp>

using namespace shigusa;

namespace {

constexpr double kAgree = 0.95;         // share of the verdicts of a map
constexpr int kSeeds = 5;               // searches at each side of a limit
constexpr std::uint64_t kOther = 1000;  // first of their seeds, which the limits did not use

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

Task task_of_hand(const CharacterSpec& spec, const Vec3d& place) {
  Task task(*build_character(spec));
  task.goals = {{.effector = "right_hand", .position = place}};
  return task;
}

// A box that is lifted from the floor onto a table.
Task task_of_work() {
  Task task(*build_character({}));
  task.things = {{.name = "box", .size = {0.4, 0.3, 0.3}, .position = {0.0, 0.15, 0.45}}};
  Action place;
  place.place = "box";
  place.position = {0.0, 0.9, 0.45};
  task.actions = {{.grasp = "box"}, place};
  return task;
}

std::optional<Verdict> verdict_of(const Task& task) {
  const auto made = task.actions.empty() ? generate(task) : perform(task);
  if (!made || !made->meets_goals()) return std::nullopt;
  return made->candidates.front().judgement.verdict;
}

bool check_map(int cells) {
  const Task task = task_of_hand({}, {});
  const double begin = processor_seconds();
  const auto map = reach_map(task);
  const double seconds = processor_seconds() - begin;
  if (!map) return false;
  Random random(7);
  int agree = 0;
  for (int k = 0; k < cells; ++k) {
    const std::size_t place = random.below(static_cast<std::uint32_t>(map->places.size()));
    Task there = task;
    there.goals.front().position = map->position(place);
    agree += verdict_of(there) == map->places[place].verdict;
  }
  fmt::print("map: {} places in {:.0f} s of processors; {} of {} verdicts agree\n",
             map->places.size(), seconds, agree, cells);
  return agree >= kAgree * cells;
}

bool check_limit(const char* name, const Task& task, LimitKind kind) {
  const double begin = processor_seconds();
  const auto limit = find_limit(task, {.kind = kind});
  if (!limit) return false;
  const double seconds = processor_seconds() - begin;
  std::array<int, 2> holds{};
  for (std::size_t side = 0; side < 2; ++side) {
    const double value = limit->value * (side == 0 ? 1.0 - kSharpMargin : 1.0 + kSharpMargin);
    for (int seed = 0; seed < kSeeds; ++seed) {
      Task there = task;
      there.seed = kOther + static_cast<std::uint64_t>(seed);
      if (!there.things.empty()) there.things.front().mass = value;
      for (Goal& goal : there.goals) {
        if (kind == LimitKind::load) goal.load = value;
        if (kind == LimitKind::highest) goal.position.y = value;
      }
      holds[side] += verdict_of(there) == Verdict::possible;
    }
  }
  fmt::print("{}: {} {:.3g} {} ({}, {}), {} searches, {:.0f} s; {} seeds hold within, {} beyond\n",
             name, word_of(kind), limit->value, limit_unit(kind), word_of(limit->end),
             limit->sharp ? "sharp" : "not sharp", limit->trials, seconds, holds[0], holds[1]);
  const bool fails = limit->end == LimitEnd::beyond || !limit->sharp || holds[1] == 0;
  // near a limit that is not sharp single searches fail
  return holds[0] >= kSeeds - (limit->sharp ? 0 : 1) && fails;
}

}  // namespace

int main(int argc, char** argv) {
  const int cells = argc > 1 ? std::atoi(argv[1]) : 100;
  CharacterSpec woman;
  woman.sex = Sex::female;
  woman.stature = stature_percentile("p5", Sex::female);
  bool good = check_limit("man", task_of_hand({}, {-0.2, 1.0, 0.45}), LimitKind::load);
  good = check_limit("woman", task_of_hand(woman, {-0.2, 1.0, 0.45}), LimitKind::load) && good;
  good = check_limit("man", task_of_hand({}, {-0.2, 1.3, 0.4}), LimitKind::highest) && good;
  good = check_limit("woman", task_of_hand(woman, {-0.2, 1.3, 0.4}), LimitKind::highest) && good;
  good = check_limit("man with a box", task_of_work(), LimitKind::load) && good;
  if (cells > 0) good = check_map(cells) && good;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
