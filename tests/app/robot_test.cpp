// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/robot_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

class RobotCommands : public testing::Test {
 protected:
  RobotCommands() { work_.put("small.urdf", RobotFile().text()); }

  ProgramRun run(const std::vector<std::string>& arguments) {
    return run_shigusa(arguments, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(RobotCommands, BodyTellsWhichJointOfTheFileAFreedomIs) {
  const ProgramRun text = run({"body", "small.urdf"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, testing::ContainsRegex("right_knee.flexion.*  right_knee\n"));
  EXPECT_THAT(text.out, HasSubstr("note: joint 'drawer' slides"));
  const Json json = Json::parse(run({"body", "small.urdf", "--json"}).out);
  EXPECT_EQ(json.at("humanoid").at("right_lower_leg"), "right_shank");
  EXPECT_TRUE(json.at("joints")[0].contains("file_joint"));
}

TEST_F(RobotCommands, ResultIsEditedWithoutTheFile) {
  const ProgramRun reach = run({"reach", "--character", "small.urdf", "--goal",
                                "right_hand=-0.2,0.4,0.35", "--evaluations", "300", "--out", "a"});
  ASSERT_EQ(reach.exit_code, 0) << reach.err;
  std::filesystem::remove(work_ / "small.urdf");
  ASSERT_EQ(run({"edit", "a", "--out", "b"}).exit_code, 0);
  EXPECT_EQ(work_.get("a/candidate-1.csv"), work_.get("b/candidate-1.csv"));
  const ProgramRun changed = run({"edit", "a", "--set", "squat_deg=40", "--out", "c"});
  EXPECT_EQ(changed.exit_code, 0) << changed.err;
  EXPECT_NE(work_.get("a/candidate-1.csv"), work_.get("c/candidate-1.csv"));
}

}  // namespace
}  // namespace shigusa
