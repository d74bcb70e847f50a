// SPDX-License-Identifier: MIT
#include "work_strip.hpp"

#include <algorithm>
#include <cstddef>

namespace shigusa {
namespace {

// Poses of a strip, at least, and up to which there are two for each action.
constexpr std::size_t kFewPoses = 7;
constexpr std::size_t kManyPoses = 13;
constexpr int kAroundThing = 16;  // points of a round edge

int frame_at(const Candidate& candidate, double time) {
  const Clip& clip = candidate.motion.clip;
  return std::clamp(static_cast<int>(time / clip.frame_time + 0.5), 0, clip.frames - 1);
}

// Corners of a thing along its own axes, without its radius; those of a box as StripThing has them.
std::vector<Vec3d> corners_of(const Thing& thing) {
  const Vec3d half = thing.size * 0.5;
  std::vector<Vec3d> corners;
  for (int k = 0; thing.shape == ThingShape::box && k < 8; ++k) {
    corners.push_back({(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                       (k & 4) != 0 ? half.z : -half.z});
  }
  for (int k = 0; thing.shape == ThingShape::cylinder && k < kAroundThing; ++k) {
    const auto [sine, cosine] = sin_cos(kTwoPi * k / kAroundThing);
    for (const double y : {-half.y, half.y}) {
      corners.push_back({half.x * sine, y, half.x * cosine});
    }
  }
  if (thing.shape == ThingShape::sphere) corners.emplace_back();
  return corners;
}

}  // namespace

std::vector<int> work_frames(const Candidate& candidate) {
  if (candidate.actions.empty()) return {};
  std::vector<int> frames{0, candidate.motion.clip.frames - 1};
  const std::size_t poses = std::clamp(2 * candidate.actions.size() + 1, kFewPoses, kManyPoses);
  const bool halves = 2 * candidate.actions.size() < poses;
  for (const ActionResult& action : candidate.actions) {
    if (frames.size() == kStripMaxPoses) break;
    frames.push_back(frame_at(candidate, action.end));
    if (halves) frames.push_back(frame_at(candidate, 0.5 * (action.start + action.end)));
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  while (frames.size() < poses) {
    auto widest = frames.begin();
    for (auto k = frames.begin(); k + 1 != frames.end(); ++k) {
      if (k[1] - k[0] > widest[1] - widest[0]) widest = k;
    }
    if (widest + 1 == frames.end() || widest[1] - widest[0] < 2) break;
    frames.insert(widest + 1, (widest[0] + widest[1]) / 2);
  }
  return frames;
}

std::vector<StripAction> work_actions(const Candidate& candidate) {
  std::vector<StripAction> actions;
  for (const ActionResult& action : candidate.actions) {
    StripAction& own = actions.emplace_back();
    own.name = action_name(action.kind);
    own.first = frame_at(candidate, action.start);
    own.last = frame_at(candidate, action.end);
    if (action.kind != ActionKind::goals) continue;
    for (const GoalResult& goal : action.goals) own.goals.push_back(goal.asked.position);
  }
  return actions;
}

StripThing moving_thing(const ThingMotion& way) {
  const bool round = way.thing.shape == ThingShape::sphere;
  return {corners_of(way.thing), round ? 0.5 * way.thing.size.x : 0.0, way.poses};
}

}  // namespace shigusa
