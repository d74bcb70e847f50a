// SPDX-License-Identifier: MIT
// Ends of a robot's limbs: hands, feet and soles that no name or shape identifies.
#include <gmock/gmock.h>

#include <algorithm>

#include "core/index.hpp"
#include "formats/urdf.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "rig/humanoid_names.hpp"
#include "robot/robot.hpp"
#include "robot/settled_posture.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::HasSubstr;
using Bone = HumanoidBone;

constexpr std::array<const char*, 2> kSides{"left_", "right_"};

Robot small_robot(bool hands = true) {
  return parse_urdf(RobotFile(hands).text(), "small.urdf").value();
}

int link_called(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Robot::Link& link) { return link.name == name; });
  return found == robot.links.end() ? -1 : static_cast<int>(found - robot.links.begin());
}
Robot::Link& link_of(Robot& robot, const std::string& name) {
  return robot.links[index(link_called(robot, name))];
}
Robot::Joint& carrier_of(Robot& robot, const std::string& name) {
  const int link = link_called(robot, name);
  return *std::find_if(robot.joints.begin(), robot.joints.end(),
                       [&](const Robot::Joint& joint) { return joint.child == link; });
}

// Adds a link to another one, by a hinge about `axis`, or fixed where that is 0.
void add_link(Robot& robot, const std::string& name, const std::string& parent, const Vec3d& at,
              const Vec3d& axis = {}) {
  Robot::Joint joint{.name = name + "_joint",
                     .parent = link_called(robot, parent),
                     .child = static_cast<int>(robot.links.size()),
                     .origin = {Mat3d{}, at}};
  joint.turns = joint.moves = joint.limited = norm(axis) > 0.0;
  if (joint.turns) joint.axis = axis;
  joint.lower = -1.5;
  joint.upper = 1.5;
  joint.effort = 20.0;
  robot.links.emplace_back().name = name;
  robot.joints.push_back(std::move(joint));
}

// The robot without a link and its descendants.
Robot without(const Robot& robot, const std::string& name) {
  std::vector<int> place(robot.links.size(), -1);
  Robot rest = robot;
  rest.links.clear();
  rest.joints.clear();
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    int parent = -2;
    for (const Robot::Joint& joint : robot.joints) {
      if (joint.child == static_cast<int>(i)) parent = place[index(joint.parent)];
    }
    if (parent == -1 || robot.links[i].name == name) continue;
    place[i] = static_cast<int>(rest.links.size());
    rest.links.push_back(robot.links[i]);
  }
  for (Robot::Joint joint : robot.joints) {
    joint.parent = place[index(joint.parent)];
    joint.child = place[index(joint.child)];
    if (joint.parent >= 0 && joint.child >= 0) rest.joints.push_back(joint);
  }
  return rest;
}

PosedBody body_of(const Robot& robot) {
  return build_robot(robot, find_humanoid(robot).value()).value();
}

// Height of the ankle above the sole.
double ankle_height(const PosedBody& posed) { return -posed.body.feet()[0].outline[0].y; }

Vec3d hand_of(const Robot& robot, const char* side) {
  const std::vector<Transformd> places = robot_places(robot);
  return places[index(link_called(robot, side + std::string("hand")))].translation;
}

// Distances of the hands from the elbows, for a robot whose forearms have a box with these half
// sides, and with its centre that far down.
double length_of_forearm(const Vec3d& half, double down) {
  Robot robot = small_robot(false);
  for (const char* side : kSides) {
    link_of(robot, side + std::string("forearm")).collides = {
        {Robot::Shape::Kind::box, half, {Mat3d{}, {0, 0, -down}}}};
  }
  const Robot whole = with_hands(robot);
  EXPECT_NEAR(hand_of(whole, "left_").y, -hand_of(whole, "right_").y, 1e-9);
  const int elbow = link_called(whole, "left_forearm");
  return norm(hand_of(whole, "left_") - robot_places(whole)[index(elbow)].translation);
}

TEST(RobotEnds, AHandIsAtTheEndOfItsForearmsShape) {
  EXPECT_NEAR(length_of_forearm({0.03, 0.03, 0.12}, 0.1), 0.22, 1e-9);
  EXPECT_NEAR(length_of_forearm({0.03, 0.03, 0.12}, 0.03), 0.15, 1e-9);
}

// The shape of a motor about the elbow, or one that hardly reaches below it, does not give a
// forearm's end: that is twice as far as its centre of mass.
TEST(RobotEnds, AHandIsNeverNearerThanItsForearmsCentreOfMass) {
  EXPECT_NEAR(length_of_forearm({0.03, 0.03, 0.03}, 0.0), 0.2, 1e-9);
  EXPECT_NEAR(length_of_forearm({0.03, 0.03, 0.03}, 0.05), 0.2, 1e-9);
  EXPECT_NEAR(length_of_forearm({0.03, 0.03, 0.13}, 0.02), 0.2, 1e-9);
}

TEST(RobotEnds, AForearmOfWhichNothingIsKnownIsAsLongAsAPersons) {
  Robot robot = small_robot(false);
  for (const char* side : kSides) link_of(robot, side + std::string("forearm")).com = {};
  const Robot whole = with_hands(robot);
  EXPECT_NEAR(norm(hand_of(whole, "left_") -
                   robot_places(whole)[index(link_called(whole, "left_forearm"))].translation),
              0.157, 0.01);
}

TEST(RobotEnds, TheHandIsTheLastLinkOfAnArm) {
  Robot robot = small_robot(false);
  for (const char* side : kSides) {
    const std::string s = side;
    add_link(robot, s + "link_5", s + "forearm", {0, 0, -0.12}, {0, 0, 1});
    add_link(robot, s + "link_6", s + "link_5", {0, 0, -0.11}, {1, 0, 0});
    add_link(robot, s + "link_7", s + "link_6", {0, 0, -0.02}, {0, 1, 0});
  }
  const HumanoidMap map = find_humanoid(robot).value();
  EXPECT_EQ(robot.links[index(map[Bone::left_hand])].name, "left_link_6");
  const PosedBody posed = build_robot(robot, map).value();
  EXPECT_EQ(posed.body.effectors()[0].node, "right_link_7");
  EXPECT_TRUE(posed.body.find_dof("left_wrist.flexion"));
}

TEST(RobotEnds, AnAnkleBeginsAtTheFirstJointOfItsPlace) {
  Robot robot = small_robot();
  // only the names identify the second one
  for (const char* side : kSides) {
    link_of(robot, side + std::string("ankle")).name = side + std::string("link_5");
    link_of(robot, side + std::string("sole")).name = side + std::string("ankle");
  }
  const PosedBody posed = body_of(robot);
  EXPECT_TRUE(posed.body.find_dof("left_ankle.flexion"));
  EXPECT_TRUE(posed.body.find_dof("left_ankle.inversion"));
}

// The frame of the ankle's second joint is 1 cm below the first one; the foot is 0.2 by 0.1 by 0.04
// of even density, its bottom 6 cm below that.
TEST(RobotEnds, AFootsMassTellsItsSoleWhereShapesDoNot) {
  Robot robot = small_robot();
  for (const char* side : kSides) {
    Robot::Link& sole = link_of(robot, side + std::string("sole"));
    sole.collides.clear();
    sole.com = {0.03, 0, -0.04};
    const auto inertia = [&](double a, double b) { return sole.mass / 12.0 * (a * a + b * b); };
    sole.inertia = {
        {inertia(0.1, 0.04), 0, 0}, {0, inertia(0.2, 0.04), 0}, {0, 0, inertia(0.2, 0.1)}};
  }
  EXPECT_NEAR(ankle_height(body_of(robot)), 0.07, 1e-9);
  // a sensor is no sole, and a frame that is called so is one
  for (const char* side : kSides) {
    add_link(robot, side + std::string("foot_imu"), side + std::string("sole"), {0, 0, -0.02});
  }
  EXPECT_NEAR(ankle_height(body_of(robot)), 0.07, 1e-9);
  for (const char* side : kSides) {
    add_link(robot, side + std::string("contact"), side + std::string("sole"), {0, 0, -0.05});
  }
  EXPECT_NEAR(ankle_height(body_of(robot)), 0.06, 1e-9);
}

TEST(RobotEnds, LegsThatEndAtTheShankGetFeetAndAnkles) {
  Robot robot = without(without(small_robot(), "left_ankle"), "right_ankle");
  EXPECT_FALSE(find_humanoid(robot));
  robot = with_ends(robot, open_ends(robot));
  const HumanoidMap map = find_humanoid(robot).value();
  EXPECT_EQ(robot.links[index(map[Bone::left_foot])].name, "left_shank_end");
  const PosedBody posed = build_robot(with_ankles(robot, map), map).value();
  EXPECT_TRUE(posed.body.find_dof("left_ankle.flexion"));
  EXPECT_THAT(robot.doubts, Contains(HasSubstr("nothing follows link 'left_shank'")));
}

// In an arm of three joints, the last link is a forearm if it is as long as one.
TEST(RobotEnds, ALastLinkAsLongAsAForearmIsNoHand) {
  Robot robot = small_robot(false);
  for (const char* side : kSides) {
    const std::string s = side;
    link_of(robot, s + "shoulder_1").name = s + "sho_pitch";
    link_of(robot, s + "shoulder_2").name = s + "sho_roll";
    link_of(robot, s + "upper_arm").name = s + "sho_yaw";
    link_of(robot, s + "forearm").name = s + "el";
  }
  const HumanoidMap first = find_humanoid(robot).value();
  EXPECT_EQ(robot.links[index(first[Bone::left_hand])].name, "left_el");
  const std::vector<int> forearms = forearms_for_hands(robot, first);
  ASSERT_EQ(forearms.size(), 2u);
  robot = with_ends(robot, forearms);
  const HumanoidMap map = find_humanoid(robot).value();
  EXPECT_EQ(robot.links[index(map[Bone::left_lower_arm])].name, "left_el");
  EXPECT_EQ(robot.links[index(map[Bone::left_hand])].name, "left_el_end");
}

TEST(RobotEnds, CamerasAndSensorsAreNoPartsOfABody) {
  for (const char* name : {"imu_link", "head_camera_link", "left_foot_imu", "lidar_link",
                           "torso_realsense", "left_hand_sensor"}) {
    EXPECT_EQ(read_bone_name(name).part, BonePart::ornament) << name;
  }
}

TEST(RobotEnds, ACameraAboveTheTrunkIsNoHead) {
  Robot robot = without(small_robot(), "head");
  add_link(robot, "imu_link", "torso", {0, 0, 0.5});
  add_link(robot, "mast", "torso", {0, 0, 0.4});
  add_link(robot, "camera_link", "mast", {0.05, 0, 0.1});
  const HumanoidMap map = find_humanoid(robot).value();
  EXPECT_NE(map[Bone::head], link_called(robot, "imu_link"));
  EXPECT_NE(map[Bone::head], link_called(robot, "camera_link"));
}

TEST(RobotEnds, NumberedLegsAndArmsTellTheirSides) {
  for (const auto& [name, part, side] : {std::tuple("LLEG_LINK3", BonePart::leg, NameSide::left),
                                         std::tuple("RLEG_LINK3", BonePart::leg, NameSide::right),
                                         std::tuple("LARM_LINK0", BonePart::arm, NameSide::left)}) {
    EXPECT_EQ(read_bone_name(name).part, part) << name;
    EXPECT_EQ(read_bone_name(name).side, side) << name;
  }
  EXPECT_EQ(read_bone_name("l_foot_toe").part, BonePart::toes);
  EXPECT_EQ(read_bone_name("l_foot_heel").part, BonePart::heel);
}

// Positions of the hands at the start, relative to the middle of the shoulders (m).
Vec3d left_hand_at_start(PosedBody posed) {
  settle(posed);
  const Kinematics<double> kinematics = home_kinematics(posed);
  const Effector& hand = posed.body.effectors()[1];
  return kinematics.point(hand.link, hand.point) - kinematics.origin[index(hand.limb_root)];
}

TEST(RobotEnds, ArmsThatStartAheadOrUpHang) {
  for (const double pitch : {-90.0, -150.0, 90.0}) {
    Robot robot = small_robot();
    for (const char* side : kSides) {
      Robot::Joint& shoulder = carrier_of(robot, side + std::string("shoulder_1"));
      const SinCos<double> turn = sin_cos(radians(pitch));
      // the zero of the shoulder's pitch turns with the arm
      shoulder.origin.rotation =
          Mat3d{{turn.cos, 0, -turn.sin}, {0, 1, 0}, {turn.sin, 0, turn.cos}};
      carrier_of(robot, side + std::string("shoulder_2")).origin.rotation = Mat3d{};
      shoulder.lower = -3.0;
      shoulder.upper = 3.0;
    }
    const Vec3d hand = left_hand_at_start(body_of(robot));
    EXPECT_LT(hand.y, -0.3) << pitch;
    EXPECT_LT(abs(hand.z), 0.15) << pitch;
  }
}

// The robot with elbows that can be straight and, where all angles are 0, bend `aside` (rad) from
// ahead, each to its own side. Upper arms can turn as far that way and back.
Robot with_elbows_aside(double aside) {
  Robot robot = small_robot();
  for (const char* side : kSides) {
    const double turned = side[0] == 'l' ? aside : -aside;
    const SinCos<double> turn = sin_cos(turned);
    Robot::Joint& yaw = carrier_of(robot, side + std::string("upper_arm"));
    yaw.origin.rotation = Mat3d{{turn.cos, turn.sin, 0}, {-turn.sin, turn.cos, 0}, {0, 0, 1}};
    yaw.lower = min(0.0, -turned) - 0.1;
    yaw.upper = max(0.0, -turned) + 0.1;
    carrier_of(robot, side + std::string("forearm")).upper = 0.0;
  }
  return robot;
}

TEST(RobotEnds, ElbowsOfHangingArmsBendAhead) {
  for (const double degrees : {90.0, -60.0, 120.0}) {
    PosedBody posed = body_of(with_elbows_aside(radians(degrees)));
    settle(posed);
    const Kinematics<double> kinematics = home_kinematics(posed);
    for (const char* side : kSides) {
      const int elbow = posed.body.find_dof(side + std::string("elbow.flexion")).value();
      EXPECT_LT(kinematics.axis[index(elbow)].x, -0.9) << side << degrees;
      EXPECT_NEAR(posed.home.angles[index(elbow)], kStandingElbow, 1e-9) << side << degrees;
    }
  }
  // an elbow that bends ahead by itself stays as it is
  PosedBody ahead = body_of(with_elbows_aside(radians(10.0)));
  settle(ahead);
  EXPECT_EQ(ahead.home.angles[index(*ahead.body.find_dof("left_elbow.flexion"))], 0.0);
}

}  // namespace
}  // namespace shigusa
