// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "document/task_samples.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

RC_GTEST_PROP(TaskFile, IsReadBackBitForBit, ()) {
  const TaskFile task = any_task();
  const Result<TaskFile> again = parse_task(format_task(task), "task.json");
  if (!again) RC_FAIL(again.error().to_string() + format_task(task));
  RC_ASSERT(bits(*again) == bits(task));
  RC_ASSERT(words(again->character) == words(task.character));
}

RC_GTEST_PROP(TaskFile, FormatsTheSameTextAgain, ()) {
  const std::string text = format_task(any_task());
  RC_ASSERT(format_task(parse_task(text, "task.json").value()) == text);
}

RC_GTEST_PROP(TaskFile, CutAnywhereIsAnErrorThatNamesTheFile, ()) {
  const std::string text = format_task(any_task());
  const std::size_t length = *rc::gen::inRange<std::size_t>(0, text.size() - 2);
  const Result<TaskFile> task = parse_task(text.substr(0, length), "cut.json");
  RC_ASSERT(!task);
  RC_ASSERT(task.error().code == ErrorCode::parse);
  RC_ASSERT(task.error().to_string().starts_with("cut.json: "));
}

TEST(TaskFile, EmptyObjectIsTheDefaultTask) {
  const TaskFile task = parse_task("{}", "task.json").value();
  EXPECT_EQ(bits(task), bits(TaskFile{}));
  EXPECT_EQ(task.character.source, "human");
  EXPECT_EQ(task.preset, Preset::flat);
}

TEST(TaskFile, CharacterMayBeItsNameAlone) {
  const TaskFile task = parse_task(R"({"character": "walk.bvh"})", "task.json").value();
  EXPECT_EQ(task.character.source, "walk.bvh");
}

TEST(TaskFile, CriteriaMayBeAMixturesName) {
  for (const CriteriaPreset& preset : criteria_presets()) {
    TaskFile expected;
    expected.criteria = preset.settings();
    const std::string text = R"({"criteria": ")" + std::string(preset.name) + R"("})";
    EXPECT_EQ(bits(parse_task(text, "task.json").value()), bits(expected)) << preset.name;
  }
}

TEST(TaskFile, CriteriaThatAFileDoesNotNameAreThePresets) {
  const char* text =
      R"({"preset": "paper", "criteria": {"joint_range": {"weight": 0.4, "margin": 0.1},
    "balance": {"weight": 0.3, "lean": 0.3}, "torque": {"weight": 0.1, "share": 0.5}}})";
  TaskFile expected;
  expected.preset = Preset::paper;
  expected.criteria = paper_criteria();
  expected.candidates = traits_of(Preset::paper).candidates;
  expected.criteria[CriterionKind::joint_range].weight = 0.4;
  expected.criteria[CriterionKind::joint_range].scale = 0.1;
  expected.criteria[CriterionKind::balance].scale = 0.3;
  expected.criteria[CriterionKind::torque].weight = 0.1;
  expected.criteria[CriterionKind::torque].scale = 0.5;
  EXPECT_EQ(bits(parse_task(text, "task.json").value()), bits(expected));
}

TEST(TaskFile, AFrontThatIsAskedForAgainKeepsItsOwnCriteria) {
  const char* text = R"({"pareto": true, "criteria": {"balance": {"weight": 0.7}}})";
  const TaskFile file = parse_task(text, "task.json").value();
  TaskFile again = file;
  adopt_pareto(again, true);
  EXPECT_EQ(bits(again), bits(file));
  adopt_pareto(again, false);
  adopt_pareto(again, true);
  EXPECT_EQ(bits(again), bits(parse_task(R"({"pareto": true})", "task.json").value()));
}

TEST(TaskFile, NameThatIsNoUtf8IsWrittenAllTheSame) {
  TaskFile task;
  task.character.source = "caf\xe9.bvh";
  EXPECT_THAT(format_task(task), HasSubstr("caf\xef\xbf\xbd.bvh"));
}

TEST(TaskFile, CoincidingJointsAreAnError) {
  TaskFile task;
  task.character.source = "walk.bvh";
  task.character.stature = 1.7;
  task.character.landmarks = asymmetric_person();
  task.character.landmarks->left_leg.knee = task.character.landmarks->left_leg.hip;
  const auto again = parse_task(format_task(task), "task.json");
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().to_string(), HasSubstr("landmarks_m"));
}

TEST(MakeTask, TakesSeedAndBudgetOver) {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
  file.seed = 9;
  file.evaluations = 80;
  file.candidates = 3;
  const Task task = make_task(file, {}).value();
  EXPECT_EQ(task.seed, 9u);
  EXPECT_EQ(task.evaluations, 80);
  EXPECT_EQ(task.candidates, 3);
  EXPECT_EQ(task.body.name(), "human");
}

}  // namespace
}  // namespace shigusa
