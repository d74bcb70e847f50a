// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "body/anthropometry.hpp"
#include "body/posture_modes.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kRounding = 1e-12;

Vec3d node_position(const PosedBody& posed, std::span<const double> angles, const char* name) {
  const Kinematics<double> kinematics = placed(posed, angles);
  for (const BodyNode& node : posed.body.nodes()) {
    if (node.name == name) return kinematics.point(node.link, node.point);
  }
  ADD_FAILURE() << name;
  return {};
}

// a spine with `joints` joints; the others are rigid
PosedBody with_spine(std::size_t joints) {
  Landmarks person = standing_landmarks(1.7, kStandingToeOut);
  person.spine.resize(joints);
  return build_human(person, {"human", BodyExtent::human, 1.7, 70.0, Sex::male});
}

double upper_limit(const PosedBody& posed, const char* freedom) {
  double sum = 0.0;
  for (const char* joint : {"spine", "chest", "upper_chest"}) {
    if (const auto d = posed.body.find_dof(std::string(joint) + freedom))
      sum += posed.body.dof(*d).upper;
  }
  return sum;
}

TEST(WholeHuman, HasFiftyOneFreedomsWithThePelvisSix) {
  EXPECT_EQ(human_body().body.dof_count() + 6, 51);
}

TEST(WholeHuman, StandsWithTheLandmarksOfThePerson) {
  const Landmarks person = asymmetric_person();
  const PosedBody posed = build_human(person, {"human", BodyExtent::human, 1.6, 55.0, Sex::female});
  const auto expect_at = [&](const char* node, const Vec3d& at) {
    EXPECT_LT(norm(node_position(posed, posed.home.angles, node) - at), kRounding) << node;
  };
  expect_at("spine", person.spine[0]);
  expect_at("upper_chest", person.spine[2]);
  expect_at("head", *person.head);
  expect_at("left_shoulder", *person.left_arm.clavicle);
  expect_at("left_hand", person.left_arm.wrist);
  expect_at("right_lower_arm", person.right_arm.elbow);
  expect_at("left_foot", person.left_leg.ankle);
}

TEST(WholeHuman, StandsOnBothFeetWhereOneIsOnAStep) {
  Landmarks person = standing_landmarks(1.7, kStandingToeOut);
  lift_leg(person.left_leg, 1.2);
  HumanSettings settings{"human", BodyExtent::human, 1.7, 70.0, Sex::male};
  EXPECT_EQ(build_human(person, settings).body.feet().size(), 1u);
  settings.on_both = true;
  for (const Side base : {Side::left, Side::right}) {
    settings.base = base;
    const PosedBody posed = build_human(person, settings);
    ASSERT_EQ(posed.body.feet().size(), 2u);
    EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
    const Kinematics<double> start = placed(posed, posed.home.angles);
    const auto height = [&](const Foot& foot) { return start.point(foot.link, foot.centre).y; };
    const double step = norm(person.left_leg.ankle - person.right_leg.ankle);
    EXPECT_GT(step, 0.1);
    const double rise = height(posed.body.feet()[1]) - height(posed.body.feet()[0]);
    const double wanted = person.left_leg.ankle.y - person.right_leg.ankle.y;
    EXPECT_NEAR(base == Side::right ? rise : -rise, wanted, 1e-9);
  }
}

// A slice of the trunk between two joints at one place has no length and no mass.
TEST(WholeHuman, SpineJointsThatDoNotRiseLeaveAWholeBody) {
  Landmarks person = standing_landmarks(1.7, kStandingToeOut);
  const Vec3d hips = (person.left_leg.hip + person.right_leg.hip) * 0.5;
  for (const double rise : {-0.05, 0.0}) {
    person.spine = {hips + Vec3d{0, rise, 0}, hips + Vec3d{0, rise, 0}, person.neck};
    const PosedBody posed = build_human(person, {"human", BodyExtent::human, 1.7, 70.0, Sex::male});
    double mass = posed.body.link_mass(kBaseLink).mass;
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const MassProperties& link = posed.body.link_mass(d);
      EXPECT_TRUE(std::isfinite(norm(link.com)) && std::isfinite(link.inertia.cx.x)) << d;
      mass += link.mass;
    }
    EXPECT_NEAR(mass, 70.0, 1e-9);
  }
}

TEST(WholeHuman, WeighsWhatIsAskedWhateverItsJoints) {
  for (const std::size_t joints : {0u, 1u, 2u, 3u}) {
    EXPECT_NEAR(with_spine(joints).body.mass(), 70.0, 1e-10) << joints;
  }
}

// kg m, of all links but the standing foot
Vec3d moment_of_mass(const PosedBody& posed) {
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  Vec3d moment{};
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    const MassProperties& mass = posed.body.link_mass(d);
    moment += kinematics.point(d, mass.com) * mass.mass;
  }
  return moment;
}

// One trunk in three parts of even density compared with de Leva's whole one.
TEST(WholeHuman, HasItsCentreOfMassWhereTheRigidTrunkHasIt) {
  const PosedBody whole = human_body();
  const Vec3d apart = moment_of_mass(whole) - moment_of_mass(full_body());
  EXPECT_LT(norm(apart) / whole.body.mass(), 0.012);
}

TEST(WholeHuman, CentreOfMassDoesNotDependOnTheSpinesJoints) {
  const Vec3d all = moment_of_mass(with_spine(3));
  for (const std::size_t joints : {0u, 1u, 2u}) {
    EXPECT_LT(norm(moment_of_mass(with_spine(joints)) - all), 1e-9) << joints;
  }
}

TEST(WholeHuman, FewerSpineJointsHaveTheSameRangeTogether) {
  for (const char* freedom : {".flexion", ".lateral", ".rotation"}) {
    const double all = upper_limit(with_spine(3), freedom);
    EXPECT_NEAR(upper_limit(with_spine(1), freedom), all, kRounding);
    EXPECT_NEAR(upper_limit(with_spine(2), freedom), all, kRounding);
  }
}

// Positive angles move nodes in the direction that the dof's name states.
TEST(WholeHuman, FreedomsTurnTheWayTheirNamesSay) {
  const PosedBody posed = human_body();
  const auto moved = [&](const char* dof, const char* node) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    angles[static_cast<std::size_t>(posed.body.find_dof(dof).value())] += 0.2;
    return node_position(posed, angles, node) - node_position(posed, posed.home.angles, node);
  };
  EXPECT_GT(moved("spine.flexion", "head").z, 0.01);
  EXPECT_GT(moved("chest.lateral", "head").x, 0.01);
  EXPECT_GT(moved("upper_chest.rotation", "right_hand").z, 0.005);
  EXPECT_GT(moved("neck.flexion", "head").z, 0.005);
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = side > 0 ? "left_" : "right_";
    const std::string hand = prefix + "hand_grip";
    const auto of = [&](const char* dof) { return moved((prefix + dof).c_str(), hand.c_str()); };
    EXPECT_GT(of("clavicle.elevation").y, 0.005) << prefix;
    EXPECT_GT(of("clavicle.protraction").z, 0.005) << prefix;
    EXPECT_LT(of("wrist.flexion").x * side, -0.005) << prefix;  // palms face the thighs
    EXPECT_GT(of("wrist.deviation").z, 0.005) << prefix;        // thumbs are ahead
  }
  // from the standing foot the body tilts, and the other foot's sole turns inwards
  EXPECT_LT(std::abs(moved("right_ankle.inversion", "right_foot").x), kRounding);
  EXPECT_GT(moved("left_ankle.inversion", "left_toes").x, -0.05);
}

TEST(WholeHuman, RoundsAndTwistsItsSpine) {
  const PosedBody posed = human_body();
  std::vector<std::string> names;
  for (const PostureMode& mode : posture_modes(posed)) names.push_back(mode.name);
  EXPECT_EQ(names, (std::vector<std::string>{"squat", "lean", "round", "twist", "right_elbow",
                                             "left_elbow", "right_swivel", "left_swivel",
                                             "right_wrist", "left_wrist"}));
}

TEST(WholeHuman, IsAsStrongAsItsSexAndMass) {
  const PosedBody woman = human_body({1.7, default_mass(1.7, Sex::female), Sex::female});
  const PosedBody man = human_body({1.7, default_mass(1.7, Sex::male), Sex::male});
  const int back = man.body.find_dof("spine.flexion").value();
  const double ratio = woman.body.dof(back).torque_negative / man.body.dof(back).torque_negative;
  EXPECT_NEAR(ratio, kFemaleStrength * (1.741 * 1.741) / (1.735 * 1.735), 1e-9);
}

}  // namespace
}  // namespace shigusa
