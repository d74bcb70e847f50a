// SPDX-License-Identifier: MIT
#include "person/likeness.hpp"

#include <gmock/gmock.h>

#include <shigusa/skeleton.hpp>
#include <shigusa/transform.hpp>

#include "person/find_humanoid.hpp"
#include "person/measure_person.hpp"
#include "support/convention.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// Why the figure of a drawing is no person.
std::string reason(const StickFigure& figure) {
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = figure.world();
  const HumanoidMap map = find_humanoid(skeleton, world).value();
  return unlike_a_person(measure_person(skeleton, world, map).value().landmarks);
}

StickFigure drawn(const std::string& name) {
  return read_convention(std::filesystem::path(SHIGUSA_SOURCE_DIR) / "tests/animals" /
                         (name + ".txt"))
      .figure;
}

TEST(Likeness, FourLeggedAnimalsAreNoPeople) {
  EXPECT_THAT(reason(drawn("fox")), HasSubstr("stands on four legs: the trunk lies level, as long "
                                              "as 1.29 legs, and the limbs in front, 1.15"));
  EXPECT_THAT(reason(drawn("horse")), HasSubstr("stands on four legs"));
}

TEST(Likeness, InsectWithWingsForArmsIsNoPerson) {
  EXPECT_THAT(reason(drawn("bee")), HasSubstr("times as broad as trunk and legs are long"));
}

// A person who touches the floor has an animal's stance, and a person's lengths.
TEST(Likeness, WhoeverBendsToTheFloorIsAPerson) {
  StickFigure figure = standing_figure();
  const Vec3d hips = figure["Hips"].at;
  for (StickFigure::Point& point : figure.points) {
    if (point.at.y > hips.y + 0.01) {
      const Vec3d off = point.at - hips;
      point.at = hips + Vec3d{off.x, -0.1 * off.y, off.y};
    }
  }
  for (const char* side : {"Left", "Right"}) {
    const Vec3d shoulder = figure[side + std::string("Arm")].at;
    figure[side + std::string("ForeArm")].at = shoulder + Vec3d{0, -0.316, 0};
    figure[side + std::string("Hand")].at = shoulder + Vec3d{0, -0.564, 0};
  }
  EXPECT_EQ(reason(figure), "");
}

TEST(Likeness, FiguresOfOddLengthsArePeople) {
  struct Odd {
    const char* what;
    double legs;
    double arms;
    double head;
  };
  for (const Odd& odd :
       {Odd{"child", 0.8, 0.9, 1.4}, Odd{"dwarf", 0.45, 0.7, 1.2}, Odd{"chibi", 0.35, 0.6, 4.0},
        Odd{"giant", 0.7, 2.0, 0.8}, Odd{"alien", 1.3, 1.8, 1.5}}) {
    StickFigure figure = standing_figure();
    const Vec3d hips = figure["Hips"].at;
    const Vec3d neck = figure["Neck"].at;
    for (StickFigure::Point& point : figure.points) {
      if (point.at.y < hips.y) point.at.y = hips.y + odd.legs * (point.at.y - hips.y);
      if (abs(point.at.x) > 0.2) point.at.x *= odd.arms;
      if (point.at.y > neck.y) point.at.y = neck.y + odd.head * (point.at.y - neck.y);
    }
    EXPECT_EQ(reason(figure), "") << odd.what;
  }
}

class LikenessOf : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LikenessOf, EachConventionIsAPersons) {
  EXPECT_EQ(reason(read_convention(GetParam()).figure), "");
}

INSTANTIATE_TEST_SUITE_P(Conventions, LikenessOf, testing::ValuesIn(convention_files()),
                         [](const auto& each) { return each.param.stem().string(); });

}  // namespace
}  // namespace shigusa
