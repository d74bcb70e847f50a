// SPDX-License-Identifier: MIT
// Task::starts: known motions, near which a search begins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "generate/known_starts.hpp"
#include "generate/parameter_space.hpp"
#include "problem/make_problem.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::SizeIs;

constexpr Vec3d kTable{-0.1, 0.85, 0.45};

Task asked(std::vector<Goal> goals, int evaluations) {
  Task task(human_body(), {.goals = std::move(goals), .duration = 2.0});
  task.evaluations = evaluations;
  return task;
}

// A random point of a space.
std::vector<double> any_point(const ParameterSpace& space, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> point;
  for (int g = 0; g < space.genes(); ++g) point.push_back(random.uniform());
  return point;
}

TEST(ParameterSpace, EncodesWhatItDecodes) {
  const Task task = asked({{"right_hand", kTable}}, 16);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  for (const GeneCode code : {GeneCode::natural, GeneCode::every}) {
    const ParameterSpace space(problem, list, code);
    const std::vector<double> point = any_point(space, 3);
    const std::vector<double> again = space.encode(space.decode(point));
    ASSERT_EQ(again.size(), point.size());
    // a logarithm of an exponential, each to some 1e-15, over a range of 11
    for (std::size_t g = 0; g < point.size(); ++g) EXPECT_NEAR(again[g], point[g], 1e-14);
  }
}

TEST(ParameterSpace, EncodesALockedFreedomAsTheHeaviest) {
  const Task task = asked({{"right_hand", kTable}}, 16);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace space(problem, list, GeneCode::natural);
  Parameters values = space.decode(space.start());
  values.locked[number_of(list, "right_elbow.flexion")] = true;
  const std::vector<double> point = space.encode(values);
  EXPECT_EQ(point[static_cast<std::size_t>(space.find("right_elbow.flexion"))], 1.0);
}

TEST(KnownStarts, PutGivenMotionsBeforeTheNearestOfTheTable) {
  const Task task = asked({{"right_hand", kTable}}, 16);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace space(problem, list, GeneCode::natural);
  const auto genes = static_cast<std::size_t>(space.genes());
  const std::vector<Parameters> given{space.decode(any_point(space, 1)),
                                      space.decode(any_point(space, 2))};
  const KnownStarts known(problem, space);
  const std::vector<double> table = known.points();
  const std::vector<double> points = known.points(given);
  ASSERT_THAT(points, SizeIs(kNearestStarts * genes));
  for (std::size_t k = 0; k < given.size(); ++k) {
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(k * genes);
    EXPECT_EQ(std::vector<double>(at, at + space.genes()), space.encode(given[k]));
  }
  const std::vector<double> rest(points.begin() + static_cast<std::ptrdiff_t>(2 * genes),
                                 points.end());
  EXPECT_EQ(rest, std::vector<double>(table.begin(),
                                      table.begin() + static_cast<std::ptrdiff_t>(rest.size())));
  const std::vector<Parameters> many(20, given[0]);
  EXPECT_THAT(known.points(many), SizeIs(many.size() * genes));
}

// A hand, two hands, and an elbow, which has no table.
class Starts : public testing::TestWithParam<std::vector<Goal>> {};

TEST_P(Starts, AreScoredSoThatNothingWorseComesOfTheSearch) {
  const GenerateResult good = generate(asked(GetParam(), 1000)).value();
  Task task = asked(GetParam(), 16);
  const double without = generate(task).value().best_seen_score;
  task.starts = {uniform_parameters(task.body), *good.best_seen};
  for (const int evaluations : {16, 40, 144, 432}) {
    task.evaluations = evaluations;
    // in single precision the same motion scores a little otherwise
    EXPECT_LE(generate(task).value().best_seen_score, good.best_seen_score + 1e-4) << evaluations;
  }
  EXPECT_GT(without, good.best_seen_score + 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Of, Starts,
                         testing::Values(std::vector<Goal>{{"right_hand", kTable}},
                                         std::vector<Goal>{{"right_hand", {-0.2, 0.4, 0.4}, 8.0},
                                                           {"left_hand", {0.2, 0.4, 0.4}, 8.0}},
                                         std::vector<Goal>{{"right_elbow", {-0.3, 1.3, 0.25}}}));

TEST(Starts, AreReadWhereTheSquatIsFixed) {
  Task task = asked({{"right_hand", {-0.2, 0.4, 0.4}}}, 40);
  const ParameterList list = list_of(task);
  task.fixed = no_fixed_parameters(list);
  fix_value(list, "squat", radians(60.0), *task.fixed);
  Task longer = task;
  longer.evaluations = 1000;
  const GenerateResult good = generate(longer).value();
  task.starts = {*good.best_seen};
  EXPECT_LE(generate(task).value().best_seen_score, good.best_seen_score + 1e-4);
}

TEST(Starts, OfAnotherBodyAreRefused) {
  Task task = asked({{"right_hand", kTable}}, 16);
  task.starts = {uniform_parameters(task.body), uniform_parameters(half_body())};
  const Result<PreparedTask> checked = PreparedTask::of(task);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().place, "starts[1]");
  EXPECT_THAT(checked.error().message.text, HasSubstr("values, for a plan of"));
  EXPECT_EQ(generate(task).error().to_string(), checked.error().to_string());
}

TEST(Starts, OutOfRangeAreRefusedByName) {
  Task task = asked({{"right_hand", kTable}}, 16);
  task.starts = {uniform_parameters(task.body)};
  value_of(task, task.starts[0], "bow") = 1.0;
  const Result<GenerateResult> refused = generate(task);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "starts[0]: bow");
}

TEST(Starts, AreOfThePresetFlatAlone) {
  for (const Preset preset : {Preset::paper, Preset::layers, Preset::human}) {
    Task task = with_preset(asked({{"right_hand", kTable}}, 16), preset);
    task.starts = {uniform_parameters(task.body)};
    const Result<GenerateResult> refused = generate(task);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message.text, HasSubstr("takes no start motions"));
  }
}

}  // namespace
}  // namespace shigusa
