// SPDX-License-Identifier: MIT
// Data sets on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <shigusa/run.hpp>
#include <thread>

#include "formats/json_text.hpp"
#include "support/night.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kPlan = R"({
  "version": 1, "seed": 3, "tasks": 12, "shard_tasks": 3, "series": ["angles"],
  "task": {"character": "half_body", "candidates": 1, "evaluations": 120,
    "goals": [{"effector": "right_hand", "position_m": {"box_m": [[-0.4, 0.6, 0.2], [0.1, 1.5, 0.5]]}}]}})";

class DatasetCommand : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> call, RunSettings settings = {}) {
    call.insert(call.begin(), "dataset");
    settings.folder = work_.path();
    return run_shigusa(call, settings);
  }
  // The shards of a folder, with their bytes.
  [[nodiscard]] std::map<std::string, std::string> shards(const std::string& folder) const {
    std::map<std::string, std::string> found;
    for (const auto& [name, bytes] : work_.contents()) {
      if (name.starts_with(folder + "/shard-")) found[name.substr(folder.size())] = bytes;
    }
    return found;
  }

  WorkFolder work_;
  const std::string plan_ = work_.put("plan.json", kPlan);
};

TEST_F(DatasetCommand, MakesShardsOnce) {
  const ProgramRun first = run({"plan.json", "--out", "data"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("4 shards made, 0 already there: 12 tasks"));
  const ProgramRun again = run({"plan.json", "--out", "data"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.out, HasSubstr("0 shards made, 4 already there"));
  EXPECT_EQ(shards("data").size(), 4u);
}

TEST_F(DatasetCommand, PartsMakeTheWhole) {
  run({"plan.json", "--out", "whole"});
  run({"plan.json", "--out", "parts", "--shards", "2:4", "--threads", "1"});
  run({"plan.json", "--out", "parts", "--shards", ":2", "--simd", "scalar"});
  EXPECT_TRUE(shards("parts") == shards("whole"));
  for (const char* part : {"2/3", "0/3", "1/3"})
    run({"plan.json", "--out", "thirds", "--part", part});
  EXPECT_TRUE(shards("thirds") == shards("whole"));
}

// The folder alone suffices to make the same data again, wherever the plan's file was.
TEST_F(DatasetCommand, CharactersAreFoundFromTheFolder) {
  const std::filesystem::path shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "needs characters of ../shared";
  std::filesystem::copy(shared / "characters/lab0_CesiumMan.glb", work_ / "man.glb");
  Json plan = Json::parse(kPlan);
  plan["tasks"] = 1;
  plan["task"]["character"] = {{"source", "man.glb"}, {"stature_m", 1.7}};
  work_.put("man.json", plan.dump());
  EXPECT_EQ(run({"man.json", "--out", "men"}).exit_code, 0);
  const ProgramRun again = run({"men/plan.json", "--out", "men"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("0 shards made, 1 already there"));
}

TEST_F(DatasetCommand, APlanIsCheckedAlone) {
  const ProgramRun checked = run({"plan.json", "--check-plan"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(checked.out, "12 tasks in 4 shards of 3\n");
}

TEST_F(DatasetCommand, OneTaskIsAnOrdinaryResult) {
  const ProgramRun one = run({"plan.json", "--out", "one", "--task", "5", "--formats", "csv"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  const ProgramRun edited =
      run_shigusa({"edit", "one", "--set", "lean_deg=5"}, {.folder = work_.path()});
  EXPECT_EQ(edited.exit_code, 0) << edited.err;
}

TEST_F(DatasetCommand, OneTaskMayBeAPieceOfWork) {
  work_.put("work.json", R"({"version": 1, "seed": 3, "tasks": 2,
    "task": {"version": 2, "candidates": 1, "evaluations": 60, "actions": [
      {"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.4]}]},
      {"wait_s": {"uniform": [0.1, 0.3]}}]}})");
  const ProgramRun one = run({"work.json", "--out", "one", "--task", "1", "--formats", "csv"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  const Json summary = Json::parse(work_.get("one/summary.json"));
  EXPECT_EQ(summary.at("candidates").at(0).at("actions").size(), 2u);
}

TEST_F(DatasetCommand, InterruptedItEndsOnAWholeShard) {
  Json plan = Json::parse(kPlan);
  plan["tasks"] = 100'000;
  work_.put("long.json", plan.dump());
  const ProgramRun stopped =
      run({"long.json", "--out", "data"}, {.interrupt_after = std::chrono::milliseconds(700)});
  EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr(" left; the same command goes on"));
  EXPECT_THAT(work_.contents(), Not(testing::IsEmpty()));
  for (const auto& [name, bytes] : work_.contents()) EXPECT_THAT(name, Not(HasSubstr(".tmp")));
}

// A kill at any time leaves no broken shard, and the same command then makes the same bytes.
TEST_F(DatasetCommand, KilledAtAnyTimeItGoesOn) {
  run({"plan.json", "--out", "wanted", "--threads", "1"});
  Random random(1);
  const int times = cases(50, 8);
  for (int i = 0; i < times; ++i) {
    const Channel out(false);
    const Channel err(false);
    const pid_t child = start_shigusa({"dataset", "plan.json", "--out", "data", "--threads", "1"},
                                      {.folder = work_.path()}, out, err);
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(150'000)));
    kill(child, SIGKILL);
    ProgramRun ended;
    read_to_end(out, err, ended);
    int status = 0;
    waitpid(child, &status, 0);
    const auto wanted = shards("wanted");
    for (const auto& [name, bytes] : shards("data")) EXPECT_TRUE(bytes == wanted.at(name)) << name;
    // begin anew, or go on where the last one was killed
    if (i % 3 == 0) std::filesystem::remove_all(work_ / "data");
  }
  EXPECT_EQ(run({"plan.json", "--out", "data"}).exit_code, 0);
  EXPECT_TRUE(shards("data") == shards("wanted"));
  for (const auto& [name, bytes] : work_.contents()) EXPECT_THAT(name, Not(HasSubstr(".tmp")));
}

TEST_F(DatasetCommand, AFullDiskIsTold) {
  // a folder of the size of a few pages
  std::filesystem::create_directory(work_ / "small");
  const std::string mount =
      "mount -t tmpfs -o size=12k none '" + (work_ / "small").string() + "' 2>/dev/null";
  if (std::system(mount.c_str()) != 0) GTEST_SKIP() << "needs to mount a folder";
  const ProgramRun full = run({"plan.json", "--out", "small/data"});
  const std::string unmount = "umount '" + (work_ / "small").string() + "'";
  bool shard = false;
  for (const auto& [name, bytes] : work_.contents()) shard = shard || name.ends_with(".h5");
  EXPECT_EQ(std::system(unmount.c_str()), 0);
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_THAT(full.err, HasSubstr("No space left on device"));
  EXPECT_FALSE(shard);
}

}  // namespace
}  // namespace shigusa
