// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/human.hpp>
#include <string>

#include "body/anthropometry.hpp"
#include "generate/known_starts.hpp"
#include "problem/make_problem.hpp"
#include "rollout/batch_rollout.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Vec3d kTable{-0.1, 0.85, 0.45};
constexpr int kMost = 16;

Task with_habit(Task task, const Habit& habit) {
  adopt_habit(task, habit);
  return task;
}

// A problem with its space.
struct Begun {
  Task task;
  ReachProblem problem;
  ParameterList list;
  ParameterSpace space;

  Begun(const PosedBody& posed, std::vector<Goal> goals, const Habit& habit = {})
      : task(
            with_habit(with_preset(Task(posed, {.goals = std::move(goals)}), Preset::flat), habit)),
        problem(make_problem(task).value()),
        list(testing_support::list_of(task)),
        space(problem, list, GeneCode::natural) {}

  [[nodiscard]] std::vector<double> starts() const { return KnownStarts(problem, space).points(); }
  [[nodiscard]] double at(std::span<const double> points, const std::string& name,
                          std::size_t row = 0) const {
    const int gene = space.find(name);
    EXPECT_GE(gene, 0) << name;
    return points[row * static_cast<std::size_t>(space.genes()) + static_cast<std::size_t>(gene)];
  }
  // of the best of the points
  [[nodiscard]] double best(std::span<const double> points) {
    BatchRollout batch(problem, task.criteria);
    std::vector<double> scores(points.size() / static_cast<std::size_t>(space.genes()));
    batch.score(space.rows(points), scores);
    return *std::min_element(scores.begin(), scores.end());
  }
};

TEST(StartTables, AreWrittenAsTheyWereRead) {
  std::string text(kStartText);
  while (text.starts_with('#')) text = text.substr(text.find('\n') + 1);
  EXPECT_EQ(start_text(start_tables()), text);
}

// Sets tables, and those of the library again at the end.
struct OtherTables {
  bool good;
  explicit OtherTables(const std::string& text) : good(set_start_tables(text)) {}
  ~OtherTables() { (void)set_start_tables(std::string(kStartText)); }
};

TEST(StartTables, OfAnotherFormAreRefused) {
  const std::string good = "table\tone\t2\tsquat lean\n-100 -200 300 0\tz0\tA5\n";
  ASSERT_TRUE(OtherTables(good).good);
  for (const auto& [part, by] : {std::pair{"z0", "z"},
                                 {"z0", "z?"},
                                 {"300 0", "300"},
                                 {"300 0", "300 0 0"},
                                 {"-100", "x"},
                                 {"table\t", "table "},
                                 {"\t2\t", "\ttwo\t"}}) {
    std::string text = good;
    text.replace(text.find(part), std::string(part).size(), by);
    EXPECT_FALSE(OtherTables(text).good) << text;
  }
  EXPECT_GT(start_tables().size(), 3U);  // the library's again
}

TEST(StartTable, NamesAllCoordinatesOfTheBuiltInBodies) {
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) {
    const Begun begun(posed, {{"right_hand", kTable}});
    const std::vector<std::string> names = begun.space.names();
    const auto is_own = [&](const StartTable& table) {
      return std::equal(names.begin(), names.end(), table.names.begin(), table.names.end());
    };
    EXPECT_TRUE(std::any_of(start_tables().begin(), start_tables().end(), is_own))
        << posed.body.name();
  }
}

TEST(NearestStarts, AreMuchBetterThanBentPostures) {
  double bent = 0.0;
  double near = 0.0;
  for (const Vec3d& goal : {kTable, Vec3d{-0.4, 0.3, 0.3}, Vec3d{-0.3, 1.7, 0.3}}) {
    Begun begun(human_body(), {{"right_hand", goal}});
    bent += begun.best(bent_starts(begun.space));
    near += begun.best(begun.starts());
  }
  EXPECT_LT(near, 0.5 * bent);
}

TEST(HabitStarts, AreBetterForWhoseKneesAreNotUsual) {
  for (const double knees : {0.3, 3.0}) {
    Begun begun(human_body(), {{"right_hand", {-0.3, 0.2, 0.35}}}, {.knees = knees});
    const std::vector<double> known = begun.starts();
    const std::vector<double> own = habit_starts(begun.problem, begun.space, known);
    ASSERT_FALSE(own.empty());
    EXPECT_LT(begun.best(own), 0.9 * begun.best(known)) << knees;
  }
  const Begun usual(human_body(), {{"right_hand", kTable}});
  EXPECT_TRUE(habit_starts(usual.problem, usual.space, usual.starts()).empty());
}

TEST(NearestStarts, OfALeftHandAreTheMirrorImage) {
  const Begun right(human_body(), {{"right_hand", kTable}});
  const Begun left(human_body(), {{"left_hand", {-kTable.x, kTable.y, kTable.z}}});
  const std::vector<double> rights = right.starts();
  const std::vector<double> lefts = left.starts();
  for (std::size_t row = 0; row < kMost; ++row) {
    EXPECT_EQ(left.at(lefts, "left_swivel", row), right.at(rights, "right_swivel", row));
    EXPECT_EQ(left.at(lefts, "squat", row), right.at(rights, "squat", row));
    EXPECT_EQ(left.at(lefts, "twist", row), 1.0 - right.at(rights, "twist", row));
  }
}

TEST(NearestStarts, OfATallerPersonAreThoseOfTheSamePlaceInStatures) {
  const double taller = 1.1;
  const Begun usual(human_body(), {{"right_hand", kTable}});
  const Begun tall(human_body({.stature = 1.741 * taller}), {{"right_hand", kTable * taller}});
  EXPECT_EQ(tall.starts(), usual.starts());
}

// For goals at the height of the table's shoulder or above, distance counts in the own arm's
// length.
TEST(StartPlace, IsByTheOwnArm) {
  using F = StatureFractions;
  const PosedBody usual = human_body();
  BodyDefinition long_armed = usual.body.definition();
  const auto elbow = static_cast<std::size_t>(usual.body.find_dof("right_elbow.flexion").value());
  const int hand = usual.body.find_effector("right_hand").value();
  const Vec3d goal{-0.6, 1.6, 0.3};
  const Vec3d before = start_place(usual.body, usual.home, hand, goal).value();
  const Vec3d shoulder = (goal * (1.0 / usual.body.stature()) - before) * usual.body.stature();
  const double arm = (F::kUpperArm + F::kForearm + kGripFraction * F::kHand) * usual.body.stature();
  long_armed.dofs[elbow].offset.y -= 0.3;
  const BodyModel changed(long_armed);
  const Vec3d after = start_place(changed, usual.home, hand, goal).value();
  EXPECT_LE(norm(after * ((arm + 0.3) / arm) - before), 1e-3);
  // below the shoulder, height counts in the own shoulder's height
  const Vec3d low{-0.2, 0.5 * shoulder.y, 0.3};
  EXPECT_NEAR(start_place(changed, usual.home, hand, low)->y, -0.5 * F::kShoulderHeight, 1e-3);
}

TEST(NearestStarts, OfTwoHandsInTheMirrorExchangeTheArms) {
  const Vec3d other{0.25, 1.1, 0.4};
  const auto image = [](const Vec3d& v) { return Vec3d{-v.x, v.y, v.z}; };
  const Begun as(human_body(), {{"right_hand", kTable}, {"left_hand", other}});
  const Begun in(human_body(), {{"left_hand", image(kTable)}, {"right_hand", image(other)}});
  for (std::size_t row = 0; row < kMost; ++row) {
    EXPECT_EQ(as.at(as.starts(), "right_elbow", row), in.at(in.starts(), "left_elbow", row));
    EXPECT_EQ(as.at(as.starts(), "left_swivel", row), in.at(in.starts(), "right_swivel", row));
    EXPECT_DOUBLE_EQ(as.at(as.starts(), "twist", row), 1.0 - in.at(in.starts(), "twist", row));
  }
}

// Each table has rows with motions, and for a box in both hands the best known start scores less
// than half of what the best bent one does.
TEST(NearestStarts, AreOfTheKindAsked) {
  const std::vector<Goal> box{{"right_hand", {-0.17, 0.3, 0.4}}, {"left_hand", {0.17, 0.3, 0.4}}};
  for (const StartTable& table : start_tables()) {
    EXPECT_GT(table.rows.size(), 100U);
    for (const StartRow& row : table.rows) ASSERT_GT(row.motions.size(), 0U);
  }
  Begun both(human_body(), box);
  EXPECT_LT(both.best(both.starts()), 0.5 * both.best(bent_starts(both.space)));
}

TEST(NearestStarts, WithinAPartOfTheSpaceAreInIt) {
  const Begun begun(human_body(), {{"right_hand", {-0.2, 0.2, 0.4}}});
  const int squat = begun.space.find("squat");
  const double least = begun.space.coordinate(squat, radians(115.0));
  const std::vector<double> points =
      KnownStarts(begun.problem, begun.space).within({{squat, least, 1.0}});
  ASSERT_THAT(points, testing::Not(IsEmpty()));
  const auto rows = points.size() / static_cast<std::size_t>(begun.space.genes());
  for (std::size_t k = 0; k < rows; ++k) EXPECT_GE(begun.at(points, "squat", k), least - 0.02);
}

TEST(NearestStarts, OfWhatIsNoHandAreNone) {
  EXPECT_THAT(Begun(human_body(), {{"head", {0.0, 1.5, 0.2}}}).starts(), IsEmpty());
}

TEST(StartScales, AreByHowMuchThePointsDiffer) {
  // the first gene differs by 3 times as much as the second, the third not at all
  const std::vector<double> points{0.2, 0.5, 0.7, 0.8, 0.7, 0.7};
  const std::vector<double> scales = start_scales(points, 3);
  ASSERT_THAT(scales, SizeIs(3));
  EXPECT_NEAR(scales[0], 3.0 * scales[1], 1e-12);
  EXPECT_NEAR(scales[0] * scales[0] + scales[1] * scales[1], 3.0, 1e-12);
  EXPECT_EQ(scales[2], kLeastScale);
}

TEST(StartScales, OfOnePointOrEqualOnesAreNone) {
  EXPECT_THAT(start_scales({}, 3), IsEmpty());
  EXPECT_THAT(start_scales(std::vector<double>{0.1, 0.2, 0.3}, 3), IsEmpty());
  EXPECT_THAT(start_scales(std::vector<double>{0.1, 0.2, 0.1, 0.2}, 2), IsEmpty());
}

}  // namespace
}  // namespace shigusa
