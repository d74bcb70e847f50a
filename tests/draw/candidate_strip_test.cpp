// SPDX-License-Identifier: MIT
#include "draw/candidate_strip.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "human/at_ease.hpp"

namespace shigusa {
namespace {

TEST(ThingsAround, OfWhoStandsAreTheObstaclesAlone) {
  Task task(human_body());
  EXPECT_TRUE(things_around(task).empty());
  task.obstacles = {{.name = "post", .position = {0.1, 0.5, 0.7}, .size = {0.2, 1.0, 0.4}}};
  const auto things = things_around(task);
  ASSERT_EQ(things.size(), 1U);
  ASSERT_EQ(things[0].corners.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3d own = things[0].corners[k] - task.obstacles[0].position;
    EXPECT_NEAR(own.x, (k & 1) != 0 ? 0.1 : -0.1, 1e-12);
    EXPECT_NEAR(own.y, (k & 2) != 0 ? 0.5 : -0.5, 1e-12);
    EXPECT_NEAR(own.z, (k & 4) != 0 ? 0.2 : -0.2, 1e-12);
  }
}

TEST(ThingsAround, OfWhoSitsIsASeatOfItsHeightBelowTheThighs) {
  const Landmarks person = seated(standing_landmarks(1.7, kStandingToeOut), 1.7, 0.42);
  const Task task(build_human(
      person,
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70.0, .sits = true}));
  const auto things = things_around(task);
  ASSERT_EQ(things.size(), 1U);
  const Vec3d low = things[0].corners.front();
  const Vec3d high = things[0].corners.back();
  EXPECT_EQ(low.y, 0.0);
  EXPECT_NEAR(high.y, 0.42, 0.02);
  for (const Vec3d& hip : {person.left_leg.hip, person.right_leg.hip}) {
    EXPECT_TRUE(low.x < hip.x && hip.x < high.x);
    EXPECT_TRUE(low.z < hip.z && hip.z < high.z);
  }
}

}  // namespace
}  // namespace shigusa
