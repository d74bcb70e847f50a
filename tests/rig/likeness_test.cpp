// SPDX-License-Identifier: MIT
#include "rig/likeness.hpp"

#include <gmock/gmock.h>

#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "support/convention.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// The reason why the figure of a drawing is no person.
std::string reason(const StickFigure& figure) {
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = figure.world();
  const Result<HumanoidMap> map = find_humanoid(skeleton, world);
  if (!map) return map.error().message;
  return unlike_a_person(measure_person(skeleton, world, *map).value().landmarks);
}

StickFigure drawn(const std::string& name) {
  return read_convention(std::filesystem::path(SHIGUSA_SOURCE_DIR) / "tests/animals" /
                         (name + ".txt"))
      .figure;
}

TEST(Likeness, FourLeggedAnimalsAreNoPeople) {
  EXPECT_THAT(reason(drawn("dog_without_names")),
              HasSubstr("stands on four legs: the trunk lies level, as long as 1.27 legs"));
  EXPECT_THAT(reason(drawn("wolf")), HasSubstr("stands on four legs: the trunk lies level, as long "
                                               "as 1.29 legs, and the limbs in front, 1.15"));
  for (const char* animal : {"fox", "horse", "fox_with_controls"}) {
    EXPECT_THAT(reason(drawn(animal)), HasSubstr("stands on four legs")) << animal;
  }
}

TEST(Likeness, InsectWithWingsForArmsIsNoPerson) {
  EXPECT_THAT(reason(drawn("bee")), HasSubstr("times as broad as trunk and legs are long"));
}

// A person who touches the floor with the hands has an animal's stance, and a person's lengths.
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

// Wings, a tail, hair to the floor and a skirt, named or not.
TEST(Likeness, WingsTailsHairAndSkirtsAreAPersons) {
  for (const bool named : {true, false}) {
    StickFigure figure = standing_figure();
    const auto add_row = [&](const std::string& name, const std::string& parent, Vec3d at,
                             const Vec3d& step) {
      std::string on = parent;
      for (int i = 0; i < 4; ++i) {
        const std::string next = name + std::to_string(i);
        figure.add(next, on, at);
        on = next;
        at += step;
      }
    };
    for (const auto& [side, x] : {std::pair("Left", 1.0), std::pair("Right", -1.0)}) {
      const std::string s = side;
      add_row(s + "Wing", "Spine", {0.1 * x, 1.35, -0.1}, {0.25 * x, 0.1, -0.05});
      add_row(s + "Hair", "Head", {0.08 * x, 1.65, -0.05}, {0.05 * x, -0.5, -0.02});
      for (int i = 0; i < 4; ++i) {
        const double turn = 0.4 + 0.75 * i;
        add_row(s + "Skirt" + std::to_string(i), "Hips",
                {0.15 * x * std::sin(turn), 0.95, 0.15 * std::cos(turn)},
                {0.03 * x * std::sin(turn), -0.28, 0.03 * std::cos(turn)});
      }
    }
    add_row("Tail", "Hips", {0, 0.9, -0.1}, {0, -0.1, -0.2});
    if (!named) {
      for (StickFigure::Point& point : figure.points) {
        const bool extra = point.name.find("Wing") != point.name.npos ||
                           point.name.find("Hair") != point.name.npos ||
                           point.name.find("Skirt") != point.name.npos;
        if (extra) point.name = "Bone" + std::to_string(&point - figure.points.data());
      }
    }
    EXPECT_EQ(reason(figure), "") << named;
  }
}

class Animals : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Animals, AreNoPeople) { EXPECT_NE(reason(read_convention(GetParam()).figure), ""); }

INSTANTIATE_TEST_SUITE_P(Files, Animals, testing::ValuesIn(convention_files("tests/animals")),
                         [](const auto& each) { return each.param.stem().string(); });

class LikenessOf : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LikenessOf, EachConventionIsAPersons) {
  EXPECT_EQ(reason(read_convention(GetParam()).figure), "");
}

INSTANTIATE_TEST_SUITE_P(Conventions, LikenessOf, testing::ValuesIn(convention_files()),
                         [](const auto& each) { return each.param.stem().string(); });

}  // namespace
}  // namespace shigusa
