// SPDX-License-Identifier: MIT
// Motions of humans whose heels may lift (preset flat).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>

#include "body/anthropometry.hpp"
#include "body/posture_modes.hpp"
#include "criteria/support_zone.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "plan/held_input.hpp"
#include "problem/make_problem.hpp"
#include "support/lanes.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

constexpr Vec3d kFrontLow{-0.1, 0.3, 0.5};
constexpr double kFlatReach = 2.255;  // m, as high as flat feet reach at …
constexpr Vec3d kAbove{-0.25, 0.0, 0.15};

Task task_for(const Vec3d& goal, bool heels = true) {
  Task task(human_body({.heels = heels}));
  task.goals = {{"right_hand", goal}};
  task.seed = 1;
  task.evaluations = 1500;
  return task;
}

Vec3d above(double rise) { return kAbove + Vec3d{0.0, kFlatReach + rise, 0.0}; }

double most_lifted(const Candidate& candidate) {
  double most = 0.0;
  for (const ContactResult& foot : candidate.contacts) most = max(most, foot.heel->angle);
  return most;
}

double least_inside(const PosedBody& posed, std::span<const double> angles, LiftedHeels lifted) {
  const Vec3d com = centre_of_mass(posed, placed(posed, angles));
  double inside = 1e9;
  for (const SupportEdge& e : support_edges(posed, posed.home, lifted)) {
    inside = min(inside, e.offset + e.x * com.x + e.z * com.z);
  }
  return inside;
}

TEST(Heels, StayDownInPlainReaches) {
  for (const Vec3d& goal :
       {kFrontLow, Vec3d{0.2, 0.35, 0.5}, Vec3d{-0.4, 1.0, 0.4}, Vec3d{-0.25, 2.1, 0.15}}) {
    const GenerateResult generation = generate(task_for(goal)).value();
    EXPECT_TRUE(generation.meets_goals());
    EXPECT_LT(most_lifted(generation.candidates[0]), radians(1.0)) << goal.y;
  }
}

TEST(Heels, LiftForWhatFlatFeetDoNotReach) {
  for (const double rise : {0.01, 0.02, 0.05, 0.08}) {
    const GenerateResult flat = generate(task_for(above(rise), false)).value();
    EXPECT_EQ(flat.status, ReachStatus::unreachable) << rise;
    const Task task = task_for(above(rise));
    const GenerateResult generation = generate(task).value();
    ASSERT_TRUE(generation.meets_goals()) << rise;
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_GT(most_lifted(candidate), radians(3.0));
      EXPECT_TRUE(candidate.measures.over_limit.empty());
      for (const ContactResult& foot : candidate.contacts) EXPECT_LE(foot.max_slide, 1e-3);
      // and stands on the forefeet at the end
      const Clip& clip = candidate.motion.clip;
      EXPECT_GT(least_inside(task, clip.frame(clip.frames - 1), 3U), 0.0) << rise;
    }
  }
}

TEST(Heels, LiftInASquatThatTheAnklesEndBefore) {
  Task task = task_for({-0.1, 0.3, 0.4});
  const ParameterList list = testing_support::list_of(task);
  FixedParameters fixed = no_fixed_parameters(list);
  // with the hips not put back
  testing_support::fix_value(list, "squat", radians(110.0), fixed);
  testing_support::fix_value(list, "lean", 0.0, fixed);
  for (const Dof& dof : task.body.dofs()) {
    if (!dof.joint.ends_with("toes")) continue;
    testing_support::fix_value(list, dof.name, 1.0, fixed);
  }
  task.fixed = fixed;
  const Candidate lifts = generate(task).value().candidates[0];
  EXPECT_GT(most_lifted(lifts), radians(5.0));
  for (const bool left : {true, false}) {
    const char* ankle = left ? "left_ankle.flexion" : "right_ankle.flexion";
    const auto d = static_cast<std::size_t>(task.body.find_dof(ankle).value());
    const Clip& clip = lifts.motion.clip;
    EXPECT_GT(clip.frame(clip.frames - 1)[d], kAnkleFlexion.upper - kLimitMargin);
  }
  // toes that are locked stay
  for (std::size_t d = 0; d < task.body.dofs().size(); ++d) {
    task.fixed->values.locked[d] = task.body.dofs()[d].joint.ends_with("toes");
  }
  EXPECT_EQ(most_lifted(generate(task).value().candidates[0]), 0.0);
}

TEST(Heels, ToldHeightIsThatOfTheHeel) {
  const Task task = task_for(above(0.05));
  const Candidate candidate = generate(task).value().candidates[0];
  for (std::size_t f = 0; f < 2; ++f) {
    const Foot& foot = task.body.feet()[f];
    // the link that the heel is on, and where it is there
    const bool base = foot.link == kBaseLink;
    const int link = base ? foot.heel->toes : task.body.dof(foot.link).parent;
    const Kinematics<double> start = placed(task.body, task.home.angles);
    const Vec3d heel = start.point(foot.link, foot.heel->back);
    const Vec3d in_link =
        transpose_times(start.link_rotation(link), heel - start.link_origin(link));
    double most = 0.0;
    for (int k = 0; k < candidate.motion.clip.frames; ++k) {
      most = max(most, placed(task.body, candidate.motion.clip.frame(k)).point(link, in_link).y);
    }
    EXPECT_NEAR(candidate.contacts[f].heel->height, most - heel.y, 1e-3);
  }
}

TEST(Heels, LiftOfOneFootThatStands) {
  Task task = task_for(above(0.03));
  task.contacts = {"right_foot"};
  const GenerateResult generation = generate(task).value();
  ASSERT_EQ(generation.candidates[0].contacts.size(), 1u);
  EXPECT_EQ(generation.candidates[0].contacts[0].node, "right_toes");
  EXPECT_LE(generation.candidates[0].contacts[0].max_slide, 1e-3);
}

// A heel reaches its goal by the ankle above it, while its toes stay.
TEST(Heels, LiftsForAGoalOfTheAnkle) {
  Task task = task_for(kFrontLow);
  const Vec3d from = effector_position(task.body, task.home.angles, "left_ankle");
  const int toes = task.body.feet()[1].heel->toes;
  const Kinematics<double> start = placed(task.body, task.home.angles);
  const Mat3d& foot = start.link_rotation(toes);
  const Vec3d hinge = start.link_origin(toes);
  const double angle = radians(22.0);
  const Vec3d up = hinge + foot * (rotation(Axis::x, angle) * transpose_times(foot, from - hinge));
  task.goals = {{"left_ankle", up}};
  const GenerateResult generation = generate(task).value();
  ASSERT_TRUE(generation.meets_goals());
  const auto& contacts = generation.candidates[0].contacts;
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_NEAR(contacts[1].heel->angle, angle, radians(1.0));
  EXPECT_LT(contacts[0].heel->angle, radians(3.0));
  EXPECT_LE(contacts[1].max_slide, 1e-3);
}

// A foot lands flat after a step, toes included.
TEST(Heels, AStepLandsLevel) {
  Task task = task_for(kFrontLow);
  const Vec3d from = effector_position(task.body, task.home.angles, "left_foot");
  task.goals = {{"left_foot", from + Vec3d{0.05, 0.0, 0.2}}};
  const GenerateResult generation = generate(task).value();
  ASSERT_TRUE(generation.meets_goals());
  const Clip& clip = generation.candidates[0].motion.clip;
  const auto toes = static_cast<std::size_t>(task.body.feet()[1].heel->toes);
  const Kinematics<double> end = placed(task.body, clip.frame(clip.frames - 1));
  EXPECT_GT(end.link_rotation(static_cast<int>(toes)).cy.y, sin_cos(radians(0.5)).cos);
  EXPECT_LT(clip.frame(clip.frames - 1)[toes], radians(3.0));
}

TEST(Heels, LanesScoreAsDoubleDoes) {
  const Task task = task_for(kFrontLow);
  const ReachProblem problem = make_problem(task).value();
  Random random(3);
  PlayedMotions played;
  std::vector<float> rows;
  std::vector<float> postures;
  std::vector<float> timing;
  for (int i = 0; i < 48; ++i) {
    Parameters parameters = random_parameters(task.body, random);
    testing_support::pose(task, parameters, [&](const PostureMode& mode) {
      return (mode.name == "squat" ? 1.0 : 0.1) * random.uniform(mode.lower, mode.upper);
    });
    // toes that give as readily as others
    for (std::size_t d = 0; d < task.body.dofs().size(); ++d) {
      if (task.body.dofs()[d].give < 1.0) parameters.values[d] = 1.0;
    }
    played.add(problem, parameters, task.criteria);
    for (const double w : inverse_weights(task.body, parameters))
      rows.push_back(static_cast<float>(w));
    for (const double q : posture_change(task.body, testing_support::modes_of(task, parameters))) {
      postures.push_back(static_cast<float>(q));
    }
    timing.insert(timing.end(), kTimings, 0.0F);
  }
  double lifted = 0.0;
  const auto toes = static_cast<std::size_t>(task.body.find_dof("right_toes.flexion").value());
  for (std::size_t k = toes; k < played.ends.size(); k += task.body.dofs().size()) {
    lifted = max(lifted, played.ends[k]);
  }
  EXPECT_GT(lifted, radians(5.0));
  expect_lanes_like(played, problem, task.criteria, MotionInputs(rows, postures, timing));
}

TEST(Heels, AreOfThePresetFlat) {
  for (const Preset preset : {Preset::paper, Preset::layers, Preset::human}) {
    const auto made = generate(with_preset(task_for(kFrontLow), preset));
    ASSERT_FALSE(made.has_value());
    EXPECT_THAT(made.error().message, HasSubstr("heels"));
  }
}

}  // namespace
}  // namespace shigusa
