// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/body/body_model.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Weights that a person may set; only their ratios matter. Over wider ratios the damping, which is
// relative, would blunt the goals.
inline constexpr double kWeightMin = 1e-3;
inline constexpr double kWeightMax = 1e3;

// How readily one joint freedom moves.
struct JointWeight {
  double weight = 1.0;  // > 0; the larger, the less the freedom moves beside the others
  bool locked = false;  // it keeps its start angle

  friend bool operator==(const JointWeight&, const JointWeight&) = default;
};

// The few readable numbers that a motion is generated from; what a search finds and a person edits.
struct Parameters {
  std::vector<JointWeight> joints;  // (dofs) in the body's order

  friend bool operator==(const Parameters&, const Parameters&) = default;
};

// All freedoms alike: the plain pseudo-inverse.
[[nodiscard]] Parameters uniform_parameters(const BodyModel& body);

// The paper's code (section 3.2): one gene per freedom, 1..15 is the weight, 0 locks it.
[[nodiscard]] Parameters decode_paper_genes(std::span<const std::uint16_t> genes);

// 1 / w of each of the paper's genes, 0 where locked, in single precision: what BatchRollout takes,
// (motions × dofs) of genomes one after the other.
[[nodiscard]] std::vector<float> inverse_weights_of_genes(std::span<const std::uint16_t> genes);

// 1 / weight, or 0 where locked: (dofs), what weighted IK computes with.
[[nodiscard]] std::vector<double> inverse_weights(const Parameters& parameters);

}  // namespace shigusa
