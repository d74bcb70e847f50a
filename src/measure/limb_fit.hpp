// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/human.hpp>
#include <vector>

namespace shigusa {

inline constexpr std::size_t kSectors = 8;
// Share of a limb's vertices in a sector that lie within its distance.
inline constexpr double kInLimb = 0.75;
inline constexpr double kThinnest = 0.005;  // m

// Quantile of a non-empty set of values.
[[nodiscard]] double quantile(std::vector<double> values, double share);

// Points with a height within a range.
[[nodiscard]] std::vector<Vec3d> between(const std::vector<Vec3d>& points, double low, double high);

// Distances of points from a line along y, in eight directions about it: the first is x, the third
// z.
class Sectors {
 public:
  // `share`: share of a sector's points within its distance.
  Sectors(const std::vector<Vec3d>& points, double x, double z, double share);

  [[nodiscard]] std::size_t filled() const { return filled_; }
  [[nodiscard]] const std::optional<double>& at(std::size_t sector) const {
    return distance_[sector];
  }
  // median over all directions
  [[nodiscard]] double middle() const;
  // Offset of the best circle from the line: the first Fourier term of the distances. Zero if a
  // direction is empty.
  [[nodiscard]] Vec3d off() const;

 private:
  std::array<std::optional<double>, kSectors> distance_{};
  std::size_t filled_ = 0;
};

// Vertices of a limb from its joint at y = 0 down to -length (m).
struct LimbPoints {
  std::vector<Vec3d> points;
  double length = 0.0;
  bool rises = false;  // its flesh may extend beyond its joint, as a hip's does
  bool hand = false;   // it may be flat, and shorter than straight fingers
};

// Shape of a limb, no thicker than `room` (m); empty if its vertices do not determine one.
[[nodiscard]] std::optional<PartShape> fit_limb(const LimbPoints& limb, double room);

// Line along y through the middle of the points, with their radius about it.
[[nodiscard]] std::optional<PartShape> round_column(const std::vector<Vec3d>& points,
                                                    double thickest);

}  // namespace shigusa
