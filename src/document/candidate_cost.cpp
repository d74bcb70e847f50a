// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

#include "core/index.hpp"
#include "problem/task_goals.hpp"

namespace shigusa {
namespace {

// A hand's hold on a thing, by frames; the last one is included.
struct Hold {
  int hand = 0;
  std::size_t thing = 0;
  int first = 0;
  int last = 0;
};

std::vector<Hold> holds_of(const Task& task, const Candidate& candidate) {
  const Clip& clip = candidate.motion.clip;
  const auto frame = [&clip](double seconds) {
    const double at = clip.frame_time > 0.0 ? seconds / clip.frame_time + 0.5 : 0.0;
    return static_cast<int>(clamp(at, 0.0, static_cast<double>(clip.frames - 1)));
  };
  std::vector<Hold> holds;
  for (const HandUse& use : candidate.hands) {
    const auto hand = task.body.find_effector(use.effector);
    const auto thing = std::find_if(task.things.begin(), task.things.end(),
                                    [&use](const Thing& t) { return t.name == use.thing; });
    if (!hand || thing == task.things.end()) continue;
    holds.push_back({*hand, static_cast<std::size_t>(thing - task.things.begin()), frame(use.there),
                     use.end ? frame(*use.end) : clip.frames - 1});
  }
  return holds;
}

// Loads of the hands in the frames between their changes; each hand bears its share of a thing.
std::vector<HeldSpan> spans_of(const Task& task, const std::vector<Hold>& holds, int frames) {
  std::vector<int> changes{0, frames};
  for (const Hold& hold : holds) {
    changes.push_back(hold.first);
    changes.push_back(hold.last);
  }
  std::sort(changes.begin(), changes.end());
  changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
  std::vector<HeldSpan> spans;
  for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
    HeldSpan span{changes[k], changes[k + 1] - 1, {}};
    const auto holds_then = [&span](const Hold& hold) {
      return hold.first <= span.first && hold.last > span.last;
    };
    for (const Hold& hold : holds) {
      if (!holds_then(hold)) continue;
      const auto shared = std::count_if(holds.begin(), holds.end(), [&](const Hold& other) {
        return other.thing == hold.thing && holds_then(other);
      });
      span.loads.push_back({.effector = hold.hand,
                            .mass = task.things[hold.thing].mass / static_cast<double>(shared)});
    }
    if (!span.loads.empty()) spans.push_back(std::move(span));
  }
  return spans;
}

// Each thing's ways in the hands, from the first hand that takes it to the last that lets it go.
std::vector<LiftSpan> lifts_of(const Task& task, std::vector<Hold> holds) {
  std::stable_sort(holds.begin(), holds.end(),
                   [](const Hold& a, const Hold& b) { return a.first < b.first; });
  std::vector<LiftSpan> lifts;
  for (const Hold& hold : holds) {
    const Thing& thing = task.things[hold.thing];
    const auto same = std::find_if(lifts.begin(), lifts.end(), [&](const LiftSpan& lift) {
      return lift.thing == thing.name && hold.first < lift.put;
    });
    if (same == lifts.end()) {
      lifts.push_back({thing.name, thing.mass, {hold.hand}, hold.first, hold.last});
      continue;
    }
    same->put = std::max(same->put, hold.last);
    if (std::find(same->hands.begin(), same->hands.end(), hold.hand) == same->hands.end()) {
      same->hands.push_back(hold.hand);
    }
  }
  return lifts;
}

}  // namespace

Result<MotionCost> candidate_cost(const Task& task, const Candidate& candidate,
                                  const Ergonomics& ergonomics) {
  const int frames = candidate.motion.clip.frames;
  const std::vector<Hold> holds = holds_of(task, candidate);
  std::vector<HeldSpan> spans = spans_of(task, holds, frames);
  if (task.actions.empty()) {
    HeldSpan all{0, frames - 1, loads_in_hands(task)};
    if (!all.loads.empty()) spans = {std::move(all)};
  }
  const std::vector<LiftSpan> lifts = lifts_of(task, holds);
  return motion_cost({task, candidate.motion, spans, lifts}, ergonomics);
}

Result<std::vector<MotionCost>> candidate_costs(const FinishedRun& run) {
  std::vector<MotionCost> costs;
  if (!run.task.cost && run.task.actions.empty()) return costs;
  const Ergonomics ergonomics = ergonomics_of(run.task, run.file.character.sex);
  for (const Candidate& candidate : run.generation.candidates) {
    SHG_TRY_ASSIGN(costs.emplace_back(), candidate_cost(run.task, candidate, ergonomics));
  }
  return costs;
}

Ergonomics ergonomics_of(const Request& request, Sex sex) {
  Ergonomics ergonomics = request.ergonomics;
  if (!ergonomics.sex) ergonomics.sex = sex;
  return ergonomics;
}

}  // namespace shigusa
