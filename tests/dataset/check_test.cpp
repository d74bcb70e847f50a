// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/dataset_check.hpp>
#include <shigusa/dataset_merge.hpp>

#include "dataset/stranger.hpp"

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing_support::change_shard;
using testing_support::made;
using testing_support::plan_of_json;
using testing_support::small_plan;
using testing_support::WorkFolder;

// The data of six tasks in three shards, and their index.
class DatasetCheck : public testing::Test {
 protected:
  DatasetCheck() : plan_(plan_of_json(small_plan(6, 2))) {
    EXPECT_TRUE(keep_plan(plan_, folder_.path()));
    made(plan_, {.folder = folder_.path(), .threads = 2});
  }

  CheckRun checked(CheckSettings settings = {.share = 0.0}) const {
    const auto run = check_dataset(folder_.path(), settings);
    EXPECT_TRUE(run) << run.error().to_string();
    return run.value_or(CheckRun{});
  }

  WorkFolder folder_;
  DatasetPlan plan_;
};

TEST_F(DatasetCheck, WholeDataIsAsItShouldBe) {
  ASSERT_TRUE(merge_dataset(folder_.path()));
  const CheckRun run = checked({.share = 1.0});
  EXPECT_EQ(run.problem_count, 0u) << run.problems.front().says;
  EXPECT_EQ(run.replayed, 6u);
  EXPECT_EQ(run.shards, 3u);
  EXPECT_TRUE(run.index);
  EXPECT_GT(run.bytes, 0u);
}

TEST_F(DatasetCheck, AtLeastOneTaskIsMadeAgain) { EXPECT_EQ(checked().replayed, 1u); }

TEST_F(DatasetCheck, ThreadsChangeNothing) {
  const CheckRun one = checked({.share = 0.5, .threads = 1});
  const CheckRun four = checked({.share = 0.5, .threads = 4});
  EXPECT_EQ(one.replayed, four.replayed);
  EXPECT_EQ(one.motions, four.motions);
  EXPECT_EQ(one.problem_count, 0u);
  EXPECT_EQ(four.problem_count, 0u);
}

TEST_F(DatasetCheck, AnyByteThatIsChangedIsFoundAndItsShardIsNamed) {
  const std::string whole = folder_.get(shard_name(1));
  const std::size_t size = whole.size();
  // in the text of the head, in its padding, and in all parts of the rest
  for (const std::size_t at :
       {std::size_t{0}, std::size_t{40}, std::size_t{110}, std::size_t{120}, std::size_t{400},
        std::size_t{511}, std::size_t{512}, std::size_t{700}, size / 3, size / 2, size - 1}) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    folder_.put(shard_name(1), bytes);
    const CheckRun run = checked();
    ASSERT_THAT(run.problems, SizeIs(1)) << at;
    EXPECT_EQ(run.problems.front().file, "shard-000001.h5") << at;
    // the others are looked at all the same
    EXPECT_EQ(run.shards, 3u);
  }
}

TEST_F(DatasetCheck, ShardThatIsCutShortIsFound) {
  const std::string whole = folder_.get(shard_name(2));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{100}, std::size_t{512}, whole.size() / 2, whole.size() - 1}) {
    folder_.put(shard_name(2), whole.substr(0, size));
    const CheckRun run = checked();
    ASSERT_THAT(run.problems, SizeIs(1)) << size;
    EXPECT_EQ(run.problems.front().file, "shard-000002.h5");
    EXPECT_THAT(run.problems.front().says, HasSubstr("damaged"));
  }
}

TEST_F(DatasetCheck, SeveralDamagedShardsAreAllNamed) {
  folder_.put(shard_name(0), "no shard");
  folder_.put(shard_name(2), folder_.get(shard_name(1)));
  const CheckRun run = checked();
  ASSERT_THAT(run.problems, SizeIs(2));
  EXPECT_EQ(run.problems[0].file, "shard-000000.h5");
  EXPECT_EQ(run.problems[1].file, "shard-000002.h5");
  EXPECT_THAT(run.problems[1].says, HasSubstr("is shard 1"));
}

TEST_F(DatasetCheck, ShardOfAnotherPlanIsFound) {
  const WorkFolder other;
  Json json = small_plan(6, 2);
  json["seed"] = 8;
  made(plan_of_json(json), {.folder = other.path(), .threads = 2});
  folder_.put(shard_name(0), other.get(shard_name(0)));
  const CheckRun run = checked();
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_THAT(run.problems.front().says, HasSubstr("another plan"));
}

TEST_F(DatasetCheck, ShardThatThePlanHasNotIsFound) {
  folder_.put(shard_name(3), folder_.get(shard_name(0)));
  const CheckRun run = checked();
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_EQ(run.problems.front().file, "shard-000003.h5");
}

TEST_F(DatasetCheck, MissingShardIsToldAndIsAProblemOfTheIndexAlone) {
  ASSERT_TRUE(merge_dataset(folder_.path()));
  std::filesystem::remove(folder_ / shard_name(1));
  CheckRun run = checked();
  EXPECT_THAT(run.missing, ElementsAre(1));
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_EQ(run.problems.front().file, kIndexName);
  EXPECT_THAT(run.problems.front().says, HasSubstr("shard-000001.h5, which is not there"));
  std::filesystem::remove(folder_ / kIndexName);
  run = checked();
  EXPECT_FALSE(run.index);
  EXPECT_EQ(run.problem_count, 0u);
}

TEST_F(DatasetCheck, IndexOfFewerShardsIsFound) {
  const std::string shard = folder_.get(shard_name(1));
  std::filesystem::remove(folder_ / shard_name(1));
  ASSERT_TRUE(merge_dataset(folder_.path()));
  folder_.put(shard_name(1), shard);
  const CheckRun run = checked();
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_THAT(run.problems.front().says, HasSubstr("without 1 of the shards"));
}

TEST_F(DatasetCheck, AnyByteOfTheIndexThatIsChangedIsFound) {
  ASSERT_TRUE(merge_dataset(folder_.path()));
  const std::string whole = folder_.get(kIndexName);
  for (const std::size_t at : {std::size_t{3}, std::size_t{60}, std::size_t{110}, std::size_t{450},
                               std::size_t{600}, whole.size() / 2, whole.size() - 1}) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    folder_.put(kIndexName, bytes);
    const CheckRun run = checked();
    ASSERT_THAT(run.problems, SizeIs(1)) << at;
    EXPECT_EQ(run.problems.front().file, kIndexName) << at;
  }
}

TEST_F(DatasetCheck, AnyByteOfTheStatisticsThatIsChangedIsFound) {
  ASSERT_TRUE(merge_dataset(folder_.path()));
  const std::string whole = folder_.get(kStatisticsName);
  for (const std::size_t at : {std::size_t{0}, whole.size() / 3, whole.size() - 2}) {
    std::string damaged = whole;
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    folder_.put(kStatisticsName, damaged);
    const CheckRun run = checked();
    ASSERT_EQ(run.problem_count, 1u) << at;
    EXPECT_EQ(run.problems.front().file, kStatisticsName);
  }
  folder_.put(kStatisticsName, whole.substr(0, whole.size() / 2));
  EXPECT_EQ(checked().problem_count, 1u) << "cut short";
  std::filesystem::remove(folder_ / kStatisticsName);
  EXPECT_EQ(checked().problem_count, 1u) << "gone";
  folder_.put(kStatisticsName, whole);
  EXPECT_EQ(checked().problem_count, 0u);
}

TEST_F(DatasetCheck, NumberThatNoSearchGaveIsFoundByMakingItsTaskAgain) {
  change_shard(folder_, 1, [](std::vector<Table>& tables) {
    Column& angles = tables.front()["angles"];
    angles.bytes[0] = static_cast<char>(angles.bytes[0] ^ 1);
  });
  const CheckRun run = checked({.share = 1.0});
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_EQ(run.problems.front().file, "shard-000001.h5");
  EXPECT_THAT(run.problems.front().says, HasSubstr("task 2 comes out otherwise"));
  EXPECT_THAT(run.problems.front().says, HasSubstr("/angles has 1 of "));
}

TEST_F(DatasetCheck, RowThatNoSearchGaveIsFound) {
  change_shard(folder_, 2, [](std::vector<Table>& tables) {
    for (Table& table : tables) {
      if (table.path != kMissedTable) continue;
      table["task"].push_as(std::uint64_t{5});
      table["effector"].push(std::string_view("head"));
      table["nearest_m"].push(Vec3d{});
      table["error_m"].push(0.0);
      table["turn_error_rad"].push(0.0);
    }
  });
  const CheckRun run = checked({.share = 1.0});
  ASSERT_THAT(run.problems, SizeIs(1));
  EXPECT_THAT(run.problems.front().says, HasSubstr("/missed/task has another number of rows"));
}

TEST_F(DatasetCheck, ShareOutOfRangeIsRefused) {
  for (const double share : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(check_dataset(folder_.path(), {.share = share}));
  }
}

TEST_F(DatasetCheck, CancelEndsIt) {
  const std::atomic<bool> cancel = true;
  const auto run = check_dataset(folder_.path(), {.cancel = &cancel});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace shigusa
