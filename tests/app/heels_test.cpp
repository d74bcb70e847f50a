// SPDX-License-Identifier: MIT
// Reaches of people whose heels may lift, by the written file's own kinematics.
#include "app/result_checks.hpp"
#include "support/person_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class HeelsApp : public testing::Test {
 protected:
  ProgramRun reach(const Words& more) {
    Words call{"reach", "--heels", "--formats", "bvh", "--out", "out", "--evaluations", "600"};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(HeelsApp, TiptoeKeepsTheToesAndTellsHowFarHeelsLift) {
  work_.put("person.bvh", person_bvh());
  // who has a rigid trunk and no clavicles reaches less high
  for (const auto& [who, goal] : {std::pair{"human", "right_hand=-0.25,2.3,0.15"},
                                  std::pair{"person.bvh", "right_hand=-0.25,2.22,0.15"}}) {
    const ProgramRun run = reach({"--character", who, "--goal", goal, "--seed", "1"});
    ASSERT_THAT(run.exit_code, delivered()) << run.err;
    EXPECT_THAT(run.out, HasSubstr("heels mm"));
    const StoredRun stored(work_, "out");
    expect_promises_kept(stored);
    const Json& candidate = stored.candidate(1);
    const ExportedMotion motion = stored.motion(candidate);
    EXPECT_EQ(candidate.at("contacts").size(), 2u);
    for (const Json& contact : candidate.at("contacts")) {
      EXPECT_THAT(std::string(contact.at("joint")), HasSubstr("toes"));
      EXPECT_GT(contact.at("heel_lift_deg"), 5.0);
      EXPECT_GT(contact.at("heel_lift_mm"), 20.0);
    }
    EXPECT_GT(motion.slide("left_foot"), 0.02);
  }
}

TEST_F(HeelsApp, EditAndMirrorKeepTheHeels) {
  const ProgramRun begun = reach({"--character", "human", "--goal", "right_hand=-0.25,2.3,0.15"});
  ASSERT_THAT(begun.exit_code, delivered()) << begun.err;
  for (const Words& call :
       {Words{"edit", "out", "--set", "right_elbow.weight=2"}, Words{"mirror", "out"}}) {
    Words words = call;
    words.insert(words.end(), {"--formats", "bvh", "--out", "again"});
    const ProgramRun run = run_shigusa(words, {.folder = work_.path()});
    ASSERT_THAT(run.exit_code, delivered()) << run.err;
    const StoredRun stored(work_, "again");
    EXPECT_GT(stored.candidate(1).at("contacts").at(0).at("heel_lift_mm"), 20.0);
  }
}

TEST_F(HeelsApp, AreRefusedWhereNobodyLiftsThem) {
  const Words goal{"--goal", "right_hand=-0.2,1,0.4"};
  for (const Words& who : {Words{"--character", "full_body"}, Words{"--character", "half_body"},
                           Words{"--character", "human", "--seat", "0.45"},
                           Words{"--character", "human", "--preset", "paper"},
                           Words{"--character", "human", "--preset", "layers"},
                           Words{"--character", "human", "--preset", "human"}}) {
    Words call = who;
    call.insert(call.end(), goal.begin(), goal.end());
    const ProgramRun run = reach(call);
    EXPECT_EQ(run.exit_code, 2) << who.back();
    EXPECT_THAT(run.err, HasSubstr("heels")) << who.back();
  }
}

// The toes' joints of a record whose heels stay down bend by nothing.
TEST_F(HeelsApp, RecordedFeetThatStayFlatAreSeenSo) {
  work_.put("person.bvh", person_bvh());
  const ProgramRun run =
      run_shigusa({"score", "person.bvh", "--heels", "--json"}, {.folder = work_.path()});
  ASSERT_THAT(run.exit_code, delivered()) << run.err;
  const Json score = Json::parse(run.out);
  EXPECT_LT(score.at("follows").at("mean_mm"), 0.01);
  EXPECT_TRUE(score.at("over_limit").empty());
}

}  // namespace
}  // namespace shigusa
