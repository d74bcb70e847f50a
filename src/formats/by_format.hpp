// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/formats.hpp>
#include <utility>

namespace shigusa {

// Table of a function family by format: one function for each format with the property, null for
// the others. `family` returns the function of a format given as a template argument. An undefined
// function is a linker error.
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
