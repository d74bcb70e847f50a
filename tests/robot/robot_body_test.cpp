// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "body/anthropometry.hpp"
#include "formats/urdf.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "robot/robot.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

Robot small_robot() { return parse_urdf(RobotFile().text(), "small.urdf").value(); }

PosedBody small_body() {
  const Robot robot = small_robot();
  return build_robot(robot, find_humanoid(robot).value()).value();
}

const Dof& dof(const PosedBody& posed, const std::string& name) {
  return posed.body.dof(posed.body.find_dof(name).value());
}

Kinematics<double> placed(const PosedBody& posed, const std::vector<double>& q) {
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, q, kinematics);
  return kinematics;
}

// Displacement of a node when one dof turns by a small angle.
Vec3d way_of(const PosedBody& posed, const std::string& node, const std::string& freedom,
             double angle) {
  const auto found = std::find_if(posed.body.nodes().begin(), posed.body.nodes().end(),
                                  [&](const BodyNode& n) { return n.name == node; });
  EXPECT_NE(found, posed.body.nodes().end()) << node;
  std::vector<double> q(posed.body.dofs().size(), 0.0);
  const Vec3d before = placed(posed, q).point(found->link, found->point);
  q[static_cast<std::size_t>(posed.body.find_dof(freedom).value())] = angle;
  return placed(posed, q).point(found->link, found->point) - before;
}

TEST(RobotBody, FindsTheBonesByTheNamesOfLinks) {
  const Robot robot = small_robot();
  const HumanoidMap map = find_humanoid(robot).value();
  const auto name = [&](HumanoidBone bone) {
    return robot.links[static_cast<std::size_t>(map[bone])].name;
  };
  EXPECT_EQ(name(HumanoidBone::hips), "pelvis");
  EXPECT_EQ(name(HumanoidBone::right_lower_leg), "right_shank");
  EXPECT_EQ(name(HumanoidBone::left_lower_arm), "left_forearm");
}

TEST(RobotBody, FreedomsAreNamedAsAPersons) {
  const PosedBody posed = small_body();
  EXPECT_EQ(posed.body.dof_count(), 25);
  for (const char* side : {"left_", "right_"}) {
    for (const char* name :
         {"hip.flexion", "hip.abduction", "hip.rotation", "knee.flexion", "ankle.flexion",
          "ankle.inversion", "shoulder.flexion", "shoulder.abduction", "shoulder.rotation",
          "elbow.flexion", "elbow.rotation"}) {
      EXPECT_TRUE(posed.body.find_dof(std::string(side) + name)) << side << name;
    }
  }
  EXPECT_TRUE(posed.body.find_dof("spine.rotation"));
  EXPECT_TRUE(posed.body.find_dof("spine.flexion"));
  EXPECT_TRUE(posed.body.find_dof("neck.rotation"));
}

TEST(RobotBody, PositiveAnglesAreTheAnatomicalOnes) {
  const PosedBody posed = small_body();
  // the pelvis stands on the right foot, so the left leg is the one that swings
  EXPECT_LT(way_of(posed, "left_foot", "left_knee.flexion", 0.3).z, -0.05);
  EXPECT_GT(way_of(posed, "left_lower_leg", "left_hip.flexion", 0.3).z, 0.05);
  EXPECT_GT(way_of(posed, "left_lower_leg", "left_hip.abduction", 0.3).x, 0.05);
  EXPECT_GT(way_of(posed, "left_palm", "left_elbow.flexion", 0.3).z, 0.05);
  EXPECT_GT(way_of(posed, "right_palm", "right_shoulder.flexion", 0.3).z, 0.05);
  EXPECT_LT(way_of(posed, "right_palm", "right_shoulder.abduction", 0.3).x, -0.05);
  EXPECT_GT(way_of(posed, "head", "spine.flexion", 0.3).z, 0.05);
  // of the standing leg the pelvis moves: it goes backwards and down when the knee bends
  EXPECT_LT(way_of(posed, "hips", "right_knee.flexion", 0.3).y, 0.0);
  EXPECT_GT(way_of(posed, "hips", "right_ankle.flexion", 0.3).z, 0.05);
}

TEST(RobotBody, LimitsAreTheFilesInTheFreedomsSense) {
  const PosedBody posed = small_body();
  // the file's knee bends by negative angles
  EXPECT_EQ(dof(posed, "right_knee.flexion").lower, 0.0);
  EXPECT_EQ(dof(posed, "right_knee.flexion").upper, 2.3);
  EXPECT_EQ(dof(posed, "right_elbow.flexion").lower, 0.2);
  EXPECT_EQ(dof(posed, "right_elbow.flexion").torque_positive, 30.0);
  // a continuous one gets a person's
  EXPECT_NEAR(dof(posed, "right_elbow.rotation").upper, radians(80.0), 1e-12);
}

TEST(RobotBody, StartsWithinLimits) {
  const PosedBody posed = small_body();
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    const double start = posed.home.angles[static_cast<std::size_t>(d)];
    EXPECT_GE(start, posed.body.dof(d).lower);
    EXPECT_LE(start, posed.body.dof(d).upper);
  }
}

TEST(RobotBody, StandsOnItsSoles) {
  const PosedBody posed = small_body();
  ASSERT_EQ(posed.body.feet().size(), 2u);
  EXPECT_EQ(posed.body.feet()[0].node, "right_sole");
  EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
  const Kinematics<double> kinematics = placed(posed, std::vector<double>(25, 0.0));
  for (const Foot& foot : posed.body.feet()) {
    for (const Vec3d& corner : foot.outline) {
      EXPECT_NEAR(kinematics.point(foot.link, corner).y, 0.0, 1e-9);
    }
    // the box is 0.2 by 0.1
    EXPECT_NEAR(norm(foot.outline[0] - foot.outline[1]), 0.2, 1e-9);
    EXPECT_NEAR(norm(foot.outline[1] - foot.outline[2]), 0.1, 1e-9);
  }
}

// The small robot with other shapes for its soles.
PosedBody with_soles(const std::string& shapes) {
  std::string text = RobotFile().text();
  const std::string box =
      "<collision><origin xyz=\"0.03 0 -0.04\"/><geometry><box size=\"0.2 0.1 0.02\"/>"
      "</geometry></collision>";
  for (std::size_t at = text.find(box); at != text.npos; at = text.find(box, at + 1)) {
    text.replace(at, box.size(), shapes);
  }
  const Robot robot = parse_urdf(text, "small.urdf").value();
  return build_robot(robot, find_humanoid(robot).value()).value();
}

std::string shape(const char* geometry, const char* xyz, const char* rpy = "0 0 0") {
  return fmt::format(
      "<collision><origin xyz=\"{}\" rpy=\"{}\"/><geometry>{}</geometry></collision>", xyz, rpy,
      geometry);
}

// Height above the sole of the foot's frame, at the ankle's first joint.
double ankle_height(const PosedBody& posed) { return -posed.body.feet()[0].outline[0].y; }

// Shapes on one line, or with a single one on the floor, leave no area.
TEST(RobotBody, SoleIsWhereShapesEnd) {
  const std::string line = shape("<sphere radius=\"0.01\"/>", "0.1 0 -0.08") +
                           shape("<sphere radius=\"0.01\"/>", "-0.05 0 -0.08");
  const std::string rocker = shape("<box size=\"0.2 0.1 0.02\"/>", "0.03 0 -0.06") +
                             shape("<sphere radius=\"0.01\"/>", "0.03 0 -0.08");
  const std::string capsule =
      shape("<capsule radius=\"0.02\" length=\"0.2\"/>", "0.03 0 -0.07", "0 1.5707963 0");
  for (const std::string& shapes : {line, rocker, capsule}) {
    EXPECT_NEAR(ankle_height(with_soles(shapes)), 0.10, 1e-6) << shapes;
  }
  // an area is the feet's own where shapes have one
  const PosedBody posed = with_soles(rocker);
  EXPECT_NEAR(norm(posed.body.feet()[0].outline[0] - posed.body.feet()[0].outline[1]), 0.2, 1e-9);
}

TEST(RobotBody, ArmThatEndsAtItsElbowHasAHandWithADoubt) {
  const Robot robot = with_hands(parse_urdf(RobotFile(false).text(), "small.urdf").value());
  const PosedBody posed = build_robot(robot, find_humanoid(robot).value()).value();
  EXPECT_EQ(posed.body.effectors()[1].name, "left_hand");
  EXPECT_TRUE(posed.body.find_dof("left_elbow.flexion"));
  EXPECT_TRUE(posed.body.find_dof("left_shoulder.rotation"));
  EXPECT_THAT(posed.doubts, testing::Contains(testing::HasSubstr(
                                "link 'left_forearm' ends its arm: the hand is taken to be 0.20 m "
                                "on, twice as far as its centre of mass")));
}

TEST(RobotBody, FramesOnAFootTellNothingOfItsFacing) {
  std::string text = RobotFile().text();
  text.replace(text.find("</robot>"), 8,
               "<joint name=\"c\" type=\"fixed\"><parent link=\"left_sole\"/><child link=\"c\"/>"
               "<origin xyz=\"-0.3 0 0\"/></joint><link name=\"c\"/></robot>");
  const Robot robot = parse_urdf(text, "small.urdf").value();
  EXPECT_THAT(find_humanoid(robot).value().doubts,
              testing::Not(testing::Contains(testing::HasSubstr("backwards"))));
}

TEST(RobotBody, HandsEndAtThePalmsFrame) {
  const PosedBody posed = small_body();
  ASSERT_EQ(posed.body.effectors().size(), 2u);
  EXPECT_EQ(posed.body.effectors()[0].name, "right_hand");
  EXPECT_EQ(posed.body.effectors()[0].node, "right_palm");
}

TEST(RobotBody, FingersAreBentAsLittleAsTheirLimitsAllow) {
  const PosedBody posed = small_body();
  const auto& joints = posed.robot->joints;
  const auto finger = std::find_if(joints.begin(), joints.end(), [](const RobotJoint& joint) {
    return joint.name == "left_finger";
  });
  ASSERT_NE(finger, joints.end());
  EXPECT_EQ(finger->dof, -1);
  EXPECT_EQ(finger->angle, 0.1);
}

TEST(RobotBody, WeighsWhatItsLinksWeigh) {
  const Robot robot = small_robot();
  double mass = 0.0;
  for (const Robot::Link& link : robot.links) mass += link.mass;
  EXPECT_NEAR(small_body().body.mass(), mass, 1e-9);
}

TEST(RobotBody, MassThatIsSpreadLiesAlongTheLimb) {
  Robot robot = small_robot();
  for (Robot::Link& link : robot.links) link.mass = 0.0;
  const PosedBody posed = build_robot(robot, find_humanoid(robot).value(), 50.0).value();
  const auto expect_rod = [&](int link, const SegmentParameters& part, const Vec3d& from,
                              const Vec3d& to) {
    const MassProperties& rod = posed.body.link_mass(link);
    const auto square = [&](double gyration) {
      return rod.mass * gyration * gyration * dot(to - from, to - from);
    };
    EXPECT_LT(norm(rod.com - (from + (to - from) * part.com)), 1e-12);
    const Vec3d along = normalized(to - from);
    const double about = dot(along, rod.inertia * along);
    EXPECT_NEAR(about, square(part.r_long), 1e-12);
    const double trace = rod.inertia.cx.x + rod.inertia.cy.y + rod.inertia.cz.z;
    EXPECT_NEAR(trace - about, 2.0 * square(0.5 * (part.r_sagittal + part.r_transverse)), 1e-12);
  };
  const SegmentTable& table = segment_table(Sex::male);
  const Foot& foot = posed.body.feet()[1];
  expect_rod(foot.link, table.foot, (foot.outline[1] + foot.outline[2]) * 0.5,
             (foot.outline[0] + foot.outline[3]) * 0.5);
  const int knee = posed.body.find_dof("left_knee.flexion").value();
  const Kinematics<double> start = placed(posed, std::vector<double>(25, 0.0));
  const int ankle = posed.body.find_dof("left_ankle.flexion").value();
  expect_rod(knee, table.shank, {},
             transpose_times(start.link_rotation(knee),
                             start.link_origin(ankle) - start.link_origin(knee)));
}

TEST(RobotBody, SkeletonOfItsNodesMovesAsItDoes) {
  const PosedBody posed = small_body();
  Clip clip;
  clip.dofs = posed.body.dof_count();
  clip.frames = 1;
  for (int d = 0; d < clip.dofs; ++d) {
    clip.angles.push_back(0.5 * (posed.body.dof(d).lower + posed.body.dof(d).upper) + 0.01 * d);
  }
  const SkeletonMotion motion = skeleton_motion(posed, clip);
  const std::vector<Transformd> world = world_transforms(motion.skeleton, motion.clip, 0);
  const Kinematics<double> kinematics = placed(posed, clip.angles);
  for (std::size_t i = 0; i < world.size(); ++i) {
    const BodyNode& node = posed.body.nodes()[i];
    EXPECT_LT(norm(world[i].translation - kinematics.point(node.link, node.point)), 1e-9)
        << node.name;
  }
}

TEST(RobotBody, SlantingAxisTurnsAboutItself) {
  const PosedBody posed = small_body();
  int slanting = 0;
  std::vector<double> q(posed.body.dofs().size(), 0.2);
  const Kinematics<double> before = placed(posed, q);
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    if (!posed.body.dof(d).turn) continue;
    ++slanting;
    const auto k = static_cast<std::size_t>(d);
    constexpr double kStep = 0.3;
    std::vector<double> turned = q;
    turned[k] += kStep;
    const Kinematics<double> after = placed(posed, turned);
    const Mat3d turn = after.rotation[k] * transpose(before.rotation[k]);
    EXPECT_LT(norm(rotation_vector(turn) - before.axis[k] * kStep), 1e-12)
        << posed.body.dof(d).name;
  }
  EXPECT_EQ(slanting, 4);
}

TEST(RobotBody, NeedsTurningKnees) {
  std::string text = RobotFile().text();
  const std::size_t at = text.find("revolute", text.find("left_knee"));
  text.replace(at, 8, "fixed");
  const Robot robot = parse_urdf(text, "r.urdf").value();
  const Result<PosedBody> posed = build_robot(robot, find_humanoid(robot).value());
  ASSERT_FALSE(posed);
  EXPECT_THAT(posed.error().message, testing::HasSubstr("left_knee"));
}

TEST(RobotBody, TrunkThatHangsOnALegIsRefused) {
  std::string text = RobotFile().text();
  const std::string parent = "parent link=\"pelvis\"";
  text.replace(text.find(parent, text.find("waist_yaw")), parent.size(),
               "parent link=\"left_thigh\"");
  const Robot robot = parse_urdf(text, "r.urdf").value();
  const Result<PosedBody> posed = build_robot(robot, find_humanoid(robot).value());
  ASSERT_FALSE(posed);
  EXPECT_EQ(posed.error().code, ErrorCode::unsupported);
  EXPECT_THAT(posed.error().message, testing::HasSubstr("is part of the left leg and of the"));
}

TEST(RobotBody, RobotsWithoutLimbsAreNone) {
  const Robot robot = parse_urdf("<robot name=\"r\"><link name=\"a\"/></robot>", "r.urdf").value();
  EXPECT_FALSE(find_humanoid(robot));
}

}  // namespace
}  // namespace shigusa
