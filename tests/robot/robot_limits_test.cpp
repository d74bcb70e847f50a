// SPDX-License-Identifier: MIT
// Files with limits in another unit than their format's.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/urdf.hpp"
#include "robot/robot.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// A chain of joints that turn by that much to one side, and by nine tenths of it to the other.
Robot turning(const std::vector<double>& ends) {
  std::string text = "<robot name=\"r\"><link name=\"0\"/>";
  for (std::size_t k = 0; k < ends.size(); ++k) {
    text += fmt::format(
        "<joint name=\"j{0}\" type=\"revolute\"><parent link=\"{0}\"/><child link=\"{1}\"/>"
        "<limit lower=\"{3}\" upper=\"{2}\" effort=\"1\" velocity=\"1\"/></joint>"
        "<link name=\"{1}\"/>",
        k, k + 1, ends[k], -0.9 * ends[k]);
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
  expect_told({6.62, 6.7, 6.8, 6.9}, "degrees");
  expect_told({0.02, 0.03, 0.04, 1}, "radians");
  expect_told({0.054, 0.055, 0.056, 0.057}, "radians");
}

TEST(RobotLimits, OfFewJointsOrAllAlikeOrUsualTellNoUnit) {
  const std::vector<double> several[]{
      {90, 91, 92},       {90, 91, 1, 2},       {90, 91, 92, 361},    {90, 91, 92, 92},
      {0.02, 0.03, 1, 2}, {10, 10, 10, 10, 10}, {6.3, 6.4, 6.5, 6.6}, {0.058, 0.06, 0.07, 0.08}};
  for (const std::vector<double>& ends : several) {
    EXPECT_THAT(turning(ends).doubts, IsEmpty()) << testing::PrintToString(ends);
  }
}

TEST(RobotLimits, AreReadInTheUnitThatTheyTell) {
  const Robot large = turning({90, 91, 92, 200, 1000});
  EXPECT_NEAR(large.joints[0].lower, radians(-81.0), 1e-12);
  EXPECT_TRUE(large.joints[0].limited);
  EXPECT_FALSE(large.joints[3].limited);
  EXPECT_EQ(large.joints[3].upper, kPi);
  EXPECT_FALSE(large.joints[4].limited);
  const Robot small = turning({0.02, 0.03, 0.04, 0.05});
  EXPECT_NEAR(small.joints[1].upper, degrees(0.03), 1e-12);
}

}  // namespace
}  // namespace shigusa
