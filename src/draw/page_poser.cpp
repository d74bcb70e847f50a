// SPDX-License-Identifier: MIT
#include "page_poser.hpp"

#include <algorithm>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "candidate_strip.hpp"
#include "core/index.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "page_figures.hpp"
#include "problem/thing_parts.hpp"
#include "work_strip.hpp"

namespace shigusa {
namespace {

constexpr double kPageMillimetres = 1e3;
constexpr double kPageFarthest = 1e6;  // mm; nothing further away is drawn there

// Longest diagonal, as the size of a figure with unknown limbs.
double page_extent(const std::vector<Transformd>& nodes) {
  Vec3d low = nodes.front().translation;
  Vec3d high = low;
  for (const Transformd& node : nodes) {
    for (int i = 0; i < 3; ++i) {
      low[i] = min(low[i], node.translation[i]);
      high[i] = max(high[i], node.translation[i]);
    }
  }
  return max(norm(high - low), 1e-3);
}

// Numbers of the poses of a motion on the page and of the frames in which they stand evenly; a
// shorter motion stays at its end.
struct PagePoses {
  int count = 0;
  int frames = 0;
};
PagePoses poses_of(const Candidate& candidate, const GenerateResult& generation) {
  int frames = candidate.motion.clip.frames;
  int most = kPagePoses;
  if (is_work(generation)) {
    for (const Candidate& each : generation.candidates) {
      frames = std::max(frames, each.motion.clip.frames);
      most = std::max(most, kPagePoses * static_cast<int>(each.actions.size()));
    }
  }
  return {std::min(frames, most), frames};
}

// Frame position of a pose, between two frames if the motion has more frames than poses.
struct FramePlace {
  int before = 0;
  double share = 0.0;  // fraction of the step to the next frame
};
FramePlace frame_of(const Clip& clip, const PagePoses& poses, int pose) {
  if (poses.count < 2) return {};
  const int last = clip.frames - 1;
  const double place = static_cast<double>(pose) * (poses.frames - 1) / (poses.count - 1);
  const int before = std::min(static_cast<int>(place), last);
  return {before, before == last ? 0.0 : place - before};
}

class FigurePoser {
 public:
  FigurePoser(const Task& task, const Candidate& candidate, const PagePoses& poses)
      : motion_(candidate.motion),
        things_(candidate.things),
        works_(!candidate.actions.empty()),
        poses_(poses),
        moves_(skeleton_motion(task.body, motion_.clip)),
        body_(moves_.skeleton, strip_settings(task, candidate), {{0, 1, 0}, {0, 0, 1}}) {}

  [[nodiscard]] PosedFigure figure() {
    PosedFigure figure;
    figure.size = size_ = body_.stature() > 0.0 ? body_.stature() : page_extent(nodes(0));
    figure.parts = body_.parts(nodes(0), size_);
    for (int pose = 0; pose < poses_.count; ++pose) {
      add(frame_of(motion_.clip, poses_, pose), figure);
    }
    return figure;
  }

 private:
  [[nodiscard]] std::vector<Transformd> nodes(int frame) const {
    return world_transforms(moves_.skeleton, moves_.clip, frame);
  }
  [[nodiscard]] std::vector<Vec3d> places(int frame) const {
    std::vector<Vec3d> places;
    for (const strip::Part& part : body_.parts(nodes(frame), size_)) {
      for (const strip::Ball& ball : part.balls) places.push_back(ball.centre);
    }
    for (const auto& effector : motion_.effectors) {
      if (!works_) places.push_back(effector[index(frame)]);
    }
    for (const auto& [thing, poses] : things_) {
      for (const Thing& part : split(thing)) {
        for (const Vec3d& point : points_of(part)) {
          places.push_back(poses[index(frame)] * (part.position + point));
        }
      }
    }
    return places;
  }
  void add(const FramePlace& at, PosedFigure& figure) const {
    std::vector<Vec3d> here = places(at.before);
    if (at.share > 0.0) {
      const std::vector<Vec3d> next = places(at.before + 1);
      for (std::size_t i = 0; i < here.size(); ++i) here[i] += (next[i] - here[i]) * at.share;
    }
    figure.points.resize(here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      figure.points[i].push_back(to_millimetres(here[i]));
    }
  }

  const Motion& motion_;
  const std::vector<ThingMotion>& things_;
  bool works_;
  PagePoses poses_;
  SkeletonMotion moves_;
  strip::FigureBody body_;  // of the skeleton above
  double size_ = 0.0;
};

}  // namespace

std::int32_t to_millimetres(double metres) {
  const double mm = clamp(kPageMillimetres * metres, -kPageFarthest, kPageFarthest);
  return static_cast<std::int32_t>(mm < 0.0 ? mm - 0.5 : mm + 0.5);
}
PagePoint to_millimetres(const Vec3d& p) {
  return {to_millimetres(p.x), to_millimetres(p.y), to_millimetres(p.z)};
}

std::vector<Vec3d> points_of(const Thing& thing) {
  if (thing.shape == ThingShape::sphere) return {Vec3d{}};
  if (thing.shape == ThingShape::box) return moving_thing({thing, {}}).corners;
  const double half = 0.5 * thing.size.y;
  return {{0, -half, 0}, {0, half, 0}};
}

PosedFigure posed_figure(const Task& task, const Candidate& candidate,
                         const GenerateResult& generation) {
  return FigurePoser(task, candidate, poses_of(candidate, generation)).figure();
}

}  // namespace shigusa
