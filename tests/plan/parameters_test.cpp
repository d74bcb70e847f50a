// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/parameters.hpp>

#include "core/check.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(Parameters, UniformOnesWeighAllFreedomsAlike) {
  const Parameters parameters = uniform_parameters(half_body());
  ASSERT_EQ(parameters.joints.size(), 9u);
  for (const JointWeight& joint : parameters.joints) {
    EXPECT_EQ(joint.weight, 1.0);
    EXPECT_FALSE(joint.locked);
  }
}

TEST(Parameters, PapersGeneIsTheWeightAndZeroLocks) {
  const std::vector<std::uint16_t> genes{0, 1, 7, 15};
  const Parameters parameters = decode_paper_genes(genes);
  ASSERT_EQ(parameters.joints.size(), 4u);
  EXPECT_TRUE(parameters.joints[0].locked);
  EXPECT_EQ(parameters.joints[1], (JointWeight{1.0, false}));
  EXPECT_EQ(parameters.joints[2], (JointWeight{7.0, false}));
  EXPECT_EQ(parameters.joints[3], (JointWeight{15.0, false}));
}

TEST(PaperGenes, InverseWeightsAreThoseOfTheDecodedParametersRounded) {
  std::vector<std::uint16_t> genes;
  for (std::uint16_t gene = 0; gene < 16; ++gene) genes.push_back(gene);
  const std::vector<double> exact = inverse_weights(decode_paper_genes(genes));
  const std::vector<float> rounded = inverse_weights_of_genes(genes);
  ASSERT_EQ(rounded.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(rounded[i], static_cast<float>(exact[i])) << i;
}

TEST(InverseWeights, AreZeroWhereLocked) {
  const Parameters parameters{{{4.0, false}, {4.0, true}, {0.5, false}}};
  EXPECT_EQ(inverse_weights(parameters), (std::vector<double>{0.25, 0.0, 2.0}));
}

TEST(InverseWeights, OfNoPositiveWeightAreRefused) {
  EXPECT_THROW((void)inverse_weights({{{0.0, false}}}), PreconditionError);
  EXPECT_THROW((void)inverse_weights({{{-1.0, false}}}), PreconditionError);
  EXPECT_THROW((void)inverse_weights({{{0.0 / 0.0, false}}}), PreconditionError);
}

}  // namespace
}  // namespace shigusa
