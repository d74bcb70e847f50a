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

// How people bend, by the stoop-squat index (FinalPosture).
enum class Style { upright, stoop, between, squat };
inline constexpr std::size_t kStyles = 4;
[[nodiscard]] Style style_of(const std::optional<double>& stoop_squat_index);

// A point that was scored, with the posture in which its motion ends.
struct Archived {
  std::vector<double> point;
  double score = 0.0;
  std::vector<float> posture;  // (dofs) rad
  Style style = Style::upright;
};

// Keeps the points that a search came upon, sorted by how their motions end, so that different
// answers stay beside better ones: the best few of each cell of a grid over measured descriptors
// (the stoop-squat index; hip rotation: twist of the trunk; shoulder rotation: swivel of the arm).
// The grid bounds its memory. After MAP-Elites (J.-B. Mouret and J. Clune, arXiv 1504.04909), but
// the archive only watches: the search does not draw from it.
class Archive {
 public:
  static constexpr double kCell = radians(20.0);  // rad, of each joint's descriptor
  static constexpr double kIndexCell = 15.0;      // of the stoop-squat index
  static constexpr std::size_t kPerCell = 4;

  // The body outlives the archive.
  explicit Archive(const BodyModel& body);

  // Takes in points (motions × genes) with their scores (motions) and postures (motions × dofs).
  // It passes over motions whose score is `worst` or above: they missed something.
  void add(std::span<const double> points, std::span<const double> scores,
           std::span<const float> postures, double worst);

  // Takes in what another of the same body keeps, as if its motions had come after.
  void add(const Archive& later);

  // The best of all, the first of equals in their order below; null where nothing is kept. Valid
  // until something is added.
  [[nodiscard]] const Archived* best() const;
  // All that is kept, best first; equal scores in the order of their cells and of their coming.
  [[nodiscard]] std::vector<Archived> ranked() const;

 private:
  using Cell = std::array<int, 3>;

  static void insert(Archived archived, std::vector<Archived>& cell);
  [[nodiscard]] double mean_of(std::size_t descriptor, std::span<const float> posture) const;
  [[nodiscard]] Cell cell_of(std::span<const float> posture, std::optional<double> index) const;

  std::size_t dofs_;
  PostureMeter meter_;
  std::vector<double> angles_;
  std::array<std::vector<std::size_t>, 2> descriptors_;  // dofs whose mean each is
  std::map<Cell, std::vector<Archived>> cells_;          // each best first
};

// Copies a clip's last frame into a posture (dofs, or empty), as archives keep them.
void copy_end(const Clip& clip, std::span<float> posture);

// Root-mean-square difference of two postures' joint angles (rad).
[[nodiscard]] double posture_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shigusa
