// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "strip_figure_layout.hpp"

namespace shigusa::strip {

// Least distance of neighbouring poses, a share of the figure's size.
inline constexpr double kGap = 0.08;

// Directions of the picture, and the floor, in the skeleton's world.
struct View {
  Vec3d right;
  Vec3d above;
  Vec3d toward;
  Vec3d up;
  double floor = 0.0;

  [[nodiscard]] Point operator()(const Vec3d& p) const { return {dot(right, p), dot(above, p)}; }
  [[nodiscard]] Vec3d on_floor(const Vec3d& p) const { return p + up * (floor - dot(up, p)); }
};

// Builder of a slot.
class SlotBuilder {
 public:
  SlotBuilder(const View& view, const Vec3d& anchor, double size)
      : view_(view), origin_(view(anchor)), size_(size) {}

  void add_parts(const std::vector<Part>& parts);
  void add_goal(const Vec3d& goal);
  void add_mass(const Vec3d& mass);
  void add_path(const std::vector<Vec3d>& path, int first, int last, int step);
  // Call last: the reach of things is limited by everything else.
  void add_things(const std::vector<StripThing>& things);
  // Shows or leaves out things that move as a whole.
  void add_moving(const std::vector<StripThing>& things);

  // Call between the body and the overlays, whose reach it limits.
  void close_body() { body_ = slot.box; }

  Slot slot;

 private:
  [[nodiscard]] Point place(const Vec3d& p) const {
    const Point q = view_(p);
    return {q.x - origin_.x, q.y - origin_.y};
  }
  // The nearest point of the body's box, widened by `room`.
  [[nodiscard]] Point nearest(Point p, double room) const {
    return {clamp(p.x, body_.left - room, body_.right + room),
            clamp(p.y, body_.bottom - room, body_.top + room)};
  }
  [[nodiscard]] bool near(Point p) const;
  void add_sole(const Part& part);
  void add_thing(const std::vector<Vec3d>& at, double radius, const Box& window);

  const View& view_;
  Point origin_;
  double size_;
  Box body_;
};

}  // namespace shigusa::strip
