// SPDX-License-Identifier: MIT
#include "problem/natural_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/minimum_jerk.hpp"
#include "problem/make_problem.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kFrom{-0.3, 0.8, 0.2};
constexpr Vec3d kUp{0, 1, 0};
constexpr Vec3d kDown{0, -1, 0};
constexpr Vec3d kForwards{0, 0, 1};

EffectorPath path_by(const Vec3d& way) { return {.start = kFrom, .goal = kFrom + way}; }

ReachGoal goal_by(const Vec3d& way) { return {.effector = 0, .path = path_by(way)}; }

PartWindows windows_by(const Vec3d& way) {
  const std::vector<ReachGoal> goals{goal_by(way)};
  return natural_windows(goals);
}

const TimeWindow& of(const PartWindows& windows, TimedPart part) {
  return windows[static_cast<std::size_t>(part)];
}

void expect_same(const PartWindows& a, const PartWindows& b) {
  for (std::size_t p = 0; p < kTimedParts; ++p) {
    EXPECT_NEAR(a[p].begin, b[p].begin, 1e-15) << p;
    EXPECT_NEAR(a[p].end, b[p].end, 1e-15) << p;
  }
}

TEST(NaturalHaste, IsMoreOnTheWayUpThanOnTheWayDown) {
  EXPECT_GT(natural_haste(path_by(kUp)), natural_haste(path_by(kForwards)));
  EXPECT_GT(natural_haste(path_by(kForwards)), natural_haste(path_by(kDown)));
}

TEST(NaturalHaste, OfWaysUpIsInTheFirstHalf) { EXPECT_GT(natural_haste(path_by(kUp)), 0.0); }

TEST(NaturalHaste, GoesByTheDirectionAlone) {
  const Vec3d way{0.1, 0.3, 0.2};
  const double haste = natural_haste(path_by(way));
  EXPECT_NEAR(natural_haste(path_by(way * 3.0)), haste, 1e-15);
  EXPECT_NEAR(natural_haste(path_by({-0.1, 0.3, 0.2})), haste, 1e-15);
  EXPECT_NEAR(natural_haste(path_by({-0.1, 0.3, -0.2})), haste, 1e-15);
  EXPECT_GT(natural_haste(path_by({0.1, 0.4, 0.2})), haste);
}

TEST(NaturalHaste, NeverTurnsAPathBack) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const double haste = natural_haste(path_by(random_direction(random)));
    EXPECT_LE(std::fabs(haste), 1.0);
  }
}

TEST(NaturalHaste, OfAHandThatStaysIsThatOfALevelWay) {
  EXPECT_EQ(natural_haste(path_by({})), natural_haste(path_by(kForwards)));
}

TEST(NaturalBegin, IsLaterTheMoreTheHandGoesDown) {
  EXPECT_GT(natural_begin(path_by(kDown)), natural_begin(path_by(kDown + kForwards)));
  EXPECT_GT(natural_begin(path_by(kDown + kForwards)), 0.0);
  EXPECT_LT(natural_begin(path_by(kDown)), 0.5);
}

TEST(NaturalBegin, OfLevelWaysAndWaysUpIsAtOnce) {
  for (const Vec3d& way : {kForwards, kUp, kUp + kForwards, Vec3d{}}) {
    EXPECT_EQ(natural_begin(path_by(way)), 0.0);
  }
}

class NaturalDuration : public testing::Test {
 protected:
  // Of a reach straight ahead from the shoulder's height.
  double of(double way, double load = 0.0, double box = 0.0) const {
    const int hand = body_.find_effector("right_hand").value();
    const Kinematics<double> start = home_kinematics(posed_);
    const Vec3d shoulder = start.link_origin(body_.effector(hand).limb_root);
    ReachGoal goal{.effector = hand, .path = {shoulder, shoulder + kForwards * way}};
    goal.tolerance = {box, box, box};
    return natural_duration(body_, start, goal, load);
  }

  PosedBody posed_ = human_body();
  const BodyModel& body_ = posed_.body;
};

TEST_F(NaturalDuration, OfNearGoalsIsThatOfMtm) {
  for (const double way : {0.25, 0.35, 0.5}) {
    EXPECT_NEAR(of(way) / (0.16 + way), 1.2, 1e-9) << way;
    EXPECT_LT(of(way), reach_duration(way, false)) << way;
  }
  EXPECT_NEAR(of(0.59), reach_duration(0.59, false), 1e-9);
  EXPECT_EQ(of(0.05), of(0.0));
}

TEST_F(NaturalDuration, GrowsWithoutAJumpWhereTheTrunkHelps) {
  double before = of(0.4);
  for (double way = 0.405; way < 1.2; way += 0.005) {
    EXPECT_GT(of(way), before) << way;
    EXPECT_LT(of(way), before + 0.012) << way;
    before = of(way);
  }
  EXPECT_NEAR(of(1.1), reach_duration(1.1, true), 1e-9);
}

TEST_F(NaturalDuration, OfALoadHasAFactorAndAConstant) {
  EXPECT_EQ(of(0.5, 1.0), of(0.5));
  const double more = 10.0 - kFreeLoad;
  EXPECT_NEAR(of(0.5, 10.0), of(0.5) * (1.0 + kPerLoad * more) + 0.0283 * more, 1e-9);
}

TEST_F(NaturalDuration, OfAnEasyGoalIsShorterByAThirdAtMost) {
  EXPECT_LT(of(0.6, 0.0, 0.02), of(0.6));
  EXPECT_LT(of(0.6, 0.0, 0.08), of(0.6, 0.0, 0.02));
  EXPECT_GE(of(0.6, 0.0, 0.5), of(0.6) * 2.0 / 3.0 - 1e-9);
}

TEST_F(NaturalDuration, OfADetourIsThatOfItsLength) {
  const int hand = body_.find_effector("right_hand").value();
  ReachGoal goal{.effector = hand, .path = path_by(kForwards * 0.3)};
  const double straight = natural_duration(body_, home_kinematics(posed_), goal, 0.0);
  goal.path.detour = kUp * 0.2;
  EXPECT_GT(natural_duration(body_, home_kinematics(posed_), goal, 0.0), straight + 0.1);
}

TEST(NaturalWindows, AreWithinTheMotion) {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    for (const TimeWindow& window : windows_by(random_direction(random))) {
      EXPECT_GE(window.begin, 0.0);
      EXPECT_LE(window.end, 1.0);
      EXPECT_LT(window.begin, window.end);
    }
  }
}

TEST(NaturalWindows, InARiseKneesAreDoneBeforeHipsAndHipsBeforeTheBack) {
  const PartWindows rise = windows_by(kUp);
  EXPECT_LT(of(rise, TimedPart::knees).end, of(rise, TimedPart::hips).end);
  EXPECT_LT(of(rise, TimedPart::hips).end, of(rise, TimedPart::spine).end);
  EXPECT_LE(of(rise, TimedPart::knees).begin, of(rise, TimedPart::hips).begin);
  EXPECT_LE(of(rise, TimedPart::hips).begin, of(rise, TimedPart::spine).begin);
}

TEST(NaturalWindows, OnTheWayDownTheBackIsDoneNoLaterThanTheHips) {
  const PartWindows down = windows_by(kDown);
  EXPECT_LE(of(down, TimedPart::spine).begin, of(down, TimedPart::hips).begin);
  EXPECT_LE(of(down, TimedPart::spine).end, of(down, TimedPart::hips).end);
}

TEST(NaturalWindows, TheBackIsDoneLaterOnTheWayUpThanOnTheWayDown) {
  EXPECT_GT(of(windows_by(kUp), TimedPart::spine).end, of(windows_by(kDown), TimedPart::spine).end);
}

TEST(NaturalWindows, OfALevelWayAreBetween) {
  const PartWindows up = windows_by(kUp);
  const PartWindows down = windows_by(kDown);
  const PartWindows level = windows_by(kForwards);
  for (std::size_t p = 0; p < kTimedParts; ++p) {
    EXPECT_GE(level[p].begin, min(up[p].begin, down[p].begin)) << p;
    EXPECT_LE(level[p].begin, max(up[p].begin, down[p].begin)) << p;
    EXPECT_GE(level[p].end, min(up[p].end, down[p].end)) << p;
    EXPECT_LE(level[p].end, max(up[p].end, down[p].end)) << p;
  }
}

TEST(NaturalWindows, OfTwoGoalsAreOfTheirMean) {
  const std::vector<ReachGoal> up_and_down{goal_by(kUp), goal_by(kDown * 0.5)};
  expect_same(natural_windows(up_and_down), windows_by(kForwards));
}

TEST(NaturalWindows, OfNoGoalAreOfALevelWay) {
  expect_same(natural_windows({}), windows_by(kForwards));
  expect_same(windows_by({}), windows_by(kForwards));
}

TEST(NaturalWindows, AreTheSameInAMirror) {
  expect_same(windows_by({0.2, 0.3, 0.1}), windows_by({-0.2, 0.3, 0.1}));
}

ReachProblem problem_of(const PosedBody& posed, Preset preset, const char* effector,
                        const Vec3d& goal) {
  const Task task = with_preset(Task(posed, {.goals = {{effector, goal}}}), preset);
  return make_problem(task).value();
}

TEST(MakeProblem, ReachesOfPeopleTakePeoplesTimes) {
  const PosedBody posed = human_body();
  const ReachProblem problem = problem_of(posed, Preset::flat, "right_hand", {-0.2, 0.1, 0.4});
  const EffectorPath& path = problem.goals[0].path;
  EXPECT_EQ(path.haste, natural_haste(path));
  EXPECT_NE(path.haste, 0.0);
  EXPECT_EQ(path.begin, natural_begin(path));
  EXPECT_GT(path.begin, 0.0);
  expect_same(problem.windows, natural_windows(problem.goals));
}

TEST(MakeProblem, ThePapersMotionsAreEven) {
  const ReachProblem problem = problem_of(full(), Preset::paper, "right_hand", {-0.2, 0.1, 0.4});
  EXPECT_EQ(problem.goals[0].path.haste, 0.0);
  EXPECT_EQ(problem.goals[0].path.begin, 0.0);
  for (const TimeWindow& window : problem.windows) {
    EXPECT_EQ(window.begin, 0.0);
    EXPECT_EQ(window.end, 1.0);
  }
}

TEST(MakeProblem, OnlyHandsHaveTimesOfTheirOwn) {
  const PosedBody posed = human_body();
  const Vec3d head = effector_position(posed, posed.home.angles, "head");
  const ReachProblem problem =
      problem_of(posed, Preset::flat, "head", head + Vec3d{0.0, -0.2, 0.1});
  EXPECT_EQ(problem.goals[0].path.haste, 0.0);
  EXPECT_EQ(problem.goals[0].path.begin, 0.0);
}

TEST(CriteriaContext, LooksAtTheHandsOfTheGoals) {
  Task task(human_body(), {.goals = {{"left_hand", {0.2, 1.0, 0.4}}}});
  const std::vector<int> left{task.body.find_effector("left_hand").value()};
  EXPECT_EQ(criteria_context(task).effectors, left);
}

}  // namespace
}  // namespace shigusa
