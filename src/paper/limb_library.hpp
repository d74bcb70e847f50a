// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "paper/arm_search.hpp"
#include "rollout/batch_rollout.hpp"

namespace shigusa {

// Rule R5: hand goals in the trunk's frame around the shoulder, by azimuth and elevation in steps
// of 15° and by 6 radii from 0.35 to 1 of the arm's length at kLeastBend.
inline constexpr int kLimbAzimuths = 24;    // 0 is forwards, positive to the left
inline constexpr int kLimbElevations = 12;  // from the trunk's horizontal plane, upwards
inline constexpr int kLimbRadii = 6;
inline constexpr int kLimbCells = kLimbAzimuths * kLimbElevations * kLimbRadii;
inline constexpr double kLimbAngle = radians(15.0);
inline constexpr double kLimbRadiusMin = 0.35;

struct LimbLibrarySettings {
  LimbSearch search = LimbSearch::ladder;
  // Criteria of the lower layer: joint range and torque.
  CriteriaSettings criteria{{CriterionKind::joint_range, kPaperRangeWeight},
                            {CriterionKind::torque, kPaperTorqueWeight}};
  BatchSettings batch{};  // does not affect results
};

// The best weights to move an arm to each of a grid of goals, from its hanging posture, with the
// trunk held upright (paper, section 3.4; rule R5). A cell is searched on first use; cells do not
// depend on one another nor on the order of use, so a stored library gives the same results as a
// new one.
class LimbLibrary {
 public:
  // Makes a library of an arm_body.
  explicit LimbLibrary(const PosedBody& arm, const LimbLibrarySettings& settings = {});

  // The cell nearest to a hand's position (m, from the shoulder, in the trunk's frame).
  [[nodiscard]] int cell_of(const Vec3d& hand) const;
  // The goal of a cell (m), and the path to it: straight, or around the shoulder if that would come
  // nearer to it than the least radius.
  [[nodiscard]] Vec3d goal_of(int cell) const;
  [[nodiscard]] EffectorPath path_to(int cell) const;

  // Searches a cell that is not built yet; genes() and score() do so too.
  void build(int cell);
  // A cell's genome.
  [[nodiscard]] ArmGenes genes(int cell);
  // A cell's score; if no motion leads to the goal, the worst score, and all weights are 1.
  [[nodiscard]] double score(int cell);
  // Searches all cells that are not built yet.
  void build_all();
  [[nodiscard]] int cells_built() const { return built_; }

  // Hash of body and settings, for a file's name.
  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  // All cells built, with a header: hash, version and a check sum.
  [[nodiscard]] std::string bytes() const;
  // Adds cells from the result of bytes(); existing ones stay. Returns false, and adds nothing, if
  // the text is damaged, or of another version, body or settings.
  bool take(std::string_view bytes);

 private:
  struct Cell {
    bool built = false;
    ArmGenes genes{1, 1, 1, 1};
    float score = 0.0F;
  };

  BodyModel arm_;
  State home_;
  LimbLibrarySettings settings_;
  double longest_ = 0.0;  // m
  Vec3d hanging_{};       // m, the hand in the start posture
  std::uint64_t hash_ = 0;
  std::vector<Cell> cells_;
  int built_ = 0;
};

// File name of a library, such as "right_arm-0123456789abcdef.limb".
[[nodiscard]] std::string limb_file_name(const std::string& arm, std::uint64_t hash);

}  // namespace shigusa
