// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The readings of the paper's count of 14 parameters for the whole body (rule R2).
enum class LayerReading {
  shared_contractions,  ///< 6 weights per half of the body and 2 contractions: arms, legs
  contraction_a_limb,   ///< without hip rotation: 5 weights per half and 4 contractions
};

/// The words of LayerReading.
template <>
inline constexpr std::array kEnumWords<LayerReading>{
    EnumWord{LayerReading::shared_contractions, "shared_contractions"},
    EnumWord{LayerReading::contraction_a_limb, "contraction_a_limb"},
};

/// The stack of layers of a preset.
enum class LayerStack {
  paper,  ///< trunk with limbs of variable length, then the arms
  human,  ///< the same, then the swivel of arms, then idle limbs
};

/// The search of an arm's genome among the 65,536 possible ones. Genomes that lock two dofs or more
/// are skipped, as three are needed to place a hand, and so are multiples of another genome's
/// weights.
enum class LimbSearch {
  /// The best of the codes 0, 1, 3, 7 and 15 in all combinations, then repeatedly the best
  /// neighbour until none is better: some 600 motions.
  ladder,
  /// The best of all genomes.
  enumeration,
};

/// A store that keeps limb libraries between runs. Either function may be empty. Loaded bytes are
/// validated.
struct LimbStore {
  /// Returns the bytes stored under a name, or nothing.
  std::function<std::optional<std::string>(const std::string& name)> load;
  /// Stores bytes under a name.
  std::function<void(const std::string& name, std::string_view bytes)> save;
};

/// Largest number of further searches for an arm that passes through the body (rule R11); after the
/// last one the collision is accepted.
inline constexpr int kCollisionRounds = 3;

/// Settings for presets with layers.
struct LayeredSettings {
  /// Search of the arms' genomes; threads and SIMD set are the task's.
  LimbSearch limb_search = LimbSearch::ladder;
  /// Store of the limb libraries; without it they are searched anew, with the same result.
  LimbStore store{};
  int feedback_rounds = kCollisionRounds;  ///< most searches for an arm that collides; 0: none
};

/// The timing of a motion's posture and the shape of its effectors' paths. S is double, or a pack
/// with a motion in each lane.
template <class S>
struct Timing {
  S delay{};  ///< share of the duration after which the posture begins to change
  S bow{};    ///< share of the path's length, forwards where > 0
  S skew{};   ///< shift of the bow towards the start (> 0) or the end, -1..1
  S sway{};   ///< share of the path's length, outwards where > 0

  /// Whether the paths leave their straight lines.
  [[nodiscard]] bool bends_paths() const { return bow != S{} || sway != S{}; }

  friend bool operator==(const Timing&, const Timing&) = default;
};

/// The name and ranges of a member of Timing.
struct TimingNumber {
  std::string_view name;      ///< "bow"
  double low;                 ///< smallest allowed value
  double high;                ///< largest allowed value
  double searched_low;        ///< smallest value in searches
  double searched_high;       ///< largest value in searches
  bool searched;              ///< searched by default; otherwise it stays 0
  std::string_view sentence;  ///< its effect, one sentence
};

inline constexpr double kDelayMax = 0.5;  ///< largest delay, share of the duration
/// Largest bow and sway, as a share of the path's length: bow forwards (backwards if < 0), sway
/// outwards (inwards if < 0). People's reaches leave their lines by 0.1 to 0.2.
inline constexpr double kBowMax = 0.3;
/// Largest bow and sway in searches, as a share of the path's length.
inline constexpr double kBowSearched = 0.2;

/// The members of Timing; all code that reads, writes, searches or shows a timing uses this table.
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
/// Number of members of Timing.
inline constexpr std::size_t kTimings = kTimingNumbers.size();
/// Pointers to the members of Timing, in the order of kTimingNumbers.
template <class S>
inline constexpr std::array<S Timing<S>::*, kTimings> kTimingMembers{
    &Timing<S>::delay, &Timing<S>::bow, &Timing<S>::skew, &Timing<S>::sway};

/// The smallest weight of a dof that a user may set. Only ratios of weights matter; with wider
/// ratios the relative damping would keep effectors from their goals.
inline constexpr double kWeightMin = 1e-3;
/// The largest weight of a dof that a user may set.
inline constexpr double kWeightMax = 1e3;
/// Largest magnitude of a weight's logarithm in searches, so that weights are e^-5.5 .. e^5.5. A
/// weight ratio of 15, as in the paper's code, is too narrow for natural postures; wider ranges
/// gain nothing.
inline constexpr double kLogWeightRange = 5.5;
inline constexpr double kPostureMax = 3.2;  ///< rad, largest magnitude of a posture mode
/// Number of steps of a limb's contraction; at the last one the limb is shortest.
inline constexpr int kContractionMax = 15;

/// Largest force of a supporting hand, as a share of body weight: a weak man (5th percentile)
/// pushes 187 N with his left arm straight (MIL-STD-1472, arm strength; quoted from memory), a
/// quarter of the weight of 73 kg.
inline constexpr double kSupportMost = 0.25;
/// Smallest value of a support parameter; every value below 0 leaves the hand free.
inline constexpr double kSupportLeast = -0.05;

/// The parameter values that generate a motion: found by a search, edited by a person. The
/// ParameterList gives name, meaning and range of each.
struct Parameters {
  std::vector<double> values{};  ///< one for each parameter, in the list's order
  /// One for each parameter; for weights: the dof keeps its start angle.
  std::vector<bool> locked{};
  /// Whether the motion follows a posture. If not, as in the paper, modes and timing are 0. Weights
  /// alone and a posture of 0 give different motions.
  bool posed = false;
  /// Whether the motion is computed as the mirror image of the opposite side's motion: a body on
  /// one foot and its mirror image do not move alike to the last digit otherwise.
  bool reflected = false;

  friend bool operator==(const Parameters&, const Parameters&) = default;
};

/// Parameter values of which a search keeps some fixed.
struct FixedParameters {
  Parameters values;      ///< values of the list's parameters
  std::vector<bool> set;  ///< one for each parameter: whether it is fixed
};

/// The meaning of a parameter's value.
enum class ParameterKind {
  weight,       ///< weight of a dof in weighted IK; a lock keeps the dof at its start angle
  contraction,  ///< contraction of limbs at the end, 0..kContractionMax steps of their range
  swivel,       ///< rad, final turn of the elbow from its place on the arm's path, outwards > 0
  final_angle,  ///< rad, final angle of a dof
  mode,         ///< rad, the value of a posture mode
  timing,       ///< a number of Timing
  support,      ///< force of a resting hand, share of body weight
};

/// The name, meaning and range of one parameter.
struct ParameterInfo {
  std::string name;  ///< "right_hip.flexion", "legs", "right_arm", "squat"
  ParameterKind kind = ParameterKind::weight;  ///< meaning of the value
  /// Indices that the parameter applies to. In the layer's body: the dof of a weight or final
  /// angle, the dofs that turn the elbow, or the limbs of a contraction. For a posture: the index
  /// of the mode or timing.
  std::vector<int> applies_to{};
  double low = 0.0;             ///< smallest allowed value
  double high = 0.0;            ///< largest allowed value
  double shown_low = 0.0;       ///< smallest sensible value
  double shown_high = 0.0;      ///< largest sensible value
  double start = 0.0;           ///< value before a search
  std::string group{};          ///< "right_leg", "arms", "trunk", "posture", "path"
  std::string_view sentence{};  ///< its effect, one sentence
  std::string layer{};          ///< name of the layer; empty for the first

  /// Whether the parameter belongs to the posture, and is unused in motions without one.
  [[nodiscard]] bool of_posture() const {
    return kind == ParameterKind::mode || kind == ParameterKind::timing;
  }
  /// The name, after the layer's for lower layers: "right_hip.flexion",
  /// "right_arm.right_elbow.flexion", "squat".
  [[nodiscard]] std::string subject() const;
  /// The name as in assignments, with kind and unit: "right_hip.flexion.weight",
  /// "legs.contraction", "squat_deg". Angles take a unit, "_deg" or "_rad".
  [[nodiscard]] std::string spelled(std::string_view unit = "_deg") const;
};

/// All parameters of a preset's motions: those of its first layer, then those of the layers below.
struct ParameterList {
  std::vector<ParameterInfo> all;  ///< in the order of Parameters::values

  [[nodiscard]] std::size_t size() const { return all.size(); }  ///< number of parameters
  /// All names as in assignments, angles in radians.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Index of the parameter with a name as in assignments, with "_deg" or "_rad" for angles;
  /// nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view spelled) const;
  /// Whether the motions can follow a posture: those that move the whole body at once.
  [[nodiscard]] bool has_posture() const;
  /// The values of all parameters of one kind, in the list's order.
  [[nodiscard]] std::vector<double> of_kind(ParameterKind kind, const Parameters& values) const;
  /// The initial values: weights of 1, no contraction, posture or swivel, final angles as at the
  /// start.
  [[nodiscard]] Parameters start() const;
  /// Checks values: fails if their number or flags do not fit the list, or if one is out of range.
  [[nodiscard]] Result<void> check(const Parameters& values) const;
};

/// FixedParameters without any fixed value.
[[nodiscard]] FixedParameters no_fixed_parameters(const ParameterList& list);

/// Equal weights for all dofs of the whole body and no posture: the plain pseudo-inverse.
[[nodiscard]] Parameters uniform_parameters(const BodyModel& body);

/// Decodes the paper's genes (section 3.2), one per dof: 1..15 is the weight, 0 locks the dof.
[[nodiscard]] Parameters decode_paper_genes(const BodyModel& body,
                                            std::span<const std::uint16_t> genes);

}  // namespace shigusa
