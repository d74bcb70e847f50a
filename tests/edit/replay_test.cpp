// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/edit.hpp>

#include "support/named_values.hpp"

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using namespace testing_support;

// A result with three candidates.
class Replay : public testing::Test {
 protected:
  Replay() {
    stored_.task.character.source = "full_body";
    stored_.task.goals = {{"right_hand", {-0.25, 0.9, 0.45}}};
    const Task task = make_task(stored_.task, {}).value();
    player_.emplace(MotionPlayer::of(task).value());
    stored_.candidates.assign(3, uniform_parameters(task.body));
    value_of(task, stored_.candidates[2], "bow") = 0.1;
  }

  StoredResult stored_{};
  std::optional<MotionPlayer> player_;
};

TEST_F(Replay, OfAllPlaysThemInTheirOrderAndTellsHowFarItIs) {
  std::vector<double> shares;
  std::vector<int> played;
  std::vector<double> scores;
  const GenerateResult all =
      replay_all(*player_, stored_, {.report = [&](const ProgressReport& now) {
        EXPECT_EQ(now.stage, "replay");
        shares.push_back(now.fraction);
        played.push_back(now.evaluations);
        scores.push_back(now.best_score);
      }}).value();
  ASSERT_EQ(all.candidates.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(all.candidates[k].parameters, stored_.candidates[k]);
  }
  EXPECT_THAT(shares, ElementsAre(1.0 / 3.0, 2.0 / 3.0));
  EXPECT_THAT(played, ElementsAre(1, 2));
  const double first = all.candidates[0].score.total;
  EXPECT_THAT(scores, ElementsAre(first, first));
}

TEST_F(Replay, MissesAGoalThatOneOfItsMotionsMisses) {
  lock_all(stored_.candidates[1]);
  EXPECT_TRUE(replay(*player_, stored_, 1)->meets_goals());
  EXPECT_FALSE(replay(*player_, stored_, 2)->meets_goals());
  EXPECT_FALSE(replay_all(*player_, stored_)->meets_goals());
}

TEST_F(Replay, ThatIsStoppedTellsAfterHowMany) {
  std::atomic<bool> cancel = false;
  const auto stopped = replay_all(
      *player_, stored_,
      {.report = [&](const auto& now) { cancel = now.evaluations == 2; }, .cancel = &cancel});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  EXPECT_THAT(stopped.error().to_string(), HasSubstr("stopped after 2 of 3 candidates"));
}

TEST_F(Replay, OfACandidateThatIsNotThereIsRefused) {
  EXPECT_TRUE(replay(*player_, stored_, 3));
  for (const int none : {-1, 0, 4}) {
    const auto refused = replay(*player_, stored_, none);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().to_string(), HasSubstr("the result has the candidates 1 to 3"));
  }
}

TEST(Assignments, AreAListOfTexts) {
  EXPECT_THAT(parse_assignments(R"(["bow=0.1", "squat_deg=20"])", "").value(),
              ElementsAre("bow=0.1", "squat_deg=20"));
  for (const char* wrong : {R"("bow=0.1")", R"(["bow=0.1", 2])", "["}) {
    EXPECT_FALSE(parse_assignments(wrong, "edits.json")) << wrong;
  }
}

TEST(WorkEdits, AreReadFromJson) {
  const WorkEdit edit =
      parse_work_edit(
          R"({"action": 2, "set": ["bow=0.1"], "again": [3], "keep": [1, 4], "seed": 5})", "edit")
          .value();
  EXPECT_EQ(edit.action, 2);
  EXPECT_THAT(edit.assignments, ElementsAre("bow=0.1"));
  EXPECT_THAT(edit.again, ElementsAre(3));
  EXPECT_THAT(edit.keep, ElementsAre(1, 4));
  EXPECT_EQ(edit.seed, 5u);
  EXPECT_FALSE(parse_work_edit("{}", "edit")->seed);
  for (const char* wrong :
       {R"({"action": 0})", R"({"action": 65})", R"({"again": [0]})", R"({"again": [65]})",
        R"({"keep": [1.5]})", R"({"keep": 1})", R"({"seed": -1})", R"({"set": [1]})"}) {
    EXPECT_FALSE(parse_work_edit(wrong, "edit")) << wrong;
  }
}

}  // namespace
}  // namespace shigusa
