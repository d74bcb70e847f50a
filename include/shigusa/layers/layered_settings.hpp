// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <shigusa/core/enum_words.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// What the paper's count of 14 parameters for the whole body means (rule R2).
enum class LayerReading {
  shared_contractions,  // 6 weights a half, and 2 contractions: of the arms, of the legs
  contraction_a_limb,   // hips do not rotate: 5 weights a half, and 4 contractions
};

template <>
inline constexpr std::array kEnumWords<LayerReading>{
    EnumWord{LayerReading::shared_contractions, "shared_contractions"},
    EnumWord{LayerReading::contraction_a_limb, "contraction_a_limb"},
};

// The layers that a body gets: the paper's two, or those of the preset human.
enum class LayerStack { paper, human };

// How an arm's genome is found among the 65,536 that there are. Two that lock two freedoms or more
// are left out, as three are needed to place a hand, and so are multiples of another's weights.
enum class LimbSearch {
  // The best of the codes kLimbLadder in all combinations, then of all codes next to it, again and
  // again until none is better: some 600 motions.
  ladder,
  // The best of all.
  enumeration,
};

// Where libraries are kept between runs. Either may be empty. What `load` gives is not trusted.
struct LimbStore {
  std::function<std::optional<std::string>(const std::string& name)> load;
  std::function<void(const std::string& name, std::string_view bytes)> save;
};

// Searches that one arm which passes through the body takes at most (rule R11); after the last one
// the collision is left.
inline constexpr int kCollisionRounds = 3;

// What layered presets are asked beside what every task says.
struct LayeredSettings {
  LayerReading reading = LayerReading::shared_contractions;
  // How the arms' layers are searched; threads and SIMD set are the task's.
  LimbSearch limb_search = LimbSearch::ladder;
  // Where the arms' libraries are kept; without it they are searched anew, with the same result.
  LimbStore store{};
  int feedback_rounds = kCollisionRounds;  // 0: none
};

}  // namespace shigusa
