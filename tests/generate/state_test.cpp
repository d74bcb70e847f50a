// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "kinematics/forward_kinematics.hpp"
#include "problem/make_problem.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The end of the best motion of the task.
State end_of(const Task& task) {
  const GenerateResult result = generate(task).value();
  EXPECT_TRUE(result.meets_goals());
  const Clip& clip = result.candidates[0].motion.clip;
  return clip.state(clip.frames - 1);
}

Task asked(const PosedBody& posed, const std::string& effector, const Vec3d& goal) {
  Task task(posed, {.goals = {{effector, goal}}});
  task.evaluations = 256;
  return task;
}

// Places the named sole at the end of a motion, and at its start.
double slide_of(const PosedBody& posed, const Clip& clip, const std::string& foot) {
  for (const Foot& known : posed.body.feet()) {
    if (known.name != foot) continue;
    const auto at = [&](int f) {
      return placed(posed, clip.state(f)).point(known.link, known.centre);
    };
    return norm(at(clip.frames - 1) - at(0));
  }
  return 1.0;
}

TEST(State, ASecondMotionBeginsWhereTheFirstEnds) {
  const PosedBody posed = human_body();
  const State low = end_of(asked(posed, "right_hand", {-0.2, 0.3, 0.45}));
  Task task = asked(posed, "right_hand", {-0.3, 1.2, 0.4});
  task.start = low;
  const GenerateResult result = generate(task).value();
  EXPECT_EQ(result.status, ReachStatus::reached);
  for (const Candidate& candidate : result.candidates) {
    const Clip& clip = candidate.motion.clip;
    EXPECT_EQ(clip.state(0), low);
    EXPECT_LE(candidate.goals[0].error, kReachTolerance);
    for (const ContactResult& foot : candidate.contacts) EXPECT_LE(foot.max_slide, kReachTolerance);
    EXPECT_LE(slide_of(posed, clip, "left_foot"), kReachTolerance);
  }
}

TEST(State, WhoBeginsBentRisesToWhereTheHipsStand) {
  const PosedBody posed = human_body();
  const State low = end_of(asked(posed, "right_hand", {-0.2, 0.15, 0.4}));
  const auto knee = static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
  ASSERT_GT(low.angles[knee], radians(15.0));
  Task task = asked(posed, "hips", effector_position(posed, posed.home.angles, "hips"));
  task.start = low;
  EXPECT_LT(end_of(task).angles[knee], radians(15.0));
}

TEST(State, AFootThatSteppedStaysWhereItIs) {
  const PosedBody posed = human_body();
  const Vec3d sole = effector_position(posed, posed.home.angles, "left_foot");
  const State stepped = end_of(asked(posed, "left_foot", sole + Vec3d{0.05, 0.0, 0.15}));
  Task task = asked(posed, "right_hand", {-0.2, 1.1, 0.5});
  task.start = stepped;
  const GenerateResult result = generate(task).value();
  EXPECT_EQ(result.status, ReachStatus::reached);
  const Clip& clip = result.candidates[0].motion.clip;
  EXPECT_LE(slide_of(posed, clip, "left_foot"), kReachTolerance);
  // the first motion did step, most of the way of the sole's node
  const Vec3d at =
      placed(posed, stepped).point(posed.body.feet()[1].link, posed.body.feet()[1].centre);
  EXPECT_NEAR(at.z, sole.z + 0.15, 0.08);
}

// A motion that sets out from the middle of another one, to another goal.
Task turned_aside(const PosedBody& posed, const Candidate& first) {
  Task task = asked(posed, "right_hand", {-0.1, 1.4, 0.35});
  task.start = first.motion.clip.state(first.motion.clip.frames / 2);
  return task;
}

TEST(State, AMotionGoesOnWithTheVelocitiesItBeginsWith) {
  const PosedBody posed = human_body();
  const Candidate first =
      generate(asked(posed, "right_hand", {-0.3, 0.7, 0.5})).value().candidates[0];
  const Task task = turned_aside(posed, first);
  const GenerateResult result = generate(task).value();
  EXPECT_EQ(result.status, ReachStatus::reached);
  const auto hand = static_cast<std::size_t>(posed.body.find_effector("right_hand").value());
  const Effector& effector = posed.body.effectors()[hand];
  const auto at = [&](const Clip& clip, int f) {
    return placed(posed, clip.state(f)).point(effector.link, effector.point);
  };
  const Clip& before = first.motion.clip;
  const int middle = before.frames / 2;
  const Vec3d speed = (at(before, middle + 1) - at(before, middle - 1)) * (0.5 / before.frame_time);
  ASSERT_GT(norm(speed), 0.5);
  for (const Candidate& candidate : result.candidates) {
    const Clip& clip = candidate.motion.clip;
    const Vec3d now = (at(clip, 1) - at(clip, 0)) * (1.0 / clip.frame_time);
    EXPECT_LT(norm(now - speed), 0.1 * norm(speed));
    EXPECT_FALSE(candidate.measures.sudden.jolts());
    EXPECT_EQ(clip.state(0).angles, task.start.angles);
    for (std::size_t d = 0; d < clip.before.size(); ++d) {
      EXPECT_NEAR(clip.frame(0)[d] - clip.before[d], task.start.velocities[d] * clip.frame_time,
                  1e-12);
    }
  }
}

TEST(State, AMovingStartIsScoredInTheSearchAsInTheStoredMotion) {
  const PosedBody posed = human_body();
  const Candidate first =
      generate(asked(posed, "right_hand", {-0.3, 0.7, 0.5})).value().candidates[0];
  const GenerateResult result = generate(turned_aside(posed, first)).value();
  EXPECT_LE(result.log.replay_difference, 0.01);
}

TEST(State, OfAnotherBodyOrWithoutANumberIsRefused) {
  Task task = asked(human_body(), "right_hand", {-0.2, 1.1, 0.5});
  task.start.angles.pop_back();
  EXPECT_EQ(generate(task).error().place, "start");
  task.start.angles.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(generate(task).error().place, "start");
  task.start = task.home;
  task.start.velocities = {0.1};
  EXPECT_EQ(generate(task).error().message.key, "start_state");
  task.start.velocities.assign(task.start.angles.size(), 0.0);
  task.generator = MotionGenerator::nlp_ik;
  EXPECT_EQ(generate(task).error().message.key, "start_at_rest");
}

TEST(State, ALoadThatIsHeldIsAsAGoalsLoad) {
  Task asks = asked(human_body(), "right_hand", {-0.2, 0.9, 0.5});
  Task holds = asks;
  asks.goals[0].load = 8.0;
  holds.start.held = {{holds.body.find_effector("right_hand").value(), 8.0}};
  const PreparedTask prepared = PreparedTask::of(holds).value();
  EXPECT_NEAR(prepared.task().body.mass(), holds.body.mass() + 8.0, 1e-9);
  EXPECT_EQ(PreparedTask::of(prepared.task()).value().task().body.mass(),
            prepared.task().body.mass());
  EXPECT_EQ(generate(holds).value().candidates[0].motion.clip.angles,
            generate(asks).value().candidates[0].motion.clip.angles);
  holds.start.held[0].mass = -1.0;
  EXPECT_EQ(generate(holds).error().message.key, "load_range");
}

TEST(State, LayersBeginInAnyPostureAtRest) {
  const PosedBody posed = human_body();
  Task task = with_preset(asked(posed, "right_hand", {-0.3, 1.2, 0.4}), Preset::human);
  task.start = end_of(asked(posed, "right_hand", {-0.2, 0.3, 0.45}));
  const GenerateResult result = generate(task).value();
  EXPECT_TRUE(result.meets_goals());
  const Clip& clip = result.candidates[0].motion.clip;
  EXPECT_EQ(clip.state(0), task.start);
  EXPECT_LE(slide_of(posed, clip, "left_foot"), kReachTolerance);
  task.start.velocities.assign(task.start.angles.size(), 0.1);
  EXPECT_EQ(generate(task).error().message.key, "start_of_layers");
}

}  // namespace
}  // namespace shigusa
