// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/parameters.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "body/posture_modes.hpp"
#include "plan/motion_input.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The meaning of a point of a search's unit cube.
enum class GeneCode {
  paper,        // a 4-bit weight 0..15 for each freedom, 0 locks it
  logarithmic,  // a weight for each freedom, even in its logarithm
  natural,      // logarithmic weights, postures, bow and sway: see ParameterSpace
  every,        // these, and delay and skew, which bring no search anything (docs/experiments.md)
};

// The parameters that a search looks for. The natural code has one weight for each freedom that
// moves a goal's effector or a planted foot, both legs sharing theirs; the value of each posture
// mode that moves one of these; bow and sway; what resting hands press with. A fixed parameter is
// no coordinate, or of the paper's code one that changes nothing. The list is of the whole body's
// plan; problem and list outlive the space.
class ParameterSpace {
 public:
  ParameterSpace(const ReachProblem& problem, const ParameterList& list, GeneCode code,
                 const std::optional<FixedParameters>& fixed = {});

  [[nodiscard]] int genes() const { return static_cast<int>(genes_.size()); }
  // The name of each coordinate: "right_knee.flexion", "squat", "delay".
  [[nodiscard]] std::vector<std::string> names() const;
  // (genes) the plain pseudo-inverse on a straight path.
  [[nodiscard]] std::vector<double> start() const;
  [[nodiscard]] Parameters decode(std::span<const double> point) const;
  // (genes) the point that decodes to given values of the body, or comes nearest: a weight that
  // freedoms share is the geometric mean of theirs, a locked one the largest. Of codes in the
  // weights' logarithms.
  [[nodiscard]] std::vector<double> encode(const Parameters& values) const;

  // Index of the coordinate of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
  // Indices of the coordinates that are weights of that freedom of that joint.
  [[nodiscard]] std::vector<int> weights_of(JointKind joint, FreedomKind freedom) const;
  // Where a coordinate is when its parameter has that value, held to [0, 1].
  [[nodiscard]] double coordinate(int gene, double value) const;
  // The least value of a gene.
  [[nodiscard]] double lowest(int gene) const {
    return genes_[static_cast<std::size_t>(gene)].lower;
  }

  // Decodes many points, one after the other, as BatchRollout takes them; valid until the next
  // call.
  [[nodiscard]] MotionInputs rows(std::span<const double> points);

 private:
  // The rows of MotionInputs.
  enum Row : std::uint8_t { kWeights, kPosture, kTiming, kSupports };
  static constexpr std::size_t kRows = 4;
  // One number of a motion's rows, which has `factor` times a coordinate's value.
  struct Cell {
    Row row;
    std::size_t column;
    double factor;
  };

  // One coordinate.
  struct Gene {
    ParameterKind kind = ParameterKind::weight;
    std::string name;
    std::vector<std::size_t> parameters{};  // that it sets, all to the same
    std::vector<Cell> cells{};              // where these stand in the rows
    double lower = 0.0;                     // of what x = 0 stands for; the logarithm of a weight
    double upper = 1.0;
    double start = 0.0;  // what the search starts from

    [[nodiscard]] double at(double x) const { return lower + x * (upper - lower); }
    [[nodiscard]] double of(double value) const { return (value - lower) / (upper - lower); }
  };

  // `useful`: (dofs) which move a target: the others do nothing in weighted IK
  void add(std::size_t parameter, const std::vector<bool>& useful);
  void add_weight(std::size_t parameter, const std::vector<bool>& useful, Gene gene);
  [[nodiscard]] std::vector<std::uint16_t> genome_of(std::span<const double> point) const;
  void start_rows();
  void add_cells(const ParameterInfo& info, std::vector<Cell>& cells) const;
  void add_to_rows(std::size_t motion, std::span<const double> point);
  [[nodiscard]] double value_of(const Gene& gene, const Parameters& values) const;

  const BodyModel* body_;
  const ParameterList* list_;
  GeneCode code_;
  bool named_;       // weights and postures by what they mean
  Parameters base_;  // what is fixed, and the start values of the rest
  std::vector<bool> set_;
  std::vector<PostureMode> modes_;
  std::size_t supports_;
  std::vector<Gene> genes_;
  std::array<std::vector<float>, kRows> base_rows_;  // of one motion, without the genes' cells
  std::array<std::vector<float>, kRows> rows_;       // of all motions
};

}  // namespace shigusa
