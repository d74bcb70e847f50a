// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <shigusa/body_model.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// When a motion changes its posture, and by what line its effectors go. S is double, or a pack
/// whose lanes are motions of their own.
template <class S>
struct Timing {
  S delay{};  ///< share of the duration after which the posture begins to change
  S bow{};    ///< share of the path's length, forwards where > 0
  S skew{};   ///< of the bow towards the start (> 0) or the end
  S sway{};   ///< share of the path's length, outwards where > 0

  /// Whether it takes paths off their lines.
  [[nodiscard]] bool bends_paths() const { return bow != S{} || sway != S{}; }

  friend bool operator==(const Timing&, const Timing&) = default;
};

/// One of these numbers.
struct TimingNumber {
  std::string_view name;      ///< "bow"
  double low;                 ///< the least that is allowed
  double high;                ///< the most that is allowed
  double searched_low;        ///< the least that searches try
  double searched_high;       ///< the most that searches try
  bool searched;              ///< by the usual searches; the others leave it at 0
  std::string_view sentence;  ///< what it does
};

inline constexpr double kDelayMax = 0.5;  ///< share of the duration
/// The share of its length by which a path may leave its line: by its bow forwards or (< 0)
/// backwards, by its sway outwards or inwards. People's reaches leave it by a tenth to a fifth.
inline constexpr double kBowMax = 0.3;
/// By so much of it searches let a path leave its line.
inline constexpr double kBowSearched = 0.2;

/// All of them; whatever reads, writes, searches or shows a timing goes by this table.
inline constexpr std::array kTimingNumbers{
    TimingNumber{"delay", 0.0, kDelayMax, 0.0, kDelayMax, false,
                 "The posture begins to change after this share of the duration."},
    TimingNumber{"bow", -kBowMax, kBowMax, -kBowSearched / 2.0, kBowSearched, true,
                 "The paths leave their line forwards by this share of their length."},
    TimingNumber{"skew", -1.0, 1.0, -1.0, 1.0, false,
                 "The bow lies nearer to the start (above 0) or to the end."},
    TimingNumber{
        "sway", -kBowMax, kBowMax, -kBowSearched, kBowSearched, true,
        "The paths leave their line sideways by this share of their length, outwards above 0."},
};
/// Number of them.
inline constexpr std::size_t kTimings = kTimingNumbers.size();
/// Where they are, in the table's order.
template <class S>
inline constexpr std::array<S Timing<S>::*, kTimings> kTimingMembers{
    &Timing<S>::delay, &Timing<S>::bow, &Timing<S>::skew, &Timing<S>::sway};

/// Weights that a person may set; only their ratios matter. Over wider ratios the damping, which is
/// relative, would blunt the goals.
inline constexpr double kWeightMin = 1e-3;
/// The largest weight that a person may set.
inline constexpr double kWeightMax = 1e3;
/// Weights of the logarithmic codes are e^-5.5 .. e^5.5: a range of 15 is too narrow to reach
/// natural postures, and wider ones add nothing.
inline constexpr double kLogWeightRange = 5.5;
inline constexpr double kPostureMax = 3.2;  ///< rad, of a posture mode's value
/// How readily one joint freedom moves.
struct JointWeight {
  double weight = 1.0;  ///< > 0; the larger, the less the freedom moves beside the others
  bool locked = false;  ///< it keeps its start angle

  friend bool operator==(const JointWeight&, const JointWeight&) = default;
};

/// Where a motion is drawn to in what its goals leave free, and how it gets there.
struct PostureParameters {
  std::vector<double> modes;  ///< (posture_modes of the body) rad, -kPostureMax..kPostureMax
  Timing<double> timing{};    ///< within kTimingNumbers

  friend bool operator==(const PostureParameters&, const PostureParameters&) = default;
};

/// The freedoms of an arm that moves by weights.
inline constexpr int kArmDofs = 4;
/// The weights of shoulder flexion, abduction and rotation, and of elbow flexion.
using ArmWeights = std::array<JointWeight, kArmDofs>;

/// The few readable numbers that a motion is generated from: a search finds them, a person edits
/// them. Which of them a motion has, and what each is called, its plan tells (plan/plan.hpp).
struct Parameters {
  std::vector<JointWeight> joints;  ///< (dofs of the plan's first layer) in that body's order
  /// of the whole body; no modes: weights alone, as in the paper
  PostureParameters posture{};
  /// Of layers that shorten limbs: (limbs) 0..kContractionMax, where the limb is longest and
  /// shortest.
  std::vector<double> contractions{};
  std::vector<ArmWeights> arms{};  ///< (goals whose arm moves by weights)
  std::vector<double> swivels{};   ///< (goals whose arm moves by its swivel) rad
  std::vector<double> finals{};    ///< (final angles that layers search) rad
  /// (the task's supports) share of the body's weight that the hand presses with; below 0 it is
  /// free
  std::vector<double> supports{};
  /// The motion is the mirror image of the one that the other side's values make, as a body that
  /// stands on one foot and its image do not move alike to the last digit.
  bool reflected = false;

  friend bool operator==(const Parameters&, const Parameters&) = default;
};
/// A limb's range has this many parts; all of them make it shortest.
inline constexpr int kContractionMax = 15;

/// Values of which a search leaves some as a person has set them.
struct FixedParameters {
  Parameters values;      ///< with a posture
  std::vector<bool> set;  ///< (the plan's parameters that the values have) which are set
};

/// The most that a hand presses with, as a share of the body's weight: a weak man (5th percentile)
/// pushes 187 N with his left arm straight (MIL-STD-1472, arm strength; quoted from memory), a
/// quarter of the weight of 73 kg.
inline constexpr double kSupportMost = 0.25;
/// The least value of a support's parameter; all below 0 leave the hand free.
inline constexpr double kSupportLeast = -0.05;

/// All freedoms alike: the plain pseudo-inverse.
[[nodiscard]] Parameters uniform_parameters(const BodyModel& body);

/// The paper's code (section 3.2): one gene per freedom, 1..15 is the weight, 0 locks it.
[[nodiscard]] Parameters decode_paper_genes(std::span<const std::uint16_t> genes);

/// 1 / w of each of the paper's genes, 0 where locked, in single precision: what BatchRollout
/// takes, (motions × dofs) of genomes one after the other.
[[nodiscard]] std::vector<float> inverse_weights_of_genes(std::span<const std::uint16_t> genes);

/// 1 / weight, or 0 where locked: (dofs), what weighted IK computes with.
[[nodiscard]] std::vector<double> inverse_weights(const Parameters& parameters);

/// (dofs, rad) the change of posture that the modes' values add up to; PreconditionError where
/// there are not as many values as the body has modes.
[[nodiscard]] std::vector<double> posture_change(const BodyModel& body,
                                                 const PostureParameters& posture);

}  // namespace shigusa
