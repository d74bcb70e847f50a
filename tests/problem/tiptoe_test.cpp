// SPDX-License-Identifier: MIT
#include "problem/tiptoe.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(Tiptoe, IsPoisedNearTheMiddleOfItsToesAndNotAtTheirEdge) {
  const PosedBody posed = human_body({.heels = true});
  const ReachProblem problem = reach_with(posed, "right_hand", {-0.2, 1.0, 0.4});
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  EXPECT_FALSE(Tiptoe(problem, angles).lifted());
  for (const char* toes : {"left_toes.flexion", "right_toes.flexion"}) {
    angles[static_cast<std::size_t>(posed.body.find_dof(toes).value())] = radians(20.0);
  }
  const Tiptoe tiptoe(problem, angles);
  ASSERT_TRUE(tiptoe.lifted());
  const Vec3d beyond{0, 1, 5};
  const Vec3d to_middle = tiptoe.offset_from(beyond);
  const Vec3d middle = beyond + to_middle;
  EXPECT_EQ(to_middle.y, 0.0);
  EXPECT_EQ(tiptoe.offset_from(middle), Vec3d{});
  for (const SupportEdge& edge : support_edges(posed, posed.home, 3)) {
    const double inside = edge.offset + edge.x * middle.x + edge.z * middle.z;
    const Vec3d out = Vec3d{-edge.x, 0, -edge.z} * (inside - 0.01);
    EXPECT_LT(norm(tiptoe.offset_from(middle + out) + out), 1e-12) << edge.x << ' ' << edge.z;
  }
}

}  // namespace
}  // namespace shigusa
