// SPDX-License-Identifier: MIT
#include "formats/mjcf.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/urdf.hpp"
#include "support/mjcf_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr double kRounding = 1e-12;

// A model of two bodies, the second with the given text, from its own line on.
std::string two_bodies(const std::string& within, const std::string& before = "",
                       const std::string& of_second = "") {
  return "<mujoco model=\"m\">" + before +
         "\n<worldbody><body name=\"a\"><geom name=\"g\" size=\"0.1\"/>\n<body name=\"b\" " +
         of_second + ">\n" + within + "\n</body></body></worldbody></mujoco>";
}

Robot read(const std::string& text) { return parse_mjcf(text, "r.xml").value(); }

std::string error_of(const std::string& text) {
  const Result<Robot> robot = parse_mjcf(text, "r.xml");
  return robot ? "no error" : robot.error().to_string();
}

void expect_near(const Vec3d& found, const Vec3d& wanted) {
  EXPECT_LE(norm(found - wanted), kRounding) << found.x << ' ' << found.y << ' ' << found.z;
}

void expect_near(const Mat3d& found, const Mat3d& wanted) {
  expect_near(found.cx, wanted.cx);
  expect_near(found.cy, wanted.cy);
  expect_near(found.cz, wanted.cz);
}

TEST(Mjcf, AnglesAreDegreesUnlessRadiansAreTold) {
  const std::string hinge = "<joint name=\"j\" range=\"-90 45\"/>";
  EXPECT_NEAR(read(two_bodies(hinge)).joints[0].upper, kPi / 4, kRounding);
  const std::string radian = "<compiler angle=\"radian\"/>";
  EXPECT_EQ(read(two_bodies("<joint range=\"-0.5 0.25\"/>", radian)).joints[0].upper, 0.25);
}

TEST(Mjcf, RangeLimitsUnlessItIsToldNotTo) {
  const auto limited = [](const std::string& joint, const std::string& before = "") {
    return read(two_bodies(joint, before)).joints[0].limited;
  };
  EXPECT_TRUE(limited("<joint range=\"-9 9\"/>"));
  EXPECT_TRUE(limited("<joint range=\"-9 9\" limited=\"auto\"/>"));
  EXPECT_FALSE(limited("<joint range=\"-9 9\" limited=\"false\"/>"));
  EXPECT_FALSE(limited("<joint/>"));
  EXPECT_FALSE(limited("<joint range=\"-180 180\"/>"));
  EXPECT_FALSE(limited("<joint range=\"-9 9\"/>", "<compiler autolimits=\"false\"/>"));
}

// The same quarter turn about y in each of the five ways.
TEST(Mjcf, OrientationsAreReadInEachOfTheirForms) {
  const Mat3d quarter{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  for (const char* way : {"quat=\"1 0 1 0\"", "axisangle=\"0 2 0 90\"", "euler=\"0 90 0\"",
                          "xyaxes=\"0 0 -1 0 3 0.1\"", "zaxis=\"5 0 0\""}) {
    SCOPED_TRACE(way);
    expect_near(read(two_bodies("", "", way)).joints[0].origin.rotation, quarter);
  }
  // x to y, y to z and z to x
  expect_near(read(two_bodies("", "", "quat=\"2 2 2 2\"")).joints[0].origin.rotation,
              {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
}

TEST(Mjcf, OrderOfEulerAnglesIsTheCompilers) {
  const Mat3d x = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  const Mat3d z = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  const auto turn = [](const std::string& order) {
    return read(two_bodies("", "<compiler eulerseq=\"" + order + "\"/>", "euler=\"90 0 90\""))
        .joints[0]
        .origin.rotation;
  };
  expect_near(turn("xyz"), x * z);
  expect_near(turn("XYZ"), z * x);
  expect_near(turn("zyx"), z * x);
}

// An element's own attributes override its class, which overrides the enclosing class; childclass
// applies without a class of its own.
TEST(Mjcf, ClassesGiveWhatAnElementDoesNotSay) {
  const std::string classes =
      "<default><joint range=\"-1 1\"/><default class=\"x\"><joint range=\"-2 2\"/>"
      "<default class=\"y\"><joint axis=\"1 0 0\"/></default></default></default>";
  const auto upper = [&](const std::string& joint, const std::string& body = "") {
    return degrees(read(two_bodies(joint, classes, body)).joints[0].upper);
  };
  EXPECT_NEAR(upper("<joint/>"), 1.0, kRounding);
  EXPECT_NEAR(upper("<joint class=\"x\"/>"), 2.0, kRounding);
  EXPECT_NEAR(upper("<joint class=\"y\"/>"), 2.0, kRounding);
  EXPECT_NEAR(upper("<joint/>", "childclass=\"y\""), 2.0, kRounding);
  EXPECT_NEAR(upper("<joint class=\"main\"/>", "childclass=\"y\""), 1.0, kRounding);
  EXPECT_NEAR(upper("<joint range=\"-3 3\"/>", "childclass=\"y\""), 3.0, kRounding);
  expect_near(read(two_bodies("<joint/>", classes, "childclass=\"y\"")).joints[0].axis, {1, 0, 0});
  // of several, the first applies to all
  const std::string named =
      "<default class=\"all\"><joint range=\"-4 4\"/></default>"
      "<default class=\"z\"><joint range=\"-5 5\"/></default>";
  EXPECT_NEAR(degrees(read(two_bodies("<joint/>", named)).joints[0].upper), 4.0, kRounding);
  EXPECT_NEAR(degrees(read(two_bodies("<joint class=\"z\"/>", named)).joints[0].upper), 5.0,
              kRounding);
}

TEST(Mjcf, HingesOfOneBodyAreAChainInTheirOrder) {
  const Robot robot = read(two_bodies(
      "<joint name=\"p\" axis=\"0 0 2\" pos=\"0 0 0.1\"/><joint name=\"q\" axis=\"0 1 0\"/>", "",
      "pos=\"1 2 3\""));
  ASSERT_EQ(robot.joints.size(), 2u);
  EXPECT_EQ(robot.links[1].name, "p");
  EXPECT_EQ(robot.links[2].name, "b");
  expect_near(robot.joints[0].origin.translation, {1, 2, 3.1});
  expect_near(robot.joints[1].origin.translation, {0, 0, -0.1});
  expect_near(robot.joints[0].axis, {0, 0, 1});
  EXPECT_EQ(robot.joints[1].parent, 1);
}

TEST(Mjcf, BallIsThreeHinges) {
  const Robot robot = read(two_bodies("<joint name=\"j\" type=\"ball\" range=\"0 60\"/>"));
  ASSERT_EQ(robot.joints.size(), 3u);
  EXPECT_EQ(robot.joints[0].name, "j_x");
  EXPECT_EQ(robot.joints[2].name, "j_z");
  EXPECT_NEAR(robot.joints[1].lower, -kPi / 3, kRounding);
  expect_near(robot.joints[1].axis, {0, 1, 0});
}

TEST(Mjcf, SlidingAndFollowingJointsKeepTheirPlaceWithADoubt) {
  const Robot slide = read(two_bodies("<joint name=\"j\" type=\"slide\" range=\"0 1\"/>"));
  EXPECT_FALSE(slide.joints[0].turns);
  EXPECT_THAT(slide.doubts, Contains("joint 'j' slides: it keeps its place"));
  const Robot follows = read(two_bodies("<joint name=\"j\"/>",
                                        "<equality><joint joint1=\"j\" joint2=\"k\"/>"
                                        "</equality>"));
  EXPECT_FALSE(follows.joints[0].turns);
  EXPECT_THAT(follows.doubts, Contains(HasSubstr("follows another joint")));
}

// At angle 0 of a joint whose model stands at 90 degrees, the body is turned back.
TEST(Mjcf, ReferenceAngleIsThatOfTheModelAsItStands) {
  const Robot robot = read(two_bodies("<joint axis=\"0 0 1\" ref=\"90\"/>", "", "pos=\"1 0 0\""));
  expect_near(robot.joints[0].origin.rotation, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}});
  expect_near(robot.joints[0].origin.translation, {1, 0, 0});
}

TEST(Mjcf, EffortIsWhatActuatorsAllow) {
  const auto effort = [](const std::string& actuator, const std::string& joint = "") {
    return read(two_bodies("<joint name=\"j\" " + joint + "/>",
                           "<actuator>" + actuator + "</actuator>"))
        .joints[0]
        .effort;
  };
  EXPECT_EQ(effort("<motor joint=\"j\" gear=\"20\" ctrlrange=\"-1 2\"/>"), 40.0);
  EXPECT_EQ(effort("<motor joint=\"j\" gear=\"20\"/>"), 0.0);
  EXPECT_EQ(effort("<motor joint=\"j\" gear=\"20\" ctrlrange=\"-1 1\" ctrllimited=\"false\"/>"),
            0.0);
  EXPECT_EQ(effort("<position joint=\"j\" kp=\"9\" ctrlrange=\"-1 1\" forcerange=\"-7 7\"/>"), 7.0);
  EXPECT_EQ(effort("<position joint=\"j\" ctrlrange=\"-1 1\"/>"), 0.0);
  EXPECT_EQ(effort("<general joint=\"j\" gainprm=\"3\" ctrlrange=\"-2 2\"/>"), 6.0);
  EXPECT_EQ(effort("", "actuatorfrcrange=\"-5 5\""), 5.0);
  EXPECT_EQ(
      effort("<motor joint=\"j\" gear=\"20\" ctrlrange=\"-1 1\"/>", "actuatorfrcrange=\"-5 5\""),
      5.0);
  EXPECT_EQ(effort("<motor joint=\"j\" ctrlrange=\"-inf inf\"/>"), 0.0);
}

// Sums over thin slices across z: ellipses, which shrink beyond `even` (m) from the middle.
TEST(Mjcf, ShapesWeighWhatTheirSlicesWeigh) {
  struct Solid {
    const char* geom;
    Vec3d half;
    double even;
  };
  constexpr int kSlices = 4000;
  for (const auto& [geom, half, even] :
       {Solid{"type=\"sphere\" size=\"0.2\"", {0.2, 0.2, 0.2}, 0.0},
        Solid{"type=\"cylinder\" size=\"0.2 0.3\"", {0.2, 0.2, 0.3}, 0.3},
        Solid{"type=\"capsule\" size=\"0.2 0.3\"", {0.2, 0.2, 0.5}, 0.3},
        Solid{"type=\"ellipsoid\" size=\"0.1 0.2 0.3\"", {0.1, 0.2, 0.3}, 0.0}}) {
    double mass = 0.0;
    Vec3d moments{};
    for (int k = 0; k < kSlices; ++k) {
      const double z = half.z * ((2.0 * k + 1.0) / kSlices - 1.0);
      const double beyond = abs(z) > even ? (abs(z) - even) / (half.z - even) : 0.0;
      const double share = 1.0 - beyond * beyond;
      const double xx = half.x * half.x * share;
      const double yy = half.y * half.y * share;
      const double slice = 1000.0 * kPi * half.x * half.y * share * 2.0 * half.z / kSlices;
      mass += slice;
      moments += Vec3d{yy / 4.0 + z * z, xx / 4.0 + z * z, (xx + yy) / 4.0} * slice;
    }
    const Robot robot = read(two_bodies(fmt::format("<geom {}/>", geom)));
    const Mat3d& inertia = robot.links[1].inertia;
    EXPECT_NEAR(robot.links[1].mass, mass, 1e-6 * mass) << geom;
    EXPECT_LT(norm(Vec3d{inertia.cx.x, inertia.cy.y, inertia.cz.z} - moments), 1e-6 * mass) << geom;
  }
  const Robot box = read(two_bodies("<geom type=\"box\" size=\"0.1 0.2 0.3\"/>"));
  const double mass = 1000.0 * 0.2 * 0.4 * 0.6;
  EXPECT_NEAR(box.links[1].mass, mass, 1e-9);
  expect_near(box.links[1].inertia.cx, Vec3d{0.04 + 0.09, 0, 0} * (mass / 3.0));
  expect_near(box.links[1].inertia.cz, Vec3d{0, 0, 0.01 + 0.04} * (mass / 3.0));
}

TEST(Mjcf, WhatOnlyShowsIsNoSole) {
  const Robot robot =
      read(two_bodies("<geom size=\"0.1\"/><geom size=\"1\" contype=\"0\" conaffinity=\"0\"/>"
                      "<geom type=\"mesh\" mesh=\"x\"/>"));
  ASSERT_EQ(robot.links[1].corners().size(), 8u);
  EXPECT_NEAR(robot.links[1].corners()[7].x, 0.1, kRounding);
}

TEST(Mjcf, MassOfMeshesIsMissedWithADoubt) {
  const Robot robot = read(two_bodies("<geom type=\"mesh\" mesh=\"x\"/>"));
  EXPECT_EQ(robot.links[1].mass, 0.0);
  EXPECT_THAT(robot.doubts, Contains("body 'b' has its mass from a mesh, which is not read"));
}

TEST(Mjcf, RobotIsTheBodyWithTheMostJoints) {
  const Robot robot = read(
      "<mujoco><worldbody><body name=\"box\"><freejoint/><geom size=\"1\"/></body>"
      "<body name=\"r\"><freejoint/><body name=\"s\"><joint/></body></body></worldbody></mujoco>");
  EXPECT_EQ(robot.links[0].name, "r");
  EXPECT_THAT(robot.doubts, Contains("body 'box' of the world is no part of the robot"));
}

TEST(Mjcf, RootOnARailIsFreeWithADoubt) {
  const Robot robot = read(
      "<mujoco><worldbody><body name=\"r\"><joint name=\"rail\" type=\"slide\"/>"
      "<body name=\"s\"><joint name=\"j\"/></body></body></worldbody></mujoco>");
  ASSERT_EQ(robot.joints.size(), 1u);
  EXPECT_THAT(robot.doubts, Contains("joint 'rail' holds the root to the world: it is left out"));
}

TEST(Mjcf, FramesStandBetweenABodyAndWhatItHas) {
  const Robot robot =
      read(two_bodies("<joint/><frame pos=\"1 0 0\" euler=\"0 0 90\"><geom size=\"0.1 0.2 0.3\" "
                      "type=\"box\" mass=\"2\" pos=\"1 0 0\"/></frame>"));
  expect_near(robot.links[1].com, {1, 1, 0});
  expect_near(robot.links[1].corners()[7], {1 - 0.2, 1 + 0.1, 0.3});
}

TEST(Mjcf, WhatIsWrongIsToldWithItsLine) {
  const auto told = [](const std::string& within, const std::string& what,
                       const std::string& before = "") {
    EXPECT_EQ(error_of(two_bodies(within, before)), what);
  };
  told("<joint axis=\"1 0\"/>", "line 4 of r.xml: axis is '1 0'; it takes 3 numbers");
  told("\n<joint axis=\"1 0 x\"/>",
       "line 5 of r.xml: axis is '1 0 x'; it takes 3 numbers of up to 1e+06");
  told("<joint axis=\"1 0 nan\"/>",
       "line 4 of r.xml: axis is '1 0 nan'; it takes 3 numbers of up to 1e+06");
  told("<joint axis=\"0 0 0\"/>",
       "line 4 of r.xml: the axis of joint 'b_joint' is '0 0 0'; it needs a direction");
  told("<joint type=\"screw\"/>",
       "line 4 of r.xml: type is 'screw'; a joint is a hinge, ball, slide or free");
  told("<joint range=\"2 1\"/>", "line 4 of r.xml: range is '2 1'; the lower end comes first");
  told("<joint limited=\"true\"/>", "line 4 of r.xml: limited is true, and there is no range");
  told("<freejoint/>", "line 4 of r.xml: a free joint within the robot; only its root is free");
  told("<geom/>", "line 4 of r.xml: a sphere without a size");
  told("<geom type=\"box\" size=\"1 1 -1\"/>",
       "line 4 of r.xml: size is '1 1 -1'; a box has sizes above 0");
  told("<geom type=\"blob\" size=\"1\"/>", "line 4 of r.xml: type is 'blob', which is no shape");
  told("<geom size=\"1\" quat=\"0 0 0 0\"/>",
       "line 4 of r.xml: quat is '0 0 0 0', which is no rotation");
  told("<geom size=\"1e7\"/>", "line 4 of r.xml: size is '1e7'; it takes 3 numbers of up to 1e+06");
  told("<inertial mass=\"-1\"/>", "line 4 of r.xml: <inertial> has a mass of 0 kg or more");
  told("<joint class=\"c\"/>", "line 4 of r.xml: class 'c' is not defined");
  told("", "line 1 of r.xml: coordinate is 'global', which MuJoCo has given up",
       "<compiler coordinate=\"global\"/>");
  told("", "line 1 of r.xml: eulerseq is 'xyw'; it is three of xyzXYZ",
       "<compiler eulerseq=\"xyw\"/>");
}

TEST(Mjcf, WhatNumbersComeToIsBounded) {
  EXPECT_EQ(error_of(two_bodies("<geom type=\"box\" size=\"900 900 900\"/>")),
            "r.xml: body 'b' has a mass beyond 1e+06 kg; lengths are metres, and this file may be "
            "in millimetres");
  EXPECT_THAT(error_of(two_bodies("<body name=\"c\" pos=\"9e5 9e5 0\"><frame pos=\"9e5 0 0\"><body "
                                  "name=\"d\" pos=\"9e5 0 0\"/></frame></body>")),
              HasSubstr("body 'd' has a place beyond 1e+06 m"));
  const Robot far = read(two_bodies("<joint type=\"slide\" range=\"5000 9000\"/>"));
  EXPECT_EQ(far.joints[0].lower, 1000.0);
}

TEST(Mjcf, WhatIsNoModelIsRefused) {
  EXPECT_EQ(error_of("<robot name=\"r\"/>"),
            "line 1 of r.xml: <robot> in place of <mujoco>: this is no MJCF file");
  EXPECT_THAT(error_of("<mujoco><worldbody>"), HasSubstr("<worldbody> is never closed"));
  EXPECT_THAT(error_of(""), HasSubstr("r.xml"));
  EXPECT_EQ(error_of("<mujoco/>"), "r.xml: no <body> in <worldbody>");
  EXPECT_THAT(error_of(std::string("<mujoco/>\0", 10)), HasSubstr("a zero byte"));
}

TEST(Mjcf, LimitsOfTheFileAreHeld) {
  EXPECT_THAT(error_of(std::string(kMjcfMaxBytes + 1, ' ')), HasSubstr("bytes; "));
  std::string tags = "<mujoco>";
  for (std::size_t i = 0; i < kMjcfMaxTags; ++i) tags += "<a/>";
  EXPECT_EQ(error_of(tags + "</mujoco>"), "r.xml: more than 50000 tags");
  std::string many;
  for (int i = 0; i < kMjcfMaxLinks; ++i) many += "<body/>";
  EXPECT_THAT(error_of(two_bodies(many)), HasSubstr("more than 1024 bodies and joints"));
  std::string deep;
  for (int i = 0; i < 80; ++i) deep += "<body>";
  for (int i = 0; i < 80; ++i) deep += "</body>";
  EXPECT_THAT(error_of(two_bodies(deep)), HasSubstr("nested deeper than 64"));
  std::string deeper;
  for (int i = 0; i < 5000; ++i) deeper += "<a>";
  EXPECT_THAT(error_of(deeper), HasSubstr("nested deeper than 100"));
  std::string classes = "<default>";
  for (int i = 0; i < 40; ++i) classes += "<geom/>";
  EXPECT_THAT(error_of(two_bodies("", classes + "</default>")), HasSubstr("more than 24 elements"));
}

class MjcfIncludes : public testing::Test {
 protected:
  Result<Robot> read(const std::string& main) {
    return parse_mjcf(main, "scene.xml", included_from(work_.path()));
  }
  static std::string including(const std::string& file) {
    return "<mujoco>\n<include file=\"" + file + "\"/></mujoco>";
  }
  WorkFolder work_;
};

TEST_F(MjcfIncludes, AreFollowedWithinTheFolder) {
  work_.put("robot.xml", two_bodies("<joint class=\"c\"/>"));
  work_.put("classes.xml",
            "<mujocoinclude><default class=\"main\"><default class=\"c\"><joint range=\"-9 9\"/>"
            "</default></default></mujocoinclude>");
  const Result<Robot> robot =
      read("<mujoco><include file=\"./classes.xml\"/><include file=\"robot.xml\"/></mujoco>");
  ASSERT_TRUE(robot) << robot.error().to_string();
  EXPECT_NEAR(degrees(robot->joints[0].upper), 9.0, kRounding);
}

TEST_F(MjcfIncludes, ErrorsAreOfTheFileThatHasThem) {
  work_.put("robot.xml", two_bodies("<joint axis=\"0\"/>"));
  EXPECT_EQ(read(including("robot.xml")).error().place, "line 4 of robot.xml");
}

TEST_F(MjcfIncludes, FilesThatAreNotThereAreDoubts) {
  const std::string with_robot =
      "<mujoco><include file=\"sky.xml\"/><worldbody><body/></worldbody></mujoco>";
  EXPECT_THAT(read(with_robot).value().doubts,
              Contains(HasSubstr("includes 'sky.xml', which is not here")));
  EXPECT_THAT(read(including("robot.xml")).error().to_string(),
              HasSubstr("includes 'robot.xml', which is not here: it was read without it; what "
                        "follows may come of that: no <body> in <worldbody>"));
  // the first error may be caused by the missing part
  const std::string in_class =
      "<mujoco><include file=\"a.xml\"/><include file=\"b.xml\"/><worldbody><body><geom "
      "class=\"of_a\" size=\"1\"/></body></worldbody></mujoco>";
  EXPECT_THAT(read(in_class).error().to_string(),
              AllOf(HasSubstr("includes 'a.xml', 'b.xml', which are not here"),
                    HasSubstr("class 'of_a' is not defined")));
}

TEST_F(MjcfIncludes, AreLookedForBesideTheFileThatIncludesThem) {
  std::filesystem::create_directories(work_.path() / "parts" / "deep");
  work_.put("parts/all.xml",
            "<mujocoinclude><include file=\"body.xml\"/><include file=\"deep/more.xml\"/>"
            "</mujocoinclude>");
  work_.put("parts/body.xml", two_bodies("<joint class=\"c\"/>"));
  // beside itself, above itself, and, by the older rule, beside the main file
  work_.put("parts/deep/more.xml",
            "<mujocoinclude><include file=\"own.xml\"/><include file=\"../up.xml\"/>"
            "<include file=\"main_one.xml\"/></mujocoinclude>");
  work_.put("parts/deep/own.xml",
            "<mujocoinclude><default><default class=\"c\"><joint range=\"-9 9\"/></default>"
            "</default></mujocoinclude>");
  work_.put("parts/up.xml", "<mujocoinclude/>");
  work_.put("main_one.xml", "<mujocoinclude/>");
  const Result<Robot> robot = read(including("parts/all.xml"));
  ASSERT_TRUE(robot) << robot.error().to_string();
  EXPECT_TRUE(robot->doubts.empty());
  EXPECT_NEAR(degrees(robot->joints[0].upper), 9.0, kRounding);
}

TEST_F(MjcfIncludes, FilesElsewhereAreRefused) {
  const std::string outside = WorkFolder().put("out.xml", "<mujocoinclude/>");
  std::filesystem::create_symlink("/etc/passwd", work_.path() / "link.xml");
  for (const std::string& file : {std::string("../x.xml"), std::string("/etc/passwd"), outside,
                                  std::string("a/../../x.xml"), std::string("link.xml")}) {
    EXPECT_THAT(read(including(file)).error().to_string(),
                HasSubstr("stands outside the model's folder"))
        << file;
  }
}

TEST_F(MjcfIncludes, CirclesAndCrowdsAreRefused) {
  work_.put("a.xml", "<mujocoinclude><include file=\"b.xml\"/></mujocoinclude>");
  work_.put("b.xml", "<mujocoinclude><include file=\"a.xml\"/></mujocoinclude>");
  EXPECT_EQ(read(including("a.xml")).error().to_string(),
            "line 1 of b.xml: includes 'a.xml' a second time; a model has each file once");
  std::string crowd = "<mujoco>";
  for (int i = 0; i < kMjcfMaxFiles; ++i) {
    work_.put(fmt::format("f{}.xml", i), "<mujocoinclude/>");
    crowd += fmt::format("<include file=\"f{}.xml\"/>", i);
  }
  EXPECT_THAT(read(crowd + "</mujoco>").error().to_string(), HasSubstr("more than 32 files"));
}

// A robot is converted to URDF, in which results keep it.
TEST(Mjcf, RobotIsTheSameAsUrdf) {
  for (const std::string& text : {research_mjcf(), makers_mjcf()}) {
    const Robot robot = parse_mjcf(text, "r.xml").value();
    const Robot again = parse_urdf(write_urdf(robot), "r.urdf").value();
    ASSERT_EQ(again.links.size(), robot.links.size());
    ASSERT_EQ(again.joints.size(), robot.joints.size());
    const std::vector<Transformd> places = robot_places(robot);
    const std::vector<Transformd> others = robot_places(again);
    for (const Robot::Joint& joint : robot.joints) {
      const auto same = [&](const Robot::Joint& other) { return other.name == joint.name; };
      const auto other = std::find_if(again.joints.begin(), again.joints.end(), same);
      ASSERT_NE(other, again.joints.end());
      EXPECT_EQ(std::tie(other->turns, other->moves, other->limited, other->lower, other->upper,
                         other->effort),
                std::tie(joint.turns, joint.moves, joint.limited, joint.lower, joint.upper,
                         joint.effort));
      expect_near(other->axis, joint.axis);
      const auto child = static_cast<std::size_t>(joint.child);
      const auto others_child = static_cast<std::size_t>(other->child);
      expect_near(others[others_child].translation, places[child].translation);
      expect_near(others[others_child].rotation, places[child].rotation);
      const Robot::Link& link = robot.links[child];
      const Robot::Link& others_link = again.links[others_child];
      EXPECT_EQ(others_link.name, link.name);
      EXPECT_EQ(others_link.mass, link.mass);
      EXPECT_EQ(others_link.com, link.com);
      expect_near(others_link.inertia, link.inertia);
      ASSERT_EQ(others_link.corners().size(), link.corners().size());
      for (std::size_t k = 0; k < link.corners().size(); ++k) {
        expect_near(others_link.corners()[k], link.corners()[k]);
      }
    }
  }
}

TEST(Mjcf, NamesWithSignsOfXmlGoThroughUrdf) {
  const Robot robot = read(two_bodies("<joint name=\"a&amp;b &lt;c&gt; &quot;d&quot; 'e'\"/>", "",
                                      "childclass=\"main\""));
  const Result<Robot> again = parse_urdf(write_urdf(robot), "r.urdf");
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->joints[0].name, "a_b _c_ _d_ _e_");
}

}  // namespace
}  // namespace shigusa
