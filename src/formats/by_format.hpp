// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/formats.hpp>
#include <utility>

namespace shigusa {

// The functions of a family that has one for each format with the property: by format, null for the
// others. `family` gives the function of a format that it is called with as a template argument. A
// format whose function nobody has defined is an error of the linker.
template <class Function, bool FormatInfo::*property, class Family>
constexpr std::array<Function*, kFileFormats.size()> by_format(Family family) {
  const auto of = [family]<std::size_t i>() -> Function* {
    if constexpr (kFileFormats[i].*property) {
      return family.template operator()<kFileFormats[i].format>();
    } else {
      return nullptr;
    }
  };
  return [of]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<Function*, kFileFormats.size()>{of.template operator()<i>()...};
  }
  (std::make_index_sequence<kFileFormats.size()>{});
}

}  // namespace shigusa
