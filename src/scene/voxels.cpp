// SPDX-License-Identifier: MIT
#include "scene/voxels.hpp"

#include <algorithm>

namespace shigusa {
namespace {

// Spacing of points on the surface, as a share of a cell's edge: a flood does not pass between.
constexpr double kSpacing = 0.35;
// Distance of the grid's start from the mesh, in cells: a flat side lies within a cell.
constexpr double kMargin = 1.5;
constexpr int kMarginCells = 3;  // of both sides
// Least extent of a mesh (m).
constexpr double kExtentLeast = 1e-6;

}  // namespace

std::optional<Voxels> Voxels::of(const Surface& surface, int cells, std::span<const Vec3d> hollow) {
  const Bounds bounds = surface.bounds();
  if (surface.points.empty() || !(bounds.longest() > kExtentLeast)) return std::nullopt;
  Voxels voxels;
  voxels.edge_ = bounds.longest() / cells;
  if (count_points(surface, kSpacing * voxels.edge_) > kSurfacePointsMax) return std::nullopt;
  std::size_t all = 1;
  for (int k = 0; k < 3; ++k) {
    const double count = min(bounds.size()[k] / voxels.edge_, static_cast<double>(cells));
    voxels.origin_[k] = bounds.low[k] - kMargin * voxels.edge_;
    const int whole = static_cast<int>(count) + kMarginCells + 1;
    voxels.counts_[static_cast<std::size_t>(k)] = whole;
    all *= static_cast<std::size_t>(whole);
  }
  voxels.kinds_.assign(all, kInside);
  voxels.surfaces_.assign(all, -1);
  voxels.mark(surface);
  voxels.flood({0, 0, 0});
  for (const Vec3d& point : hollow) {
    if (const Cell cell = voxels.cell_at(point); voxels.has(cell)) voxels.flood(cell);
  }
  return voxels;
}

Cell Voxels::cell_at(const Vec3d& point) const {
  Cell cell{};
  for (int k = 0; k < 3; ++k) {
    const double at = (point[k] - origin_[k]) / edge_;
    cell[static_cast<std::size_t>(k)] = at >= 0.0 && at < 1e6 ? static_cast<int>(at) : -1;
  }
  return cell;
}

bool Voxels::has(const Cell& cell) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell[k] < 0 || cell[k] >= counts_[k]) return false;
  }
  return true;
}

void Voxels::mark(const Surface& surface) {
  each_point(surface, kSpacing * edge_, [&](const Vec3d& point) {
    Cell cell = cell_at(point);
    // rounding stays within the margin
    for (std::size_t k = 0; k < 3; ++k) cell[k] = std::clamp(cell[k], 1, counts_[k] - 2);
    const std::size_t at = place(cell);
    if (surfaces_[at] < 0) {
      surfaces_[at] = static_cast<std::int32_t>(bounds_.size());
      bounds_.emplace_back();
      kinds_[at] = kSurface;
    }
    bounds_[static_cast<std::size_t>(surfaces_[at])].add(point);
  });
}

void Voxels::flood(const Cell& from) {
  if (kinds_[place(from)] != kInside) return;
  kinds_[place(from)] = kOutside;
  std::vector<Cell> open{from};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int step : {-1, 1}) {
        Cell next = cell;
        next[k] += step;
        if (!has(next) || kinds_[place(next)] != kInside) continue;
        kinds_[place(next)] = kOutside;
        open.push_back(next);
      }
    }
  }
}

Vec3d Voxels::centre() const {
  Vec3d sum{};
  double full = 0.0;
  for (int z = 0; z < counts_[2]; ++z) {
    for (int y = 0; y < counts_[1]; ++y) {
      for (int x = 0; x < counts_[0]; ++x) {
        if (!is_full({x, y, z})) continue;
        sum += Vec3d{x + 0.5, y + 0.5, z + 0.5};
        full += 1.0;
      }
    }
  }
  return origin_ + sum * (edge_ / max(full, 1.0));
}

}  // namespace shigusa
