// SPDX-License-Identifier: MIT
#include "rollout/smooth_motion.hpp"

#include "core/index.hpp"
#include "record_motion.hpp"

namespace shigusa {
namespace {

// λ: changes with a period of 10 frames are halved, faster ones nearly removed.
constexpr double kSmoothness = 16.0;
constexpr std::array<double, 4> kThirdDifference{-1.0, 3.0, -3.0, 1.0};
constexpr int kBand = 3;

// Smooths a sequence of frames by an LDLᵀ decomposition of I + λ DᵀD, a matrix of seven diagonals;
// the first and the last frame are fixed, and the body is at rest beyond them.
class LeastJerk {
 public:
  explicit LeastJerk(int frames)
      : inner_(frames - 2), rows_(index(inner_)), first_(rows_.size()), last_(rows_.size()) {
    for (auto& row : rows_) row[0] = 1.0;
    for (int j = -kBand; j <= inner_; ++j) add_difference(j);
    for (int i = 0; i < inner_; ++i) {
      const auto& row = rows_[index(i)];
      for (int k = 1; k <= most(i); ++k) {
        const double share = row[index(k)] / row[0];
        for (int m = k; m <= most(i); ++m)
          rows_[index(i + k)][index(m - k)] -= share * row[index(m)];
      }
      for (int k = 1; k <= kBand; ++k) rows_[index(i)][index(k)] /= row[0];
    }
  }

  // `value(frame)` returns a reference.
  template <class Value>
  void smooth(Value&& value) const {
    const double first = value(0);
    const double last = value(inner_ + 1);
    for (int i = 0; i < inner_; ++i) {
      value(i + 1) -= first_[index(i)] * first + last_[index(i)] * last;
    }
    for (int i = 0; i < inner_; ++i) {
      for (int k = 1; k <= most(i); ++k)
        value(i + 1 + k) -= rows_[index(i)][index(k)] * value(i + 1);
    }
    for (int i = inner_ - 1; i >= 0; --i) {
      value(i + 1) /= rows_[index(i)][0];
      for (int k = 1; k <= most(i); ++k)
        value(i + 1) -= rows_[index(i)][index(k)] * value(i + 1 + k);
    }
  }

 private:
  // Number of diagonals to the right in a row.
  [[nodiscard]] int most(int i) const { return i + kBand < inner_ ? kBand : inner_ - 1 - i; }

  // Adds the third difference that begins at the inner frame j.
  void add_difference(int j) {
    for (int k = 0; k <= kBand; ++k) {
      const int i = j + k;
      if (i < 0 || i >= inner_) continue;
      for (int m = 0; m <= kBand; ++m) {
        const double part = kSmoothness * kThirdDifference[index(k)] * kThirdDifference[index(m)];
        const int other = j + m;
        if (other < 0) {
          first_[index(i)] += part;
        } else if (other >= inner_) {
          last_[index(i)] += part;
        } else if (other >= i) {
          rows_[index(i)][index(other - i)] += part;
        }
      }
    }
  }

  int inner_;  // frames between the first and the last
  std::vector<std::array<double, 1 + kBand>>
      rows_;                   // from the diagonal to the right; then D and Lᵀ
  std::vector<double> first_;  // of the matrix, for the fixed frames
  std::vector<double> last_;
};

// Adds a share of what the start's velocities carry on to the frames (frames × dofs, rad).
void carry(const ReachProblem& problem, double share, std::vector<double>& angles) {
  const std::vector<double> momentum = problem.momentum();
  for (std::size_t i = 0; !momentum.empty() && i < angles.size(); ++i) {
    const double tau = static_cast<double>(i / momentum.size()) / problem.steps;
    angles[i] += share * momentum[i % momentum.size()] * carried_on(tau);
  }
}

}  // namespace

void smooth_frames(std::size_t dofs, std::vector<double>& angles) {
  const auto frames = static_cast<int>(angles.size() / dofs);
  if (frames < 3) return;
  const LeastJerk row(frames);
  for (std::size_t d = 0; d < dofs; ++d) {
    bool moves = false;
    for (int f = 1; f < frames; ++f) moves = moves || angles[index(f) * dofs + d] != angles[d];
    // locked joints keep their exact values
    if (!moves) continue;
    row.smooth([&](int frame) -> double& { return angles[index(frame) * dofs + d]; });
  }
}

RolledOut smoothed(const ReachProblem& problem, const Parameters& parameters, RolledOut rolled) {
  std::vector<double> angles = rolled.motion.clip.angles;
  // what the start's velocities carry on is smooth, and the rest begins at rest
  carry(problem, -1.0, angles);
  smooth_frames(problem.body->dofs().size(), angles);
  carry(problem, 1.0, angles);
  MotionRecorder recorder(problem);
  const HeldInput held(*problem.body, parameters, problem.supports.size());
  const ReachOutcome outcome = Rollout<double>(problem).retrace(held.input(), angles, recorder);
  if (!outcome.met(problem.tolerance)) return rolled;
  return {std::move(recorder.motion), outcome};
}

}  // namespace shigusa
