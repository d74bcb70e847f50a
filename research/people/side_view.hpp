// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

#include "draw/strip_figure_canvas.hpp"

// People as seen from their right: they look to the right, heights go up.
namespace shigusa::bench {

// A place seen from the side (m).
struct SidePoint {
  double ahead = 0.0;
  double up = 0.0;
};
[[nodiscard]] inline SidePoint from_the_side(const Vec3d& at) { return {at.z, at.y}; }

// Colouring of a figure.
struct FigureColours {
  strip::Colour near_arm, body, near_leg, far_limbs;
};
inline constexpr FigureColours kFullColours{{0xc8502d}, {0x4a5a6a}, {0x33414e}, {0xa9b4bf}};
inline constexpr FigureColours kPaleColours{{0xeae6e2}, {0xe4e8eb}, {0xdde2e6}, {0xeceff1}};

// Draws on a part of a canvas with the floor below the ankles at `origin`.
class SideView {
 public:
  // `scale`: points a metre. The canvas outlives the view.
  SideView(strip::Canvas& canvas, strip::Point origin, double scale)
      : canvas_(&canvas), origin_(origin), scale_(scale) {}

  [[nodiscard]] strip::Point at(SidePoint point) const {
    return {origin_.x + scale_ * point.ahead, origin_.y - scale_ * point.up};
  }
  // A frame of a motion of the built-in body human, or of one with its nodes' names.
  void person(const SkeletonMotion& motion, int frame, const FigureColours& colours = kFullColours);
  void line(const std::vector<SidePoint>& points, strip::Colour colour, double width,
            double dash = 0.0);
  // A ringed cross.
  void goal(SidePoint at);
  // The floor between two places (m ahead).
  void floor(double from, double to);

 private:
  strip::Canvas* canvas_;
  strip::Point origin_;
  double scale_;
};

}  // namespace shigusa::bench
