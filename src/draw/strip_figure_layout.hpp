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

// Largest coordinate that is drawn, in the skeleton's unit; larger ones would overflow.
inline constexpr double kFarthest = 1e12;

// Checks that settings, motion and overlay are within the limits of draw_strip. Positions of nodes
// are checked when they are computed, for the drawn frames alone.
[[nodiscard]] Result<void> check_strip(const SkeletonMotion& motion, const StripOverlay& overlay,
                                       const StripSettings& settings);

// Whether a transform is finite and within kFarthest.
[[nodiscard]] bool usable(const Transformd& x);

// A piece as seen by the viewer. Lengths are in the skeleton's unit: x to the right, y up, measured
// from the slot's own point on the floor line.
struct Shape {
  std::vector<Disc> discs;
  double depth = 0.0;  // towards the viewer
  Tone tone = Tone::bone;
  int joints = 0;  // number of leading discs that mark joints
};

struct GoalMark {
  Point at;
  bool arrow = false;  // the goal lies further out, in the direction of `away`
  Point away;
};

// One pose of the strip with the things drawn around it.
struct Slot {
  int frame = 0;
  std::vector<SeenThing> things;
  std::vector<Shape> shapes;  // far to near
  std::vector<Disc> soles;    // on the floor, under the feet that stand on it
  std::vector<GoalMark> goals;
  std::vector<Point> mass;               // centre of mass and the floor below it, or nothing
  std::vector<std::vector<Point>> path;  // pieces of the hand's path that lie near the figure
  Box box;                               // bounds of everything drawn
  double x = 0.0;                        // page, points: the slot's own point
};

struct Strip {
  std::vector<Slot> slots;
  double size = 1.0;  // of the figure, units
  double step = 0.0;  // least distance between slots, set by the widest neighbours, units
  double top = 0.0;   // highest and lowest thing drawn, units from the floor line
  double bottom = 0.0;
  double scale = 1.0;    // page, points per unit
  double spacing = 0.0;  // page, points from slot to slot

  // Scale at which the strip fills a page's width or reaches the greatest height of a strip.
  [[nodiscard]] double largest_scale(double width) const;
};

// Poses and their projection, without page positions. Fails at a position that is not finite.
[[nodiscard]] Result<Strip> lay_out(const SkeletonMotion& motion, const StripOverlay& overlay,
                                    const StripSettings& settings);

// Places the slots of a strip on a page of that width (points), at a scale of at most its largest
// one.
void place_slots(Strip& strip, double width, double scale);

}  // namespace shigusa::strip
