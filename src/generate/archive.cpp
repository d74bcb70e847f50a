// SPDX-License-Identifier: MIT
#include "generate/archive.hpp"

#include <algorithm>
#include <utility>

namespace shigusa {

Style style_of(const std::optional<double>& stoop_squat_index) {
  if (!stoop_squat_index) return Style::upright;
  return *stoop_squat_index > kStoopIndex   ? Style::stoop
         : *stoop_squat_index < kSquatIndex ? Style::squat
                                            : Style::between;
}

Archive::Archive(const PosedBody& posed, int hand)
    : dofs_(posed.body.dofs().size()), meter_(posed.body, posed.home, hand), angles_(dofs_) {
  for (std::size_t d = 0; d < dofs_; ++d) {
    const JointPlace& part = posed.body.dofs()[d].part;
    if (part.freedom_kind != FreedomKind::rotation) continue;
    if (part.joint_kind == JointKind::hip && part.side == Side::right) descriptors_[0].push_back(d);
    if (part.joint_kind == JointKind::shoulder) descriptors_[1].push_back(d);
  }
}

double Archive::mean_of(std::size_t descriptor, std::span<const float> posture) const {
  const std::vector<std::size_t>& dofs = descriptors_[descriptor];
  double sum = 0.0;
  for (const std::size_t d : dofs) sum += static_cast<double>(posture[d]);
  return dofs.empty() ? 0.0 : sum / static_cast<double>(dofs.size());
}

Archive::Cell Archive::cell_of(std::span<const float> posture, std::optional<double> index) const {
  Cell cell{};
  // a posture that hardly bends has its own cell
  cell[2] = index ? static_cast<int>(clamp(*index / kIndexCell + 100.0, 0.0, 200.0)) : -1;
  for (std::size_t k = 0; k < descriptors_.size(); ++k) {
    // angles far outside the human range share a cell
    cell[k] = static_cast<int>(clamp(mean_of(k, posture) / kCell + 100.0, 0.0, 200.0));
  }
  return cell;
}

void Archive::add(std::span<const double> points, std::span<const double> scores,
                  std::span<const float> postures, double worst) {
  const std::size_t genes = scores.empty() ? 0 : points.size() / scores.size();
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!(scores[i] < worst)) continue;
    const std::span<const float> posture = postures.subspan(i * dofs_, dofs_);
    angles_.assign(posture.begin(), posture.end());
    const std::optional<double> index = meter_.index(angles_);
    std::vector<Archived>& cell = cells_[cell_of(posture, index)];
    if (cell.size() >= kPerCell && !(scores[i] < cell.back().score)) continue;
    const std::span<const double> point = points.subspan(i * genes, genes);
    insert({{point.begin(), point.end()}, scores[i], meter_.look(angles_), style_of(index)}, cell);
  }
}

void Archive::add(const Archive& later) {
  for (const auto& [cell, kept] : later.cells_) {
    for (const Archived& archived : kept) insert(archived, cells_[cell]);
  }
}

// Inserts a point behind those of the same score.
void Archive::insert(Archived archived, std::vector<Archived>& cell) {
  const auto after =
      std::upper_bound(cell.begin(), cell.end(), archived.score,
                       [](double score, const Archived& kept) { return score < kept.score; });
  cell.insert(after, std::move(archived));
  if (cell.size() > kPerCell) cell.pop_back();
}

const Archived* Archive::best() const {
  const Archived* best = nullptr;
  for (const auto& [cell, kept] : cells_) {
    if (best == nullptr || kept.front().score < best->score) best = &kept.front();
  }
  return best;
}

std::vector<Archived> Archive::ranked() const {
  std::vector<Archived> all;
  for (const auto& [cell, kept] : cells_) all.insert(all.end(), kept.begin(), kept.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Archived& a, const Archived& b) { return a.score < b.score; });
  return all;
}

void copy_end(const Clip& clip, std::span<float> posture) {
  const std::span<const double> last = clip.frame(clip.frames - 1);
  for (std::size_t d = 0; d < posture.size(); ++d) posture[d] = static_cast<float>(last[d]);
}

}  // namespace shigusa
