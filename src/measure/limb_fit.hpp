// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/human.hpp>
#include <vector>

namespace shigusa {

inline constexpr std::size_t kSectors = 8;
// Of a limb's vertices in a sector, the share that lies within its distance.
inline constexpr double kInLimb = 0.75;
inline constexpr double kThinnest = 0.005;  // m

// The value that a share of the values does not exceed; there must be some.
[[nodiscard]] double quantile(std::vector<double> values, double share);

// The points whose height is within a range.
[[nodiscard]] std::vector<Vec3d> between(const std::vector<Vec3d>& points, double low, double high);

// Distances of points from a line along y, by eight directions about it: the first is x, the third
// z.
class Sectors {
 public:
  // `share`: of a sector's points that its distance has within it.
  Sectors(const std::vector<Vec3d>& points, double x, double z, double share);

  [[nodiscard]] std::size_t filled() const { return filled_; }
  [[nodiscard]] const std::optional<double>& at(std::size_t sector) const {
    return distance_[sector];
  }
  // of all directions the middle one
  [[nodiscard]] double middle() const;
  // How far the middle of a circle at these distances is off the line: the first term of their
  // Fourier series. Where a direction is empty nothing.
  [[nodiscard]] Vec3d off() const;

 private:
  std::array<std::optional<double>, kSectors> distance_{};
  std::size_t filled_ = 0;
};

// The vertices of a limb from its joint at y = 0 down to -length (m).
struct LimbPoints {
  std::vector<Vec3d> points;
  double length = 0.0;
  bool rises = false;  // its flesh may go on beyond its joint, as a hip's does
  bool hand = false;   // it may be flat, and end before its fingertips would if it were straight
};

// A limb's shape, no thicker than there is `room` (m); nothing where its vertices do not tell.
[[nodiscard]] std::optional<PartShape> fit_limb(const LimbPoints& limb, double room);

// A line along y through the middle of the points, and how far they lie about it.
[[nodiscard]] std::optional<PartShape> round_column(const std::vector<Vec3d>& points,
                                                    double thickest);

}  // namespace shigusa
