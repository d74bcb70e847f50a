// SPDX-License-Identifier: MIT
// Places on obstacles for resting hands.
#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <shigusa/request.hpp>

#include "kinematics/forward_kinematics.hpp"
#include "problem/task_supports.hpp"

namespace shigusa {
namespace {

class RestingHand : public testing::Test {
 protected:
  RestingHand() {
    const Effector& left = task_.body.effector(task_.body.find_effector("left_hand").value());
    thickness_ = half_thickness(task_.body, left);
    hand_ = home_kinematics(task_).point(left.link, left.point);
  }

  // Where the left hand begins to rest on it.
  HandSupport rests_on(const Obstacle& obstacle) {
    task_.obstacles = {obstacle};
    task_.supports = {{"left_hand", obstacle.name}};
    return make_supports(task_, home_kinematics(task_)).value()[0];
  }

  static void expect_near(const Vec3d& found, const Vec3d& wanted) {
    EXPECT_LT(norm(found - wanted), 1e-12) << found.x << ' ' << found.y << ' ' << found.z;
  }

  Task task_{human_body()};
  double thickness_ = 0.0;  // m, half of the hand's
  Vec3d hand_{};            // m, world
};

TEST_F(RestingHand, ThatIsWithinABoxIsPutOnTopOfIt) {
  const Vec3d size{0.3, 0.4, 0.5};
  const auto expect_up = [&](const Vec3d& about, double angle_deg, double height) {
    const SinCos<double> half = sin_cos(0.5 * radians(angle_deg));
    const Vec3d v = about * half.sin;
    const Vec3d middle = hand_ + Vec3d{0.02, 0.03, -0.04};
    const HandSupport support = rests_on({.name = "rest",
                                          .position = middle,
                                          .rotation = {v.x, v.y, v.z, half.cos},
                                          .size = size,
                                          .radius = 0.01});
    expect_near(support.normal, {0, 1, 0});
    expect_near(support.place, {hand_.x, middle.y + 0.5 * height + 0.01 + thickness_, hand_.z});
  };
  for (const double side : {1.0, -1.0}) {
    expect_up({1, 0, 0}, side > 0.0 ? 0.0 : 180.0, size.y);
    expect_up({0, 0, 1}, side * 90.0, size.x);
    expect_up({1, 0, 0}, side * 90.0, size.z);
  }
}

TEST_F(RestingHand, IsPutOnTheLevelSideOfABoxBeforeANearerOneAndOffItsEdge) {
  // the hand is 0.3 m above and 0.1 m ahead of it, and 1 mm within its side
  const Vec3d size{0.4, 0.2, 0.6};
  const Vec3d middle = hand_ - Vec3d{0.199, 0.3 + 0.1, 0.1 + 0.3};
  const HandSupport support = rests_on({.name = "rest", .position = middle, .size = size});
  expect_near(support.normal, {0, 1, 0});
  expect_near(support.place, middle + Vec3d{0.2 - 0.04, 0.1 + thickness_, 0.3 - 0.04});
}

TEST_F(RestingHand, IsPutWhereARoundThingIsNearest) {
  for (const Vec3d& way : {Vec3d{0.6, 0.0, 0.8}, Vec3d{0.0, -1.0, 0.0}}) {
    const HandSupport support =
        rests_on({.name = "rest", .position = hand_ - way * 0.3, .radius = 0.05});
    expect_near(support.normal, way);
    expect_near(support.place, hand_ - way * (0.3 - 0.05 - thickness_));
  }
  const HandSupport middle = rests_on({.name = "rest", .position = hand_, .radius = 0.05});
  expect_near(middle.normal, {0, 1, 0});
}

}  // namespace
}  // namespace shigusa
