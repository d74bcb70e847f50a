// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "body/anthropometry.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

std::vector<std::string> dof_names(const PosedBody& posed) {
  std::vector<std::string> names;
  for (const Dof& dof : posed.body.dofs()) names.push_back(dof.name);
  return names;
}

TEST(HalfBody, HasThePapersNineDofs) {
  EXPECT_EQ(dof_names(half_body()),
            (std::vector<std::string>{
                "right_ankle.flexion", "right_knee.flexion", "right_hip.rotation",
                "right_hip.abduction", "right_hip.flexion", "right_shoulder.flexion",
                "right_shoulder.abduction", "right_shoulder.rotation", "right_elbow.flexion"}));
}

TEST(FullBody, HasTwiceTheHalfBodysDofs) {
  const std::vector<std::string> names = dof_names(full_body());
  EXPECT_EQ(names.size(), 18u);
  for (const std::string& name : dof_names(half_body())) {
    const std::string left = "left" + name.substr(5);
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), left), 1) << left;
  }
}

TEST(HalfBody, ReachesWithTheRightHand) {
  const PosedBody posed = half_body();
  ASSERT_EQ(posed.body.effectors().size(), 1u);
  EXPECT_EQ(posed.body.effectors()[0].name, "right_hand");
  EXPECT_EQ(posed.body.effectors()[0].limb_root, posed.body.find_dof("right_shoulder.flexion"));
  ASSERT_EQ(posed.body.feet().size(), 1u);
  EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
}

TEST(FullBody, ReachesWithBothHandsOnBothFeet) {
  const PosedBody posed = full_body();
  EXPECT_TRUE(posed.body.find_effector("right_hand") && posed.body.find_effector("left_hand"));
  ASSERT_EQ(posed.body.feet().size(), 2u);
  EXPECT_EQ(posed.body.feet()[0].name, "right_foot");
  EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
  EXPECT_EQ(posed.body.feet()[1].name, "left_foot");
  EXPECT_EQ(posed.body.feet()[1].link, posed.body.find_dof("left_ankle.flexion"));
}

TEST(HumanBody, TrunkCapsuleReachesFromTheHipsToTheShoulders) {
  const Landmarks person = standing_landmarks(1.741, kStandingToeOut);
  const PosedBody posed = full_body();
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  for (const Capsule& capsule : posed.body.capsules()) {
    if (capsule.name != "trunk") continue;
    const Vec3d low = kinematics.point(capsule.link, capsule.from);
    const Vec3d high = kinematics.point(capsule.link, capsule.to);
    EXPECT_LT(norm(low - (person.left_leg.hip + person.right_leg.hip) * 0.5), 1e-12);
    EXPECT_NEAR(high.y + capsule.radius, person.left_arm.shoulder.y, 1e-12);
  }
}

TEST(HumanBody, WeighsWhatIsAsked) {
  EXPECT_NEAR(half_body({1.741, 73.0, Sex::male}).body.mass(), 73.0, 1e-10);
  EXPECT_NEAR(full_body({1.6, 90.0, Sex::male}).body.mass(), 90.0, 1e-10);
  // the printed women's table adds up to 0.9999
  EXPECT_NEAR(full_body({1.735, 61.9, Sex::female}).body.mass(), 0.9999 * 61.9, 1e-10);
}

TEST(HumanBody, StandsWithItsCentreOfMassWherePeopleHaveIt) {
  // an upright mean person has it at 0.575 of the stature by de Leva's lengths, at 0.55 to 0.58 in
  // the literature, and some centimetres ahead of the ankles
  for (const PosedBody& posed : {half_body(), full_body(), full_body({1.735, 61.9, Sex::female})}) {
    const Vec3d com = centre_of_mass(posed, placed(posed, posed.home.angles));
    EXPECT_NEAR(com.x, 0.0, 1e-10);
    EXPECT_GT(com.y, 0.55 * posed.body.stature());
    EXPECT_LT(com.y, 0.58 * posed.body.stature());
    EXPECT_GT(com.z, posed.body.base().translation.z + 0.02);
    EXPECT_LT(com.z, posed.body.base().translation.z + 0.07);
  }
}

TEST(HalfBody, WeighsAndStandsAsTheWholePerson) {
  const Landmarks person = standing_landmarks(1.7, 0.0);
  const PosedBody half = build_human(person, {"half", BodyExtent::half, 1.7, 70.0, Sex::male});
  const PosedBody full = build_human(person, {"full", BodyExtent::full, 1.7, 70.0, Sex::male});
  EXPECT_NEAR(half.body.mass(), full.body.mass(), 1e-10);
  EXPECT_LT(norm(centre_of_mass(half, placed(half, half.home.angles)) -
                 centre_of_mass(full, placed(full, full.home.angles))),
            1e-12);
}

TEST(HalfBody, LegsCountForBoth) {
  const PosedBody half = half_body();
  const PosedBody full = full_body();
  for (const char* name : {"right_ankle.flexion", "right_knee.flexion", "right_hip.flexion"}) {
    const Dof& one = half.body.dof(*half.body.find_dof(name));
    const Dof& two = full.body.dof(*full.body.find_dof(name));
    EXPECT_DOUBLE_EQ(one.torque_positive, 2 * two.torque_positive) << name;
    EXPECT_DOUBLE_EQ(one.torque_negative, 2 * two.torque_negative) << name;
  }
  const Dof& elbow = half.body.dof(*half.body.find_dof("right_elbow.flexion"));
  EXPECT_DOUBLE_EQ(elbow.torque_positive, kElbowFlexion.torque_positive);
}

TEST(HumanBody, StrengthGrowsByAPartOfTheMassAndIsSmallerInWomen) {
  const auto elbow = [](const PosedBody& posed) {
    return posed.body.dof(*posed.body.find_dof("right_elbow.flexion")).torque_positive;
  };
  EXPECT_DOUBLE_EQ(elbow(full_body({1.741, 73.0, Sex::male})), 70.0);
  EXPECT_DOUBLE_EQ(elbow(full_body({1.741, 146.0, Sex::male})), 70.0 * (1.0 + kStrengthOfMass));
  EXPECT_NEAR(elbow(full_body({1.25 * 1.741, 1.5625 * 73.0, Sex::male})), 1.5625 * 70.0, 1e-9);
  EXPECT_DOUBLE_EQ(elbow(full_body({1.735, 61.9, Sex::female})), 42.0);
}

TEST(HumanBody, ThighHasDeLevasInertia) {
  // the thigh alone is the link that the right knee moves; its frame has y along the segment
  const PosedBody posed = full_body();
  const SegmentParameters& p = segment_table(Sex::male).thigh;
  const double length = StatureFractions::kThigh * posed.body.stature();
  const double mass = p.mass * posed.body.mass();
  const MassProperties& thigh = posed.body.link_mass(*posed.body.find_dof("right_knee.flexion"));
  EXPECT_NEAR(thigh.mass, mass, 1e-12);
  EXPECT_LT(norm(thigh.com - Vec3d{0, length * (1 - p.com), 0}), 1e-12);
  const auto moment = [&](double radius) { return mass * radius * length * radius * length; };
  EXPECT_NEAR(thigh.inertia.cx.x, moment(p.r_transverse), 1e-10);
  EXPECT_NEAR(thigh.inertia.cy.y, moment(p.r_long), 1e-10);
  EXPECT_NEAR(thigh.inertia.cz.z, moment(p.r_sagittal), 1e-10);
  EXPECT_NEAR(thigh.inertia.cy.x, 0.0, 1e-10);
  EXPECT_NEAR(thigh.inertia.cz.x, 0.0, 1e-10);
  EXPECT_NEAR(thigh.inertia.cz.y, 0.0, 1e-10);
}

// Each landmark with its position in the body's start posture, through the nodes of its skeleton.
class NodePlaces {
 public:
  explicit NodePlaces(const PosedBody& posed)
      : body_(posed), kinematics_(placed(posed, posed.home.angles)) {}

  [[nodiscard]] Vec3d of(const std::string& name) const { return at(find(name)); }
  // the end site under the node
  [[nodiscard]] Vec3d tip_of(const std::string& name) const {
    const auto nodes = body_.body.nodes();
    const auto tip = std::find_if(nodes.begin(), nodes.end(), [&](const BodyNode& node) {
      return node.end_site && node.parent == find(name);
    });
    return at(static_cast<int>(tip - nodes.begin()));
  }

 private:
  [[nodiscard]] int find(const std::string& name) const {
    const auto nodes = body_.body.nodes();
    return static_cast<int>(std::find_if(nodes.begin(), nodes.end(),
                                         [&](const BodyNode& node) { return node.name == name; }) -
                            nodes.begin());
  }
  [[nodiscard]] Vec3d at(int index) const {
    if (index >= static_cast<int>(body_.body.nodes().size())) return {NAN, NAN, NAN};
    const BodyNode& node = body_.body.nodes()[static_cast<std::size_t>(index)];
    return kinematics_.point(node.link, node.point);
  }

  const PosedBody& body_;
  Kinematics<double> kinematics_;
};

// Largest distance (m) of a landmark from its position in the body.
double misplacement(const Landmarks& person, const PosedBody& posed, bool left_too = true) {
  const NodePlaces nodes(posed);
  double largest = 0.0;
  const auto compare = [&](const Vec3d& expected, const Vec3d& seen) {
    const double distance = norm(expected - seen);
    largest = distance <= largest ? largest : distance;  // keeps a NaN
  };
  compare(person.neck, nodes.of("neck"));
  compare(person.head_top, nodes.tip_of("head"));
  compare((person.left_leg.hip + person.right_leg.hip) * 0.5, nodes.of("hips"));
  for (const Side side : {Side::left, Side::right}) {
    if (side == Side::left && !left_too) continue;
    const std::string prefix = side == Side::left ? "left_" : "right_";
    const Landmarks::Leg& leg = person.leg(side);
    compare(leg.hip, nodes.of(prefix + "upper_leg"));
    compare(leg.knee, nodes.of(prefix + "lower_leg"));
    compare(leg.ankle, nodes.of(prefix + "foot"));
    compare(leg.toe, nodes.tip_of(prefix + "toes"));
    const Landmarks::Arm& arm = person.arm(side);
    compare(arm.shoulder, nodes.of(prefix + "upper_arm"));
    compare(arm.elbow, nodes.of(prefix + "lower_arm"));
    compare(arm.wrist, nodes.of(prefix + "hand"));
    compare(arm.fingertip, nodes.tip_of(prefix + "hand_grip"));
    const Vec3d grip = arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction;
    compare(grip, nodes.of(prefix + "hand_grip"));
    compare(grip, effector_position(posed, posed.home.angles, (prefix + "hand").c_str()));
  }
  return largest;
}

// Distances of 2 m through ten rotations, each exact to rounding.
constexpr double kExact = 1e-13;

TEST(BuildHuman, StandsWhereTheLandmarksAre) {
  const Landmarks person = standing_landmarks(1.75, radians(7));
  EXPECT_LT(misplacement(person, build_human(person, {})), kExact);
  EXPECT_LT(misplacement(person, build_human(person, {.extent = BodyExtent::half}), false), kExact);
}

TEST(BuildHuman, PlacesUnevenPeopleExactly) {
  Random random(71);
  for (int trial = 0; trial < 200; ++trial) {
    const Landmarks person = perturbed(standing_landmarks(1.6, radians(10)), 0.03, random);
    ASSERT_LT(misplacement(person, build_human(person, {})), kExact);
    ASSERT_LT(misplacement(person, build_human(person, {.extent = BodyExtent::half}), false),
              kExact);
  }
}

TEST(BuildHuman, PlacesArmsInAnyDirectionExactly) {
  Random random(72);
  for (int trial = 0; trial < 500; ++trial) {
    Landmarks person = standing_landmarks(1.741, 0.1);
    for (Landmarks::Arm* arm : {&person.left_arm, &person.right_arm}) {
      point_arm(*arm, random_direction(random), random_direction(random));
    }
    ASSERT_LT(misplacement(person, build_human(person, {})), kExact);
  }
}

TEST(BuildHuman, PlacesStraightArmsInAnyDirectionExactly) {
  Random random(73);
  for (int trial = 0; trial < 500; ++trial) {
    Landmarks person = standing_landmarks(1.741, 0.1);
    for (Landmarks::Arm* arm : {&person.left_arm, &person.right_arm}) {
      const Vec3d along = random_direction(random);
      point_arm(*arm, along, along);
    }
    ASSERT_LT(misplacement(person, build_human(person, {})), kExact);
  }
}

TEST(BuildHuman, PlacesSquatsExactly) {
  Random random(74);
  for (int trial = 0; trial < 200; ++trial) {
    Landmarks person = perturbed(standing_landmarks(1.741, 0.2), 0.01, random);
    // hips and all above go down and back, knees forwards and apart
    const Vec3d down{0, random.uniform(-0.5, 0.0), random.uniform(-0.3, 0.0)};
    for (Vec3d* point : all_points(person)) {
      if (point->y > 0.6) *point += down;
    }
    for (Landmarks::Leg* leg : {&person.left_leg, &person.right_leg}) {
      const double side = leg == &person.left_leg ? 1.0 : -1.0;
      leg->knee = (leg->hip + leg->ankle) * 0.5 +
                  Vec3d{side * random.uniform(0.0, 0.2), 0.0, random.uniform(0.1, 0.4)};
    }
    ASSERT_LT(misplacement(person, build_human(person, {})), kExact);
  }
}

// Straight out to both sides.
Landmarks t_pose() {
  Landmarks person = standing_landmarks(1.741, 0.1);
  point_arm(person.left_arm, {1, 0, 0}, {1, 0, 0});
  point_arm(person.right_arm, {-1, 0, 0}, {-1, 0, 0});
  return person;
}

TEST(BuildHuman, TPoseIsArmsAbductedByARightAngle) {
  const Landmarks person = t_pose();
  const PosedBody posed = build_human(person, {});
  EXPECT_LT(misplacement(person, posed), kExact);
  for (const char* side : {"left_", "right_"}) {
    const auto angle = [&](const char* freedom) {
      const int d = posed.body.find_dof(std::string(side) + "shoulder." + freedom).value();
      return degrees(posed.home.angles[static_cast<std::size_t>(d)]);
    };
    EXPECT_NEAR(angle("abduction"), 90.0, 1e-6);
    EXPECT_NEAR(angle("flexion"), 0.0, 1e-6);
    EXPECT_NEAR(angle("rotation"), 0.0, 1e-6);
  }
  EXPECT_TRUE(posed.doubts.empty());
}

TEST(BuildHuman, ArmsRaisedSidewaysStayWithinTheLimits) {
  // 60° to 165° of abduction, through the right angle where flexion and rotation meet
  for (double abduction = 60.0; abduction < 166.0; abduction += 1.0) {
    const SinCos<double> a = sin_cos(radians(abduction));
    Landmarks person = standing_landmarks(1.741, 0.1);
    point_arm(person.left_arm, {a.sin, -a.cos, 0}, {a.sin, -a.cos, 0});
    const PosedBody posed = build_human(person, {});
    ASSERT_LT(misplacement(person, posed), kExact);
    ASSERT_TRUE(posed.doubts.empty()) << abduction << ": " << posed.doubts[0].text;
  }
}

TEST(BuildHuman, LimbAtTheSingularityIsPlacedToAMicrometre) {
  // within 1e-6 rad of straight out the flexion is taken for 0, which moves the hand by that much
  Random random(75);
  for (int trial = 0; trial < 200; ++trial) {
    Landmarks person = t_pose();
    const double noise = std::pow(10.0, random.uniform(-16.0, -5.0));
    const Vec3d along = Vec3d{1, 0, 0} + random_direction(random) * noise;
    point_arm(person.left_arm, along, along);
    ASSERT_LT(misplacement(person, build_human(person, {})), 1.1e-6);
  }
}

TEST(BuildHuman, StandsOnTheLeftFootWhereTheRightIsLifted) {
  Landmarks person = standing_landmarks(1.741, 0.1);
  lift_leg(person.right_leg, 1.0);
  const PosedBody posed = build_human(person, {});
  EXPECT_LT(misplacement(person, posed), kExact);
  ASSERT_EQ(posed.body.feet().size(), 1u);
  EXPECT_EQ(posed.body.feet()[0].name, "left_foot");
  EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
  EXPECT_EQ(posed.body.dof(0).name, "left_ankle.flexion");
  EXPECT_FALSE(posed.doubts.empty());
}

TEST(BuildHuman, StandsOnTheRightFootWhereTheLeftIsLifted) {
  Landmarks person = standing_landmarks(1.741, 0.1);
  lift_leg(person.left_leg, 1.0);
  const PosedBody posed = build_human(person, {});
  EXPECT_LT(misplacement(person, posed), kExact);
  ASSERT_EQ(posed.body.feet().size(), 1u);
  EXPECT_EQ(posed.body.feet()[0].name, "right_foot");
}

TEST(BuildHuman, FeetLieOnTheFloorInTheirDirection) {
  const PosedBody posed = full_body();
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  for (const Foot& foot : posed.body.feet()) {
    double left_most = -1.0;
    double length = 0.0;
    for (const Vec3d& corner : foot.outline) {
      const Vec3d at = kinematics.point(foot.link, corner);
      EXPECT_NEAR(at.y, 0.0, 1e-12);
      left_most = std::max(left_most, at.x);
      for (const Vec3d& other : foot.outline) {
        length = std::max(length, norm(at - kinematics.point(foot.link, other)));
      }
    }
    // the diagonal of the sole
    const double h = posed.body.stature();
    EXPECT_NEAR(length, std::hypot(0.152 * h, 0.055 * h), 1e-12);
    EXPECT_EQ(left_most > 0.0, foot.name == "left_foot");
  }
}

TEST(BuildHuman, LimitsHoldTheStartPosture) {
  Random random(76);
  for (int trial = 0; trial < 100; ++trial) {
    Landmarks person = perturbed(standing_landmarks(1.741, 0.1), 0.05, random);
    for (Landmarks::Arm* arm : {&person.left_arm, &person.right_arm}) {
      point_arm(*arm, random_direction(random), random_direction(random));
    }
    const PosedBody posed = build_human(person, {});
    for (std::size_t d = 0; d < posed.body.dofs().size(); ++d) {
      ASSERT_GE(posed.home.angles[d], posed.body.dofs()[d].lower);
      // hips: the widened limit counts on the bend of the knee
      if (posed.body.dofs()[d].name.ends_with("hip.flexion")) continue;
      ASSERT_LE(posed.home.angles[d], posed.body.dofs()[d].upper);
    }
  }
}

TEST(BuildHuman, SaysWhichLimitItWidened) {
  Landmarks person = standing_landmarks(1.741, 0.1);
  // a hyperextended elbow: the forearm 30° back
  point_arm(person.left_arm, {0, -1, 0}, {0, -0.87, -0.5});
  const PosedBody posed = build_human(person, {});
  const Dof& elbow = posed.body.dof(*posed.body.find_dof("left_elbow.flexion"));
  EXPECT_LT(elbow.lower, radians(-29));
  ASSERT_EQ(posed.doubts.size(), 1u);
  EXPECT_NE(posed.doubts[0].text.find("left_elbow.flexion"), std::string::npos)
      << posed.doubts[0].text;
}

TEST(BuildHuman, KeepsTheDoubtsItIsGiven) {
  const PosedBody posed = build_human(standing_landmarks(1.7, 0.1), {}, {"the unit is a guess"});
  ASSERT_EQ(posed.doubts.size(), 1u);
  EXPECT_EQ(posed.doubts[0], "the unit is a guess");
}

TEST(BuildHuman, AnatomicalAnglesOfAKnownPosture) {
  // left thigh raised forwards by 90°, its shank hanging: hip and knee flexed by 90°, ankle by 0
  Landmarks person = standing_landmarks(1.741, 0.0);
  Landmarks::Leg& leg = person.left_leg;
  const double thigh = norm(leg.knee - leg.hip);
  const double shank = norm(leg.ankle - leg.knee);
  const Vec3d foot = leg.toe - leg.ankle;
  leg.knee = leg.hip + Vec3d{0, 0, thigh};
  leg.ankle = leg.knee - Vec3d{0, shank, 0};
  leg.toe = leg.ankle + foot;
  const PosedBody posed = build_human(person, {});
  const auto angle = [&](const char* name) {
    return degrees(posed.home.angles[static_cast<std::size_t>(posed.body.find_dof(name).value())]);
  };
  EXPECT_NEAR(angle("left_hip.flexion"), 90.0, 1e-9);
  EXPECT_NEAR(angle("left_hip.abduction"), 0.0, 1e-9);
  EXPECT_NEAR(angle("left_hip.rotation"), 0.0, 1e-9);
  EXPECT_NEAR(angle("left_knee.flexion"), 90.0, 1e-9);
  EXPECT_NEAR(angle("left_ankle.flexion"), 0.0, 1e-9);
}

TEST(BuildHuman, BothSidesTurnTheSameWayIntoTheirLimits) {
  // a symmetric posture has the same anatomical angles on both sides, standing leg or not
  Random random(77);
  for (int trial = 0; trial < 50; ++trial) {
    Landmarks person = perturbed(standing_landmarks(1.741, 0.15), 0.05, random);
    point_arm(person.left_arm, random_direction(random), random_direction(random));
    const auto mirrored = [](Vec3d p) {
      p.x = -p.x;
      return p;
    };
    for (Vec3d* middle : {&person.neck, &person.head_top}) middle->x = 0.0;
    const Landmarks::Leg& leg = person.left_leg;
    const Landmarks::Arm& arm = person.left_arm;
    person.right_leg = {mirrored(leg.hip), mirrored(leg.knee), mirrored(leg.ankle),
                        mirrored(leg.toe)};
    person.right_arm = {mirrored(arm.shoulder), mirrored(arm.elbow), mirrored(arm.wrist),
                        mirrored(arm.fingertip)};
    const PosedBody posed = build_human(person, {});
    for (std::size_t d = 0; d < posed.body.dofs().size(); ++d) {
      const std::string& name = posed.body.dofs()[d].name;
      if (!name.starts_with("right_")) continue;
      const auto left =
          static_cast<std::size_t>(posed.body.find_dof("left_" + name.substr(6)).value());
      ASSERT_NEAR(posed.home.angles[d], posed.home.angles[left], 1e-9) << name;
    }
  }
}

std::vector<std::string> capsule_names(const PosedBody& posed) {
  std::vector<std::string> names;
  for (const Capsule& capsule : posed.body.capsules()) names.push_back(capsule.name);
  return names;
}

TEST(HumanBody, EveryPartHasItsCapsule) {
  std::vector<std::string> expected;
  for (int i = 0; i < kBodyPartCount; ++i) {
    expected.emplace_back(body_part_name(static_cast<BodyPart>(i)));
  }
  std::erase(expected, "trunk");
  EXPECT_THAT(capsule_names(human_body()), testing::UnorderedElementsAreArray(expected));
  // without joints in trunk and hand, these are parts of their carriers
  std::erase_if(expected, [](const std::string& name) {
    return name.ends_with("spine") || name.ends_with("chest") || name.ends_with("hand");
  });
  std::replace(expected.begin(), expected.end(), std::string("pelvis"), std::string("trunk"));
  EXPECT_THAT(capsule_names(full_body()), testing::UnorderedElementsAreArray(expected));
  std::erase_if(expected, [](const std::string& name) { return name.starts_with("left_"); });
  EXPECT_THAT(capsule_names(half_body()), testing::UnorderedElementsAreArray(expected));
}

// Skull and jaw reach from the vertex to the chin, and as far ahead, back and sideways as a head.
TEST(HumanBody, HeadsAreAsLargeAsPeoplesAre) {
  const PosedBody posed = full_body();
  const Kinematics<double> start = placed(posed, posed.home.angles);
  Vec3d low{1e9, 1e9, 1e9};
  Vec3d high{-1e9, -1e9, -1e9};
  for (const Capsule& capsule : posed.body.capsules()) {
    if (capsule.name != "head" && capsule.name != "jaw") continue;
    for (const Vec3d& end : {capsule.from, capsule.to}) {
      const Vec3d at = start.point(capsule.link, end);
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k] - capsule.radius);
        high[k] = std::max(high[k], at[k] + capsule.radius);
      }
    }
  }
  const double h = posed.body.stature();
  EXPECT_NEAR(high.x - low.x, 0.150 / 1.756 * h, 1e-9);
  EXPECT_NEAR(high.z - low.z, 0.195 / 1.756 * h, 1e-9);
  EXPECT_NEAR(high.y - low.y, 0.130 * h, 1e-9);
}

}  // namespace
}  // namespace shigusa
