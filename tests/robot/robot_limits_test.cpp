// SPDX-License-Identifier: MIT
// Files whose limits are in another unit than their format has.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/robot.hpp"
#include "robot/urdf.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// A chain of joints that turn as far to one side as to the other.
Robot turning(const std::vector<double>& ends) {
  std::string text = "<robot name=\"r\"><link name=\"0\"/>";
  for (std::size_t k = 0; k < ends.size(); ++k) {
    text += fmt::format(
        "<joint name=\"j{0}\" type=\"revolute\"><parent link=\"{0}\"/><child link=\"{1}\"/>"
        "<limit lower=\"-{2}\" upper=\"{2}\" effort=\"1\" velocity=\"1\"/></joint>"
        "<link name=\"{1}\"/>",
        k, k + 1, ends[k]);
  }
  return parse_urdf(text + "</robot>", "r.urdf").value();
}

TEST(RobotLimits, TellTheirUnitByMostOfFourThatDiffer) {
  const auto expect_told = [](const std::vector<double>& ends, const char* unit) {
    SCOPED_TRACE(testing::PrintToString(ends));
    EXPECT_THAT(turning(ends).doubts,
                testing::ElementsAre(HasSubstr(fmt::format("are taken to be in {}", unit))));
  };
  expect_told({90, 91, 92, 93}, "degrees");
  expect_told({90, 91, 92, 1}, "degrees");
  expect_told({90, 91, 92, 360}, "degrees");
  expect_told({90, 91, 92, 93, 1000}, "degrees");  // which is none
  expect_told({6.3, 6.4, 6.5, 6.6}, "degrees");
  expect_told({0.02, 0.03, 0.04, 1}, "radians");
  expect_told({0.051, 0.052, 0.053, 0.054}, "radians");
}

TEST(RobotLimits, OfFewJointsOrAllAlikeOrUsualTellNoUnit) {
  const std::vector<double> several[]{
      {90, 91, 92},     {90, 91, 1, 2},       {0.02, 0.03, 1, 2},    {90, 91, 92, 361},
      {90, 91, 92, 92}, {10, 10, 10, 10, 10}, {6.0, 6.1, 6.2, 6.25}, {0.06, 0.07, 0.08, 0.09}};
  for (const std::vector<double>& ends : several) {
    EXPECT_THAT(turning(ends).doubts, IsEmpty()) << testing::PrintToString(ends);
  }
}

TEST(RobotLimits, AreReadInTheUnitThatTheyTell) {
  const Robot large = turning({90, 91, 92, 200, 1000});
  EXPECT_NEAR(large.joints[0].lower, -kPi / 2.0, 1e-12);
  EXPECT_TRUE(large.joints[0].limited);
  EXPECT_FALSE(large.joints[3].limited);
  EXPECT_EQ(large.joints[3].upper, kPi);
  EXPECT_EQ(large.joints[4].ends->at(1), 1000.0);
  const Robot small = turning({0.02, 0.03, 0.04, 0.05});
  EXPECT_NEAR(small.joints[1].upper, degrees(0.03), 1e-12);
}

}  // namespace
}  // namespace shigusa
