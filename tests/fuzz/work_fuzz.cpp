// SPDX-License-Identifier: MIT
// From the bytes of a task with actions and things to a piece of work: it is checked as a whole,
// and its beginning, if it is quick, performed by few motions. No crash, hang or memory exhaustion,
// every number stays finite, and the result can be written and read again.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <string_view>

#include "work/check_work.hpp"

namespace {

using namespace shigusa;

// Actions and motions that keep an input within seconds.
constexpr std::size_t kMostActions = 2;
constexpr std::size_t kMostGoals = 4;
constexpr double kLow = 0.8;      // m
constexpr double kHeavy = 5.0;    // kg
constexpr double kLongest = 0.3;  // s, of a pause
constexpr double kUsual = 1.0;    // s, of a motion

void require(bool holds) {
  if (!holds) std::abort();
}

void shorten(std::optional<double>& seconds) {
  if (seconds) seconds = min(*seconds, kLongest);
}

template <class Item>
void keep_first(std::size_t most, std::vector<Item>& list) {
  if (list.size() > most) list.erase(list.begin() + static_cast<std::ptrdiff_t>(most), list.end());
}

// Whether no body has to bend or to go around something, of which each search takes seconds here.
bool is_quick(const Task& task) {
  return task.obstacles.empty() && task.things.size() <= 2 &&
         std::all_of(
             task.things.begin(), task.things.end(),
             [](const Thing& thing) { return thing.position.y > kLow && thing.mass < kHeavy; }) &&
         std::all_of(task.actions.begin(), task.actions.end(), [](const Action& action) {
           return (!action.position || action.position->y > kLow) &&
                  std::all_of(action.goals.begin(), action.goals.end(),
                              [](const Goal& goal) { return goal.position.y > kLow; });
         });
}

// The beginning of a task, with a small budget.
Task brief(Task task) {
  keep_first(kMostActions, task.actions);
  for (Action& action : task.actions) {
    keep_first(kMostGoals, action.goals);
    shorten(action.wait);
    // with a duration of its own no other one is searched
    action.duration = min(action.duration.value_or(kUsual), kUsual);
    action.hold = min(action.hold, kLongest);
  }
  shorten(task.duration);
  task.generator = MotionGenerator::weighted_ik;
  task.evaluations = kPaperPopulation;
  task.candidates = 1;
  task.batch.threads = 1;
  return task;
}

void check_candidate(const Task& task, const Candidate& candidate) {
  const Clip& clip = candidate.motion.clip;
  require(std::all_of(clip.angles.begin(), clip.angles.end(),
                      [](double angle) { return std::isfinite(angle); }));
  require(candidate.actions.size() <= task.actions.size());
  double before = 0.0;
  for (const ActionResult& action : candidate.actions) {
    require(action.start >= before && action.end >= action.start);
    before = action.start;
  }
  require(before <= clip.duration() + 1e-9);
  for (const ThingMotion& thing : candidate.things) {
    require(thing.poses.size() == static_cast<std::size_t>(clip.frames));
    for (const Transformd& pose : thing.poses) require(std::isfinite(norm(pose.translation)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto file = parse_task(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
  if (!file || file->actions.empty()) return 0;
  const std::string text = format_task(*file);
  const auto again = parse_task(text, "written.json");
  require(again && format_task(*again) == text);
  if (!is_built_in(file->character)) return 0;
  const auto whole = make_task(*file, {});
  if (!whole || !check_work(*whole)) return 0;
  const Task task = brief(*whole);
  if (!is_quick(task)) return 0;
  const auto result = perform(task);
  if (!result) return 0;
  require(!result->candidates.empty());
  require(result->meets_goals() || !result->conflict.empty());
  for (const Candidate& candidate : result->candidates) check_candidate(task, candidate);
  static_cast<Request&>(*file) = task;
  require(parse_result(format_result({*file, task, *result, {}}, {}), "written.json").has_value());
  return 0;
}
