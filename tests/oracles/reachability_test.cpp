// SPDX-License-Identifier: MIT
#include "problem/reachability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/generate.hpp>

#include "generate/distinct.hpp"
#include "problem/make_problem.hpp"
#include "support/independent_reach.hpp"
#include "support/problems.hpp"
#include "support/reach_bounds.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Among postures whose distances differ by less than 5 mm the library takes the most natural one,
// and its descents end within 0.1 mm of their limit.
constexpr double kNearEqual = 5.1e-3;

TEST(ReachabilityAgainstSecondSearch, OneHand) {
  const PosedBody posed = full_body();
  Random random(101);
  int unreachable = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3d goal{random.uniform(-1.3, 1.3), random.uniform(0.0, 2.3),
                     random.uniform(-1.3, 1.3)};
    const ReachProblem problem = reach_with(posed, "right_hand", goal);
    const ClosestReach reach = closest_reach(problem);
    if (reach.reached()) continue;
    ++unreachable;
    const double other = IndependentReach(problem).distance(30, random);
    ASSERT_GT(other, kReachTolerance) << "the library gave up a goal that can be met";
    ASSERT_LT(reach.distance, other + kNearEqual);
  }
  EXPECT_GT(unreachable, 20);
}

TEST(ReachabilityAgainstSecondSearch, BothHands) {
  const PosedBody posed = full_body();
  Random random(102);
  int unreachable = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Vec3d goal{random.uniform(-1.0, 1.0), random.uniform(0.0, 2.2),
                     random.uniform(-1.0, 1.0)};
    const Vec3d apart{random.uniform(0.0, 0.9), random.uniform(-0.5, 0.5),
                      random.uniform(-0.5, 0.5)};
    ReachProblem problem = reach_with(posed, "right_hand", goal);
    problem.goals.push_back(reach_with(posed, "left_hand", goal + apart).goals[0]);
    const ClosestReach reach = closest_reach(problem);
    if (reach.reached()) continue;
    ++unreachable;
    const double other = IndependentReach(problem).distance(30, random);
    ASSERT_GT(other, kReachTolerance);
    ASSERT_LT(reach.distance, other + kNearEqual);
  }
  EXPECT_GT(unreachable, 15);
}

TEST(ReachabilityAgainstSecondSearch, NearTheEdge) {
  // goals that the library calls unreachable by less than 3 cm
  const PosedBody posed = full_body();
  Random random(103);
  int near = 0;
  while (near < 25) {
    const Vec3d goal{random.uniform(-1.3, 1.3), random.uniform(0.0, 2.3),
                     random.uniform(-1.3, 1.3)};
    const ReachProblem problem = reach_with(posed, "right_hand", goal);
    const ClosestReach reach = closest_reach(problem);
    if (reach.reached() || reach.distance > 0.03) continue;
    ++near;
    ASSERT_GT(IndependentReach(problem).distance(60, random), kReachTolerance);
  }
}

// sanitizers make everything slower by an order of magnitude
#if defined(__has_feature)
#define SHG_HAS_FEATURE(feature) __has_feature(feature)
#else
#define SHG_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    SHG_HAS_FEATURE(address_sanitizer) || SHG_HAS_FEATURE(thread_sanitizer)
constexpr int kGoals = 100;
#else
constexpr int kGoals = 1000;
#endif

// A thousand random goals of one body, each searched with the first three populations of the
// paper's algorithm: enough to exercise the library's handling of any goal.
class ManyGoals {
 public:
  explicit ManyGoals(PosedBody posed) : task_(with_preset(Task(std::move(posed)), Preset::paper)) {
    task_.genetic.max_generations = 2;
  }

  // calls check(problem, generation) after the checks of every result
  template <class Check>
  void run(Random& random, Check check) {
    const auto hands = static_cast<std::uint32_t>(task_.body.effectors().size());
    for (int trial = 0; trial < kGoals; ++trial) {
      SCOPED_TRACE(trial);
      const Vec3d goal{random.uniform(-1.3, 1.3), random.uniform(0.0, 2.3),
                       random.uniform(-1.3, 1.3)};
      task_.goals = {{task_.body.effectors()[random.below(hands)].name, goal}};
      task_.seed = static_cast<std::uint64_t>(trial);
      const Result<GenerateResult> generation = generate(task_);
      ASSERT_TRUE(generation);
      check_candidates(*generation);
      if (trial % 10 == 0) check_regeneration(*generation);
      (generation->meets_goals() ? reached_ : unreachable_) += 1;
      check(make_problem(task_).value(), *generation);
      if (testing::Test::HasFatalFailure()) return;
    }
    testing::Test::RecordProperty("reached", reached_);
    testing::Test::RecordProperty("unreachable", unreachable_);
    EXPECT_GT(reached_, kGoals / 4);
    EXPECT_GT(unreachable_, kGoals / 4);
  }

 private:
  void check_candidates(const GenerateResult& generation) {
    ASSERT_FALSE(generation.candidates.empty());
    const ReachProblem problem = make_problem(task_).value();
    for (const Candidate& candidate : generation.candidates) {
      const MeasuredMotion measured(problem, candidate.motion.clip);
      ASSERT_TRUE(measured.finite);
      ASSERT_TRUE(std::isfinite(candidate.score.total));
      for (const double tau : candidate.motion.torques) ASSERT_TRUE(std::isfinite(tau));
      ASSERT_EQ(measured.start_error, 0.0);
      ASSERT_LE(measured.contact_slide, 1e-3);
      ASSERT_LE(degrees(measured.contact_tilt), 0.1);
      if (generation.meets_goals()) {
        ASSERT_LE(measured.goal_error, 1e-3);
      }
    }
  }

  void check_regeneration(const GenerateResult& generation) {
    for (const Candidate& candidate : generation.candidates) {
      const GenerateResult again = regenerate(task_, candidate.parameters).value();
      ASSERT_EQ(again.meets_goals(), generation.meets_goals());
      ASSERT_EQ(again.candidates[0].motion.clip.angles, candidate.motion.clip.angles);
    }
  }

  Task task_;
  int reached_ = 0;
  int unreachable_ = 0;
};

// The candidates end within 5 mm of the closest point, which is within 5 mm of the best one.
constexpr double kEdge = kNearEqual + kEdgeTolerance;

TEST(ThousandGoals, OfTheHalfBody) {
  Random random(104);
  ManyGoals(half_body()).run(random, [](const ReachProblem& problem, const GenerateResult& g) {
    const double exact = half_body_distance(*problem.body, problem.goals[0].path.goal);
    ASSERT_EQ(g.meets_goals(), exact <= kReachTolerance) << exact;
    if (g.status == ReachStatus::unreachable) {
      ASSERT_NEAR(g.remaining_distance, exact, kEdge);
    }
  });
}

TEST(ThousandGoals, OfTheFullBody) {
  Random random(105);
  ManyGoals(full_body()).run(random, [&](const ReachProblem& problem, const GenerateResult& g) {
    if (g.meets_goals()) return;
    const double other = IndependentReach(problem).distance(20, random);
    ASSERT_GT(other, kReachTolerance) << "the library gave up a goal that can be met";
    ASSERT_LT(g.remaining_distance, other + kEdge);
  });
}

}  // namespace
}  // namespace shigusa
