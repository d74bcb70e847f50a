// SPDX-License-Identifier: MIT
// Things beside the figure: tables, walls, seats, balls.
#include <gmock/gmock.h>

#include <limits>

#include "draw/strip_figure_things.hpp"
#include "strip_support.hpp"

namespace shigusa {
namespace {

using namespace strip_support;
using strip::Box;
using strip::seen_thing;
using strip::SeenCorner;
using strip::SeenThing;
using testing::HasSubstr;

const Box kWide{-100.0, 100.0, -100.0, 100.0};

std::vector<Vec3d> box(const Vec3d& low, const Vec3d& high) {
  std::vector<Vec3d> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back({(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                       (k & 4) != 0 ? high.z : low.z});
  }
  return corners;
}

// Seen from above, in front and on the left, in parallel projection.
std::vector<SeenCorner> seen(const std::vector<Vec3d>& corners) {
  const Vec3d toward = normalized(Vec3d{0.5, 0.3, 0.8});
  const Vec3d right = normalized(cross(Vec3d{0, 1, 0}, toward));
  const Vec3d above = cross(toward, right);
  std::vector<SeenCorner> list;
  for (const Vec3d& p : corners) list.push_back({{dot(right, p), dot(above, p)}, dot(toward, p)});
  return list;
}

double length_of_edges(const SeenThing& thing) {
  double length = 0.0;
  for (const auto& [a, b] : thing.edges) length += std::hypot(b.x - a.x, b.y - a.y);
  return length;
}

TEST(StripThings, OfABoxThreeFacesAreSeen) {
  const SeenThing thing = seen_thing(seen(box({0, 0, 0}, {1, 1, 1})), 0.0, kWide);
  EXPECT_EQ(thing.face.size(), 6U);
  EXPECT_EQ(thing.edges.size(), 9U);
}

TEST(StripThings, TheCornerThatIsFurthestAwayIsHidden) {
  const auto corners = seen(box({0, 0, 0}, {1, 1, 1}));
  for (const auto& [a, b] : seen_thing(corners, 0.0, kWide).edges) {
    for (const auto& end : {a, b}) {
      EXPECT_GT(std::hypot(end.x - corners[0].at.x, end.y - corners[0].at.y), 0.1);
    }
  }
}

TEST(StripThings, ABallIsRoundAndHasItsRadius) {
  const SeenThing ball = seen_thing(seen({{2, 3, 4}}), 0.5, kWide);
  const auto middle = seen({{2, 3, 4}})[0].at;
  ASSERT_EQ(ball.face.size(), 24U);
  for (const auto& p : ball.face) {
    EXPECT_NEAR(std::hypot(p.x - middle.x, p.y - middle.y), 0.5, 1e-12);
  }
  EXPECT_NEAR(length_of_edges(ball), kTwoPi * 0.5, 0.01);
}

TEST(StripThings, WhatReachesOutOfTheWindowIsCut) {
  const Box window{-1.0, 1.0, -1.0, 1.0};
  const SeenThing wall = seen_thing(seen(box({-50, -50, -50}, {50, 50, -49})), 0.0, window);
  ASSERT_EQ(wall.face.size(), 4U);
  for (const auto& p : wall.face) {
    EXPECT_NEAR(std::abs(p.x), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(p.y), 1.0, 1e-9);
  }
  EXPECT_TRUE(wall.edges.empty());
  const SeenThing away = seen_thing(seen(box({5, 5, 5}, {6, 6, 6})), 0.0, window);
  EXPECT_TRUE(away.face.empty());
  EXPECT_TRUE(away.edges.empty());
}

TEST(StripThings, ABoxWithoutSizeIsNoTrouble) {
  const SeenThing point = seen_thing(seen(box({1, 1, 1}, {1, 1, 1})), 0.0, kWide);
  EXPECT_EQ(point.face.size(), 1U);
  EXPECT_EQ(length_of_edges(point), 0.0);
}

TEST(StripThings, AHugeWallLeavesTheFigureNearlyAsLarge) {
  const SkeletonMotion motion = reaching(10);
  StripOverlay overlay;
  overlay.things = {{box({-90, 0, -2}, {90, 90, -1}), 0.0}};
  const std::string bare = svg(motion, {}, {});
  const std::string walled = svg(motion, overlay, {});
  // a page of one width is as high as its figures are large
  EXPECT_GT(attribute(walled, "height"), 0.7 * attribute(bare, "height"));
  EXPECT_LT(walled.size(), bare.size() + 6000);
}

TEST(StripThings, WhatIsNoThingIsRefused) {
  const auto refused = [](StripThing thing) {
    StripOverlay overlay;
    overlay.things = {std::move(thing)};
    const auto drawn = draw_strip(standing(1), overlay, {});
    return drawn ? std::string() : drawn.error().to_string();
  };
  EXPECT_EQ(refused({{{0, 0, 0}}, 0.1}), "");
  EXPECT_THAT(refused({}), HasSubstr("thing 0: 0 corners given; 1 to 64 allowed"));
  EXPECT_THAT(refused({{{0, std::numeric_limits<double>::quiet_NaN(), 0}}, 0.1}),
              HasSubstr("not finite"));
  EXPECT_THAT(refused({{{0, 0, 0}}, -0.1}), HasSubstr("radius of a thing: -0.1 given; 0 to"));
}

}  // namespace
}  // namespace shigusa
