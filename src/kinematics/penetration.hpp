// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/goal.hpp>
#include <span>
#include <vector>

#include "body/capsules.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// Two capsules of a body (indices) that must not meet: one of an effector's limb, unless grown on
// the trunk, and one that the limb does not move.
struct CapsulePair {
  int limb = 0;
  int part = 0;
  double allowed = 0.0;  // m, depth that is tolerated
};
// The pairs of one effector's limb.
[[nodiscard]] std::vector<CapsulePair> limb_pairs(const BodyModel& body, const Effector& effector);
// The pairs of one leg and the other.
[[nodiscard]] std::vector<CapsulePair> leg_pairs(const BodyModel& body);
// The pairs of all arms and of the legs, each pair once.
[[nodiscard]] std::vector<CapsulePair> all_limb_pairs(const BodyModel& body);

// Compliance (m) of the softer of both.
[[nodiscard]] double give_of(const BodyModel& body, const CapsulePair& pair);
// The pairs with their depths at the start as the tolerated ones.
[[nodiscard]] std::vector<CapsulePair> allowed_as_at(const Kinematics<double>& start,
                                                     const BodyModel& body,
                                                     std::vector<CapsulePair> pairs);

// Depth of a limb inside the rest of the body.
struct Penetration {
  double depth = -1e9;  // m; negative: distance
  Vec3d outward{};      // unit vector, world: shortest way out of the part
};

// The deepest of the pairs.
[[nodiscard]] Penetration deepest_of(const BodyModel& body, const Kinematics<double>& kinematics,
                                     std::span<const CapsulePair> pairs);
// The deepest of the effector's pairs, without tolerated depths.
[[nodiscard]] Penetration limb_penetration(const BodyModel& body,
                                           const Kinematics<double>& kinematics,
                                           const Effector& effector);

// Factor on squared distances (m²), for rounding, beyond which capsules are discarded as too far
// apart.
inline constexpr double kApartSlack = 1.0001;

// A capsule's ends and midpoint in the world (m).
template <class S>
struct PlacedCapsule {
  Vec3<S> from{};
  Vec3<S> to{};
  Vec3<S> middle{};
};
// Places the ends (m, in the link frame).
template <class S>
[[gnu::always_inline]] inline void place_capsule(int link, const Vec3<Element<S>>& from,
                                                 const Vec3<Element<S>>& to,
                                                 const Kinematics<S>& kinematics,
                                                 PlacedCapsule<S>& placed) {
  const Mat3<S>& r = kinematics.link_rotation(link);
  const Vec3<S>& origin = kinematics.link_origin(link);
  const auto place = [&](const Vec3<Element<S>>& local) {
    return origin + times_place(r, local, false);
  };
  placed.from = place(from);
  placed.to = place(to);
  placed.middle = (placed.from + placed.to) * S(0.5);
}
template <class S>
[[nodiscard]] PlacedCapsule<S> placed_capsule(const Capsule& capsule,
                                              const Kinematics<S>& kinematics) {
  PlacedCapsule<S> placed;
  place_capsule(capsule.link, to_scalar<Element<S>>(capsule.from),
                to_scalar<Element<S>>(capsule.to), kinematics, placed);
  return placed;
}

// Nearest points of two segments, which may be single points; any of the nearest points if they are
// parallel.
template <class S>
struct NearestPlaces {
  Vec3<S> apart{};  // m, from b's to a's
  S along_a{};      // 0..1 along the segments
  S along_b{};
};
template <class S>
[[nodiscard, gnu::always_inline]] inline NearestPlaces<S> nearest_places(
    const PlacedCapsule<S>& a, const PlacedCapsule<S>& b) {
  const Vec3<S> along_a = a.to - a.from;
  const Vec3<S> along_b = b.to - b.from;
  const Vec3<S> between = a.from - b.from;
  constexpr double kPoint = 1e-12;  // m², avoids a division by 0 for points
  const S aa = max(dot(along_a, along_a), S(kPoint));
  const S bb = max(dot(along_b, along_b), S(kPoint));
  const S ab = dot(along_a, along_b);
  const S a_between = dot(along_a, between);
  const S b_between = dot(along_b, between);
  const S square = aa * bb;
  const S lines = (ab * b_between - bb * a_between) / max(square - ab * ab, square * S(1e-6));
  const S t = clamp((ab * clamp(lines, S(0), S(1)) + b_between) / bb, S(0), S(1));
  const S s = clamp((ab * t - a_between) / aa, S(0), S(1));
  return {between + along_a * s - along_b * t, s, t};
}

// Depth (m, negative: distance) of two capsules in each other at the nearest points of their axes;
// `radii` (m): sum of the radii at their first ends.
template <class S>
[[nodiscard, gnu::always_inline]] inline S depth_of(const PlacedCapsule<S>& a,
                                                    const PlacedCapsule<S>& b, double radii,
                                                    double taper_a, double taper_b) {
  const NearestPlaces<S> nearest = nearest_places(a, b);
  return S(radii) + nearest.along_a * S(taper_a) + nearest.along_b * S(taper_b) -
         sqrt(dot(nearest.apart, nearest.apart));
}
template <class S>
[[nodiscard]] S depth_of(const PlacedCapsule<S>& a, const Capsule& of_a, const PlacedCapsule<S>& b,
                         const Capsule& of_b) {
  return depth_of(a, b, of_a.radius + of_b.radius, taper_of(of_a), taper_of(of_b));
}

// False if two capsules are certainly apart along the line of their midpoints. `radii` (m): sum of
// their largest radii; `between` (m): from b's midpoint to a's; `square` (m²): its square.
template <class S>
[[nodiscard, gnu::always_inline]] inline auto may_touch(const PlacedCapsule<S>& a,
                                                        const PlacedCapsule<S>& b,
                                                        const Vec3<S>& between, const S& square,
                                                        double radii) {
  // gap between the segments, times the distance of their midpoints
  const S gap = square - abs(dot(between, a.to - a.middle)) - abs(dot(between, b.to - b.middle));
  const S apart = max(gap, S(0));
  return apart * apart < square * S(kApartSlack * radii * radii);
}

// A box with round edges and its rotation R_WO, without a name.
struct PlacedBox {
  Vec3d position{};  // m, world: its middle
  Vec3d half{};      // m, half its size
  double radius = 0.0;
  Mat3d axes{};
};
[[nodiscard]] std::vector<PlacedBox> placed_boxes(std::span<const Obstacle> obstacles);

// Signed distance (m) of a point in the box's frame from it, negative inside.
template <class S>
[[nodiscard, gnu::always_inline]] inline S box_distance_within(const PlacedBox& box,
                                                               const Vec3<S>& p) {
  const Vec3d& half = box.half;
  const Vec3<S> over{abs(p.x) - S(half.x), abs(p.y) - S(half.y), abs(p.z) - S(half.z)};
  const Vec3<S> outside{max(over.x, S(0)), max(over.y, S(0)), max(over.z, S(0))};
  const S inside = min(max(over.x, max(over.y, over.z)), S(0));
  return sqrt(dot(outside, outside)) + inside - S(box.radius);
}

template <class S>
[[nodiscard, gnu::always_inline]] inline Vec3<S> to_frame_of(const PlacedBox& box,
                                                             const Vec3<S>& point) {
  return transpose_times(to_scalar<S>(box.axes), point - to_scalar<S>(box.position));
}

// Signed distance (m) of a point from a box, negative inside.
template <class S>
[[nodiscard]] S box_distance(const PlacedBox& box, const Vec3<S>& point) {
  return box_distance_within(box, to_frame_of(box, point));
}

// Least signed distance (m) of a point from boxes.
[[nodiscard]] inline double least_distance(std::span<const PlacedBox> boxes, const Vec3d& point) {
  double least = 1e9;
  for (const PlacedBox& box : boxes) least = min(least, box_distance(box, point));
  return least;
}

// Halvings of a capsule's axis in the search for its point nearest to a box.
inline constexpr int kAxisHalvings = 4;

// Least signed distance (m) of a box from a capsule's axis, less what the radius has grown there,
// by `taper` (m) at the second end; the nearest point is found to 1/32 of the `length` (m) of the
// axis. Where it is certainly more than `within` (m) in all lanes, the least of the ends and the
// midpoint. The distance is convex along the axis, so the nearest point lies beside the nearest of
// three in a row.
template <class S>
[[nodiscard, gnu::always_inline]] inline S axis_distance(const PlacedBox& box,
                                                         const PlacedCapsule<S>& limb,
                                                         double length, double taper,
                                                         double within) {
  const Vec3<S> from = to_frame_of(box, limb.from);
  const Vec3<S> way = to_frame_of(box, limb.to) - from;
  S least(0);
  S nearest(0);
  S middle(0);
  double step = 0.5;
  // one loop of the ends, the midpoint and the halvings keeps the code small
  for (int k = 0; k < 3 + 2 * kAxisHalvings; ++k) {
    // the distance changes by no more than the way between two points
    if (k == 3 && !any(least < S(within + 0.25 * (length + abs(taper))))) break;
    const bool back = k >= 3 && k % 2 == 1;
    if (back) {
      middle = nearest;
      step *= 0.5;
    }
    const S share = k < 3 ? S(0.5 * k) : max(min(middle + S(back ? -step : step), S(1)), S(0));
    const S other = box_distance_within(box, from + way * share) - S(taper) * share;
    if (k == 0) {
      least = other;
      continue;
    }
    nearest = select(other < least, share, nearest);
    least = min(least, other);
  }
  return least;
}

}  // namespace shigusa
