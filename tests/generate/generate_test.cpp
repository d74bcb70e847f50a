// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <shigusa/generate.hpp>

#include "generate/distinct.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kFrontLow{-0.15, 0.5, 0.5};
constexpr Vec3d kOutOfReach{-1.5, 1.5, 1.2};

Task task_for(const PosedBody& posed, const Vec3d& goal, std::uint64_t seed = 1) {
  Task task = with_preset(Task(posed, {.goals = {{"right_hand", goal}}}), Preset::paper);
  task.seed = seed;
  return task;
}

GenerateResult generated(const Task& task, const Progress& progress = {}) {
  return generate(task, progress).value();
}

// One search of a task is shared by many tests, as it takes long.
const GenerateResult& full_generation() {
  static const GenerateResult generation = generated(task_for(full_body(), kFrontLow));
  return generation;
}

// Largest root-mean-square difference (rad) of two motions' angles in any frame.
double motion_distance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (int f = 0; f < a.frames; ++f) {
    double squares = 0.0;
    for (std::size_t d = 0; d < a.frame(f).size(); ++d) {
      squares += std::pow(a.frame(f)[d] - b.frame(f)[d], 2);
    }
    largest = std::fmax(largest, std::sqrt(squares / a.dofs));
  }
  return largest;
}

// All numbers of a candidate.
std::vector<double> numbers(const Candidate& c) {
  std::vector<double> all = c.motion.clip.angles;
  all.insert(all.end(), c.motion.torques.begin(), c.motion.torques.end());
  all.push_back(c.motion.clip.frame_time);
  for (const Vec3d& p : c.motion.centre_of_mass) all.insert(all.end(), {p.x, p.y, p.z});
  for (const auto& path : c.motion.effectors) {
    for (const Vec3d& p : path) all.insert(all.end(), {p.x, p.y, p.z});
  }
  all.insert(all.end(), c.parameters.values.begin(), c.parameters.values.end());
  all.insert(all.end(), c.parameters.locked.begin(), c.parameters.locked.end());
  all.push_back(c.score.total);
  for (const ScoreTerm& t : c.score.terms) all.insert(all.end(), {t.weight, t.penalty});
  for (const GoalResult& g : c.goals) all.insert(all.end(), {g.reached.x, g.reached.y, g.error});
  for (const ContactResult& k : c.contacts) all.push_back(k.max_slide);
  for (const LimitExcess& e : c.measures.over_limit) all.push_back(e.excess);
  return all;
}

std::vector<double> numbers(const GenerateResult& g) {
  std::vector<double> all{g.remaining_distance,      g.duration,
                          double(g.log.evaluations), double(g.log.generations),
                          double(g.log.near_copies), double(g.log.missed),
                          g.best_seen_score};
  for (const Candidate& c : g.candidates) {
    const std::vector<double> more = numbers(c);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(Generate, SameSeedGivesTheSameNumbers) {
  const Task task = task_for(half_body(), kFrontLow, 5);
  EXPECT_EQ(numbers(generated(task)), numbers(generated(task)));
  EXPECT_EQ(numbers(generated(task_for(full_body(), kFrontLow))), numbers(full_generation()));
}

TEST(Generate, AnotherSeedFindsOtherMotions) {
  const GenerateResult one = generated(task_for(half_body(), kFrontLow, 5));
  const GenerateResult other = generated(task_for(half_body(), kFrontLow, 6));
  EXPECT_NE(numbers(one.candidates[0]), numbers(other.candidates[0]));
}

TEST(Generate, CandidatesMeetTheGoal) {
  const GenerateResult& generation = full_generation();
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_EQ(generation.remaining_distance, 0.0);
  for (const Candidate& candidate : generation.candidates) {
    ASSERT_EQ(candidate.goals.size(), 1u);
    const GoalResult& goal = candidate.goals[0];
    EXPECT_EQ(goal.asked.effector, "right_hand");
    EXPECT_EQ(goal.node, "right_hand_grip");
    EXPECT_EQ(goal.asked.position, kFrontLow);
    EXPECT_LE(goal.error, kReachTolerance);
    EXPECT_DOUBLE_EQ(goal.error, norm(goal.asked.position - goal.reached));
    EXPECT_EQ(goal.reached,
              effector_position(full_body(), candidate.motion.clip.frame(60), "right_hand"));
  }
}

TEST(Generate, FeetStayWhereTheyStand) {
  const PosedBody posed = full_body();
  const ReachProblem problem = reach_with(posed, "right_hand", kFrontLow);
  for (const Candidate& candidate : full_generation().candidates) {
    ASSERT_EQ(candidate.contacts.size(), 2u);
    const MeasuredMotion measured(problem, candidate.motion.clip);
    EXPECT_LE(measured.contact_slide, 1e-3);
    EXPECT_LE(degrees(measured.contact_tilt), 0.1);
    EXPECT_EQ(candidate.contacts[0].max_slide, 0.0) << "the base";
    EXPECT_LE(candidate.contacts[1].max_slide, 1e-3);
    EXPECT_EQ(measured.start_error, 0.0);
  }
}

TEST(Generate, CandidatesDifferFromEachOther) {
  const auto& candidates = full_generation().candidates;
  ASSERT_GE(candidates.size(), 2u);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(motion_distance(candidates[i].motion.clip, candidates[j].motion.clip),
                kDistinctPosture);
    }
  }
}

TEST(Generate, BestCandidateComesFirst) {
  const auto& candidates = full_generation().candidates;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    EXPECT_LE(candidates[i - 1].score.total, candidates[i].score.total);
  }
}

TEST(Generate, ScoresAreThoseOfTheMotions) {
  const PosedBody posed = full_body();
  for (const Candidate& candidate : full_generation().candidates) {
    EXPECT_EQ(candidate.score.total, score_motion(posed, candidate.motion, {}).total);
    EXPECT_LT(candidate.score.total, worst_score({}));
  }
  EXPECT_LE(full_generation().best_seen_score, full_generation().candidates[0].score.total);
}

TEST(Generate, KeepsToTheNumberOfCandidates) {
  Task task = task_for(half_body(), kFrontLow);
  task.candidates = 1;
  const GenerateResult one = generated(task);
  ASSERT_EQ(one.candidates.size(), 1u);
  task.candidates = 8;
  EXPECT_EQ(numbers(one.candidates[0]), numbers(generated(task).candidates[0]));
}

TEST(Generate, ParametersArePapersCode) {
  for (const Candidate& candidate : full_generation().candidates) {
    for (std::size_t d = 0; d < full_body().body.dofs().size(); ++d) {
      const double weight = candidate.parameters.values[d];
      EXPECT_EQ(weight, std::floor(weight));
      EXPECT_TRUE(weight >= 1.0 && weight <= 15.0);
    }
  }
}

TEST(Generate, TellsWhichLimitsAreExceeded) {
  const PosedBody posed = full_body();
  for (const Candidate& candidate : full_generation().candidates) {
    for (std::size_t i = 0; i < candidate.measures.over_limit.size(); ++i) {
      const LimitExcess& over = candidate.measures.over_limit[i];
      EXPECT_TRUE(posed.body.find_dof(over.dof)) << over.dof;
      EXPECT_GT(degrees(over.excess), 0.1);
      if (i > 0) {
        EXPECT_LE(over.excess, candidate.measures.over_limit[i - 1].excess);
      }
    }
    EXPECT_EQ(candidate.score.terms[0].penalty > 1e-3, !candidate.measures.over_limit.empty());
  }
}

TEST(Generate, BothHandsReachTogether) {
  Task task = task_for(full_body(), {-0.2, 0.8, 0.5});
  task.goals.push_back({"left_hand", {0.2, 0.9, 0.45}});
  const GenerateResult generation = generated(task);
  EXPECT_TRUE(generation.meets_goals());
  for (const Candidate& candidate : generation.candidates) {
    ASSERT_EQ(candidate.goals.size(), 2u);
    EXPECT_LE(candidate.goals[0].error, kReachTolerance);
    EXPECT_LE(candidate.goals[1].error, kReachTolerance);
  }
}

// The largest change (rad) of any angle of these joints during a motion.
double largest_change(const PosedBody& posed, const Clip& clip,
                      const std::function<bool(const Dof&)>& counts) {
  double largest = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const auto k = static_cast<std::size_t>(d);
      if (!counts(posed.body.dof(d))) continue;
      largest = std::fmax(largest, std::fabs(clip.frame(f)[k] - posed.home.angles[k]));
    }
  }
  return largest;
}

TEST(Generate, LimbsThatNoGoalNeedsKeepTheirAngles) {
  // the other arm, and a leg that is lifted at the start; in reach and out of it
  Landmarks person = standing_landmarks(1.7, 0.1);
  lift_leg(person.left_leg, 1.0);
  const PosedBody posed = build_human(person, {"one_leg_up", BodyExtent::full, 1.7, 70.0});
  const auto is_left = [](const Dof& dof) { return dof.joint.starts_with("left_"); };
  for (const Vec3d& goal : {kFrontLow, kOutOfReach}) {
    for (const Candidate& candidate : generated(task_for(posed, goal)).candidates) {
      EXPECT_EQ(largest_change(posed, candidate.motion.clip, is_left), 0.0);
      EXPECT_GT(largest_change(posed, candidate.motion.clip, std::not_fn(is_left)), 0.1);
    }
  }
}

TEST(Generate, PeopleOfAllSizesReachInProportion) {
  for (const double stature : {0.5, 1.0, 2.5}) {
    const PosedBody posed = full_body({stature, 70.0, Sex::female});
    const GenerateResult generation = generated(task_for(posed, kFrontLow * (stature / 1.741)));
    EXPECT_TRUE(generation.meets_goals()) << stature;
    EXPECT_LE(generation.candidates[0].goals[0].error, kReachTolerance);
  }
}

TEST(Generate, WrongTaskIsAnError) {
  Task task = task_for(half_body(), kFrontLow);
  task.goals[0].effector = "left_hand";
  const Result<GenerateResult> generation = generate(task);
  ASSERT_FALSE(generation);
  EXPECT_EQ(generation.error().code, ErrorCode::not_found);
}

TEST(Generate, UnreachableGoalIsAStatusWithTheDistanceLeft) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const GenerateResult generation = generated(task_for(posed, kOutOfReach));
    EXPECT_EQ(generation.status, ReachStatus::unreachable);
    ASSERT_FALSE(generation.candidates.empty());
    const Candidate& best = generation.candidates[0];
    EXPECT_GT(generation.remaining_distance, 0.1);
    EXPECT_DOUBLE_EQ(generation.remaining_distance, best.goals[0].error);
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_LE(candidate.goals[0].error, best.goals[0].error + 2 * kEdgeTolerance);
    }
  }
}

TEST(Generate, MotionTowardsAnUnreachableGoalIsCalm) {
  // joints turn by no more in a frame than a fast reach asks for, and the hand does not turn back
  const PosedBody posed = full_body();
  const GenerateResult generation = generated(task_for(posed, kOutOfReach));
  const ReachProblem problem = reach_with(posed, "right_hand", kOutOfReach);
  for (const Candidate& candidate : generation.candidates) {
    const MeasuredMotion measured(problem, candidate.motion.clip);
    EXPECT_TRUE(measured.finite);
    EXPECT_LT(degrees(measured.largest_step), 20.0);
    EXPECT_LE(measured.contact_slide, 1e-3);
    double left = 1e9;
    for (const Vec3d& at : candidate.motion.effectors[0]) {
      EXPECT_LT(norm(at - kOutOfReach), left + 1e-2);
      left = std::fmin(left, norm(at - kOutOfReach));
    }
  }
}

TEST(Generate, CancelledBeforeItBeganStillGivesAMotion) {
  const std::atomic<bool> cancel = true;
  const GenerateResult generation =
      generated(task_for(full_body(), kFrontLow), {.report = {}, .cancel = &cancel});
  EXPECT_EQ(generation.end, SearchEnd::cancelled);
  ASSERT_FALSE(generation.candidates.empty());
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_EQ(generation.log.evaluations, kPaperPopulation);
}

TEST(Generate, CancelledInTheMiddleGivesTheBestSoFar) {
  std::atomic<bool> cancel = false;
  int reports = 0;
  const Progress progress{.report =
                              [&](const ProgressReport&) {
                                if (++reports == 3) cancel = true;
                              },
                          .cancel = &cancel};
  const GenerateResult generation = generated(task_for(full_body(), kFrontLow), progress);
  EXPECT_EQ(generation.end, SearchEnd::cancelled);
  EXPECT_EQ(generation.log.generations, 2);
  EXPECT_FALSE(generation.candidates.empty());
}

TEST(Generate, ReportsItsProgress) {
  std::vector<ProgressReport> reports;
  const Progress progress{.report = [&](const ProgressReport& r) { reports.push_back(r); }};
  const GenerateResult generation = generated(task_for(half_body(), kFrontLow), progress);
  ASSERT_FALSE(reports.empty());
  for (std::size_t i = 1; i < reports.size(); ++i) {
    EXPECT_GE(reports[i].fraction, reports[i - 1].fraction);
    EXPECT_GE(reports[i].evaluations, reports[i - 1].evaluations);
    EXPECT_LE(reports[i].best_score, reports[i - 1].best_score);
  }
  EXPECT_EQ(reports.back().evaluations, generation.log.evaluations);
  // scored in single precision during the search
  EXPECT_NEAR(reports.back().best_score, generation.best_seen_score, kReplayTolerance);
}

TEST(Generate, ProgressOfASearchInPartsNeverGoesBack) {
  Task task = task_for(full_body(), kFrontLow);
  task.preset = Preset::flat;
  for (const int threads : {1, 2}) {
    task.batch.threads = threads;
    std::vector<ProgressReport> reports;
    const Progress progress{.report = [&](const ProgressReport& r) { reports.push_back(r); }};
    const GenerateResult generation = generated(task, progress);
    ASSERT_FALSE(reports.empty());
    for (std::size_t i = 1; i < reports.size(); ++i) {
      EXPECT_GE(reports[i].fraction, reports[i - 1].fraction);
      EXPECT_GE(reports[i].evaluations, reports[i - 1].evaluations);
      EXPECT_LE(reports[i].best_score, reports[i - 1].best_score);
    }
    EXPECT_LE(reports.back().fraction, 1.0);
    EXPECT_LE(reports.back().evaluations, generation.log.evaluations);
    if (threads > 1) continue;  // the first to begin and the last to end may be on another thread
    EXPECT_LT(reports.front().fraction, 0.1);
    EXPECT_GT(reports.back().fraction, 0.95);
    EXPECT_EQ(reports.back().evaluations, generation.log.evaluations);
  }
}

// Largest bend of the right elbow, as a share of a straight angle.
UserCriterion elbow_bend() {
  return {.name = "elbow_bend",
          .weight = 5.0,
          .scale = kPi,
          .value = [](const BodyModel& body, const Motion& motion) {
            const auto elbow = static_cast<std::size_t>(*body.find_dof("right_elbow.flexion"));
            double most = 0.0;
            for (int f = 0; f < motion.clip.frames; ++f) {
              most = std::fmax(most, motion.clip.frame(f)[elbow]);
            }
            return most;
          }};
}

TEST(Generate, OwnCriterionChangesWhatIsChosen) {
  Task task = task_for(half_body(), {-0.3, 1.2, 0.35});
  const GenerateResult without = generated(task);
  task.criteria.user = {elbow_bend()};
  const GenerateResult with = generated(task);
  const auto bend = [&](const GenerateResult& generation) {
    return elbow_bend().value(task.body, generation.candidates[0].motion);
  };
  EXPECT_LT(bend(with), bend(without));
  EXPECT_EQ(with.candidates[0].score.terms.back().name, "elbow_bend");
}

TEST(Generate, OwnCriterionOfManyMotionsIsTheSame) {
  Task task = task_for(half_body(), {-0.3, 1.2, 0.35});
  task.criteria.user = {elbow_bend()};
  const GenerateResult one_by_one = generated(task);
  std::size_t most = 0;
  task.criteria.user[0].values = [&most, bend = elbow_bend().value](const BodyModel& body,
                                                                    std::span<const Motion> motions,
                                                                    std::span<double> values) {
    most = std::max(most, motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) values[i] = bend(body, motions[i]);
  };
  task.criteria.user[0].value = nullptr;
  const GenerateResult together = generated(task);
  EXPECT_GT(most, 1U);
  ASSERT_EQ(together.candidates.size(), one_by_one.candidates.size());
  for (std::size_t i = 0; i < together.candidates.size(); ++i) {
    EXPECT_EQ(together.candidates[i].motion.clip.angles,
              one_by_one.candidates[i].motion.clip.angles);
    EXPECT_EQ(together.candidates[i].score.total, one_by_one.candidates[i].score.total);
  }
}

TEST(Generate, CriterionThatIsAlwaysZeroChangesNothing) {
  Task task = task_for(half_body(), kFrontLow);
  const GenerateResult without = generated(task);
  task.criteria.user = {
      {.name = "none", .weight = 1.0, .scale = 1.0, .value = [](const BodyModel&, const Motion&) {
         return 0.0;
       }}};
  const GenerateResult with = generated(task);
  ASSERT_EQ(with.candidates.size(), without.candidates.size());
  for (std::size_t i = 0; i < with.candidates.size(); ++i) {
    EXPECT_EQ(with.candidates[i].motion.clip.angles, without.candidates[i].motion.clip.angles);
  }
}

TEST(Generate, NaNsOfACriterionAreRejectedAndCounted) {
  // NaN for motions that bend the elbow: they are not chosen while there are others
  Task task = task_for(half_body(), {-0.3, 1.2, 0.35});
  task.criteria.user = {elbow_bend()};
  const auto bend = task.criteria.user[0].value;
  task.criteria.user[0].value = [bend](const BodyModel& body, const Motion& motion) {
    const double value = bend(body, motion);
    return value > 1.2 ? std::numeric_limits<double>::quiet_NaN() : value;
  };
  const GenerateResult generation = generated(task);
  EXPECT_GT(generation.log.rejected_nan, 0);
  EXPECT_LT(generation.log.rejected_nan, generation.log.evaluations);
  EXPECT_TRUE(std::isfinite(generation.candidates[0].score.total));
}

TEST(Generate, CriterionThatIsAlwaysNaNStillGivesMotions) {
  Task task = task_for(half_body(), kFrontLow);
  task.criteria.user = {elbow_bend()};
  task.criteria.user[0].value = [](const BodyModel&, const Motion&) {
    return std::numeric_limits<double>::quiet_NaN();
  };
  const GenerateResult generation = generated(task);
  EXPECT_EQ(generation.log.rejected_nan, generation.log.evaluations);
  ASSERT_FALSE(generation.candidates.empty());
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_LE(generation.candidates[0].goals[0].error, kReachTolerance);
}

TEST(Regenerate, GivesTheCandidateAgain) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (const Vec3d& goal : {kFrontLow, kOutOfReach}) {
      const Task task = task_for(posed, goal);
      MotionPlayer player = MotionPlayer::of(task).value();
      for (const Candidate& candidate : generated(task).candidates) {
        const GenerateResult again = regenerate(task, candidate.parameters).value();
        ASSERT_EQ(again.candidates.size(), 1u);
        EXPECT_EQ(numbers(again.candidates[0]), numbers(candidate));
        // a player keeps its task's data, and no state of played motions
        for (int times = 0; times < 2; ++times) {
          const GenerateResult played = player.play(candidate.parameters).value();
          EXPECT_EQ(numbers(played.candidates[0]), numbers(candidate));
          EXPECT_EQ(played.status, again.status);
        }
      }
    }
  }
}

// Total change (rad) of a dof over a motion.
double travel(const Clip& clip, int dof) {
  double sum = 0.0;
  const auto d = static_cast<std::size_t>(dof);
  for (int f = 1; f < clip.frames; ++f) {
    sum += std::fabs(clip.frame(f)[d] - clip.frame(f - 1)[d]);
  }
  return sum;
}

TEST(Regenerate, LargerWeightMovesTheJointLessAndTheHandArrivesAllTheSame) {
  // exactly true of one step, and in the end of nearly all motions; the two hips of the full body,
  // which turn the trunk together, are an exception
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task = task_for(posed, kFrontLow);
    const Parameters uniform = uniform_parameters(posed);
    const GenerateResult before = regenerate(task, uniform).value();
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      if (posed.body.dof(d).name.ends_with("hip.flexion") ||
          posed.body.dof(d).joint.starts_with("left_")) {
        continue;
      }
      Parameters heavier = uniform;
      heavier.values[static_cast<std::size_t>(d)] = 10.0;
      const GenerateResult after = regenerate(task, heavier).value();
      EXPECT_TRUE(after.meets_goals());
      EXPECT_LE(after.candidates[0].goals[0].error, kReachTolerance);
      EXPECT_LT(travel(after.candidates[0].motion.clip, d),
                travel(before.candidates[0].motion.clip, d))
          << posed.body.name() << " " << posed.body.dof(d).name;
    }
  }
}

TEST(Regenerate, LockedJointStaysAndTheHandArrivesAllTheSame) {
  const PosedBody posed = half_body();
  Parameters parameters = uniform_parameters(posed);
  const int knee = posed.body.find_dof("right_knee.flexion").value();
  parameters.locked[static_cast<std::size_t>(knee)] = true;
  const GenerateResult generation = regenerate(task_for(posed, kFrontLow), parameters).value();
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_EQ(travel(generation.candidates[0].motion.clip, knee), 0.0);
}

TEST(Regenerate, WithAllJointsLockedTellsHowFarTheGoalIs) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    Parameters parameters = uniform_parameters(posed);
    testing_support::lock_all(parameters);
    const GenerateResult generation = regenerate(task_for(posed, kFrontLow), parameters).value();
    EXPECT_EQ(generation.status, ReachStatus::unreachable);
    const Vec3d hand = effector_position(posed, posed.home.angles, "right_hand");
    EXPECT_NEAR(generation.remaining_distance, norm(hand - kFrontLow), 1e-12);
  }
}

TEST(Regenerate, RefusesParametersOfAnotherBody) {
  const Result<GenerateResult> generation =
      regenerate(task_for(full_body(), kFrontLow), uniform_parameters(half_body()));
  ASSERT_FALSE(generation);
  EXPECT_THAT(generation.error().to_string(), testing::HasSubstr("values, for a plan of"));
}

TEST(Regenerate, RefusesWeightsOutsideOfTheirRange) {
  const PosedBody posed = half_body();
  for (const double weight : {0.0, -1.0, 1e-7, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    Parameters parameters = uniform_parameters(posed);
    parameters.values[1] = weight;
    const Result<GenerateResult> generation = regenerate(task_for(posed, kFrontLow), parameters);
    ASSERT_FALSE(generation);
    EXPECT_EQ(generation.error().place, "right_knee.flexion");
  }
}

TEST(Regenerate, AnyOneWeightMayBeAnythingInItsRange) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task = task_for(posed, kFrontLow);
    for (std::size_t d = 0; d < posed.body.dofs().size(); ++d) {
      for (const double weight : {kWeightMin, 0.1, 10.0, kWeightMax}) {
        Parameters parameters = uniform_parameters(posed);
        parameters.values[d] = weight;
        const GenerateResult generation = regenerate(task, parameters).value();
        EXPECT_TRUE(generation.meets_goals()) << posed.body.dofs()[d].name << " " << weight;
      }
    }
  }
}

}  // namespace
}  // namespace shigusa
