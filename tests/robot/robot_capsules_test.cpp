// SPDX-License-Identifier: MIT
// A robot's colliding parts: from its file's shapes, else as a person's.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "body/anthropometry.hpp"
#include "body/capsules.hpp"
#include "formats/mjcf.hpp"
#include "formats/urdf.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "robot/robot.hpp"
#include "robot/shape_points.hpp"
#include "support/mjcf_file.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

BodyModel body_of(const Robot& robot) {
  return build_robot(robot, find_humanoid(robot).value()).value();
}
BodyModel urdf_body(const std::string& text) {
  return body_of(parse_urdf(text, "small.urdf").value());
}

// The small robot's text with additions to the links of that name, on both sides.
std::string with_shapes(const std::string& link, const std::string& shapes,
                        std::string text = RobotFile().text()) {
  for (const char* side : {"left_", "right_"}) {
    const std::string tag = "<link name=\"" + (side + link) + "\">";
    text.insert(text.find(tag) + tag.size(), shapes);
  }
  return text;
}

std::string shape(const char* use, const std::string& geometry, const char* xyz,
                  const char* rpy = "0 0 0") {
  return fmt::format("<{0}><origin xyz=\"{2}\" rpy=\"{3}\"/><geometry>{1}</geometry></{0}>", use,
                     geometry, xyz, rpy);
}

std::string cylinder(double radius, double length) {
  return fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", radius, length);
}

std::vector<Capsule> capsules(const BodyModel& body, const std::string& name) {
  std::vector<Capsule> found;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.name == name) found.push_back(capsule);
  }
  return found;
}

// Thickness of a part at its middle; for a flat part, of either line.
double radius_of(const BodyModel& body, const std::string& name) {
  const std::vector<Capsule> found = capsules(body, name);
  EXPECT_FALSE(found.empty()) << name;
  return found.empty() ? 0.0 : 0.5 * (found[0].radius + found[0].to_radius);
}

double persons(const BodyModel& body, double share) { return share * body.stature(); }

TEST(RobotCapsules, EveryPartHasOne) {
  const BodyModel body = urdf_body(RobotFile().text());
  std::vector<std::string> names;
  for (const Capsule& capsule : body.capsules()) names.push_back(capsule.name);
  for (const char* one : {"pelvis", "spine", "neck", "head", "jaw"}) {
    EXPECT_THAT(names, testing::Contains(one));
  }
  for (const char* side : {"left_", "right_"}) {
    for (const char* part : {"thigh", "shank", "foot", "upper_arm", "forearm", "hand"}) {
      EXPECT_THAT(names, testing::Contains(side + std::string(part)));
    }
  }
}

TEST(RobotCapsules, LieAlongTheLimbsInAnyPosture) {
  const BodyModel body = urdf_body(RobotFile().text());
  std::vector<double> q(body.dofs().size(), 0.0);
  for (std::size_t d = 0; d < q.size(); ++d) q[d] = 0.3 * body.dofs()[d].upper;
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, q, kinematics);
  const auto node = [&](const std::string& name) {
    const auto found = std::find_if(body.nodes().begin(), body.nodes().end(),
                                    [&](const BodyNode& n) { return n.name == name; });
    return kinematics.point(found->link, found->point);
  };
  for (const std::string side : {"left_", "right_"}) {
    for (const auto& [part, from, to] :
         {std::tuple("thigh", "upper_leg", "lower_leg"), std::tuple("shank", "lower_leg", "foot"),
          std::tuple("forearm", "lower_arm", "wrist")}) {
      const Capsule line = capsules(body, side + part).at(0);
      const SegmentPair far = nearest_points(
          kinematics.point(line.link, line.from), kinematics.point(line.link, line.to),
          (node(side + from) + node(side + to)) * 0.5, (node(side + from) + node(side + to)) * 0.5);
      EXPECT_LT(norm(far.on_a - far.on_b), 0.02) << side << part;
    }
  }
}

TEST(RobotCapsules, WithoutShapesAreAsAPersons) {
  const BodyModel body = urdf_body(RobotFile().text());
  EXPECT_NEAR(radius_of(body, "left_forearm"), persons(body, kForearmRadius), 1e-12);
  EXPECT_NEAR(radius_of(body, "right_upper_arm"), persons(body, kUpperArmRadius), 1e-12);
  EXPECT_NEAR(radius_of(body, "right_shank"), persons(body, kShankRadius), 1e-12);
  EXPECT_NEAR(radius_of(body, "pelvis"), persons(body, kTrunkRadius), 1e-12);
}

TEST(RobotCapsules, AreAsThickAsTheShapesThatCollide) {
  const BodyModel straight =
      urdf_body(with_shapes("forearm", shape("collision", cylinder(0.047, 0.2), "0 0 -0.1")));
  EXPECT_NEAR(radius_of(straight, "left_forearm"), 0.047, 0.002);
  // the same in a frame of its own: z of the cylinder is x of the shape, turned down
  const BodyModel turned = urdf_body(with_shapes(
      "shank", shape("collision", cylinder(0.061, 0.3), "0 0 -0.15", "3.14159265 0 0")));
  EXPECT_NEAR(radius_of(turned, "left_shank"), 0.061, 0.002);
  EXPECT_NEAR(radius_of(turned, "right_shank"), 0.061, 0.002);
}

TEST(RobotCapsules, ABoxIsBetweenItsSidesAndItsEdges) {
  for (const auto& [size, rpy] :
       {std::pair("0.08 0.08 0.2", "0 0 0"), std::pair("0.2 0.08 0.08", "0 1.5707963 0"),
        std::pair("0.08 0.08 0.2", "0 0 0.4")}) {
    const BodyModel body = urdf_body(with_shapes(
        "forearm", shape("collision", fmt::format("<box size=\"{}\"/>", size), "0 0 -0.1", rpy)));
    EXPECT_GT(radius_of(body, "right_forearm"), 0.04) << size << rpy;
    EXPECT_LT(radius_of(body, "right_forearm"), 0.04 * sqrt(2.0)) << size << rpy;
  }
}

// Two halves, end to end, and a lid between them.
TEST(RobotCapsules, ShapesOfOneLinkCountTogether) {
  const BodyModel body = urdf_body(
      with_shapes("thigh", shape("collision", cylinder(0.07, 0.15), "0 0 -0.075") +
                               shape("collision", cylinder(0.05, 0.15), "0 0 -0.225") +
                               shape("collision", "<sphere radius=\"0.03\"/>", "0 0 -0.15")));
  const Capsule thigh = capsules(body, "left_thigh").at(0);
  const double thick = max(thigh.radius, thigh.to_radius);
  const double thin = min(thigh.radius, thigh.to_radius);
  EXPECT_GT(thick, 0.06);
  EXPECT_LT(thin, 0.06);
}

TEST(RobotCapsules, WhereNothingCollidesTheLooksTell) {
  const std::string seen = shape("visual", cylinder(0.05, 0.2), "0 0 -0.1");
  EXPECT_NEAR(radius_of(urdf_body(with_shapes("forearm", seen)), "left_forearm"), 0.05, 0.002);
  const std::string mesh = shape("collision", "<mesh filename=\"a.stl\"/>", "0 0 0");
  EXPECT_NEAR(radius_of(urdf_body(with_shapes("forearm", seen + mesh)), "left_forearm"), 0.05,
              0.002);
  const std::string slim = shape("collision", cylinder(0.03, 0.2), "0 0 -0.1");
  EXPECT_NEAR(radius_of(urdf_body(with_shapes("forearm", seen + slim)), "left_forearm"), 0.03,
              0.002);
}

TEST(RobotCapsules, LooksThatAreWrongRefuseNothing) {
  for (const char* wrong : {"<sphere/>", "<box size=\"1 2\"/>", "<sphere radius=\"1e30\"/>",
                            "<cylinder radius=\"a\" length=\"1\"/>", "<sphere radius=\"-1\"/>"}) {
    const BodyModel body = urdf_body(with_shapes("forearm", shape("visual", wrong, "0 0 0")));
    EXPECT_NEAR(radius_of(body, "left_forearm"), persons(body, kForearmRadius), 1e-12) << wrong;
  }
}

// A motor at one end, or a ball that represents the whole robot.
TEST(RobotCapsules, ShapesOfSomethingElseTellNothing) {
  for (const std::string& other : {shape("collision", "<sphere radius=\"0.035\"/>", "0 0 0"),
                                   shape("collision", cylinder(0.02, 0.07), "0 0 -0.19"),
                                   shape("collision", cylinder(1.0, 1.0), "0 0 -0.1"),
                                   shape("collision", "<sphere radius=\"0\"/>", "0 0 -0.1")}) {
    const BodyModel body = urdf_body(with_shapes("forearm", other));
    EXPECT_NEAR(radius_of(body, "left_forearm"), persons(body, kForearmRadius), 1e-12) << other;
  }
}

TEST(RobotCapsules, AHandGoesOnAsFarAsItsShapes) {
  const auto end_of = [](const BodyModel& body) {
    const Capsule hand = capsules(body, "right_hand").at(0);
    return max(norm(hand.from), norm(hand.to)) + hand.to_radius;
  };
  const BodyModel plain = urdf_body(RobotFile().text());
  const BodyModel fist = urdf_body(
      with_shapes("wrist", shape("collision", "<box size=\"0.05 0.06 0.16\"/>", "0 0 -0.08")));
  // along the way to the palm, which is a little aside
  EXPECT_NEAR(end_of(fist), 0.16, 0.02);
  EXPECT_GT(end_of(fist), end_of(plain) + 0.04);
}

TEST(RobotCapsules, ScaleWithTheRobot) {
  Robot robot = parse_urdf(RobotFile().text(), "small.urdf").value();
  const BodyModel body = body_of(robot);
  for (Robot::Joint& joint : robot.joints) {
    joint.origin.translation = joint.origin.translation * 0.25;
  }
  for (Robot::Link& link : robot.links) {
    link.com = link.com * 0.25;
    for (Robot::Shape& shape : link.collides) {
      shape.half = shape.half * 0.25;
      shape.place.translation = shape.place.translation * 0.25;
    }
  }
  const BodyModel small = body_of(robot);
  ASSERT_EQ(small.capsules().size(), body.capsules().size());
  for (std::size_t c = 0; c < body.capsules().size(); ++c) {
    EXPECT_NEAR(small.capsules()[c].radius, 0.25 * body.capsules()[c].radius, 1e-9)
        << body.capsules()[c].name;
  }
}

TEST(RobotCapsules, OfMjcfAreItsGeoms) {
  const Robot robot = parse_mjcf(research_mjcf(), "r.xml").value();
  // as results keep it
  for (const Robot& each : {robot, parse_urdf(write_urdf(robot), "r.urdf").value()}) {
    const BodyModel body = body_of(each);
    EXPECT_NEAR(radius_of(body, "left_upper_arm"), 0.04, 0.002);
    EXPECT_NEAR(radius_of(body, "right_forearm"), 0.03, 0.002);
    EXPECT_NEAR(radius_of(body, "left_thigh"), 0.06, 0.002);
    EXPECT_NEAR(radius_of(body, "right_shank"), 0.049, 0.002);
    EXPECT_NEAR(radius_of(body, "head"), 0.09, 0.005);
    // the chest is the root, and the pelvis hangs on it
    EXPECT_NEAR(radius_of(body, "pelvis"), 0.09, 0.005);
    EXPECT_NEAR(radius_of(body, "chest"), 0.07, 0.005);
  }
}

TEST(RobotCapsules, OfMjcfGeomsThatCollideWithNothingTellWhereNoOtherDoes) {
  std::string text = research_mjcf();
  const std::string arm = "fromto=\"0.01 -0.01 0.01 0.17 -0.17 0.17\" size=\"0.03\"";
  const std::size_t at = text.find(arm);
  ASSERT_NE(at, text.npos);
  text.insert(at, "contype=\"0\" conaffinity=\"0\" ");
  const Robot robot = parse_mjcf(text, "r.xml").value();
  const auto link = std::find_if(robot.links.begin(), robot.links.end(),
                                 [](const auto& l) { return l.name == "left_lower_arm"; });
  ASSERT_NE(link, robot.links.end());
  EXPECT_TRUE(link->collides.empty());
  EXPECT_EQ(link->shown.size(), 1u);
  EXPECT_NEAR(radius_of(body_of(robot), "left_forearm"), 0.03, 0.002);
}

TEST(SurfacePoints, LieOnTheShapeAndAreNeverTooMany) {
  using Kind = Robot::Shape::Kind;
  constexpr int kMost = 24;
  for (const Kind kind : {Kind::box, Kind::cylinder, Kind::ball}) {
    const Robot::Shape one{kind, {0.5, 0.5, 0.5}, {}};
    for (const Vec3d& p : surface_points(one, 0.05, kMost)) {
      const double round = sqrt(p.x * p.x + p.y * p.y);
      const double off = kind == Kind::ball       ? norm(p)
                         : kind == Kind::cylinder ? max(round, abs(p.z))
                                                  : max(max(abs(p.x), abs(p.y)), abs(p.z));
      EXPECT_NEAR(off, 0.5, 1e-12);
    }
    for (const double apart : {1e-9, 1e-300, 0.01, 100.0}) {
      const std::size_t count = surface_points(one, apart, kMost).size();
      EXPECT_GE(count, 12u);
      EXPECT_LE(count, 6u * kMost * kMost);
    }
  }
  EXPECT_TRUE(surface_points({Kind::box, {0.5, 0.0, 0.5}, {}}, 0.05, kMost).empty());
}

}  // namespace
}  // namespace shigusa
