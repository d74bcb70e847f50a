// SPDX-License-Identifier: MIT
// Balance of a candidate with what its hands hold in each frame.
#include <algorithm>
#include <set>
#include <shigusa/score.hpp>

#include "body/load.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "problem/task_goals.hpp"
#include "work/moment.hpp"

namespace shigusa {
namespace {

// The body with what its hands hold, up to a frame.
struct LoadedSpan {
  int last = 0;
  BodyModel body;
};

// Frame of a time (s). At a change of hands it is the last one with what they held before.
int frame_at(const Clip& clip, double seconds) {
  const double at = clip.frame_time > 0.0 ? seconds / clip.frame_time + 0.5 : 0.0;
  return static_cast<int>(clamp(at, 0.0, static_cast<double>(clip.frames - 1)));
}

// Things and the hands on them in a frame.
Moment moment_in(const Task& task, const Candidate& candidate, int frame) {
  const Clip& clip = candidate.motion.clip;
  const auto angles = clip.frame(frame);
  Moment moment{.angles = {angles.begin(), angles.end()}, .things = {}, .grips = {}};
  for (const ThingMotion& way : candidate.things) moment.things.push_back(way.poses[index(frame)]);
  const Kinematics<double> now = placed(task.body, {.angles = moment.angles, .held = {}});
  for (const HandUse& use : candidate.hands) {
    const bool holds = !use.thing.empty() && frame_at(clip, use.there) < frame &&
                       (!use.end || frame <= frame_at(clip, *use.end));
    const auto hand = task.body.find_effector(use.effector);
    if (!holds || !hand) continue;
    const auto own = std::find_if(task.things.begin(), task.things.end(),
                                  [&use](const Thing& thing) { return thing.name == use.thing; });
    const auto thing = static_cast<std::size_t>(own - task.things.begin());
    const int link = task.body.effector(*hand).link;
    const Transformd place{now.link_rotation(link), now.link_origin(link)};
    moment.grips.push_back({*hand, link, thing, inverse(place) * moment.things[thing]});
  }
  return moment;
}

std::vector<LoadedSpan> loaded_spans(const Task& task, const Candidate& candidate) {
  const Clip& clip = candidate.motion.clip;
  if (task.actions.empty()) {
    const Result<Task> stands = standing(task);
    return {{clip.frames - 1, stands ? stands->body : task.body}};
  }
  std::set<int> changes{clip.frames - 1};
  for (const HandUse& use : candidate.hands) {
    if (use.thing.empty()) continue;
    changes.insert(frame_at(clip, use.there));
    if (use.end) changes.insert(frame_at(clip, *use.end));
  }
  std::vector<LoadedSpan> spans;
  for (const int last : changes) {
    spans.push_back({last, task.body});
    const Moment moment = moment_in(task, candidate, last);
    for (const HeldLoad& load : state_of(task.body, task.things, moment).held) {
      spans.back().body = with_load(spans.back().body, load);
    }
  }
  return spans;
}

// Values of `measure` in each frame, by the body as it is loaded there.
template <class Value, class Measure>
std::vector<Value> by_frames(const Task& task, const Candidate& candidate, Measure&& measure) {
  std::vector<Value> all;
  if (candidate.motion.clip.frames == 0) return all;
  for (const LoadedSpan& span : loaded_spans(task, candidate)) {
    const std::vector<Value> own = measure(span.body, candidate.motion);
    if (own.empty()) return own;
    all.insert(all.end(), own.begin() + static_cast<std::ptrdiff_t>(all.size()),
               own.begin() + span.last + 1);
  }
  return all;
}

}  // namespace

std::vector<Vec3d> centres_of_pressure(const Task& task, const Candidate& candidate) {
  return by_frames<Vec3d>(task, candidate, [](const BodyModel& body, const Motion& motion) {
    return centres_of_pressure(body, motion);
  });
}

std::vector<SupportFrame> support_frames(const Task& task, const Candidate& candidate) {
  return by_frames<SupportFrame>(task, candidate, [](const BodyModel& body, const Motion& motion) {
    return support_frames(body, motion);
  });
}

}  // namespace shigusa
