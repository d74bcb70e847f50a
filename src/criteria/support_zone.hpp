// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <span>
#include <vector>

#include "dynamics/contact_forces.hpp"

namespace shigusa {

// The feet with lifted heels: bit f for foot f.
using LiftedHeels = unsigned;

// Corners (m, world) of the support polygon of the planted feet: the convex hull of their soles at
// the start of the motion, or of the forefoot alone where the heel is lifted, counter-clockwise
// from above. Empty for a body without feet.
[[nodiscard]] std::vector<Vec3d> support_polygon(const BodyModel& body, const State& start,
                                                 LiftedHeels lifted = 0);

// One edge of the support polygon: `offset + x · p.x + z · p.z` is the distance (m) of a point p
// inside, negative outside.
struct SupportEdge {
  double x = 0.0;
  double z = 0.0;
  double offset = 0.0;  // m
};
[[nodiscard]] std::vector<SupportEdge> support_edges(const BodyModel& body, const State& start,
                                                     LiftedHeels lifted = 0);

// Support polygon of the planted feet in each frame: of whole soles, and of forefeet once their
// heels are lifted. While a heel begins to lift (heel_lifted) the distance to the edge is
// interpolated between both polygons.
template <class S>
class SupportZone {
 public:
  SupportZone(const BodyModel& body, const State& start) {
    for (std::size_t f = 0; f < body.feet().size(); ++f) {
      if (!body.feet()[f].heel) continue;
      const LiftedHeels bit = 1U << f;
      heels_.push_back({bit, body.feet()[f].heel->toes});
    }
    for (LiftedHeels lifted = 0; lifted < 1U << body.feet().size(); ++lifted) {
      LiftedHeels can = 0;
      for (const Lifts& heel : heels_) can |= heel.bit;
      if ((lifted & ~can) != 0) continue;
      zones_.push_back({lifted, {}});
      for (const SupportEdge& edge : support_edges(body, start, lifted)) {
        zones_.back().edges.push_back(
            {static_cast<T>(edge.x), static_cast<T>(edge.z), static_cast<T>(edge.offset)});
      }
    }
  }

  // Distance (m) of a point p inside the nearest edge, negative outside, times h, for (h p.x, h, h
  // p.z), with the body's angles (dofs, rad); very large for a body without feet, or with feet of
  // no size.
  [[nodiscard]] S inside(const Vec3<S>& p, std::span<const S> angles) const {
    if (heels_.empty()) return nearest(zones_.front(), p);
    S sum(0);
    for (const Zone& zone : zones_) {
      S share(1);
      for (const Lifts& heel : heels_) {
        const S lifted = heel_lifted<S>(heel.toes, angles);
        share = share * ((zone.lifted & heel.bit) != 0 ? lifted : S(1) - lifted);
      }
      sum = sum + share * nearest(zone, p);
    }
    return sum;
  }

 private:
  using T = Element<S>;
  struct Edge {
    T x;
    T z;
    T offset;
  };
  struct Zone {
    LiftedHeels lifted;
    std::vector<Edge> edges;
  };
  struct Lifts {
    LiftedHeels bit;
    int toes;
  };
  static constexpr double kNoEdge = 1e30;  // m

  static S nearest(const Zone& zone, const Vec3<S>& p) {
    S inside(kNoEdge);
    for (const Edge& edge : zone.edges) {
      inside = min(inside, S(edge.offset) * p.y + S(edge.x) * p.x + S(edge.z) * p.z);
    }
    return inside;
  }

  std::vector<Lifts> heels_;
  std::vector<Zone> zones_;
};

}  // namespace shigusa
