// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <set>
#include <shigusa/dataset_export.hpp>

#include "dataset/drawn_again.hpp"
#include "dataset/plans.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// A data set in its own folder, and a folder for exports.
struct MadeSet {
  WorkFolder data;
  WorkFolder out;
  DatasetPlan plan;

  explicit MadeSet(const Json& json, const std::filesystem::path& characters = {})
      : plan(plan_of_json(json, characters)) {
    EXPECT_TRUE(keep_plan(plan, data.path()));
    made(plan, {.folder = data.path()});
  }
  [[nodiscard]] DataExportSettings settings() const {
    return {.from = data.path(), .to = out.path()};
  }
};

Json small_set() {
  Json json = small_plan(4, 2);
  json["series"] = Json::array();
  json["motions"] = "all";
  return json;
}

DataExportRun exported(const DataExportSettings& settings) {
  const auto run = export_dataset(settings);
  EXPECT_TRUE(run) << run.error().to_string();
  return run.value_or(DataExportRun{});
}

std::string refusal(const DataExportSettings& settings) {
  const auto run = export_dataset(settings);
  return run ? "" : run.error().to_string();
}

// The names of a folder's motions, "000012-1".
std::set<std::string> motions_in(const WorkFolder& folder) {
  std::set<std::string> names;
  for (const auto& [name, bytes] : folder.contents()) {
    if (name.ends_with(".glb")) names.insert(std::filesystem::path(name).stem().string());
  }
  return names;
}

TEST(Export, LimitsPickMotions) {
  if (!has_mannequin()) GTEST_SKIP() << "no mannequin";
  const MadeSet set(small_set());
  const std::uint64_t all = exported(set.settings()).motions;
  std::uint64_t parts = 0;
  for (const char* part : {"train", "validation", "test"}) {
    const WorkFolder out;
    DataExportSettings settings = set.settings();
    settings.to = out.path();
    settings.split = part;
    const auto run = export_dataset(settings);
    parts += run ? run->motions : 0;
  }
  EXPECT_EQ(parts, all);
  const WorkFolder out;
  DataExportSettings settings = set.settings();
  settings.to = out.path();
  settings.tasks = TaskRange{1, 3};
  settings.most = 2;
  EXPECT_EQ(exported(settings).motions, 2u);
  EXPECT_EQ(motions_in(out).size(), 2u);
  for (const std::string& name : motions_in(out)) {
    EXPECT_THAT(name,
                testing::AnyOf(testing::StartsWith("000001-"), testing::StartsWith("000002-")));
  }
}

TEST(Export, SameDataSameBytes) {
  if (!has_mannequin()) GTEST_SKIP() << "no mannequin";
  const MadeSet set(small_set());
  const WorkFolder other;
  DataExportSettings settings = set.settings();
  exported(settings);
  settings.to = other.path();
  exported(settings);
  EXPECT_TRUE(set.out.contents() == other.contents());
}

TEST(Export, RefusesWhatIsNotAllowed) {
  if (!has_mannequin()) GTEST_SKIP() << "no mannequin";
  const MadeSet set(small_set());
  DataExportSettings settings = set.settings();
  settings.split = "tests";
  EXPECT_THAT(refusal(settings), HasSubstr("allowed are train, validation and test"));
  settings = set.settings();
  settings.tasks = TaskRange{2, 9};
  EXPECT_THAT(refusal(settings), HasSubstr("the plan has 4 tasks"));
  settings = set.settings();
  settings.rate = 500.0;
  EXPECT_THAT(refusal(settings), HasSubstr("--fps"));
  EXPECT_TRUE(set.out.contents().empty());
  settings = set.settings();
  set.out.put("mine.txt", "of another program");
  EXPECT_THAT(refusal(settings), HasSubstr("is not empty"));
  settings.force = true;
  exported(settings);
  EXPECT_EQ(set.out.get("mine.txt"), "of another program");
}

TEST(Export, GlbOfBuiltInBodiesIsTheMannequin) {
  const MadeSet set(small_set());
  const DataExportSettings settings = set.settings();
  if (!has_mannequin()) {
    EXPECT_THAT(refusal(settings), HasSubstr("give a character's file"));
    return;
  }
  const DataExportRun run = exported(settings);
  EXPECT_EQ(run.left_out, 0u) << run.why;
  std::uint64_t files = 0;
  for (const auto& [name, bytes] : set.out.contents()) {
    if (!name.ends_with(".glb")) continue;
    ++files;
    EXPECT_TRUE(set.out.get(name).starts_with("glTF")) << name;
  }
  EXPECT_EQ(files, run.motions);
  EXPECT_GT(files, 0u);
}

TEST(Export, GlbMovesAnyCharacterByTheSameParameters) {
  const std::filesystem::path characters = std::filesystem::path(SHIGUSA_SHARED_DIR) / "characters";
  const std::filesystem::path file = characters / "lab0_CesiumMan.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  Json json = small_set();
  json["task"]["character"] = {{"source", file.filename().string()}};
  json["tasks"] = 2;
  const MadeSet set(json, characters);
  DataExportSettings settings = set.settings();
  const DataExportRun own = exported(settings);
  EXPECT_EQ(own.left_out, 0u) << own.why;
  const WorkFolder out;
  settings.to = out.path();
  settings.character = file;
  const DataExportRun given = exported(settings);
  EXPECT_EQ(given.motions, own.motions);
  EXPECT_EQ(given.searched, 0u);
  int files = 0;
  for (const auto& [name, bytes] : set.out.contents()) {
    if (!name.ends_with(".glb")) continue;
    ++files;
    EXPECT_EQ(set.out.get(name).substr(0, 4), "glTF");
    EXPECT_TRUE(set.out.get(name) == out.get(name)) << name;
  }
  EXPECT_EQ(static_cast<std::uint64_t>(files), own.motions);
  // the parameters that are played give the very motion that the data set has
  const DataFolder data = DataFolder::open(set.data.path()).value();
  const ShardRows rows = read_rows(data, 0).value();
  for (const DataMotion& motion : rows.motions) {
    const DrawnAgain again = drawn_again(set.plan, motion).value();
    ASSERT_EQ(again.misfit, "");
    const Candidate candidate = regenerate(again.task, again.parameters).value().candidates.front();
    EXPECT_EQ(candidate.score.total, motion.motion.number("score"));
  }
}

}  // namespace
}  // namespace shigusa
