// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;

class HabitCommand : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }

  // Knees (degrees) at the end of a reach with these options.
  double knees(const Words& options, const std::string& out = "out") {
    Words call{"reach",     "--goal", "right_hand=-0.2,0.25,0.45",
               "--formats", "bvh",    "--candidates",
               "1",         "--out",  out,
               "--json"};
    call.insert(call.end(), options.begin(), options.end());
    const ProgramRun made = run(call);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return Json::parse(made.out)["candidates"][0]["final_posture"]["knee_flexion_deg"];
  }

  WorkFolder work_;
};

TEST_F(HabitCommand, AWordNumbersAndAFileBendTheKnees) {
  const double natural = knees({});
  EXPECT_LT(knees({"--habit", "stoop"}), natural - 20.0);
  EXPECT_GT(knees({"--habit", "squat"}), natural + 6.0);
  EXPECT_LT(knees({"--habit", "knees=0.2"}), natural - 20.0);
  work_.put("habit.json", "{\"knees\": 0.2, \"round_rad\": 0.1}");
  EXPECT_LT(knees({"--habit", "habit.json"}), natural - 20.0);
}

TEST_F(HabitCommand, IsLearnedFromAClip) {
  knees({"--habit", "stoop"}, "stoops");
  const ProgramRun learned = run({"habit", "stoops/candidate-1.bvh"});
  ASSERT_EQ(learned.exit_code, 0) << learned.err;
  EXPECT_THAT(learned.err, HasSubstr("measured in 1 reach down"));
  EXPECT_LT(Json::parse(learned.out)["knees"].get<double>(), 0.8);
  work_.put("learned.json", learned.out);
  EXPECT_LT(knees({"--habit", "learned.json"}), knees({}) - 20.0);
  const ProgramRun part = run({"habit", "stoops/candidate-1.bvh", "--frames", "0:55"});
  EXPECT_NEAR(Json::parse(part.out)["knees"].get<double>(),
              Json::parse(learned.out)["knees"].get<double>(), 0.1);
  EXPECT_EQ(run({"habit", "stoops/candidate-1.bvh", "--frames", "0:3"}).exit_code, 2);
}

TEST_F(HabitCommand, MistakesAreNamed) {
  const auto told = [&](const std::string& habit) {
    const ProgramRun made = run({"reach", "--goal", "right_hand=-0.2,0.25,0.45", "--habit", habit});
    EXPECT_EQ(made.exit_code, 2) << habit;
    return made.err;
  };
  EXPECT_THAT(told("knee=2"), HasSubstr("knees"));
  EXPECT_THAT(told("knees=many"), HasSubstr("--habit"));
  EXPECT_THAT(told("knees=99"), HasSubstr("of the habit is 99"));
  EXPECT_THAT(told("sqat"), HasSubstr("did you mean 'squat'"));
  EXPECT_THAT(told("none.json"), HasSubstr("none.json"));
  work_.put("wrong.json", "{\"knees\": \"two\"}");
  EXPECT_THAT(told("wrong.json"), HasSubstr("knees"));
  EXPECT_EQ(run({"habit", "none.bvh"}).exit_code, 2);
}

}  // namespace
}  // namespace shigusa
