// SPDX-License-Identifier: MIT
// Pieces of work, drawn at random: places and grips are exact, feet stay, velocities are
// continuous, limbs stay out of each other and of things. scripts/check_work draws more of them.
#include "support/pieces.hpp"

#include <gtest/gtest.h>

namespace shigusa {
namespace {

TEST(Pieces, DrawnWorkIsExact) {
  testing_support::PiecesTally tally;
  for (int k = 0; k < 30; ++k) tally.add(k);
  EXPECT_TRUE(tally.holds()) << tally.table();
}

}  // namespace
}  // namespace shigusa
