// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <type_traits>

// The lane counts of packs in use, for typed tests. A program that instantiates those of 8 and 16
// must not link the library's scorers of the same packs, which pass them in wide registers: this
// one uses nothing that links BatchRollout.
namespace shigusa::testing_support {

template <int N>
using LaneCount = std::integral_constant<int, N>;
using LaneCounts = testing::Types<LaneCount<1>, LaneCount<4>, LaneCount<8>, LaneCount<16>>;

}  // namespace shigusa::testing_support
