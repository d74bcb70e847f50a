// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <shigusa/generate.hpp>
#include <shigusa/search.hpp>
#include <thread>

#include "generate/layered_approaches.hpp"
#include "paper/arm_feedback.hpp"
#include "problem/make_problem.hpp"
#include "problem/reachability.hpp"
#include "support/layered.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kFrontLow{-0.15, 0.5, 0.5};
constexpr Vec3d kFront{-0.3, 1.2, 0.35};
constexpr Vec3d kOutOfReach{-1.5, 1.5, 1.2};

Task task_for(const PosedBody& posed, const Vec3d& goal, std::uint64_t seed = 1) {
  Task task = with_preset(Task(posed, {.goals = {{"right_hand", goal}}}), Preset::layers);
  task.seed = seed;
  return task;
}

GenerateResult generated(const Task& task) { return generate(task).value(); }

// All numbers of a result.
std::vector<double> numbers(const GenerateResult& g) {
  std::vector<double> all{g.remaining_distance,      g.duration,
                          double(g.log.evaluations), double(g.log.near_copies),
                          double(g.log.missed),      g.best_seen_score};
  for (const Candidate& c : g.candidates) {
    for (const auto* part : {&c.motion.clip.angles, &c.motion.torques}) {
      all.insert(all.end(), part->begin(), part->end());
    }
    all.insert(all.end(), c.parameters.values.begin(), c.parameters.values.end());
    all.insert(all.end(), c.parameters.locked.begin(), c.parameters.locked.end());
    all.insert(all.end(), {c.score.total, c.path_error, c.arm_collision->depth,
                           double(c.arm_collision->searches)});
  }
  return all;
}

TEST(GenerateLayers, HandArrivesAndFeetStay) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (const Vec3d& goal : {kFrontLow, kFront, Vec3d{-0.5, 1.6, 0.2}}) {
      const Task task = task_for(posed, goal);
      expect_layers_kept(task, generated(task));
    }
  }
}

TEST(GenerateLayers, PeopleOfAllSizesAndShapesReach) {
  Landmarks lifted = standing_landmarks(1.7, 0.1);
  lift_leg(lifted.right_leg, 1.0);
  const std::vector<PosedBody> people{
      full_body({0.5, 8.0, Sex::female}), full_body({2.5, 150.0, Sex::male}),
      build_human(asymmetric_person(), {"asymmetric", BodyExtent::full, 1.6, 60.0}),
      build_human(asymmetric_person(), {"asymmetric_half", BodyExtent::half, 1.6, 60.0}),
      build_human(lifted, {"right_leg_up", BodyExtent::full, 1.7, 70.0})};
  for (const PosedBody& posed : people) {
    const Task task = task_for(posed, kFront * (posed.body.stature() / 1.741));
    expect_layers_kept(task, generated(task));
  }
}

TEST(GenerateLayers, EitherHandAndBothTogetherReach) {
  Task task =
      with_preset(Task(full_body(), {.goals = {{"left_hand", {0.3, 1.2, 0.35}}}}), Preset::layers);
  expect_layers_kept(task, generated(task));
  task.goals.push_back({"right_hand", {-0.2, 1.1, 0.4}});
  expect_layers_kept(task, generated(task));
}

TEST(GenerateLayers, BothReadingsReach) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    Task task = task_for(posed, kFront);
    const GenerateResult shared = generated(task);
    task.layer_reading = LayerReading::contraction_a_limb;
    const GenerateResult each = generated(task);
    expect_layers_kept(task, each);
    EXPECT_NE(numbers(each), numbers(shared));
  }
}

TEST(GenerateLayers, ArmWithoutAGoalHangs) {
  const PosedBody posed = full_body();
  for (const Candidate& candidate : generated(task_for(posed, kFrontLow)).candidates) {
    for (int f = 0; f < candidate.motion.clip.frames; ++f) {
      for (int d = 0; d < posed.body.dof_count(); ++d) {
        const bool left_arm =
            posed.body.dof(d).joint == "left_shoulder" || posed.body.dof(d).joint == "left_elbow";
        const auto k = static_cast<std::size_t>(d);
        if (!left_arm) continue;
        EXPECT_EQ(candidate.motion.clip.frame(f)[k], posed.home.angles[k]);
      }
    }
  }
}

TEST(GenerateLayers, SameSeedGivesTheSameNumbersOnAnyMachine) {
  Task task = task_for(full_body(), kFront, 5);
  task.batch = {SimdSet::scalar, 1};
  const auto one = numbers(generated(task));
  task.batch = {widest_simd_set(), 3};
  EXPECT_EQ(numbers(generated(task)), one);
  task.seed = 6;
  EXPECT_NE(numbers(generated(task)), one);
}

TEST(GenerateLayers, MoreEvaluationsFindNoWorse) {
  Task task = task_for(half_body(), kFrontLow);
  double best = std::numeric_limits<double>::infinity();
  for (const int evaluations : {8, 100, 300}) {
    task.evaluations = evaluations;
    const GenerateResult generation = generated(task);
    EXPECT_LE(generation.log.evaluations, evaluations);
    EXPECT_LE(generation.best_seen_score, best);
    best = generation.best_seen_score;
  }
}

TEST(GenerateLayers, EverySearchReaches) {
  Task task = task_for(half_body(), kFront);
  task.evaluations = 150;
  for (const auto& [method, word] : kEnumWords<SearchMethod>) {
    task.search = method;
    const GenerateResult generation = generated(task);
    expect_layers_kept(task, generation);
    EXPECT_EQ(generation.log.evaluations, 150) << word;
    EXPECT_LT(generation.best_seen_score, worst_score(task.criteria)) << word;
  }
}

TEST(GenerateLayers, CandidatesAreRankedAndDiffer) {
  Task task = task_for(half_body(), kFront);
  task.evaluations = 300;
  task.candidates = 4;
  const auto candidates = generated(task).candidates;
  ASSERT_GE(candidates.size(), 2u);
  EXPECT_LE(candidates.size(), 4u);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (candidates[i].arm_collision->left == candidates[i - 1].arm_collision->left) {
      EXPECT_LE(candidates[i - 1].score.total, candidates[i].score.total);
    }
    EXPECT_NE(candidates[i].motion.clip.angles, candidates[i - 1].motion.clip.angles);
  }
}

TEST(GenerateLayers, OwnCriterionDecides) {
  Task task = task_for(half_body(), kFront);
  task.evaluations = 200;
  const auto knee = static_cast<std::size_t>(task.body.find_dof("right_knee.flexion").value());
  const auto last_knee = [knee](const Motion& motion) {
    return motion.clip.frame(motion.clip.frames - 1)[knee];
  };
  // a penalty for knees that are straight at the end
  task.criteria.user = {
      {.name = "sit",
       .weight = 5.0,
       .scale = 1.0,
       .value = [&](const BodyModel&, const Motion& motion) { return 1.0 - last_knee(motion); }}};
  EXPECT_GT(last_knee(generated(task).candidates[0].motion), 0.8);
  task.criteria.user[0].value = [](const BodyModel&, const Motion&) {
    return std::numeric_limits<double>::quiet_NaN();
  };
  const GenerateResult generation = generated(task);
  EXPECT_GT(generation.log.rejected_nan, 0);
  EXPECT_TRUE(generation.meets_goals());
}

TEST(GenerateLayers, CallsAUsersCriterionOnTheCallersThread) {
  Task task = task_for(half_body(), kFront);
  task.batch.threads = 3;
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> elsewhere = 0;
  task.criteria.user = {
      {.name = "where", .weight = 1.0, .scale = 1.0, .value = [&](const BodyModel&, const Motion&) {
         if (std::this_thread::get_id() != caller) ++elsewhere;
         return 0.0;
       }}};
  (void)generated(task);
  EXPECT_EQ(elsewhere, 0);
}

TEST(GenerateLayers, GoalOutOfReachIsAStatusWithTheDistanceLeft) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const GenerateResult generation = generated(task_for(posed, kOutOfReach));
    EXPECT_EQ(generation.status, ReachStatus::unreachable);
    ASSERT_FALSE(generation.candidates.empty());
    EXPECT_GT(generation.remaining_distance, 0.1);
    for (const Candidate& candidate : generation.candidates) {
      const MeasuredMotion measured(reach_with(posed, "right_hand", kOutOfReach),
                                    candidate.motion.clip);
      EXPECT_TRUE(measured.finite);
      EXPECT_LE(measured.contact_slide, kReachTolerance);
    }
  }
}

// Random genomes do not stretch all limbs at once, as these goals require.
TEST(GenerateLayers, GoalsAtTheEdgeOfReachAreMet) {
  for (const Vec3d& goal :
       {Vec3d{-0.83, 1.65, -0.03}, {-0.79, 1.81, 0.26}, {0.46, 1.83, 0.64}, {-0.69, 1.63, 0.68}}) {
    const GenerateResult generation = generated(task_for(half_body(), goal, 0));
    EXPECT_TRUE(generation.meets_goals());
    for (const Candidate& candidate : generation.candidates) {
      // by layers in closed form, or by steps of the whole body's IK
      EXPECT_LT(candidate.goals[0].error, kReachTolerance);
      EXPECT_EQ(candidate.contacts[0].max_slide, 0.0);
    }
  }
}

TEST(GenerateLayers, ClosestMotionsEndNearWhereTheBodyCould) {
  // what layers lack: a limb's last 5° of bend, and 5 mm for more than one candidate
  constexpr double kShort = 0.025;
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (const Vec3d& goal : {Vec3d{-0.2, 2.36, 0.31}, {0.06, 1.98, 1.67}, {-1.96, 2.45, 0.62}}) {
      const Task task = task_for(posed, goal, 0);
      const double closest = closest_reach(make_problem(task).value()).distance;
      const GenerateResult generation = generated(task);
      EXPECT_EQ(generation.status, ReachStatus::unreachable);
      EXPECT_LT(generation.remaining_distance, closest + kShort);
      for (const Candidate& candidate : generation.candidates) {
        const auto again = regenerate(task, candidate.parameters).value();
        EXPECT_EQ(again.candidates[0].motion.clip.angles, candidate.motion.clip.angles);
        EXPECT_EQ(again.status, ReachStatus::unreachable);
      }
    }
  }
}

TEST(GenerateLayers, CancelledBeforeItBeganStillGivesAMotion) {
  const std::atomic<bool> cancel = true;
  const Task task = task_for(half_body(), kFront);
  const auto generation = generate(task, {.report = {}, .cancel = &cancel}).value();
  EXPECT_EQ(generation.end, SearchEnd::cancelled);
  EXPECT_FALSE(generation.candidates.empty());
}

TEST(GenerateLayers, WrongTasksAndBodiesAreErrors) {
  Task task = task_for(half_body(), kFront);
  task.goals[0].effector = "left_hand";
  EXPECT_EQ(generate(task).error().code, ErrorCode::not_found);
  const Task rods =
      with_preset(Task(chain({{}, {}, {}}), {.goals = {{"tip", {0.1, 1.0, 0.1}}}}), Preset::layers);
  EXPECT_EQ(generate(rods).error().code, ErrorCode::unsupported);
}

// Rule R11. The hand moves to the other side of the trunk, and the library, which ignores the
// trunk, leads the forearm through it.
TEST(GenerateLayers, ArmsThatPassThroughTheTrunkAreSearchedAgain) {
  int taken_back = 0;
  for (const Vec3d& goal : {Vec3d{0.1, 1.3, 0.15}, {0.2, 1.3, 0.25}, {0.3, 1.1, 0.25}}) {
    Task task = task_for(half_body(), goal, 0);
    const GenerateResult with = generated(task);
    task.layers.feedback_rounds = 0;
    const GenerateResult without = generated(task);
    expect_layers_kept(task, with);
    for (const Candidate& candidate : without.candidates) {
      const LayeredValues values = layered_of(task, candidate.parameters);
      EXPECT_EQ(candidate.arm_collision->left, candidate.arm_collision->depth > kCollisionDepth);
      EXPECT_EQ(candidate.arm_collision->searches, 0);
      for (const Candidate& again : with.candidates) {
        const LayeredValues others = layered_of(task, again.parameters);
        if (others.joints != values.joints || others.contractions != values.contractions) continue;
        EXPECT_EQ(again.arm_collision->searches > 0, others.arms != values.arms);
        EXPECT_LE(again.arm_collision->searches, kCollisionRounds);
        if (!candidate.arm_collision->left || again.arm_collision->left) continue;
        ++taken_back;
        EXPECT_LE(again.arm_collision->depth, kCollisionDepth);
        // measured apart from the search
        EXPECT_EQ(again.arm_collision->depth,
                  collision_depth(task.body, again.motion.clip, task.body.effectors()[0]));
      }
    }
  }
  EXPECT_GE(taken_back, 3);
}

TEST(GenerateLayers, CollisionThatNoArmCanAvoidIsSaid) {
  // the hand's own way leads through the thigh
  const GenerateResult generation = generated(task_for(half_body(), {0.1, 0.5, 0.15}));
  const Candidate& candidate = generation.candidates.front();
  EXPECT_TRUE(candidate.arm_collision->left);
  EXPECT_GT(candidate.arm_collision->depth, kCollisionDepth);
}

TEST(RegenerateLayers, GivesTheCandidateAgain) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task = task_for(posed, kFront);
    for (const Candidate& candidate : generated(task).candidates) {
      const GenerateResult again = regenerate(task, candidate.parameters).value();
      ASSERT_EQ(again.candidates.size(), 1u);
      EXPECT_EQ(again.candidates[0].motion.clip.angles, candidate.motion.clip.angles);
      EXPECT_EQ(again.candidates[0].score.total, candidate.score.total);
    }
  }
}

// The paper's figure 7.
TEST(RegenerateLayers, MoreContractionOfTheLegsBendsTheKneesMore) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task = task_for(posed, {-0.1, 0.35, 0.4});
    Parameters parameters = generated(task).candidates[0].parameters;
    const auto knee = static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
    double last = 0.0;
    for (const double contraction : {1.5, 3.0, 5.25}) {
      value_of(parameter_list(task.body, task.start, task).value(), parameters, "legs") =
          contraction;
      const auto edited = regenerate(task, parameters).value();
      expect_layers_kept(task, edited);
      const Clip& clip = edited.candidates[0].motion.clip;
      const double bend = clip.frame(clip.frames - 1)[knee];
      EXPECT_GT(bend, last + 0.1) << posed.body.name();
      last = bend;
    }
  }
}

TEST(RegenerateLayers, RefusesParametersOfAnotherBodyOrOutOfRange) {
  const Task task = task_for(half_body(), kFront);
  const Parameters good = generated(task).candidates[0].parameters;
  const auto message = [&](const Parameters& parameters, const Task& of) {
    const auto result = regenerate(of, parameters);
    return result ? "" : result.error().to_string();
  };
  EXPECT_EQ(message(good, task), "");
  EXPECT_THAT(message(good, task_for(full_body(), kFront)),
              testing::HasSubstr("values, for a plan of"));
  const ParameterList list = parameter_list(task.body, task.start, task).value();
  Parameters bad = good;
  value_of(list, bad, "legs") = 15.5;
  EXPECT_THAT(message(bad, task), testing::HasSubstr("contraction is 15.5"));
  bad = good;
  value_of(list, bad, "right_arm.right_shoulder.abduction.weight") = 0.0;
  EXPECT_THAT(message(bad, task), testing::HasSubstr("weight is 0"));
}

}  // namespace
}  // namespace shigusa
