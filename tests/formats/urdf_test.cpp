// SPDX-License-Identifier: MIT
#include "formats/urdf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "support/robot_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

const std::string kTwoLinks =
    "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"><inertial><mass value=\"2\"/>"
    "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>"
    "<joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>"
    "<origin xyz=\"1 2 3\"/><axis xyz=\"0 0 2\"/>"
    "<limit lower=\"-1\" upper=\"2\" effort=\"7\" velocity=\"1\"/></joint></robot>";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text) {
  const Result<Robot> robot = parse_urdf(text, "r.urdf");
  return robot ? "no error" : robot.error().to_string();
}

TEST(Urdf, ReadsLinksAndJoints) {
  const Robot robot = parse_urdf(kTwoLinks, "r.urdf").value();
  EXPECT_EQ(robot.name, "r");
  ASSERT_EQ(robot.links.size(), 2u);
  ASSERT_EQ(robot.joints.size(), 1u);
  EXPECT_EQ(robot.links[1].mass, 2.0);
  const Robot::Joint& joint = robot.joints[0];
  EXPECT_EQ(joint.origin.translation, (Vec3d{1, 2, 3}));
  EXPECT_EQ(joint.axis, (Vec3d{0, 0, 1}));
  EXPECT_TRUE(joint.turns);
  EXPECT_TRUE(joint.limited);
  EXPECT_EQ(joint.lower, -1.0);
  EXPECT_EQ(joint.upper, 2.0);
  EXPECT_EQ(joint.effort, 7.0);
}

TEST(Urdf, JointsStandInTheFilesOrder) {
  const Robot robot = parse_urdf(RobotFile().text(), "small.urdf").value();
  EXPECT_EQ(robot.joints[0].name, "left_hip_yaw");
  EXPECT_EQ(robot.joints[6].name, "right_hip_yaw");
  EXPECT_EQ(robot.joints.back().name, "drawer");
}

TEST(Urdf, SlidingAndFollowingJointsKeepTheirPlaceWithADoubt) {
  const Robot robot = parse_urdf(RobotFile().text(), "small.urdf").value();
  EXPECT_FALSE(robot.joints.back().turns);
  EXPECT_TRUE(robot.joints.back().moves);
  EXPECT_THAT(robot.doubts, testing::Contains(HasSubstr("joint 'drawer' slides")));
  EXPECT_THAT(robot.doubts, testing::Contains(HasSubstr("follow")));
}

TEST(Urdf, ContinuousJointsAndWholeTurnsHaveNoLimits) {
  const std::string wide =
      with(kTwoLinks, "lower=\"-1\" upper=\"2\"", "lower=\"-10\" upper=\"10\"");
  for (const std::string& text : {with(kTwoLinks, "revolute", "continuous"), wide}) {
    const Robot robot = parse_urdf(text, "r.urdf").value();
    EXPECT_TRUE(robot.joints[0].turns);
    EXPECT_FALSE(robot.joints[0].limited);
  }
  const std::string fixed = with(kTwoLinks, "lower=\"-1\" upper=\"2\"", "lower=\"1\" upper=\"1\"");
  EXPECT_FALSE(parse_urdf(fixed, "r.urdf").value().joints[0].turns);
}

TEST(Urdf, WhatStandsForNoLimitIsNone) {
  for (const char* effort : {"1e+9", "inf", "INF", "1000000", "1.5e12", "nan", "1e999", " -1e9"}) {
    const std::string text = with(kTwoLinks, "effort=\"7\"", fmt::format("effort=\"{}\"", effort));
    const Result<Robot> robot = parse_urdf(text, "r.urdf");
    ASSERT_TRUE(robot) << robot.error().to_string();
    EXPECT_EQ(robot->joints[0].effort, 0.0) << effort;
    EXPECT_EQ(robot->joints[0].upper, 2.0);
  }
  for (const char* effort : {"1e-9", "999999", "0000000012", "9.5e5", "12345.678e1"}) {
    const std::string text = with(kTwoLinks, "\"7\"", fmt::format("\"{}\"", effort));
    EXPECT_EQ(parse_urdf(text, "r.urdf").value().joints[0].effort, std::strtod(effort, nullptr));
  }
  for (const char* wide : {"lower=\"-inf\" upper=\"inf\"", "lower=\"-1e20\" upper=\"+1E20\""}) {
    const Robot robot =
        parse_urdf(with(kTwoLinks, "lower=\"-1\" upper=\"2\"", wide), "r.urdf").value();
    EXPECT_TRUE(robot.joints[0].turns);
    EXPECT_FALSE(robot.joints[0].limited) << wide;
  }
  const Result<Robot> without = parse_urdf(with(kTwoLinks, " effort=\"7\"", ""), "r.urdf");
  ASSERT_TRUE(without) << without.error().to_string();
  EXPECT_EQ(without->joints[0].effort, 0.0);
}

TEST(Urdf, ReductionKeepsTheRobotAndLeavesOutMeshes) {
  const std::string text = RobotFile().text();
  const std::string reduced = write_xml(reduced_urdf(text, "small.urdf").value());
  EXPECT_LT(reduced.size(), text.size());
  EXPECT_THAT(reduced, testing::Not(HasSubstr("mesh")));
  EXPECT_THAT(reduced, HasSubstr("<box"));
  EXPECT_EQ(write_xml(reduced_urdf(reduced, "small.urdf").value()), reduced);
  const Robot robot = parse_urdf(text, "small.urdf").value();
  const Robot again = parse_urdf(reduced, "small.urdf").value();
  ASSERT_EQ(robot.links.size(), again.links.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    EXPECT_EQ(robot.links[i].name, again.links[i].name);
    EXPECT_EQ(robot.links[i].inertia, again.links[i].inertia);
  }
}

TEST(Urdf, TellsWhatIsWrongAndWhere) {
  EXPECT_THAT(error_of(""), HasSubstr("no element"));
  EXPECT_THAT(error_of("<sdf/>"), HasSubstr("<sdf> in place of <robot>"));
  EXPECT_THAT(error_of("<robot name=\"r\">\n<link name=\"a\">"),
              HasSubstr("<link> is never closed"));
  EXPECT_THAT(error_of("<robot>\n</link></robot>"), HasSubstr("line 2 of r.urdf: </link> closes"));
  EXPECT_THAT(error_of("<robot><xacro:macro/></robot>"), HasSubstr("expand the file first"));
  EXPECT_THAT(error_of("<!DOCTYPE r [<!ENTITY a \"b\">]><robot/>"), HasSubstr("document type"));
  EXPECT_THAT(error_of("<robot name=\"r\"></robot>"), HasSubstr("no <link> in <robot>"));
  EXPECT_EQ(error_of(with(kTwoLinks, "1 2 3", "one 2 3")),
            "line 1 of r.urdf: xyz of <origin> is 'one 2 3'; it takes 3 numbers");
  const std::string first = "<link name=\"a\"/>";
  const std::string limit = "<limit lower=\"-1\" upper=\"2\" effort=\"7\" velocity=\"1\"/>";
  const struct {
    std::string from;
    std::string to;
    std::string told;
  } changes[] = {
      {"<mass value=\"2\"/>", "<mass value=\"-2\"/>", "the mass of link 'b' is -2 kg"},
      {"0 0 2", "0 0 0", "axis of joint 'j'"},
      {"lower=\"-1\"", "lower=\"3\"", "the limits 3 to 2"},
      {"1 2 3", "1e9 2 3", "beyond"},
      {"child link=\"b\"", "child link=\"c\"", "joint 'j' names the link 'c', which is not there"},
      // a file that urdfdom refuses would not drive a robot
      {"<robot name=\"r\">", "<robot>", "<robot> has no name"},
      {first, "<link name=\"b\"/>", "link 'b' is there twice"},
      {first, first + "<link name=\"c\"/>", "links 'a' and 'c' hang on none"},
      {"revolute", "ball", "joint 'j' has the type 'ball'; allowed are revolute, continuous"},
      {"<parent link=\"a\"/>", "", "joint 'j' has no <parent>"},
      {limit, "", "joint 'j' has no <limit>"},
      {"<mass value=\"2\"/>", "", "<inertial> of link 'b' has no <mass>"},
      {" iyz=\"0\"", "", "<inertia> has no iyz"},
      {first, "<link name=\"a\"><collision><geometry><sphere/></geometry></collision></link>",
       "<sphere> has no radius"},
  };
  for (const auto& [from, to, told] : changes) {
    EXPECT_THAT(error_of(with(kTwoLinks, from, to)), HasSubstr(told));
  }
}

std::string link(const std::string& name) { return "<link name=\"" + name + "\"/>"; }
std::string fixed(const std::string& from, const std::string& to) {
  return "<joint name=\"" + from + to + "\" type=\"fixed\"><parent link=\"" + from +
         "\"/><child link=\"" + to + "\"/></joint>";
}

TEST(Urdf, RefusesLinksThatHangTwiceOrInACircle) {
  const std::string links = link("a") + link("b") + link("c");
  EXPECT_THAT(error_of("<robot name=\"r\">" + links + fixed("a", "c") + fixed("b", "c") +
                       fixed("a", "b") + "</robot>"),
              HasSubstr("hangs on two joints"));
  EXPECT_THAT(
      error_of("<robot name=\"r\">" + links + fixed("b", "c") + fixed("c", "b") + "</robot>"),
      HasSubstr("in a circle"));
}

TEST(Urdf, AJointsLinksAreReadOnce) {
  const std::string links = link("a") + link("b") + link("c");
  const auto joint = [&](const std::string& inside) {
    return "<robot name=\"r\">" + links + "<joint name=\"j\" type=\"fixed\">" + inside +
           "</joint></robot>";
  };
  EXPECT_THAT(error_of(joint("<parent link=\"b\"/><parent link=\"c\"/><child link=\"b\"/>")),
              HasSubstr("a second <parent>"));
  EXPECT_THAT(error_of(joint("<parent link=\"&#98;\"/><child link=\"b\"/>")),
              HasSubstr("in a circle"));
  EXPECT_THAT(error_of(joint("<parent xlink=\"a\" link=\"b\"/><child link=\"b\"/>")),
              HasSubstr("in a circle"));
  EXPECT_THAT(error_of(joint("<parent name=\"a\"/><child link=\"b\"/>")),
              HasSubstr("<parent> names no link"));
}

TEST(Urdf, HugeAndDeepFilesEndAtOnce) {
  const auto begin = std::chrono::steady_clock::now();
  std::string deep = "<robot name=\"r\">";
  for (int k = 0; k < 100000; ++k) deep += "<a>";
  EXPECT_THAT(error_of(deep), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(error_of(deep + deep), HasSubstr("more than 200000 tags"));
  std::string many = "<robot name=\"r\">";
  for (int k = 0; k < 20000; ++k) many += link("l" + std::to_string(k));
  EXPECT_THAT(error_of(many + "</robot>"), HasSubstr("more than 1024 links"));
  EXPECT_THAT(error_of(std::string(kUrdfMaxBytes + 1, ' ')), HasSubstr("are allowed"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(Urdf, LongestChainIsRead) {
  std::string text = "<robot name=\"r\">" + link("l0");
  for (int k = 1; k < kUrdfMaxLinks; ++k) {
    text +=
        link("l" + std::to_string(k)) + fixed("l" + std::to_string(k - 1), "l" + std::to_string(k));
  }
  EXPECT_EQ(parse_urdf(text + "</robot>", "r.urdf").value().links.size(),
            static_cast<std::size_t>(kUrdfMaxLinks));
}

TEST(Urdf, TurnsByRollPitchAndYaw) {
  const std::string turned = with(kTwoLinks, "xyz=\"1 2 3\"", "rpy=\"1.5707963267948966 0 0\"");
  const Mat3d rotation = parse_urdf(turned, "r.urdf").value().joints[0].origin.rotation;
  EXPECT_LT(norm(rotation * Vec3d{0, 1, 0} - Vec3d{0, 0, 1}), 1e-15);
  const std::string all = with(kTwoLinks, "xyz=\"1 2 3\"", "rpy=\"0.3 -0.8 2.5\"");
  const Mat3d r = parse_urdf(all, "r.urdf").value().joints[0].origin.rotation;
  EXPECT_NEAR(r.cx.z, -std::sin(-0.8), 1e-15);
  EXPECT_NEAR(std::atan2(r.cx.y, r.cx.x), 2.5, 1e-15);
  EXPECT_NEAR(std::atan2(r.cy.z, r.cz.z), 0.3, 1e-15);
}

}  // namespace
}  // namespace shigusa
