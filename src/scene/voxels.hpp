// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/surface.hpp"

namespace shigusa {

using Cell = std::array<int, 3>;

// Largest number of points on a surface that are put into cells.
inline constexpr double kSurfacePointsMax = 2e6;

// A mesh as full and empty cells of a grid, whose outermost layers are empty.
class Voxels {
 public:
  // `cells`: number of them along the longest side. Enclosed cells are full, unless one of
  // the points `hollow` is among them. None if the surface has no extent or too many points.
  [[nodiscard]] static std::optional<Voxels> of(const Surface& surface, int cells,
                                                std::span<const Vec3d> hollow);

  [[nodiscard]] double edge() const { return edge_; }  // m
  [[nodiscard]] const Cell& counts() const { return counts_; }
  [[nodiscard]] bool is_full(const Cell& cell) const { return kinds_[place(cell)] != kOutside; }
  // The surface in a cell; null: there is none.
  [[nodiscard]] const Bounds* surface_in(const Cell& cell) const {
    const std::int32_t at = surfaces_[place(cell)];
    return at < 0 ? nullptr : &bounds_[static_cast<std::size_t>(at)];
  }
  // The lower side of a cell along an axis (m).
  [[nodiscard]] double side(int axis, int cell) const { return origin_[axis] + edge_ * cell; }
  // Middle of all full cells (m).
  [[nodiscard]] Vec3d centre() const;

 private:
  static constexpr std::uint8_t kInside = 0;
  static constexpr std::uint8_t kSurface = 1;
  static constexpr std::uint8_t kOutside = 2;

  [[nodiscard]] std::size_t place(const Cell& cell) const {
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(counts_[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(counts_[0]) +
           static_cast<std::size_t>(cell[0]);
  }
  [[nodiscard]] Cell cell_at(const Vec3d& point) const;
  [[nodiscard]] bool has(const Cell& cell) const;
  void mark(const Surface& surface);
  void flood(const Cell& from);

  Vec3d origin_{};
  double edge_ = 0.0;
  Cell counts_{};
  std::vector<std::uint8_t> kinds_{};
  std::vector<std::int32_t> surfaces_{};  // index in bounds_, or -1
  std::vector<Bounds> bounds_{};
};

}  // namespace shigusa
