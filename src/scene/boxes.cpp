// SPDX-License-Identifier: MIT
#include "scene/boxes.hpp"

#include <iterator>
#include <utility>

namespace shigusa {
namespace {

// Full cells from `low` to before `high`.
struct CellBox {
  Cell low{};
  Cell high{};
};

// An order in which cells are gathered: along the first axis, the second, the third; from the top
// of the third one, or from its bottom.
struct Order {
  std::array<std::size_t, 3> axes;
  bool down = false;
};
constexpr Order kOrders[] = {
    {{0, 2, 1}, true}, {{2, 0, 1}, true}, {{0, 2, 1}, false}, {{2, 0, 1}, false},
    {{0, 1, 2}, true}, {{1, 0, 2}, true}, {{0, 1, 2}, false}, {{1, 0, 2}, false},
    {{1, 2, 0}, true}, {{2, 1, 0}, true}, {{1, 2, 0}, false}, {{2, 1, 0}, false},
};

// Visits the cells of a box; stops and returns false where `visit` does.
template <class Visit>
bool each_cell(const CellBox& box, Visit&& visit) {
  for (int z = box.low[2]; z < box.high[2]; ++z) {
    for (int y = box.low[1]; y < box.high[1]; ++y) {
      for (int x = box.low[0]; x < box.high[0]; ++x) {
        if (!visit(Cell{x, y, z})) return false;
      }
    }
  }
  return true;
}

// Gathers full cells into boxes, greedily.
class Gatherer {
 public:
  Gatherer(const Voxels& voxels, const Order& order) : voxels_(voxels), order_(order) {
    const Cell& n = voxels.counts();
    taken_.assign(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
                      static_cast<std::size_t>(n[2]),
                  false);
  }

  // The boxes; empty if there are more than `most`.
  std::vector<CellBox> gather(std::size_t most) {
    std::vector<CellBox> boxes;
    const auto [a, b, c] = order_.axes;
    const Cell& n = voxels_.counts();
    for (int k = 0; k < n[c]; ++k) {
      Cell cell{};
      cell[c] = order_.down ? n[c] - 1 - k : k;
      for (cell[b] = 0; cell[b] < n[b]; ++cell[b]) {
        for (cell[a] = 0; cell[a] < n[a]; ++cell[a]) {
          if (!is_free(cell)) continue;
          if (boxes.size() == most) return {};
          boxes.push_back(grown(cell));
        }
      }
    }
    return boxes;
  }

 private:
  [[nodiscard]] std::size_t place(const Cell& cell) const {
    const Cell& n = voxels_.counts();
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(n[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(n[0]) +
           static_cast<std::size_t>(cell[0]);
  }
  [[nodiscard]] bool is_free(const Cell& cell) const {
    return voxels_.is_full(cell) && !taken_[place(cell)];
  }

  CellBox grown(const Cell& from) {
    CellBox box{from, {from[0] + 1, from[1] + 1, from[2] + 1}};
    for (const std::size_t axis : order_.axes) {
      const bool down = order_.down && axis == order_.axes[2];
      // the outermost layers of the grid are empty
      for (;;) {
        CellBox layer = box;
        layer.low[axis] = down ? box.low[axis] - 1 : box.high[axis];
        layer.high[axis] = layer.low[axis] + 1;
        if (!each_cell(layer, [&](const Cell& cell) { return is_free(cell); })) break;
        (down ? box.low[axis] : box.high[axis]) += down ? -1 : 1;
      }
    }
    each_cell(box, [&](const Cell& cell) {
      taken_[place(cell)] = true;
      return true;
    });
    return box;
  }

  const Voxels& voxels_;
  const Order& order_;
  std::vector<bool> taken_;
};

// The fewest boxes of all orders; empty if all have more than `most`.
std::vector<CellBox> gathered(const Voxels& voxels, std::size_t most) {
  std::vector<CellBox> best;
  for (const Order& order : kOrders) {
    if (most == 0) break;
    std::vector<CellBox> boxes = Gatherer(voxels, order).gather(most);
    if (boxes.empty()) continue;
    most = boxes.size() - 1;
    best = std::move(boxes);
  }
  return best;
}

// One end of a box along an axis (m): where its surface ends, if most of what lies beyond is empty,
// else the cells' side.
double end_of(const Voxels& voxels, const CellBox& box, int axis, bool upper) {
  const auto k = static_cast<std::size_t>(axis);
  CellBox layer = box;
  (upper ? layer.low[k] : layer.high[k]) = upper ? box.high[k] - 1 : box.low[k] + 1;
  int cells = 0;
  int open = 0;
  Bounds reach;
  each_cell(layer, [&](Cell cell) {
    ++cells;
    const Bounds* surface = voxels.surface_in(cell);
    cell[k] += upper ? 1 : -1;
    if (voxels.is_full(cell)) return true;
    ++open;
    if (surface == nullptr) return true;
    reach.add(surface->low);
    reach.add(surface->high);
    return true;
  });
  if (2 * open <= cells || reach.low[axis] > reach.high[axis]) {
    return voxels.side(axis, upper ? box.high[k] : box.low[k]);
  }
  return upper ? reach.high[axis] : reach.low[axis];
}

}  // namespace

MeshBoxes boxes_of(const Surface& surface, std::size_t most, std::span<const Vec3d> hollow,
                   std::size_t grid) {
  if (surface.points.empty()) return {};
  while (most > 1 && grid < std::size(kSceneCells)) {
    const std::optional<Voxels> voxels = Voxels::of(surface, kSceneCells[grid++], hollow);
    if (!voxels) continue;
    const std::vector<CellBox> cells = gathered(*voxels, most);
    if (cells.empty()) continue;
    MeshBoxes found{{}, grid};
    for (const CellBox& box : cells) {
      Bounds& tight = found.boxes.emplace_back();
      for (int k = 0; k < 3; ++k) {
        tight.low[k] = end_of(*voxels, box, k, false);
        tight.high[k] = end_of(*voxels, box, k, true);
      }
    }
    return found;
  }
  return {{surface.bounds()}, std::size(kSceneCells)};
}

}  // namespace shigusa
