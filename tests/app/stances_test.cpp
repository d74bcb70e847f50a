// SPDX-License-Identifier: MIT
// Reaches of people who sit or whose heels may lift, measured by the written file's own kinematics.
#include "app/result_checks.hpp"
#include "support/person_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class Stances : public testing::Test {
 protected:
  ProgramRun reach(const std::string& character, const Words& more) {
    Words call{"reach", "--character",   character, "--formats", "bvh", "--out",
               "out",   "--evaluations", "600",     "--seed",    "1"};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(Stances, TiptoeKeepsTheToesAndTellsHowFarHeelsLift) {
  work_.put("person.bvh", person_bvh());
  // a person with a rigid trunk and no clavicles reaches less high
  for (const auto& [who, goal] : {std::pair{"human", "right_hand=-0.25,2.3,0.15"},
                                  std::pair{"person.bvh", "right_hand=-0.25,2.22,0.15"}}) {
    const ProgramRun run = reach(who, {"--heels", "--goal", goal});
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

// Toes of a record do not bend while the heels stay down.
TEST_F(Stances, RecordedFeetThatStayFlatAreSeenSo) {
  work_.put("person.bvh", person_bvh());
  const ProgramRun run =
      run_shigusa({"score", "person.bvh", "--heels", "--json"}, {.folder = work_.path()});
  ASSERT_THAT(run.exit_code, delivered()) << run.err;
  const Json score = Json::parse(run.out);
  EXPECT_LT(score.at("follows").at("mean_mm"), 0.01);
  EXPECT_TRUE(score.at("over_limit").empty());
}

// Thighs, shanks and feet stay in place while the trunk moves to the goal.
TEST_F(Stances, OfWhoSitsHandsReachAndThighsAndFeetStay) {
  work_.put("person.bvh", person_bvh());
  for (const auto& [who, seat, goal] : {std::tuple{"human", "0.45", "right_hand=-0.3,0.9,0.6"},
                                        {"human", "0.45", "left_hand=0.1,0.45,0.4"},
                                        {"person.bvh", "0.4", "right_hand=-0.3,0.9,0.5"}}) {
    const ProgramRun run = reach(who, {"--seat", seat, "--goal", goal});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const StoredRun stored(work_, "out");
    const ExportedMotion motion = stored.motion(stored.candidate(1));
    for (const char* node : {"left_upper_leg", "right_upper_leg", "left_lower_leg",
                             "right_lower_leg", "left_foot", "right_foot"}) {
      EXPECT_LT(motion.slide(node), 1e-3) << who << node;
    }
    EXPECT_GT(motion.slide("head"), 0.05);
  }
}

}  // namespace
}  // namespace shigusa
