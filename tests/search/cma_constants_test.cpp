// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "search/cma_run.hpp"

namespace shigusa {
namespace {

// Computed by a script from table 1 and equations 49 to 58 of Hansen's tutorial: few genes and many
// points, where the step's damping grows, and as many as usual.
TEST(CmaConstants, AreThoseOfTheTutorial) {
  struct Row {
    int genes, population;
    double mu_eff, c_sigma, d_sigma, c_path, c_one, c_mu, expected_norm, first, last;
  };
  for (const Row& row : {
           Row{2, 40, 11.3094820889323, 0.72691745316912, 3.4344740769547, 0.557771803619671,
               0.0900921918803285, 0.706560705642853, 1.254272742819, 0.167124701498081,
               -0.0126958071279723},
           Row{10, 10, 3.1672992814107, 0.284428587946367, 1.28442858794637, 0.294990383035622,
               0.0152838245247517, 0.0235517766504175, 3.08472656516901, 0.456272646903406,
               -0.549749917697385},
           Row{3, 6, 2.02861146461006, 0.401711790194148, 1.40171179019415, 0.559862978600505,
               0.0974724826506679, 0.0570920547095023, 1.59687753025861, 0.637042571241217,
               -1.15598177815892},
       }) {
    const CmaConstants found(row.genes, row.population);
    constexpr double kRounding = 1e-12;  // of some ten operations, and of 15 digits
    EXPECT_NEAR(found.mu_eff, row.mu_eff, kRounding * row.mu_eff) << row.genes;
    EXPECT_NEAR(found.c_sigma, row.c_sigma, kRounding) << row.genes;
    EXPECT_NEAR(found.d_sigma, row.d_sigma, kRounding) << row.genes;
    EXPECT_NEAR(found.c_path, row.c_path, kRounding) << row.genes;
    EXPECT_NEAR(found.c_one, row.c_one, kRounding) << row.genes;
    EXPECT_NEAR(found.c_mu, row.c_mu, kRounding) << row.genes;
    EXPECT_NEAR(found.expected_norm, row.expected_norm, kRounding) << row.genes;
    EXPECT_NEAR(found.weights.front(), row.first, kRounding) << row.genes;
    EXPECT_NEAR(found.weights.back(), row.last, kRounding) << row.genes;
  }
}

}  // namespace
}  // namespace shigusa
