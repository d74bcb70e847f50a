// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <shigusa/generate.hpp>
#include <span>
#include <string>
#include <string_view>

#include "support/flesh.hpp"

// Depth of a person's limbs in the things of a piece of work, by another geometry than the
// kernel's: tapered limbs in the exact shapes. Circumferences are those of flesh.hpp, and of the
// same survey: thigh 0.597 m, knee 0.386 m, forearm 0.303 m.
namespace shigusa::testing_support {

// m, signed distance of a point from a thing's surface in the thing's frame, negative inside.
inline double distance_from(const Thing& thing, const Vec3d& p) {
  const Vec3d half = thing.size * 0.5;
  const auto over = [](double a, double b, double c) {
    const double inside = std::fmin(std::fmax(a, std::fmax(b, c)), 0.0);
    return inside + norm(Vec3d{std::fmax(a, 0.0), std::fmax(b, 0.0), std::fmax(c, 0.0)});
  };
  switch (thing.shape) {
    case ThingShape::sphere:
      return norm(p) - half.x;
    case ThingShape::cylinder:
      return over(std::hypot(p.x, p.z) - half.x, std::fabs(p.y) - half.y, -1e9);
    default:
      return over(std::fabs(p.x) - half.x, std::fabs(p.y) - half.y, std::fabs(p.z) - half.z);
  }
}

// A limb between two nodes as far as `share` of the way, with its girths (m, of a stature of 1.756
// m) at the nodes.
struct TaperedLimb {
  std::string_view from;
  std::string_view to;
  double share;
  double first;
  double last;
};
inline constexpr std::array kLegs{
    TaperedLimb{"upper_leg", "lower_leg", 1.0, 0.597, 0.386},
    TaperedLimb{"lower_leg", "foot", 1.0, 0.378, 0.222},
};
// The hand touches what it holds; towards the wrist, which is flat, the girth is of its thickness.
inline constexpr std::array kForearms{TaperedLimb{"lower_arm", "hand", 0.8, 0.303, 0.126}};

// Depth (m) of limbs in things in any frame; some way below 0 where nothing is near.
inline double depth_in_things(const BodyModel& body, const ClipPlaces& places,
                              std::span<const TaperedLimb> limbs,
                              std::span<const ThingMotion> things) {
  constexpr int kPoints = 16;
  double deepest = -1.0;
  const auto measure = [&](const TaperedLimb& limb, const std::string& side, std::size_t frame) {
    const Vec3d from = places.at(side + std::string(limb.from), frame).translation;
    const Vec3d way = places.at(side + std::string(limb.to), frame).translation - from;
    for (int k = 0; k <= kPoints; ++k) {
      const double share = limb.share * k / kPoints;
      const double girth = limb.first + (limb.last - limb.first) * share;
      const double radius = girth / kTwoPi * body.stature() / 1.756;
      for (const ThingMotion& thing : things) {
        const Vec3d at = inverse(thing.poses[frame]) * (from + way * share);
        deepest = std::fmax(deepest, radius - distance_from(thing.thing, at));
      }
    }
  };
  for (std::size_t f = 0; f < places.frames(); ++f) {
    for (const TaperedLimb& limb : limbs) {
      for (const char* side : {"left_", "right_"}) measure(limb, side, f);
    }
  }
  return deepest;
}

}  // namespace shigusa::testing_support
