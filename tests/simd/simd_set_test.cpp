// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <shigusa/run.hpp>

namespace shigusa {
namespace {

constexpr SimdSet kAll[] = {SimdSet::scalar, SimdSet::lanes_4, SimdSet::avx2, SimdSet::avx512};

TEST(SimdSet, IsFoundByItsName) {
  std::set<std::string_view> names;
  for (const SimdSet set : kAll) {
    EXPECT_EQ(find_simd(simd_name(set)), set);
    names.insert(simd_name(set));
  }
  EXPECT_EQ(names.size(), std::size(kAll));
}

TEST(SimdSet, NamesAreThoseOfTheCommandLine) {
  EXPECT_EQ(simd_name(SimdSet::scalar), "scalar");
  EXPECT_EQ(simd_name(SimdSet::avx2), "avx2");
  EXPECT_EQ(simd_name(SimdSet::avx512), "avx512");
#if defined(__x86_64__)
  EXPECT_EQ(simd_name(SimdSet::lanes_4), "sse2");
#else
  EXPECT_EQ(simd_name(SimdSet::lanes_4), "simd128");
#endif
}

TEST(SimdSet, UnknownNamesAreNotFound) {
  for (const char* name : {"", "AVX2", "avx", "sse4", "scalar "}) {
    EXPECT_EQ(find_simd(name), std::nullopt) << name;
  }
}

TEST(SimdSet, LanesDoubleTwiceAndThenOnce) {
  EXPECT_EQ(simd_lanes(SimdSet::scalar), 1);
  EXPECT_EQ(simd_lanes(SimdSet::lanes_4), 4);
  EXPECT_EQ(simd_lanes(SimdSet::avx2), 8);
  EXPECT_EQ(simd_lanes(SimdSet::avx512), 16);
}

TEST(SimdSet, EveryMachineRunsTheFirstTwo) {
  const auto usable = usable_simd_sets();
  ASSERT_GE(usable.size(), 2U);
  EXPECT_EQ(usable[0], SimdSet::scalar);
  EXPECT_EQ(usable[1], SimdSet::lanes_4);
}

TEST(SimdSet, UsableOnesStandNarrowestFirstAndTheWidestIsTheLast) {
  const auto usable = usable_simd_sets();
  EXPECT_TRUE(std::is_sorted(usable.begin(), usable.end(),
                             [](SimdSet a, SimdSet b) { return simd_lanes(a) < simd_lanes(b); }));
  EXPECT_EQ(widest_simd_set(), usable.back());
}

}  // namespace
}  // namespace shigusa
