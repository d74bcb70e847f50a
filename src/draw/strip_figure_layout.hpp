// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "strip_figure_body.hpp"
#include "strip_figure_canvas.hpp"
#include "strip_figure_things.hpp"

namespace shigusa::strip {

// Page sizes, points.
inline constexpr double kMargin = 5.0;
inline constexpr double kPointsPerMm = 72.0 / 25.4;

// Nothing further away than this is drawn, in the skeleton's unit: it would overflow later on.
inline constexpr double kFarthest = 1e12;

// Settings, motion and overlay are within what draw_strip allows. Positions of nodes are looked at
// when they are computed, for the drawn frames alone.
[[nodiscard]] Result<void> check_strip(const SkeletonMotion& motion, const StripOverlay& overlay,
                                       const StripSettings& settings);

// The lengths below are the skeleton's unit as seen by the viewer: x to the right, y up, measured
// from the slot's own point on the floor line.
struct Shape {
  std::vector<Disc> discs;
  double depth = 0.0;  // towards the viewer
  Tone tone = Tone::bone;
  int joints = 0;  // how many of the discs, from the first on, mark joints
};

struct GoalMark {
  Point at;
  bool arrow = false;  // the goal lies further out, in the direction of `away`
  Point away;
};

// One pose of the strip and what is drawn around it.
struct Slot {
  int frame = 0;
  std::vector<SeenThing> things;
  std::vector<Shape> shapes;  // far to near
  std::vector<Disc> soles;    // on the floor, under the feet that stand on it
  std::vector<GoalMark> goals;
  std::vector<Point> mass;               // centre of mass and the floor below it, or nothing
  std::vector<std::vector<Point>> path;  // pieces of the hand's path that lie near the figure
  Box box;                               // of all that is drawn
  double x = 0.0;                        // page, points: the slot's own point
};

struct Strip {
  std::vector<Slot> slots;
  double size = 1.0;  // of the figure, units
  double step = 0.0;  // from slot to slot that the widest neighbours need, units
  double top = 0.0;   // highest and lowest thing drawn, units from the floor line
  double bottom = 0.0;
  double scale = 1.0;    // page, points per unit
  double spacing = 0.0;  // page, points from slot to slot

  // The scale at which the strip fills a page's width, or its height is as much as a strip may
  // have.
  [[nodiscard]] double largest_scale(double width) const;
};

// Poses and their projection, not placed yet. Fails at a position that is not finite.
[[nodiscard]] Result<Strip> lay_out(const SkeletonMotion& motion, const StripOverlay& overlay,
                                    const StripSettings& settings);

// Puts the slots of a strip on a page of that width (points) at a scale of at most its largest one.
void place_slots(Strip& strip, double width, double scale);

}  // namespace shigusa::strip
