// SPDX-License-Identifier: MIT
// The preset human on the command line: results, edits, mirror images, refusals.
#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const char* const kGoal = "right_hand=-0.25,1.2,0.35";

class Human : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }

  ProgramRun reach(const Words& more) {
    Words call{"reach", "--preset", "human", "--formats",     "bvh,csv", "--out",
               "out",   "--goal",   kGoal,   "--evaluations", "160"};
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }

  [[nodiscard]] Json parameters(const std::string& folder) const {
    return StoredRun(work_, folder).candidate(1).at("parameters");
  }

  // all angles of the first candidate
  [[nodiscard]] std::string motion(const std::string& folder) const {
    return StoredRun(work_, folder).get("candidate-1.csv");
  }

  WorkFolder work_;
};

TEST_F(Human, HandArrivesAndFeetStay) {
  for (const char* body : {"half_body", "full_body", "human"}) {
    const ProgramRun done = reach({"--character", body});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    const StoredRun stored(work_, "out");
    expect_promises_kept(stored);
    EXPECT_EQ(stored.summary().at("preset"), "human");
    EXPECT_EQ(stored.summary().at("search"), "cma_es");
    EXPECT_TRUE(stored.candidate(1).at("over_limit").empty());
    EXPECT_TRUE(parameters("out").contains("right_arm.swivel_rad"));
    EXPECT_EQ(parameters("out").contains("left_elbow.flexion.final_rad"),
              std::string(body) != "half_body");
  }
}

TEST_F(Human, MirrorsAndEditsAWholeHuman) {
  ASSERT_EQ(reach({"--character", "human"}).exit_code, 0);
  ASSERT_EQ(run({"mirror", "out", "--formats", "csv"}).exit_code, 0);
  const Json score = StoredRun(work_, "out").candidate(1).at("score");
  const Json image = StoredRun(work_, "out/mirror-1").candidate(1).at("score");
  // the body stands on the same foot, and only rounding distinguishes its two legs
  EXPECT_NEAR(image.get<double>(), score.get<double>(), 1e-3);
  const ProgramRun edited =
      run({"edit", "out", "--formats", "csv", "--set", "hip.flexion.weight=3"});
  EXPECT_EQ(edited.exit_code, 0) << edited.err;
}

TEST_F(Human, EditSwivelsTheElbowAndBendsTheFreeArm) {
  ASSERT_EQ(reach({}).exit_code, 0);
  const ProgramRun done = run({"edit", "out", "--formats", "bvh,csv", "--set",
                               "right_arm.swivel_deg=45", "--set", "left_elbow.final_deg=60"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const StoredRun stored(work_, "out/edit-1");
  expect_promises_kept(stored);
  const auto elbow = csv_column(motion("out/edit-1"), "left_elbow.flexion [rad]");
  EXPECT_NEAR(elbow.back(), radians(60.0), 1e-6);
  const auto swivel = [this](const char* folder) {
    return StoredRun(work_, folder)
        .candidate(1)
        .at("final_posture")
        .at("elbow_swivel_deg")
        .get<double>();
  };
  EXPECT_GT(swivel("out/edit-1"), swivel("out") + 10.0);
}

TEST_F(Human, WrongValuesAreRefusedInWords) {
  ASSERT_EQ(reach({}).exit_code, 0);
  const struct {
    Words call;
    Words told;
  } table[] = {
      {{"reach", "--goal", kGoal, "--preset", "humen"}, {"did you mean 'human'?"}},
      {{"reach", "--preset", "human", "--goal", kGoal, "--fix", "right_hip.weight=3"},
       {"fixed with the other presets", "human"}},
      {{"reach", "--preset", "human", "--goal", kGoal, "--generator", "nlp_ik"},
       {"the preset human knows weighted IK only"}},
      {{"edit", "out", "--set", "right_arm.swivel_deg=95"}, {"'95'", "-60 to 90"}},
      {{"edit", "out", "--set", "left_arm.swivel_deg=5"}, {"did you mean 'right_arm'?"}},
      {{"edit", "out", "--set", "right_elbow.final_deg=5"}, {"did you mean"}},
      {{"edit", "out", "--set", "left_elbow.final_deg=170"}, {"'170'", "0 to 120"}},
      {{"edit", "out", "--set", "right_arm.swivel=5"}, {"did you mean 'swivel_deg'?"}},
      {{"edit", "out", "--set", "swivel"}, {"NAME.swivel_deg"}},
  };
  const auto before = work_.contents();
  for (const auto& row : table) {
    const ProgramRun refused = run(row.call);
    EXPECT_EQ(refused.exit_code, 2) << row.call.back();
    for (const std::string& word : row.told) EXPECT_THAT(refused.err, HasSubstr(word));
  }
  EXPECT_EQ(work_.contents(), before);
}

}  // namespace
}  // namespace shigusa
