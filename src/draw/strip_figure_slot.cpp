// SPDX-License-Identifier: MIT
#include "strip_figure_slot.hpp"

#include <algorithm>
#include <shigusa/math.hpp>

#include "core/index.hpp"

namespace shigusa::strip {
namespace {

// Shares of the figure's size.
constexpr double kOverlayReach = 0.6;  // goals and paths further than this from the body are cut
constexpr double kStanding = 0.04;     // a foot whose lowest ball is within this of the floor
constexpr double kMarkRoom = 0.06;     // around a goal
constexpr double kThingRoom = 0.15;    // things further than this from all else are cut

}  // namespace

bool SlotBuilder::near(Point p) const {
  const Point q = nearest(p, kOverlayReach * size_);
  return p.x == q.x && p.y == q.y;
}

void SlotBuilder::add_parts(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    Shape shape{{}, -part.setback, part.tone, part.joints};
    for (const Ball& ball : part.balls) {
      shape.discs.push_back({place(ball.centre), ball.radius});
      shape.depth += dot(view_.toward, ball.centre) / static_cast<double>(part.balls.size());
      slot.box.add(shape.discs.back().centre, ball.radius);
    }
    if (part.foot) add_sole(part);
    slot.shapes.push_back(std::move(shape));
  }
  std::stable_sort(slot.shapes.begin(), slot.shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.depth < b.depth; });
}

void SlotBuilder::add_sole(const Part& part) {
  double lowest = kFarthest;
  for (const Ball& ball : part.balls) {
    lowest = min(lowest, dot(view_.up, ball.centre) - ball.radius - view_.floor);
  }
  if (abs(lowest) > kStanding * size_) return;
  for (const Ball& ball : part.balls) {
    slot.soles.push_back({place(view_.on_floor(ball.centre)), 1.6 * ball.radius});
    slot.box.add(slot.soles.back().centre, slot.soles.back().radius);
  }
}

void SlotBuilder::add_goal(const Vec3d& goal) {
  GoalMark mark{place(goal), false, {}};
  if (!near(mark.at)) {
    const Point edge = nearest(mark.at, kGap * size_);
    const Vec3d away = normalized({mark.at.x - edge.x, mark.at.y - edge.y, 0.0});
    mark = {edge, true, {away.x, away.y}};
  }
  slot.box.add(mark.at, kMarkRoom * size_);
  slot.goals.push_back(mark);
}

void SlotBuilder::add_mass(const Vec3d& mass) {
  slot.mass = {place(mass), place(view_.on_floor(mass))};
  if (!near(slot.mass[0]) || !near(slot.mass[1])) slot.mass.clear();
  for (const Point& p : slot.mass) slot.box.add(p, 0.0);
}

void SlotBuilder::add_path(const std::vector<Vec3d>& path, int first, int last, int step) {
  bool broken = true;
  for (int frame = first; frame <= last;
       frame = frame < last ? std::min(frame + step, last) : last + 1) {
    const Point p = place(path[index(frame)]);
    if (!near(p)) {
      broken = true;
      continue;
    }
    if (broken) slot.path.emplace_back();
    broken = false;
    slot.path.back().push_back(p);
    slot.box.add(p, 0.0);
  }
}

void SlotBuilder::add_things(const std::vector<StripThing>& things) {
  double depth = 0.0;  // of the figure
  for (const Shape& shape : slot.shapes) {
    depth += shape.depth / static_cast<double>(slot.shapes.size());
  }
  const double room = kThingRoom * size_;
  const Box window{slot.box.left - room, slot.box.right + room, slot.box.bottom - room,
                   slot.box.top + room};
  for (const StripThing& thing : things) {
    if (!thing.poses.empty()) continue;
    add_thing(thing.corners, thing.radius, window);
    SeenThing& seen = slot.things.back();
    if (seen.face.empty()) {
      slot.things.pop_back();
    } else {
      seen.near = seen.depth > depth;
    }
  }
}

void SlotBuilder::add_moving(const std::vector<StripThing>& things) {
  constexpr Box kAll{-kFarthest, kFarthest, -kFarthest, kFarthest};
  for (const StripThing& thing : things) {
    if (thing.poses.empty()) continue;
    const Transformd& pose = thing.poses[index(slot.frame)];
    if (!near(place(pose.translation))) continue;
    std::vector<Vec3d> corners;
    for (const Vec3d& corner : thing.corners) corners.push_back(pose * corner);
    add_thing(corners, thing.radius, kAll);
    slot.things.back().moves = true;
  }
}

void SlotBuilder::add_thing(const std::vector<Vec3d>& at, double radius, const Box& window) {
  std::vector<SeenCorner> corners;
  double mean = 0.0;
  for (const Vec3d& corner : at) {
    corners.push_back({place(corner), dot(view_.toward, corner)});
    mean += corners.back().depth / static_cast<double>(at.size());
  }
  SeenThing& seen = slot.things.emplace_back(seen_thing(corners, radius, window));
  seen.depth = mean;
  for (const Point& p : seen.face) slot.box.add(p, 0.0);
}

}  // namespace shigusa::strip
