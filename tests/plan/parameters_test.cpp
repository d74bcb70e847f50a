// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/parameters.hpp>

#include "core/check.hpp"
#include "plan/held_input.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The freedoms of the half body are nine.
constexpr std::size_t kDofs = 9;

TEST(Parameters, UniformOnesWeighAllFreedomsAlikeAndHaveNoPosture) {
  const Parameters parameters = uniform_parameters(half_body());
  EXPECT_FALSE(parameters.posed);
  ASSERT_GT(parameters.values.size(), kDofs);
  for (std::size_t i = 0; i < parameters.values.size(); ++i) {
    EXPECT_EQ(parameters.values[i], i < kDofs ? 1.0 : 0.0);
    EXPECT_FALSE(parameters.locked[i]);
  }
}

TEST(Parameters, PapersGeneIsTheWeightAndZeroLocks) {
  const std::vector<std::uint16_t> genes{0, 1, 7, 15, 3, 2, 9, 8, 1};
  const Parameters parameters = decode_paper_genes(half_body(), genes);
  for (std::size_t d = 0; d < kDofs; ++d) {
    EXPECT_EQ(parameters.locked[d], genes[d] == 0);
    EXPECT_EQ(parameters.values[d], d == 0 ? 1.0 : genes[d]);
  }
}

TEST(PaperGenes, InverseWeightsAreThoseOfTheDecodedParametersRounded) {
  for (std::uint16_t gene = 0; gene < 16; ++gene) {
    const std::vector<std::uint16_t> genes(kDofs, gene);
    const auto exact = inverse_weights(half_body(), decode_paper_genes(half_body(), genes));
    const std::vector<float> rounded = inverse_weights_of_genes(genes);
    ASSERT_EQ(rounded.size(), kDofs);
    EXPECT_EQ(rounded[0], static_cast<float>(exact[0])) << gene;
  }
}

TEST(InverseWeights, AreZeroWhereLocked) {
  Parameters parameters = uniform_parameters(half_body());
  parameters.values[0] = parameters.values[1] = 4.0;
  parameters.values[2] = 0.5;
  parameters.locked[1] = true;
  EXPECT_EQ(inverse_weights(half_body(), parameters),
            (std::vector<double>{0.25, 0, 2, 1, 1, 1, 1, 1, 1}));
}

TEST(InverseWeights, OfNoPositiveWeightAreRefused) {
  for (const double weight : {0.0, -1.0, 0.0 / 0.0}) {
    Parameters parameters = uniform_parameters(half_body());
    parameters.values[3] = weight;
    EXPECT_THROW((void)inverse_weights(half_body(), parameters), PreconditionError);
  }
}

}  // namespace
}  // namespace shigusa
