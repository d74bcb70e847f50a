// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "plan/held_input.hpp"
#include "rollout/rollout.hpp"
#include "simd/pack.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kAtTheFeet{-0.1, 0.15, 0.4};
constexpr Vec3d kHigh{-0.4, 1.8, 0.3};

ReachProblem lawful_reach(const PosedBody& posed, const Vec3d& goal) {
  ReachProblem problem = reach_with(posed, "right_hand", goal);
  problem.hold_limits = problem.posture_law = true;
  problem.context.gaze = goal;
  return problem;
}

Vec3d direction(const PosedBody& posed, std::span<const double> angles, const char* from,
                const char* to) {
  const Kinematics<double> kinematics = placed(posed, angles);
  Vec3d ends[2];
  for (const BodyNode& node : posed.body.nodes()) {
    if (node.name == from) ends[0] = kinematics.point(node.link, node.point);
    if (node.name == to) ends[1] = kinematics.point(node.link, node.point);
  }
  return normalized(ends[1] - ends[0]);
}

double degrees_between(const Vec3d& a, const Vec3d& b) { return degrees(acos(dot(a, b))); }

// from where the head faces
double gaze_off(const PosedBody& posed, std::span<const double> angles, const Vec3d& goal) {
  const int head = posed.body.find_dof("head.rotation").value();
  const Kinematics<double> kinematics = placed(posed, angles);
  const Vec3d way = goal - kinematics.origin[static_cast<std::size_t>(head)];
  return degrees_between(kinematics.link_rotation(head).cz, normalized(way));
}

TEST(PostureLaw, TheHeadTurnsToTheGoalBeforeTheHandIsThere) {
  const PosedBody posed = human_body();
  const Vec3d goal{-0.6, 1.2, 0.3};
  const ReachProblem problem = lawful_reach(posed, goal);
  const Clip clip = roll_out(problem, uniform_parameters(posed)).motion.clip;
  const double before = gaze_off(posed, clip.frame(0), goal);
  EXPECT_GT(before, 60.0);
  // the eyes do a quarter of each angle; two joints that turn and nod in turn lose some degrees
  // more
  EXPECT_LT(gaze_off(posed, clip.frame(48), goal), 0.4 * before);
  EXPECT_LT(gaze_off(posed, clip.frame(60), goal), 0.4 * before);
}

TEST(PostureLaw, AFreeArmHangs) {
  const PosedBody posed = human_body();
  const ReachProblem problem = lawful_reach(posed, kAtTheFeet);
  const Clip clip = roll_out(problem, uniform_parameters(posed)).motion.clip;
  const auto from_plumb = [&](const char* arm, const char* elbow) {
    return degrees_between(direction(posed, clip.frame(60), arm, elbow), {0, -1, 0});
  };
  // the trunk leans by some 100°, of which a stiff arm would make up nothing
  const Vec3d trunk = direction(posed, clip.frame(60), "hips", "neck");
  ASSERT_GT(degrees_between(trunk, {0, 1, 0}), 60.0);
  EXPECT_LT(from_plumb("left_upper_arm", "left_lower_arm"), 30.0);
}

TEST(PostureLaw, AFreeElbowBendsAsTheTrunkLeans) {
  const PosedBody posed = human_body();
  const Clip clip =
      roll_out(lawful_reach(posed, kAtTheFeet), uniform_parameters(posed)).motion.clip;
  const int elbow = posed.body.find_dof("left_elbow.flexion").value();
  const auto bent = [&](int frame) {
    return degrees(clip.frame(frame)[static_cast<std::size_t>(elbow)]);
  };
  EXPECT_LT(bent(0), 15.0);
  EXPECT_GT(bent(60), bent(0) + 20.0);
  EXPECT_LT(bent(60), 100.0);
}

// The sum of the back's bends, in degrees, in a frame.
double back_bend(const PosedBody& posed, std::span<const double> angles) {
  double sum = 0.0;
  for (const char* joint : {"spine.flexion", "chest.flexion", "upper_chest.flexion"}) {
    sum += degrees(angles[static_cast<std::size_t>(posed.body.find_dof(joint).value())]);
  }
  return sum;
}

// by the formula, from the pelvis in the frame before
TEST(PostureLaw, TheBackBendsWithThePelvisAndWomensLess) {
  double bends[2] = {};
  for (const Sex sex : {Sex::male, Sex::female}) {
    const PosedBody posed = human_body({.sex = sex});
    const Clip clip =
        roll_out(lawful_reach(posed, kAtTheFeet), uniform_parameters(posed)).motion.clip;
    const int spine = posed.body.find_dof("spine.flexion").value();
    const Mat3d pelvis = placed(posed, clip.frame(59)).link_rotation(posed.body.dof(spine).parent);
    const double tip = std::atan2(-pelvis.cz.y, pelvis.cy.y);
    ASSERT_GT(degrees(tip), 30.0);
    const double wanted = kBackBend * posed.body.lumbar_part() * tip / (tip + kBackHalf);
    // the last step has the hand at its goal, by whatever moves it
    EXPECT_NEAR(back_bend(posed, clip.frame(60)), degrees(wanted), 2.0);
    bends[sex == Sex::female ? 1 : 0] = wanted;
  }
  EXPECT_LT(bends[1], bends[0]);
}

TEST(PostureLaw, ARaisedArmTakesItsClavicleAlong) {
  const PosedBody posed = human_body();
  const Clip clip = roll_out(lawful_reach(posed, kHigh), uniform_parameters(posed)).motion.clip;
  const auto angle = [&](const char* name) {
    return clip.frame(60)[static_cast<std::size_t>(posed.body.find_dof(name).value())];
  };
  EXPECT_GT(degrees(angle("right_clavicle.elevation")), 5.0);
  EXPECT_LT(std::fabs(degrees(angle("left_clavicle.elevation"))), 4.0);
}

// The clavicle's share of each step of elevation, for an arm in the frontal plane.
TEST(Shrug, HasTheRhythmOfTheScapula) {
  const auto elevation = [](double raised) {
    const SinCos<double> arm = sin_cos(radians(raised));
    return degrees(shrugged(Vec3d{arm.sin, -arm.cos, 0.0}).elevation);
  };
  const auto share = [&](double from, double to) {
    return (elevation(to) - elevation(from)) / (to - from);
  };
  EXPECT_EQ(elevation(0.0), 0.0);
  EXPECT_LT(share(0.0, 30.0), 0.06);  // 2.5 %
  EXPECT_NEAR(share(30.0, 60.0), 0.21, 0.03);
  EXPECT_NEAR(share(60.0, 90.0), 0.38, 0.03);
  EXPECT_NEAR(share(90.0, 120.0), 0.53, 0.03);
  // 2.3 and 2.7 to 1 over the whole arc
  EXPECT_NEAR((180.0 - elevation(180.0)) / elevation(180.0), 2.3, 0.1);
  const double lowered = kScapulaLowers * elevation(180.0);
  EXPECT_NEAR((180.0 - lowered) / lowered, 2.7, 0.1);
}

TEST(Shrug, IsLessOfAnArmThatIsLowered) {
  const PosedBody posed = human_body();
  const ArmLinks links{
      posed.body.dof(posed.body.find_dof("right_shoulder.flexion").value()).parent,
      posed.body.dof(posed.body.find_dof("right_clavicle.elevation").value()).parent,
      posed.body.find_dof("right_shoulder.rotation").value()};
  EXPECT_EQ(scapula_share(lawful_reach(posed, kHigh), links), 1.0);
  Landmarks person = standing_landmarks(1.7, 0.0);
  point_arm(person.right_arm, {-0.3, 0.9, 0.2}, {-0.3, 0.9, 0.2});
  const PosedBody raised = build_human(person, {.extent = BodyExtent::human, .stature = 1.7});
  EXPECT_EQ(scapula_share(lawful_reach(raised, {-0.3, 0.8, 0.2}), links), kScapulaLowers);
}

// The turn of the trunk to the left (degrees) that the law requires for a goal of a hand.
double wanted_turn(const Vec3d& goal, const char* hand = "right_hand") {
  const PosedBody posed = human_body();
  ReachProblem problem = reach_with(posed, hand, goal);
  problem.posture_law = true;
  problem.context.gaze = goal;
  const TrunkTurn turn = trunk_turn(problem);
  if (turn.change.empty()) return 0.0;
  double sum = 0.0;
  for (const char* joint : {"spine.rotation", "chest.rotation", "upper_chest.rotation"}) {
    sum += degrees(turn.change[static_cast<std::size_t>(posed.body.find_dof(joint).value())]);
  }
  const double hip = degrees(
      turn.change[static_cast<std::size_t>(posed.body.find_dof("right_hip.rotation").value())]);
  EXPECT_EQ(turn.side, sum > 0.0 ? 1.0 : -1.0);
  EXPECT_NEAR(hip, sum * 0.4 / 0.6, 1.0);  // legs that follow take a little of it
  return sum + hip;
}

TEST(TrunkTurn, IsForWhatIsAtTheSideAndBehind) {
  EXPECT_EQ(wanted_turn({-0.2, 1.3, 0.5}), 0.0);
  EXPECT_EQ(wanted_turn({-0.35, 1.3, 0.4}), 0.0);
  const double side = wanted_turn({-0.5, 1.4, 0.0});
  // the neck stands some centimetres ahead of the ankles
  EXPECT_NEAR(side, -(90.0 - 50.0) * 0.6, 3.0);
  EXPECT_LT(wanted_turn({-0.4, 1.4, -0.3}), side - 10.0);
  EXPECT_GT(wanted_turn({0.4, 1.4, -0.3}), 30.0);
  // no more than hips and spine turn
  EXPECT_NEAR(wanted_turn({-0.1, 1.4, -0.5}), -65.0, 1.0);
  // a goal far below is hardly behind
  EXPECT_LT(std::fabs(wanted_turn({-0.2, 0.1, -0.1})), 20.0);
}

TEST(TrunkTurn, IsToTheHandsSideForWhatIsRightBehind) {
  const double behind = 0.02;
  for (const double x : {-behind, behind}) {
    EXPECT_LT(wanted_turn({x, 1.3, -0.5}), -50.0);
    EXPECT_GT(wanted_turn({x, 1.3, -0.5}, "left_hand"), 50.0);
  }
}

// Displacement (mm) of the left foot by a hundredth of the turn required for a goal.
double foot_moved(const Vec3d& goal, bool turned_palm = false) {
  const PosedBody posed = human_body();
  ReachProblem problem = lawful_reach(posed, goal);
  if (turned_palm) problem.goals[0].turn.kind = Turning::axis;
  const TrunkTurn turn = trunk_turn(problem);
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  const Effector& foot = posed.body.effector(posed.body.find_effector("left_foot").value());
  const Vec3d before = home_kinematics(posed).point(foot.link, foot.point);
  for (std::size_t d = 0; d < turn.change.size(); ++d) angles[d] += 0.01 * turn.change[d];
  return 1e3 * norm(placed(posed, angles).point(foot.link, foot.point) - before);
}

TEST(TrunkTurn, TakesLegsAlongForWhatIsBehind) {
  const Vec3d behind{-0.1, 1.4, -0.5};
  EXPECT_LT(foot_moved(behind), 0.01);
  EXPECT_GT(foot_moved({-0.5, 1.4, -0.05}), 0.1);
  // with a given rotation ankles would come to their limits
  EXPECT_GT(foot_moved(behind, true), 0.1);
}

TEST(PostureLaw, TheTrunkTurnsUntilEyesAreOnWhatIsBehind) {
  const PosedBody posed = human_body();
  const Vec3d goal{-0.35, 1.3, -0.35};
  const Clip clip = roll_out(lawful_reach(posed, goal), uniform_parameters(posed)).motion.clip;
  const int chest = posed.body.dof(posed.body.find_dof("neck.flexion").value()).parent;
  const auto chest_turned = [&](int frame) {
    const Vec3d faces = placed(posed, clip.frame(frame)).link_rotation(chest).cz;
    return degrees(std::atan2(-faces.x, faces.z));
  };
  EXPECT_GT(chest_turned(60), 35.0);
  constexpr double kEyes = 35.0;
  EXPECT_LT(gaze_off(posed, clip.frame(60), goal), kEyes + 15.0);
  // eyes, then head, then trunk and hand: at 0.45 of the time the trunk has half of its turn to go
  EXPECT_LT(chest_turned(24), 0.6 * chest_turned(60));
}

// Also where the trunk turns, and a goal behind is farther aside than half a turn.
TEST(PostureLaw, TheHeadDoesItsShareOfTheWayToTheGoal) {
  const PosedBody posed = human_body();
  const auto neck = static_cast<std::size_t>(posed.body.find_dof("neck.rotation").value());
  const auto head = static_cast<std::size_t>(posed.body.find_dof("head.rotation").value());
  const int chest = posed.body.dof(posed.body.find_dof("neck.flexion").value()).parent;
  for (int aside = 20; aside <= 180; aside += 40) {
    const SinCos<double> way = sin_cos(radians(static_cast<double>(aside)));
    const Vec3d goal{-0.5 * way.sin, 1.4, 0.05 + 0.5 * way.cos};
    const Clip clip = roll_out(lawful_reach(posed, goal), uniform_parameters(posed)).motion.clip;
    const Kinematics<double> end = placed(posed, clip.frame(60));
    const Vec3d to = transpose_times(end.link_rotation(chest), goal - end.origin[head]);
    const double turned = clip.frame(60)[neck] + clip.frame(60)[head];
    EXPECT_NEAR(turned, kHeadOfGaze * std::atan2(to.x, to.z), radians(2.0)) << aside;
  }
}

TEST(PostureLaw, GoalsFeetAndLimitsStayWhatTheyAre) {
  const PosedBody posed = human_body();
  for (const Vec3d& goal : {kAtTheFeet, kHigh, Vec3d{-0.6, 1.2, -0.1}, Vec3d{-0.35, 1.2, -0.35}}) {
    ReachProblem problem = lawful_reach(posed, goal);
    problem.corrections = 2;
    const RolledOut rolled = roll_out(problem, uniform_parameters(posed));
    const MeasuredMotion measured(problem, rolled.motion.clip);
    EXPECT_LT(measured.goal_error, kReachTolerance);
    EXPECT_LT(measured.contact_slide, kReachTolerance);
    for (int f = 0; f < rolled.motion.clip.frames; ++f) {
      for (int d = 0; d < posed.body.dof_count(); ++d) {
        const double angle = rolled.motion.clip.frame(f)[static_cast<std::size_t>(d)];
        EXPECT_GE(angle, posed.body.dof(d).lower - 1e-12) << posed.body.dof(d).name;
      }
    }
  }
}

// In lanes the law uses its own arctangent.
void expect_same_in_lanes(const Vec3d& goal) {
  using Lanes = Pack<float, 4>;
  const PosedBody posed = human_body();
  const ReachProblem problem = lawful_reach(posed, goal);
  const std::vector<double> weights = inverse_weights(posed, uniform_parameters(posed));
  std::vector<Lanes> in_lanes;
  for (const double weight : weights) in_lanes.emplace_back(static_cast<float>(weight));
  Rollout<double> alone(problem);
  Rollout<Lanes> together(problem);
  const auto ignore = [](const auto&) {};
  alone.run(MotionInput<double>(weights), ignore);
  together.run(MotionInput<Lanes>(in_lanes), ignore);
  for (std::size_t d = 0; d < weights.size(); ++d) {
    EXPECT_NEAR(static_cast<double>(together.final_angles()[d][0]), alone.final_angles()[d], 2e-4)
        << posed.body.dof(static_cast<int>(d)).name;
  }
}

TEST(PostureLaw, IsTheSameInLanes) {
  expect_same_in_lanes(kAtTheFeet);
  expect_same_in_lanes({-0.4, 1.3, -0.2});
}

TEST(PostureLaw, AHeadThatIsBroaderThanTheShouldersTurnsLess) {
  const PosedBody usual = human_body();
  BodyDefinition body = usual.body.definition();
  EXPECT_EQ(head_share(reach_with(usual, "right_hand", kHigh)), 1.0);
  for (Capsule& capsule : body.capsules) {
    if (capsule.name == "head") capsule.radius = capsule.to_radius = 0.4;
  }
  const PosedBody big{BodyModel(body), usual.home};
  EXPECT_LT(head_share(reach_with(big, "right_hand", kHigh)), 0.1);
  const auto nod = [](const PosedBody& of) {
    ReachProblem problem = lawful_reach(of, kAtTheFeet);
    const Clip clip = roll_out(problem, uniform_parameters(of)).motion.clip;
    return clip.frame(clip.frames - 1)[static_cast<std::size_t>(*of.body.find_dof("neck.flexion"))];
  };
  EXPECT_LT(abs(nod(big)), 0.2 * abs(nod(human_body())));
}

TEST(PostureLaw, BodiesWithoutANeckHaveNone) {
  const PosedBody posed = full_body();
  EXPECT_TRUE(PostureLaw<double>(lawful_reach(posed, kHigh)).empty());
}

}  // namespace
}  // namespace shigusa
