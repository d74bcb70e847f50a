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

/// The meanings of the paper's count of 14 parameters for the whole body (rule R2).
enum class LayerReading {
  shared_contractions,  ///< 6 weights a half, and 2 contractions: of the arms, of the legs
  contraction_a_limb,   ///< hips do not rotate: 5 weights a half, and 4 contractions
};

/// The words of LayerReading.
template <>
inline constexpr std::array kEnumWords<LayerReading>{
    EnumWord{LayerReading::shared_contractions, "shared_contractions"},
    EnumWord{LayerReading::contraction_a_limb, "contraction_a_limb"},
};

/// The layers that a body gets: the paper's two, or those of the preset human.
enum class LayerStack {
  paper,  ///< the trunk with limbs of variable length, then the arms
  human,  ///< the same, then the swivel of arms and what no goal moves
};

/// How an arm's genome is found among the 65,536 that there are. Two that lock two freedoms or more
/// are left out, as three are needed to place a hand, and so are multiples of another's weights.
enum class LimbSearch {
  /// The best of the codes 0, 1, 3, 7 and 15 in all combinations, then of all codes next to it,
  /// again and
  /// again until none is better: some 600 motions.
  ladder,
  /// The best of all.
  enumeration,
};

/// Keeps libraries between runs. Either function may be empty. The bytes that `load` gives are not
/// trusted.
struct LimbStore {
  /// gives the bytes of that name, or nothing
  std::function<std::optional<std::string>(const std::string& name)> load;
  /// keeps bytes by a name
  std::function<void(const std::string& name, std::string_view bytes)> save;
};

/// Searches that one arm which passes through the body takes at most (rule R11); after the last one
/// the collision is left.
inline constexpr int kCollisionRounds = 3;

/// The settings of layered presets beside those of every task.
struct LayeredSettings {
  /// How the arms' layers are searched; threads and SIMD set are the task's.
  LimbSearch limb_search = LimbSearch::ladder;
  /// Where the arms' libraries are kept; without it they are searched anew, with the same result.
  LimbStore store{};
  int feedback_rounds = kCollisionRounds;  ///< 0: none
};

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
/// A limb's range has this many parts; all of them make it shortest.
inline constexpr int kContractionMax = 15;

/// The most that a hand presses with, as a share of the body's weight: a weak man (5th percentile)
/// pushes 187 N with his left arm straight (MIL-STD-1472, arm strength; quoted from memory), a
/// quarter of the weight of 73 kg.
inline constexpr double kSupportMost = 0.25;
/// The least value of a support's parameter; all below 0 leave the hand free.
inline constexpr double kSupportLeast = -0.05;

/// The values of the few readable numbers that a motion is generated from: a search finds them, a
/// person edits them. The plan's ParameterList says of each its name, meaning and range.
struct Parameters {
  std::vector<double> values{};  ///< (the list's) in its order
  std::vector<bool> locked{};    ///< (the list's) of weights: the freedom keeps its start angle
  /// The motion is drawn to a posture: weights alone, as in the paper, and a posture of 0 are
  /// different motions. If not, the posture's numbers are 0.
  bool posed = false;
  /// The motion is the mirror image of the one that the other side's values make, as a body that
  /// stands on one foot and its image do not move alike to the last digit.
  bool reflected = false;

  friend bool operator==(const Parameters&, const Parameters&) = default;
};

/// Values of which a search leaves some as a person has set them.
struct FixedParameters {
  Parameters values;      ///< of the list
  std::vector<bool> set;  ///< (the list's) which are set
};

/// The meaning of a parameter's number.
enum class ParameterKind {
  weight,       ///< of one freedom in weighted IK; a lock keeps the freedom at its start angle
  contraction,  ///< how much shorter limbs end: 0..kContractionMax parts of their range
  swivel,       ///< rad, how far the elbow ends from where the arm's path takes it, outwards
  final_angle,  ///< rad, that one freedom ends at
  mode,         ///< rad, the value of a posture mode
  timing,       ///< a number of Timing
  support,      ///< share of the body's weight that a resting hand presses with
};

/// One number that a search or a person sets.
struct ParameterInfo {
  std::string name;  ///< "right_hip.flexion", "legs", "right_arm", "squat"
  ParameterKind kind = ParameterKind::weight;  ///< its meaning
  /// Of the layer's body: the freedom with that weight or final angle; the freedoms that turn the
  /// elbow; limbs that share a contraction. Of the posture: the number of the mode or timing.
  std::vector<int> applies_to{};
  double low = 0.0;             ///< the least that is allowed
  double high = 0.0;            ///< the most that is allowed
  double shown_low = 0.0;       ///< the least that makes sense
  double shown_high = 0.0;      ///< the most that makes sense
  double start = 0.0;           ///< before any search
  std::string group{};          ///< "right_leg", "arms", "trunk", "posture", "path"
  std::string_view sentence{};  ///< its effect
  std::string layer{};          ///< name of its layer, where that is below the first

  /// Whether motions that have no posture do without it.
  [[nodiscard]] bool of_posture() const {
    return kind == ParameterKind::mode || kind == ParameterKind::timing;
  }
  /// "right_hip.flexion", "right_arm.right_elbow.flexion" of the layer below, "squat".
  [[nodiscard]] std::string subject() const;
  /// As people write and read it: "right_hip.flexion.weight", "legs.contraction", "squat_deg". An
  /// angle takes a unit, "_deg" or "_rad".
  [[nodiscard]] std::string spelled(std::string_view unit = "_deg") const;
};

/// All parameters of a plan: of its first layer, then of those below. Whatever assigns, fixes,
/// mirrors, stores, shows or searches parameters goes by this list.
struct ParameterList {
  std::vector<ParameterInfo> all;  ///< in the order of Parameters::values

  [[nodiscard]] std::size_t size() const { return all.size(); }  ///< how many there are
  /// As people write them, angles in radians.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Index of the parameter that is spelled so, its angle in degrees or radians.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view spelled) const;
  /// Whether motions may have a posture: those that move the whole body at once.
  [[nodiscard]] bool has_posture() const;
  /// The values of one kind.
  [[nodiscard]] std::vector<double> of_kind(ParameterKind kind, const Parameters& values) const;
  /// The values that a plan begins with: weights of 1, no contraction, no posture, no swivel, and
  /// final angles as at the start.
  [[nodiscard]] Parameters start() const;
  /// Fails on values of another list, and on those outside their range.
  [[nodiscard]] Result<void> check(const Parameters& values) const;
};

/// Values of which none is fixed.
[[nodiscard]] FixedParameters no_fixed_parameters(const ParameterList& list);

/// All freedoms of the whole body alike, and no posture: the plain pseudo-inverse.
[[nodiscard]] Parameters uniform_parameters(const BodyModel& body);

/// The paper's code (section 3.2): one gene per freedom, 1..15 is the weight, 0 locks it.
[[nodiscard]] Parameters decode_paper_genes(const BodyModel& body,
                                            std::span<const std::uint16_t> genes);

/// 1 / w of each of the paper's genes, 0 where locked, in single precision: what BatchRollout
/// takes, (motions × dofs) of genomes one after the other.
[[nodiscard]] std::vector<float> inverse_weights_of_genes(std::span<const std::uint16_t> genes);

/// 1 / weight, or 0 where locked: (dofs), what weighted IK computes with; of values of the whole
/// body.
[[nodiscard]] std::vector<double> inverse_weights(const BodyModel& body,
                                                  const Parameters& parameters);

/// (dofs, rad) the change of posture that the modes' values add up to; PreconditionError where
/// there are not as many values as the body has modes.
[[nodiscard]] std::vector<double> posture_change(const BodyModel& body,
                                                 std::span<const double> modes);

}  // namespace shigusa
