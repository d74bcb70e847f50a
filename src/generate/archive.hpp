// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <shigusa/motion.hpp>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

#include "generate/posture_meter.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Final bend of a person, by the stoop-squat index (FinalPosture).
enum class Style { upright, stoop, between, squat };
inline constexpr std::size_t kStyles = 4;
[[nodiscard]] Style style_of(const std::optional<double>& stoop_squat_index);

// A scored point, with the posture in which its motion ends.
struct Archived {
  std::vector<double> point;
  double score = 0.0;
  Look look;
  Style style = Style::upright;
};

// Points evaluated by a search, sorted by the ends of their motions so that different answers
// survive beside better ones: the best few of each cell of a grid over measured descriptors (the
// stoop-squat index; hip rotation: twist of the trunk; shoulder rotation: swivel of the arm). The
// grid bounds the memory. After MAP-Elites (J.-B. Mouret and J. Clune, arXiv 1504.04909), but
// passive: the search does not draw from the archive.
class Archive {
 public:
  static constexpr double kCell = radians(20.0);  // rad, of each joint's descriptor
  static constexpr double kIndexCell = 15.0;      // in points of the stoop-squat index
  static constexpr std::size_t kPerCell = 4;

  // The body outlives the archive. `hand`: see PostureMeter.
  Archive(const PosedBody& body, int hand);

  // Adds points (motions × genes) with their scores (motions) and postures (motions × dofs).
  // Motions with a score of `worst` or above are skipped: they violate a constraint.
  void add(std::span<const double> points, std::span<const double> scores,
           std::span<const float> postures, double worst);

  // Adds the points of another archive of the same body, as if they had come later.
  void add(const Archive& later);

  // The best point, the first among equals in the order of ranked(); null in an empty archive.
  // Valid until the next add().
  [[nodiscard]] const Archived* best() const;
  // All points, best first; equal scores in the order of their cells and of insertion.
  [[nodiscard]] std::vector<Archived> ranked() const;

 private:
  using Cell = std::array<int, 3>;

  static void insert(Archived archived, std::vector<Archived>& cell);
  [[nodiscard]] double mean_of(std::size_t descriptor, std::span<const float> posture) const;
  [[nodiscard]] Cell cell_of(std::span<const float> posture, std::optional<double> index) const;

  std::size_t dofs_;
  PostureMeter meter_;
  std::vector<double> angles_;
  std::array<std::vector<std::size_t>, 2> descriptors_;  // dofs averaged for each descriptor
  std::map<Cell, std::vector<Archived>> cells_;          // each best first
};

// Copies the last frame of a clip into a posture (dofs, or empty) of the archive's format.
void copy_end(const Clip& clip, std::span<float> posture);

}  // namespace shigusa
