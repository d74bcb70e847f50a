// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <thread>

#include "app/result_checks.hpp"
#include "support/person_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class Edit : public testing::Test {
 protected:
  // A result in the folder "result".
  void SetUp() override {
    reach({"--character", "full_body", "--goal", "right_hand=0.25,0.55,0.5", "--seed", "1"});
  }

  void reach(Words more) {
    Words call{"reach", "--candidates", "2", "--formats", "bvh,csv,svg", "--out", "result"};
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun run = run_shigusa(call, {.folder = work_.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  ProgramRun edit(const std::string& result, Words more = {}) {
    Words call{"edit", result, "--formats", "bvh,csv,svg"};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(Edit, KeepsTheHandOnItsGoalWithoutASearch) {
  const ProgramRun run =
      edit("result", {"--candidate", "1", "--set", "right_shoulder.flexion.weight=12"});
  EXPECT_THAT(run.exit_code, delivered()) << run.err;
  const StoredRun stored(work_, "result/edit-1");
  EXPECT_EQ(stored.summary().at("evaluations"), 0);
  EXPECT_EQ(stored.summary().at("search"), "edit");
  EXPECT_EQ(stored.candidate(1).at("parameters").at("right_shoulder.flexion.weight"), 12.0);
  expect_promises_kept(stored);
}

TEST_F(Edit, SaysWhereNothingIsChanged) {
  const auto told = [this](Words more) {
    Words call{"edit", "result"};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()}).err;
  };
  EXPECT_THAT(told({}), HasSubstr("nothing was changed: --set NAME=VALUE"));
  EXPECT_THAT(told({"--set", "squat_deg=60"}), Not(HasSubstr("nothing was changed")));
  EXPECT_THAT(told({"--fps", "24"}), Not(HasSubstr("nothing was changed")));
}

TEST_F(Edit, WithoutChangesGivesTheSameBytes) {
  ASSERT_THAT(edit("result", {"--candidate", "2"}).exit_code, delivered());
  const StoredRun edited(work_, "result/edit-1");
  for (const std::string ending : {"bvh", "csv", "svg"}) {
    EXPECT_EQ(edited.get("candidate-1." + ending), work_.get("result/candidate-2." + ending));
  }
  EXPECT_EQ(edited.candidate(1).at("score"), StoredRun(work_, "result").candidate(2).at("score"));
}

TEST_F(Edit, LeavesTheOriginalUntouchedAndTakesANewFolderEachTime) {
  const auto before = work_.contents();
  ASSERT_THAT(edit("result").exit_code, delivered());
  ASSERT_THAT(edit("result/summary.json").exit_code, delivered());
  auto after = work_.contents();
  EXPECT_TRUE(after.contains("result/edit-1/summary.json"));
  EXPECT_TRUE(after.contains("result/edit-2/summary.json"));
  std::erase_if(after, [](const auto& entry) { return entry.first.starts_with("result/edit-"); });
  EXPECT_EQ(after, before);
}

TEST_F(Edit, GoesToTheFolderThatIsGiven) {
  ASSERT_THAT(edit("result", {"--out", "mine/first"}).exit_code, delivered());
  EXPECT_TRUE(std::filesystem::exists(work_ / "mine/first/candidate-1.bvh"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "result/edit-1"));
}

TEST_F(Edit, OfAnEditGoesOnFromThere) {
  ASSERT_THAT(edit("result", {"--set", "right_hip.weight=5"}).exit_code, delivered());
  ASSERT_THAT(edit("result/edit-1", {"--set", "right_elbow.weight=7"}).exit_code, delivered());
  const StoredRun stored(work_, "result/edit-1/edit-1");
  const Json& parameters = stored.candidate(1).at("parameters");
  EXPECT_EQ(parameters.at("right_hip.rotation.weight"), 5.0);
  EXPECT_EQ(parameters.at("right_elbow.flexion.weight"), 7.0);
  expect_promises_kept(stored);
}

TEST_F(Edit, LocksThatKeepTheHandFromItsGoalAreToldAsOutOfReach) {
  const ProgramRun run =
      edit("result", {"--set", "right_ankle.locked=true", "--set", "right_knee.locked=true",
                      "--set", "right_hip.locked=true"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("out of reach"));
  const StoredRun stored(work_, "result/edit-1");
  EXPECT_EQ(stored.summary().at("status"), "unreachable");
  EXPECT_GT(stored.summary().at("remaining_mm").get<double>(), 100.0);
}

TEST_F(Edit, OfAPersonFromAFileNeedsTheFileNoMore) {
  work_.put("person.bvh", person_bvh());
  reach({"--character", "person.bvh", "--frame", "2", "--goal", "left_hand=0.1,0.9,0.45"});
  ASSERT_THAT(edit("result").exit_code, delivered());
  EXPECT_EQ(work_.get("result/edit-1/candidate-1.bvh"), work_.get("result/candidate-1.bvh"));
  // without it the motion is the same, on nodes of the body's own
  std::filesystem::remove(work_ / "person.bvh");
  ASSERT_THAT(edit("result").exit_code, delivered());
  EXPECT_EQ(work_.get("result/edit-2/candidate-1.csv"), work_.get("result/candidate-1.csv"));
  expect_promises_kept(StoredRun(work_, "result/edit-2"));
}

TEST_F(Edit, WaitsForNoPipeAndReadsNoOtherFileThatAResultNames) {
  work_.put("person.bvh", person_bvh());
  reach({"--character", "person.bvh", "--goal", "left_hand=0.1,0.9,0.45"});
  ASSERT_EQ(mkfifo((work_ / "pipe.bvh").c_str(), 0600), 0);
  for (const auto& [file, told] : {std::pair{"../pipe.bvh", "is a pipe"},
                                   {"/etc/passwd", "unknown character"},
                                   {"", "does not say where"},
                                   {"../result", "unknown character"}}) {
    Json summary = Json::parse(work_.get("result/summary.json"));
    summary["character_file"] = file;
    work_.put("result/summary.json", summary.dump());
    const ProgramRun run = edit("result");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr(told));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("root:")));
  }
}

TEST_F(Edit, RefusesAFileThatIsNotTheOneThatTheResultDescribes) {
  work_.put("result/candidate-2.svg", "drawn over");
  const ProgramRun run = edit("result", {"--candidate", "2"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("candidate-2.svg: is not the file that summary.json describes"));
  EXPECT_THAT(run.err, HasSubstr("Delete it to go on"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "result/edit-1"));
  EXPECT_EQ(edit("result", {"--candidate", "1"}).exit_code, 0);
  std::filesystem::remove(work_ / "result/candidate-2.svg");
  EXPECT_EQ(edit("result", {"--candidate", "2"}).exit_code, 0);
}

TEST_F(Edit, ProgramsAtOnceTakeFoldersOfTheirOwn) {
  std::vector<std::thread> programs;
  for (int i = 0; i < 4; ++i) {
    programs.emplace_back([this] { EXPECT_EQ(edit("result").exit_code, 0); });
  }
  for (std::thread& program : programs) program.join();
  for (const char* folder : {"edit-1", "edit-2", "edit-3", "edit-4"}) {
    EXPECT_TRUE(std::filesystem::exists(work_ / "result" / folder / "summary.json")) << folder;
  }
}

TEST_F(Edit, NamesFromAResultReachTheTerminalWithoutControlCharacters) {
  work_.put("person.bvh", person_bvh());
  reach({"--character", "person.bvh", "--goal", "left_hand=0.1,0.9,0.45"});
  Json summary = Json::parse(work_.get("result/summary.json"));
  summary["task"]["character"]["source"] = "\x1b[31mred.bvh";
  summary["task"]["character"]["doubts"] = {"\x1b[2J"};
  work_.put("result/summary.json", summary.dump());
  const ProgramRun run = edit("result");
  EXPECT_THAT(run.exit_code, delivered()) << run.err;
  EXPECT_THAT(run.out + run.err, testing::Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace shigusa
