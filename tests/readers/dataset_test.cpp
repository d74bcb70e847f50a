// SPDX-License-Identifier: MIT
// Data sets as read by other programs: shards by h5py, pandas and h5wasm, and the LeRobot data sets
// that scripts/dataset_to_lerobot makes of them by DuckDB.
#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kTool = SHIGUSA_SOURCE_DIR "/tools/lerobot";
// Debian's: a python3 that comes first on the path may have no h5py
constexpr const char* kPython = "/usr/bin/python3";

// People reaching with either hand, in two shards.
constexpr const char* kPeople = R"({"version": 1, "seed": 3, "tasks": 6, "shard_tasks": 3, "task": {
  "character": {"source": "human", "stature_m": {"percentile": [5, 95]}}, "evaluations": 120,
  "goals": [{"effector": {"choice": ["right_hand", "left_hand"]}, "load_kg": {"uniform": [0, 5]},
             "position_m": {"box_m": [[-0.5, 0.4, 0.1], [0.5, 1.6, 0.6]]}}]},
  "series": ["angles", "torques"], "motions": "all"})";
// Bodies of one plan: either of them, by a draw, or only the robot.
constexpr const char* kBodies = R"({{"version": 1, "seed": 4, "tasks": 6, "shard_tasks": 3,
  "name": "two", "licence": "CC-BY-4.0", "task": {{"character": {{"source": {{"choice": {}}}}},
  "evaluations": 20, "goals": [{{"effector": "left_hand",
                               "position_m": {{"box_m": [[0.05, 0.6, 0.15], [0.25, 0.9, 0.3]]}}}}]}},
  "series": ["angles"], "motions": "all"}})";

class Datasets : public testing::Test {
 protected:
  // Makes the data set `name` of a plan.
  void make(const std::string& name, const std::string& plan) const {
    fs::copy_file(SHIGUSA_SOURCE_DIR "/tests/fuzz/urdf_corpus/small_robot.urdf",
                  work_ / "small_robot.urdf", fs::copy_options::skip_existing);
    work_.put(name + ".json", plan);
    const ProgramRun run =
        run_shigusa({"dataset", name + ".json", "--out", name}, {.folder = work_.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  // Runs a shell command in the work folder; true if it succeeds; its output is in said().
  [[nodiscard]] bool runs(const std::string& command) const {
    const std::string call =
        fmt::format("cd '{}' && {} > said 2>&1", work_.path().string(), command);
    return std::system(call.c_str()) == 0;
  }
  [[nodiscard]] std::string said() const { return work_.get("said"); }

  // Makes the index of a data set.
  void merge(const std::string& name) const {
    const ProgramRun run = run_shigusa({"dataset", "merge", name}, {.folder = work_.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  [[nodiscard]] static bool has_packages() {
    return fs::exists(fs::path(kTool) / "node_modules/h5wasm");
  }
  [[nodiscard]] bool has_python() const {
    return runs(fmt::format("{} -c 'import h5py, pandas'", kPython));
  }

  [[nodiscard]] bool python_reads(const std::string& arguments) const {
    return runs(fmt::format("{} '" SHIGUSA_SOURCE_DIR "/tests/readers/read_dataset.py' {}", kPython,
                            arguments));
  }
  [[nodiscard]] bool reads_shard(const std::string& shard) const {
    return runs(fmt::format("'" SHIGUSA_NODE "' '{}/tests/read_shard.mjs' {}", kTool, shard));
  }
  [[nodiscard]] bool converts(const std::string& arguments) const {
    return runs("'" SHIGUSA_SOURCE_DIR "/scripts/dataset_to_lerobot' " + arguments);
  }
  [[nodiscard]] bool reads_back(const std::string& folders) const {
    return runs(fmt::format("'" SHIGUSA_NODE "' '{}/tests/read_back.mjs' {}", kTool, folders));
  }

  WorkFolder work_;
};

#define SKIP_WITHOUT_PACKAGES() \
  if (!has_packages()) GTEST_SKIP() << "no Node.js, or its packages could not be fetched"
#define SKIP_WITHOUT_PYTHON() \
  if (!has_python())          \
  GTEST_SKIP() << "no h5py or pandas: apt-get install python3-h5py python3-pandas"

using DatasetReaders = Datasets;

// Each table's names and columns, including words, to the last bit; also through the index, whose
// columns are in the shards.
TEST_F(DatasetReaders, H5pyAndH5wasmFindTheSameBytes) {
  SKIP_WITHOUT_PACKAGES();
  SKIP_WITHOUT_PYTHON();
  make("people", kPeople);
  merge("people");
  for (const char* file : {"people/shard-000001.h5", "people/index.h5"}) {
    ASSERT_TRUE(reads_shard(file)) << said();
    const std::string found = said();
    EXPECT_THAT(found, HasSubstr("@words possible strains impossible\n"));
    EXPECT_THAT(found, HasSubstr("/tasks/stature_m "));
    EXPECT_THAT(found, HasSubstr("x61x45 "));
    ASSERT_TRUE(python_reads(file)) << said();
    EXPECT_EQ(said(), found);
  }
}

TEST_F(DatasetReaders, PandasJoinsTasksGoalsAndMotions) {
  SKIP_WITHOUT_PYTHON();
  make("people", kPeople);
  EXPECT_TRUE(python_reads("--pandas people/shard-000000.h5")) << said();
  EXPECT_THAT(said(), testing::StartsWith("3 3 "));
  merge("people");
  EXPECT_TRUE(python_reads("--index people")) << said();
  EXPECT_THAT(said(), HasSubstr("\n6 6 "));
}

using LeRobot = Datasets;

TEST_F(LeRobot, IsReadBackByDuckdb) {
  SKIP_WITHOUT_PACKAGES();
  make("people", kPeople);
  // files so small that there are several of them
  ASSERT_TRUE(converts("people lerobot --fps 30 --file-mb 0.1")) << said();
  ASSERT_TRUE(reads_back("people lerobot")) << said();
  int episodes = 0;
  int frames = 0;
  int tasks = 0;
  int files = 0;
  ASSERT_TRUE(std::istringstream(said()) >> episodes >> frames >> tasks >> files);
  EXPECT_GE(episodes, 6);
  EXPECT_GE(frames, 10 * episodes);
  EXPECT_EQ(tasks, 6);
  EXPECT_GE(files, 2);
  EXPECT_THAT(work_.get("lerobot/README.md"), HasSubstr("Nothing here was recorded"));
  // the same shards give the same bytes
  ASSERT_TRUE(converts("people again --fps 30 --file-mb 0.1")) << said();
  EXPECT_TRUE(runs("diff -r lerobot again")) << said();
}

// Shows that the test above can fail.
TEST_F(LeRobot, IsFoundToBeOfOtherShards) {
  SKIP_WITHOUT_PACKAGES();
  make("people", kPeople);
  ASSERT_TRUE(converts("people lerobot")) << said();
  Json info = Json::parse(work_.get("lerobot/meta/info.json"));
  info["fps"] = 25;
  info["total_frames"] = 7;
  work_.put("lerobot/meta/info.json", info.dump());
  std::string other = kPeople;
  other.replace(other.find("\"seed\": 3"), 9, "\"seed\": 5");
  make("others", other);
  EXPECT_FALSE(reads_back("others lerobot"));
  for (const char* complaint : {"7 frames are told", "ends otherwise", "a timestamp is off",
                                "a state is off", "a torque is off", "'reach (", "another goal"}) {
    EXPECT_THAT(said(), HasSubstr(complaint));
  }
}

// Learning for a robot needs its file's joints, in the file's order.
TEST_F(LeRobot, OfARobotHasTheJointsOfItsFile) {
  SKIP_WITHOUT_PACKAGES();
  make("robots", fmt::format(kBodies, R"(["small_robot.urdf"])"));
  ASSERT_TRUE(converts("robots lerobot")) << said();
  ASSERT_TRUE(reads_back("robots lerobot")) << said();
  EXPECT_THAT(said(), HasSubstr("left_knee left_ankle_pitch left_ankle_roll right_hip_yaw"));
  EXPECT_THAT(work_.get("lerobot/README.md"), HasSubstr("license: \"cc-by-4.0\""));
}

TEST_F(LeRobot, IsOfOneBody) {
  SKIP_WITHOUT_PACKAGES();
  make("two", fmt::format(kBodies, R"(["human", "small_robot.urdf"])"));
  EXPECT_FALSE(converts("two lerobot"));
  EXPECT_THAT(said(), HasSubstr("--body takes one: human-"));
  const std::size_t robot = said().find("small_robot-");
  ASSERT_NE(robot, std::string::npos) << said();
  EXPECT_FALSE(fs::exists(work_ / "lerobot"));
  const std::string body = said().substr(robot, std::string("small_robot-123456").size());
  ASSERT_TRUE(converts("two lerobot --body " + body)) << said();
  EXPECT_TRUE(reads_back("two lerobot")) << said();
}

// A learner judged by the test split must not have learnt from its people.
TEST_F(LeRobot, HasTheSplitsOfTheIndex) {
  SKIP_WITHOUT_PACKAGES();
  std::string plan = kPeople;
  // of 40 tasks each split gets some
  plan.replace(plan.find("\"tasks\": 6"), 10, "\"tasks\": 40");
  plan.replace(plan.find("\"evaluations\": 120"), 18, "\"evaluations\": 8");
  make("people", plan);
  merge("people");
  ASSERT_TRUE(converts("people lerobot --split region --verdict possible,strains,impossible"))
      << said();
  EXPECT_THAT(said(), testing::ContainsRegex("train [0-9]+, validation [0-9]+, test [0-9]+"));
  EXPECT_TRUE(reads_back("people lerobot region")) << said();
}

TEST_F(LeRobot, SaysWhatIsWrong) {
  SKIP_WITHOUT_PACKAGES();
  make("people", kPeople);
  const auto complaint = [this](const std::string& arguments) {
    return converts(arguments) ? "none" : said();
  };
  EXPECT_THAT(complaint("people"), HasSubstr("1 folders; there are two"));
  EXPECT_THAT(complaint("people lerobot --fps 0"), HasSubstr("--fps is '0'; allowed is 1 to 1000"));
  EXPECT_THAT(complaint("people lerobot --verdict good"), HasSubstr("--verdict has 'good'"));
  EXPECT_THAT(complaint("people lerobot --split person"),
              HasSubstr("shigusa dataset merge people"));
  EXPECT_THAT(complaint("people people"), HasSubstr("people: is there and not empty"));
  EXPECT_THAT(complaint("nowhere lerobot"), HasSubstr("nowhere: cannot be read"));
  const std::string shard = work_.get("people/shard-000001.h5");
  work_.put("people/shard-000001.h5", shard + "x");
  EXPECT_THAT(complaint("people lerobot"), HasSubstr("shard-000001.h5: is damaged"));
  work_.put("people/shard-000001.h5", "no shard");
  EXPECT_THAT(complaint("people lerobot"), HasSubstr("is no shard of version 1"));
  // nothing half made is left
  for (const auto& entry : fs::directory_iterator(work_.path())) {
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("lerobot")));
  }
}

}  // namespace
}  // namespace shigusa
