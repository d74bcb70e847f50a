// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <shigusa/run.hpp>
#include <vector>

#include "statistics.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// SplitMix64's finaliser, implemented a second time.
std::uint64_t finaliser(std::uint64_t z) {
  z ^= z >> 30;
  z *= 13787848793156543929ULL;
  z ^= z >> 27;
  z *= 10723151780598845931ULL;
  return z ^ (z >> 31);
}

TEST(Random, KthNumberIsAFunctionOfSeedStreamAndK) {
  constexpr std::uint64_t golden = 11400714819323198485ULL;  // 2^64 over the golden ratio
  for (const std::uint64_t seed : {0ULL, 1ULL, 42ULL, ~0ULL}) {
    for (const std::uint64_t stream : {0ULL, 1ULL, 7ULL}) {
      const std::uint64_t key =
          finaliser(seed + golden) ^ finaliser(stream * golden + 7640891576956012809ULL);
      Random random(seed, stream);
      for (std::uint64_t k = 1; k <= 100; ++k) {
        EXPECT_EQ(random.next(), finaliser(key + golden * k));
        EXPECT_EQ(random.counter(), k);
      }
    }
  }
}

TEST(Random, FirstNumbersNeverChange) {
  Random random(42);
  EXPECT_EQ(random.next(), 7023634494418463498ULL);
  EXPECT_EQ(random.next(), 4913011415402869401ULL);
  EXPECT_EQ(Random(42, 1).next(), 2910405140954247471ULL);
}

TEST(Random, EachBitIsOneHalfOfTheTime) {
  constexpr int n = 100000;
  std::vector<int> ones(64);
  Random random(1);
  for (int i = 0; i < n; ++i) {
    std::uint64_t bits = random.next();
    for (auto& count : ones) {
      count += static_cast<int>(bits & 1U);
      bits >>= 1;
    }
  }
  for (const int count : ones) EXPECT_NEAR(count, 0.5 * n, binomial_tolerance(n, 0.5));
}

TEST(Random, UniformFillsEqualBinsEqually) {
  std::vector<int> counts(100);
  Random random(2);
  for (int i = 0; i < 200000; ++i) ++counts[static_cast<std::size_t>(random.uniform() * 100.0)];
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(99));
  // nor is it more even than chance: 3.7 standard deviations below the mean
  EXPECT_GT(chi_square_uniform(counts), 99.0 - 3.7 * std::sqrt(2.0 * 99.0));
}

TEST(Random, UniformIsBelowOneAndAMultipleOfTwoToMinus53) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    const double scaled = u * 0x1.0p53;
    ASSERT_EQ(scaled, std::floor(scaled));
  }
}

TEST(Random, UniformBetweenStaysBetween) {
  Random random(4);
  double sum = 0.0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform(-3.0, 5.0);
    ASSERT_GE(u, -3.0);
    ASSERT_LE(u, 5.0);
    sum += u;
  }
  // the mean of n has standard deviation 8 / √(12 n)
  EXPECT_NEAR(sum / n, 1.0, 5.0 * 8.0 / std::sqrt(12.0 * n));
}

TEST(Random, BelowFillsEachValueEqually) {
  for (const std::uint32_t count : {2U, 3U, 10U, 31U}) {
    std::vector<int> counts(count);
    Random random(5, count);
    for (int i = 0; i < 100000; ++i) ++counts.at(random.below(count));
    EXPECT_LT(chi_square_uniform(counts), chi_square_limit(count - 1)) << count;
  }
}

TEST(Random, BelowOneIsZero) {
  Random random(6);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0U);
}

TEST(Random, BelowTheLargestCountUsesTheWholeRange) {
  constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();
  std::vector<int> sixteenths(16);
  Random random(7);
  for (int i = 0; i < 16000; ++i) {
    const std::uint32_t value = random.below(largest);
    ASSERT_LT(value, largest);
    ++sixteenths[value >> 28];
  }
  EXPECT_LT(chi_square_uniform(sixteenths), chi_square_limit(15));
}

TEST(Random, ChanceIsNeverAtZeroAndAlwaysAtOne) {
  Random random(8);
  for (int i = 0; i < 100000; ++i) {
    ASSERT_FALSE(random.chance(0.0));
    ASSERT_TRUE(random.chance(1.0));
  }
}

TEST(Random, ChanceComesAtItsRate) {
  constexpr int n = 100000;
  int hits = 0;
  Random random(9);
  for (int i = 0; i < n; ++i) hits += random.chance(0.1) ? 1 : 0;
  EXPECT_NEAR(hits, 0.1 * n, binomial_tolerance(n, 0.1));
}

double correlation(Random a, Random b, int n) {
  double sum = 0.0;
  // uniform numbers less 1/2 have variance 1/12
  for (int i = 0; i < n; ++i) sum += (a.uniform() - 0.5) * (b.uniform() - 0.5) * 12.0;
  return sum / n;
}

TEST(Random, StreamsOfOneSeedAreUncorrelated) {
  constexpr int n = 10000;
  for (std::uint64_t i = 0; i < 20; ++i) {
    for (std::uint64_t j = 0; j < i; ++j) {
      // the correlation of independent samples has standard deviation 1 / √n
      EXPECT_NEAR(correlation(Random(1, i), Random(1, j), n), 0.0, 5.0 / std::sqrt(n));
      EXPECT_NEAR(correlation(Random(i, 1), Random(j, 1), n), 0.0, 5.0 / std::sqrt(n));
      EXPECT_NEAR(correlation(Random(i, j), Random(j, i), n), 0.0, 5.0 / std::sqrt(n));
    }
  }
}

TEST(Random, NeighbouringStreamsShareNoNumbers) {
  // of 64-bit numbers drawn independently, 100 000 would hold an equal pair with probability 3e-10
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (std::uint64_t stream = 0; stream < 10; ++stream) {
      Random random(seed, stream);
      for (int i = 0; i < 1000; ++i) EXPECT_TRUE(seen.insert(random.next()).second);
    }
  }
}

TEST(Random, FirstNumbersOfConsecutiveStreamsAreUniform) {
  std::vector<int> by_stream(64);
  std::vector<int> by_seed(64);
  for (std::uint64_t i = 0; i < 64000; ++i) {
    ++by_stream[static_cast<std::size_t>(Random(0, i).uniform() * 64.0)];
    ++by_seed[static_cast<std::size_t>(Random(i, 0).uniform() * 64.0)];
  }
  EXPECT_LT(chi_square_uniform(by_stream), chi_square_limit(63));
  EXPECT_LT(chi_square_uniform(by_seed), chi_square_limit(63));
}

}  // namespace
}  // namespace shigusa
