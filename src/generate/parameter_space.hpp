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

// Meaning of a point of the search's unit cube.
enum class GeneCode {
  paper,        // a 4-bit weight 0..15 for each dof, 0 locks it
  logarithmic,  // a weight for each dof, uniform in its logarithm
  natural,      // logarithmic weights, postures, bow and sway: see ParameterSpace
  every,  // as `natural`, with delay and skew, which do not help a search (docs/experiments.md)
};

// The space of searched parameters. The natural code has one weight for each dof that moves a
// goal's effector or a planted foot, shared by both legs; each posture mode that moves one of
// these; bow and sway; the loads of resting hands. A fixed parameter has no coordinate, or in the
// paper's code one without effect. The list belongs to the whole body's plan; problem and list
// outlive the space.
class ParameterSpace {
 public:
  ParameterSpace(const ReachProblem& problem, const ParameterList& list, GeneCode code,
                 const std::optional<FixedParameters>& fixed = {});

  [[nodiscard]] int genes() const { return static_cast<int>(genes_.size()); }
  // The name of each coordinate: "right_knee.flexion", "squat", "delay".
  [[nodiscard]] std::vector<std::string> names() const;
  // (genes) the point of the plain pseudo-inverse on a straight path.
  [[nodiscard]] std::vector<double> start() const;
  [[nodiscard]] Parameters decode(std::span<const double> point) const;
  // (genes) the point that decodes to the given values, or nearest to them: a weight shared by
  // several dofs is the geometric mean of theirs, with locked ones at the upper bound. For codes in
  // the logarithms of weights.
  [[nodiscard]] std::vector<double> encode(const Parameters& values) const;

  // Index of the coordinate with this name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
  // Indices of the coordinates that are weights of this dof of the joint.
  [[nodiscard]] std::vector<int> weights_of(JointKind joint, FreedomKind freedom) const;
  // The coordinate for a parameter value, clamped to [0, 1].
  [[nodiscard]] double coordinate(int gene, double value) const;

  // Decodes many points, in sequence, for BatchRollout; valid until the next call.
  [[nodiscard]] MotionInputs rows(std::span<const double> points);

 private:
  // The rows of MotionInputs.
  enum Row : std::uint8_t { kWeights, kPosture, kTiming, kSupports };
  static constexpr std::size_t kRows = 4;
  // One element of a motion's rows, `factor` times the value of a coordinate.
  struct Cell {
    Row row;
    std::size_t column;
    double factor;
  };

  // One coordinate.
  struct Gene {
    ParameterKind kind = ParameterKind::weight;
    std::string name;
    std::vector<std::size_t> parameters{};  // all set to the same value
    std::vector<Cell> cells{};              // their elements in the rows
    double lower = 0.0;                     // value at x = 0; for a weight its logarithm
    double upper = 1.0;
    double start = 0.0;  // initial value of the search

    [[nodiscard]] double at(double x) const { return lower + x * (upper - lower); }
    [[nodiscard]] double of(double value) const { return (value - lower) / (upper - lower); }
  };

  // `useful`: (dofs) whether a dof moves a target: the others have no effect in weighted IK.
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
  bool named_;       // weights and postures have names of their own meaning
  Parameters base_;  // the fixed values, and start values of the rest
  std::vector<bool> set_;
  std::vector<PostureMode> modes_;
  std::size_t supports_;
  std::vector<Gene> genes_;
  std::array<std::vector<float>, kRows> base_rows_;  // of one motion, without the genes' cells
  std::array<std::vector<float>, kRows> rows_;       // of all motions
};

}  // namespace shigusa
