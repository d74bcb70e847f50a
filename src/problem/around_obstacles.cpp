// SPDX-License-Identifier: MIT
#include "around_obstacles.hpp"

#include <array>

#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

// Sizes (m) of ways upwards, back against the way over the floor and aside, and times of their
// peaks, as shares of the way's own.
constexpr std::array kWaysUp{0.0, 0.06, 0.12, 0.18, 0.24, 0.32, 0.4};
constexpr std::array kWaysBack{0.0, 0.08, 0.16, 0.24, 0.32};
// Behind what is carried is the trunk.
constexpr std::array kNoWayBack{0.0, 0.05, 0.1};
constexpr std::array kWaysAside{0.12, -0.12, 0.24, -0.24, 0.36, -0.36};
constexpr std::array kWayPeaks{0.3, 0.4, 0.5, 0.6};
// Points of a way at which its distance is taken.
constexpr int kPathPoints = 20;
// Growth of the distance to keep with that from an end of the way.
constexpr double kFromEnd = 0.7;
// Length (m) of a detour that a metre of missing distance is worth.
constexpr double kMissingCosts = 20.0;

class Ways {
 public:
  // `points`: m, of what moves, from the path.
  Ways(const CriteriaContext& context, const EffectorPath& path, std::span<const Vec3d> points,
       double keeps_off)
      : boxes_(placed_boxes(context.obstacles)),
        keeps_off_(keeps_off),
        straight_(path),
        best_(path) {
    for (const Vec3d& point : points) {
      points_.push_back({point, distance(path.start + point), distance(path.goal + point)});
    }
    least_ = kMissingCosts * missing(path);
    needed_ = least_ > 0.0;
  }

  [[nodiscard]] bool needed() const { return needed_; }
  [[nodiscard]] const EffectorPath& best() const { return best_; }

  void look_at(const Vec3d& detour) {
    const double size = norm(detour);
    if (size >= least_) return;
    for (const double peak : kWayPeaks) {
      EffectorPath way = straight_;
      way.detour = straight_.detour + detour;
      way.detour_peak = peak;
      const double cost = size + kMissingCosts * missing(way);
      if (cost >= least_) continue;
      least_ = cost;
      best_ = way;
    }
  }

 private:
  [[nodiscard]] double distance(const Vec3d& point) const {
    double least = keeps_off_;
    for (const PlacedBox& box : boxes_) least = min(least, box_distance(box, point));
    return least;
  }

  // Most of the distance to keep that a way lacks.
  [[nodiscard]] double missing(const EffectorPath& way) const {
    double most = 0.0;
    for (int k = 1; k < kPathPoints; ++k) {
      const Vec3d at = way.at(way.begin + (1.0 - way.begin) * k / kPathPoints);
      for (const Moving& point : points_) {
        const double keeps = min(keeps_off_, min(point.at_start + kFromEnd * norm(at - way.start),
                                                 point.at_goal + kFromEnd * norm(at - way.goal)));
        most = max(most, keeps - distance(at + point.offset));
      }
    }
    return most;
  }

  struct Moving {
    Vec3d offset{};         // m, from the path
    double at_start = 0.0;  // m, distances from obstacles
    double at_goal = 0.0;
  };

  std::vector<PlacedBox> boxes_;
  std::vector<Moving> points_{};
  double keeps_off_;
  EffectorPath straight_;
  EffectorPath best_;
  double least_ = 0.0;  // m, cost of the best
  bool needed_ = false;
};

// Looks for the best way around; `out`: unit vector of the side to look at first, `backs`: sizes of
// the ways back.
EffectorPath best_way(Ways ways, const EffectorPath& path, const Vec3d& out,
                      std::span<const double> backs) {
  if (!ways.needed()) return path;
  const Vec3d along = path.goal - path.start;
  const Vec3d back = normalized(Vec3d{-along.x, 0.0, -along.z}, {0, 0, -1});
  for (const double b : backs) {
    for (const double u : kWaysUp) ways.look_at(back * b + Vec3d{0.0, u, 0.0});
    for (const double a : kWaysAside) ways.look_at(back * b + out * a);
  }
  return ways.best();
}

}  // namespace

void go_around_obstacles(const CriteriaContext& context, const Effector& hand, EffectorPath& path) {
  if (context.obstacles.empty()) return;
  const Vec3d out{hand.part.side == Side::left ? 1.0 : -1.0, 0.0, 0.0};
  path = best_way(Ways(context, path, std::array{Vec3d{}}, kKeepsOff), path, out, kWaysBack);
}

void carry_around_obstacles(const CriteriaContext& context, std::span<const Vec3d> corners,
                            EffectorPath& path) {
  if (context.obstacles.empty()) return;
  path = best_way(Ways(context, path, corners, kThingKeepsOff), path, {1.0, 0.0, 0.0}, kNoWayBack);
}

}  // namespace shigusa
