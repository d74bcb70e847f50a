// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <shigusa/words.hpp>
#include <string>
#include <string_view>

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

}  // namespace shigusa
