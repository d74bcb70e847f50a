// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/run.hpp>
#include <system_error>

#include "dataset/index_reader.hpp"
#include "dataset/index_tables.hpp"
#include "dataset/splits.hpp"
#include "dataset/statistics.hpp"
#include "dataset/task_rows.hpp"
#include "plans.hpp"

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::made;
using testing_support::open_file;
using testing_support::plan_of_json;
using testing_support::read_index;
using testing_support::read_text;
using testing_support::small_plan;
using testing_support::WorkFolder;

// A plan's data in a folder, with the plan beside it.
DatasetPlan put_data(const WorkFolder& folder, const Json& json) {
  const DatasetPlan plan = plan_of_json(json);
  EXPECT_TRUE(keep_plan(plan, folder.path()));
  made(plan, {.folder = folder.path(), .threads = 2});
  return plan;
}

Json six_tasks() {
  Json json = small_plan(6, 2);
  json["licence"] = "CC0-1.0";
  json["name"] = "Six reaches";
  return json;
}

MergeRun merged(const WorkFolder& folder) {
  const auto run = merge_dataset(folder.path());
  EXPECT_TRUE(run) << run.error().to_string();
  return run.value_or(MergeRun{});
}

// The same table without rows, to be read from an index.
Table shape_of(const Table& table) {
  Table shape{table.path};
  for (const Column& column : table.columns) {
    shape.columns.push_back(
        {.name = column.name, .type = column.type, .text_size = column.text_size});
  }
  for (const auto& [what, list] : table.names)
    shape.names.emplace_back(what, std::vector<std::string>{});
  return shape;
}

// The rows of all shards, in order.
std::map<std::string, Table> joined(const WorkFolder& folder, std::uint64_t shards) {
  std::map<std::string, Table> tables;
  for (std::uint64_t shard = 0; shard < shards; ++shard) {
    const ShardReader reader = ShardReader::open(folder / shard_name(shard)).value();
    std::vector<std::string> paths = reader.motion_tables().value();
    for (const Table& table : empty_tables()) paths.push_back(table.path);
    for (const std::string& path : paths) {
      Table more = reader.table(path).value();
      const auto [known, added] = tables.try_emplace(path, more);
      if (added) continue;
      for (std::size_t k = 0; k < more.columns.size(); ++k) {
        known->second.columns[k].bytes += more.columns[k].bytes;
      }
    }
  }
  return tables;
}

void expect_same(const Table& read, const Table& expected) {
  EXPECT_EQ(read.names, expected.names) << expected.path;
  ASSERT_EQ(read.columns.size(), expected.columns.size());
  for (std::size_t k = 0; k < read.columns.size(); ++k) {
    const Column& a = read.columns[k];
    const Column& b = expected.columns[k];
    EXPECT_EQ(a.bytes, b.bytes) << expected.path << "/" << b.name;
    EXPECT_EQ(a.shape, b.shape) << b.name;
    EXPECT_EQ(a.unit, b.unit) << b.name;
    EXPECT_EQ(a.says, b.says) << b.name;
    EXPECT_EQ(a.words, b.words) << b.name;
  }
}

TEST(DatasetMerge, TablesOfTheIndexAreThoseOfTheShardsOneAfterTheOther) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  const MergeRun run = merged(folder);
  EXPECT_EQ(run.shards, 3u);
  EXPECT_EQ(run.tasks, 6u);
  EXPECT_TRUE(run.missing.empty());
  const std::map<std::string, Table> tables = joined(folder, 3);
  EXPECT_GE(tables.size(), 5u);
  for (const auto& [path, table] : tables) {
    Table read = shape_of(table);
    ASSERT_TRUE(read_index(folder / kIndexName, read)) << path;
    expect_same(read, table);
    if (path.starts_with(kMotionsGroup)) {
      EXPECT_EQ(read.rows(), run.motions);
    }
  }
}

TEST(DatasetMerge, IndexIsReadInAFolderThatWasMoved) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  merged(folder);
  const std::map<std::string, Table> tables = joined(folder, 3);
  const WorkFolder other;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    std::filesystem::rename(entry.path(), other.path() / entry.path().filename());
  }
  Table read = shape_of(tables.at(kTasksTable));
  ASSERT_TRUE(read_index(other / kIndexName, read));
  expect_same(read, tables.at(kTasksTable));
}

TEST(DatasetMerge, SameShardsGiveTheSameBytes) {
  const WorkFolder one;
  const WorkFolder two;
  for (const WorkFolder* folder : {&one, &two}) {
    put_data(*folder, six_tasks());
    merged(*folder);
  }
  const auto first = one.contents();
  EXPECT_EQ(first, two.contents());
  // once more over the files that are there
  merged(one);
  EXPECT_EQ(one.contents(), first);
}

TEST(DatasetMerge, ListsTheShardsWithTheirSumsAndRows) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  merged(folder);
  Table list{kShardsTable,
             {{.name = "shard", .type = ElementType::u64},
              {.name = "sha256", .type = ElementType::text, .text_size = kSumSize},
              {.name = "rows", .type = ElementType::u32}},
             {{"tables", {}}}};
  ASSERT_TRUE(read_index(folder / kIndexName, list));
  EXPECT_THAT(list["shard"].as<std::uint64_t>(), ElementsAre(0, 1, 2));
  const auto rows = list["rows"].as<std::uint32_t>();
  const std::vector<std::string>& tables = *list.names_of("tables");
  for (std::uint64_t shard = 0; shard < 3; ++shard) {
    const ShardReader reader = ShardReader::open(folder / shard_name(shard)).value();
    EXPECT_EQ(list["sha256"].texts()[shard], reader.head().sha256);
    for (std::size_t k = 0; k < tables.size(); ++k) {
      EXPECT_EQ(rows[shard * tables.size() + k], reader.table(tables[k], {"task"})->rows());
    }
  }
}

TEST(DatasetMerge, MissingShardIsToldAndTheIndexIsOfTheOthers) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  std::filesystem::remove(folder / shard_name(1));
  const MergeRun run = merged(folder);
  EXPECT_THAT(run.missing, ElementsAre(1));
  Table tasks{kTasksTable, {{.name = "task", .type = ElementType::u64}}};
  ASSERT_TRUE(read_index(folder / kIndexName, tasks));
  EXPECT_THAT(tasks["task"].as<std::uint64_t>(), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(folder.get(kCardName), HasSubstr("1 of the plan's 3 shards are not made yet"));
}

TEST(DatasetMerge, RowsOfAShardThatIsGoneAreNoNumbers) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  merged(folder);
  std::filesystem::remove(folder / shard_name(1));
  Table tasks{kTasksTable, {{.name = "task", .type = ElementType::u64}, {.name = "mass_kg"}}};
  ASSERT_TRUE(read_index(folder / kIndexName, tasks));
  EXPECT_THAT(tasks["task"].as<std::uint64_t>(), ElementsAre(0, 1, UINT64_MAX, UINT64_MAX, 4, 5));
  const auto masses = tasks["mass_kg"].as<double>();
  EXPECT_FALSE(std::isnan(masses[1]));
  EXPECT_TRUE(std::isnan(masses[2]));
}

TEST(DatasetMerge, DamagedShardIsNamedAndTheIndexStaysAsItWas) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  merged(folder);
  const std::string index = folder.get(kIndexName);
  std::string bytes = folder.get(shard_name(2));
  bytes[bytes.size() / 2] ^= 1;
  folder.put(shard_name(2), bytes);
  const auto run = merge_dataset(folder.path());
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().to_string(), HasSubstr("shard-000002.h5"));
  EXPECT_EQ(folder.get(kIndexName), index);
  // and nothing else is left beside it
  EXPECT_EQ(folder.contents().size(), 7u);
}

TEST(DatasetMerge, TellsByWhatPeopleAreToldApart) {
  for (const auto& [people, told, of_card] :
       {std::tuple{0, "character, sex, stature", "the same character, sex"},
        {1, "the number that the plan's people have", "by the person's number"}}) {
    const WorkFolder folder;
    Json json = small_plan(2, 2);
    json["people"] = people;
    put_data(folder, json);
    merged(folder);
    const hdf5::Handle file = open_file(folder / kIndexName).value();
    const hdf5::Handle splits(H5Gopen2(file.id(), kSplitsTable, H5P_DEFAULT), H5Gclose);
    EXPECT_THAT(read_text(splits, "person").value(), HasSubstr(told));
    EXPECT_THAT(folder.get(kCardName), HasSubstr(of_card));
  }
}

TEST(DatasetMerge, ShardOfAnotherPlanIsNamed) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  const WorkFolder other;
  Json json = six_tasks();
  json["seed"] = 8;
  put_data(other, json);
  folder.put(shard_name(1), other.get(shard_name(1)));
  const auto run = merge_dataset(folder.path());
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().to_string(), HasSubstr("shard-000001.h5: is a shard of another plan"));
}

TEST(DatasetMerge, ShardInAnotherOnesPlaceIsNamed) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  folder.put(shard_name(1), folder.get(shard_name(0)));
  const auto run = merge_dataset(folder.path());
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().to_string(), HasSubstr("shard-000001.h5: is shard 0"));
}

TEST(DatasetMerge, FolderWithoutShardsIsRefused) {
  const WorkFolder folder;
  ASSERT_TRUE(keep_plan(plan_of_json(six_tasks()), folder.path()));
  const auto run = merge_dataset(folder.path());
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().to_string(), HasSubstr("has no shard yet"));
}

TEST(DatasetMerge, CancelLeavesNothing) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  const auto before = folder.contents();
  const std::atomic<bool> cancel = true;
  const auto run = merge_dataset(folder.path(), {.cancel = &cancel});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::cancelled);
  EXPECT_EQ(folder.contents(), before);
}

TEST(DatasetMerge, TaskThatWasRefusedIsInNoSplit) {
  const WorkFolder folder;
  Json json = six_tasks();
  // nothing of the box is in reach
  json["task"]["goals"][0]["position_m"] = {
      {"choice", {Json::array({-0.2, 1.2, 0.4}), {{"reach", {{5.0, 5.0, 5.0}, {6.0, 6.0, 6.0}}}}}}};
  put_data(folder, json);
  merged(folder);
  Table tasks{kTasksTable, {{.name = "status", .type = ElementType::u8}}};
  Table splits = shape_of(splits_table());
  ASSERT_TRUE(read_index(folder / kIndexName, tasks));
  ASSERT_TRUE(read_index(folder / kIndexName, splits));
  const auto status = tasks["status"].as<std::uint8_t>();
  const auto by_person = splits["by_person"].as<std::uint8_t>();
  const auto by_region = splits["by_region"].as<std::uint8_t>();
  std::uint64_t refused = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    const bool was = tasks["status"].words[status[k]] == kRefused;
    refused += was ? 1 : 0;
    EXPECT_EQ(static_cast<Split>(by_person[k]) == Split::none, was);
    EXPECT_EQ(static_cast<Split>(by_region[k]) == Split::none, was);
  }
  EXPECT_GT(refused, 0u);
  EXPECT_EQ(Json::parse(folder.get(kStatisticsName))["refused"], refused);
}

// --- data card ---

TEST(DataCard, TellsLicenceCountsAndPlan) {
  const WorkFolder folder;
  const DatasetPlan plan = put_data(folder, six_tasks());
  const MergeRun run = merged(folder);
  const std::string card = folder.get(kCardName);
  EXPECT_TRUE(card.starts_with("# Six reaches\n"));
  for (const std::string& part :
       {std::string("CC0-1.0"), "| motions | " + std::to_string(run.motions) + " |",
        std::string("| tasks | 6 of the plan's 6 |"), plan.digest(),
        std::string("| `angles` | rows × 61 × 9 | f32 | rad |"), std::string("Seed: 7")}) {
    EXPECT_THAT(card, HasSubstr(part));
  }
}

TEST(DataCard, SaysThatNoLicenceWasGiven) {
  const WorkFolder folder;
  put_data(folder, small_plan(2, 2));
  merged(folder);
  EXPECT_THAT(folder.get(kCardName), HasSubstr("No licence was given"));
}

TEST(DataCard, FirstOneTellsThePlanAndKeepsALaterOne) {
  const WorkFolder folder;
  const DatasetPlan plan = plan_of_json(six_tasks());
  ASSERT_TRUE(write_first_card(plan, folder.path(), "shigusa 9.9"));
  const std::string card = folder.get(kCardName);
  EXPECT_THAT(card, HasSubstr("asks for 6 tasks in 3 files"));
  EXPECT_THAT(card, HasSubstr("shigusa 9.9"));
  EXPECT_THAT(card, HasSubstr("| `angles` | rows × 61 × 9 | f32 | rad |"));
  folder.put(kCardName, "mine");
  ASSERT_TRUE(write_first_card(plan, folder.path()));
  EXPECT_EQ(folder.get(kCardName), "mine");
}

// --- statistics ---

TEST(DatasetStatistics, AreThoseOfAllMotionsAtOnce) {
  const WorkFolder folder;
  put_data(folder, six_tasks());
  merged(folder);
  const Json json = Json::parse(folder.get(kStatisticsName));
  for (const auto& [path, table] : joined(folder, 3)) {
    if (!path.starts_with(kMotionsGroup)) continue;
    const auto angles = table.find("angles")->as<float>();
    const std::size_t joints = table.names_of("joints")->size();
    const Json& told = json["tables"][path];
    EXPECT_EQ(told["motions"], table.rows());
    for (std::size_t joint = 0; joint < joints; ++joint) {
      double sum = 0.0;
      double squares = 0.0;
      double least = INFINITY;
      for (std::size_t k = joint; k < angles.size(); k += joints) {
        sum += angles[k];
        least = std::min(least, static_cast<double>(angles[k]));
      }
      const double mean = sum / static_cast<double>(angles.size() / joints);
      for (std::size_t k = joint; k < angles.size(); k += joints) {
        squares += (angles[k] - mean) * (angles[k] - mean);
      }
      const double deviation = std::sqrt(squares / static_cast<double>(angles.size() / joints));
      // sums of some thousand numbers of order 1
      EXPECT_NEAR(told["angles"]["mean"][joint].get<double>(), mean, 1e-12);
      EXPECT_NEAR(told["angles"]["deviation"][joint].get<double>(), deviation, 1e-12);
      EXPECT_EQ(told["angles"]["least"][joint].get<double>(), least);
    }
  }
}

TEST(Moments, FarFromZeroTheSpreadIsStillRight) {
  // 1e9 + {0, 1, 2}: the sum of squares has no bits left for the spread
  std::vector<Moments> columns(1);
  for (int block = 0; block < 1000; ++block) {
    const std::vector<double> numbers{1e9, 1e9 + 1.0, 1e9 + 2.0};
    add_moments(numbers, columns);
  }
  EXPECT_EQ(columns[0].count, 3000u);
  EXPECT_DOUBLE_EQ(columns[0].mean, 1e9 + 1.0);
  EXPECT_NEAR(columns[0].deviation(), std::sqrt(2.0 / 3.0), 1e-9);
}

TEST(Moments, NumbersThatAreNoneAreLeftOut) {
  std::vector<Moments> columns(2);
  const std::vector<double> numbers{1.0, kNoNumber, 3.0, kNoNumber};
  add_moments(numbers, columns);
  EXPECT_EQ(columns[0].mean, 2.0);
  EXPECT_EQ(columns[1].count, 0u);
  EXPECT_TRUE(std::isnan(columns[1].deviation()));
}

RC_GTEST_PROP(Quantiles, AreNearThoseOfTheSortedNumbers, (std::vector<double> numbers)) {
  std::erase_if(numbers, [](double x) { return !std::isfinite(x); });
  RC_PRE(!numbers.empty());
  Quantiles quantiles;
  for (const double number : numbers) quantiles.add(number);
  std::sort(numbers.begin(), numbers.end());
  for (const double share : kQuantileShares) {
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1));
    const double exact = numbers[rank];
    // 12 bits of the fraction are counted apart, and what is told is the middle between; below the
    // least normal number there are fewer
    RC_ASSERT(std::abs(quantiles.at(share) - exact) <= std::abs(exact) / 4000.0 + 1e-300);
  }
}

// --- splits ---

// Tasks of drawn people, and their goals.
struct SplitInput {
  Table tasks = empty_tables()[0];
  Table goals = empty_tables()[1];

  explicit SplitInput(std::uint64_t count) {
    Random random(5);
    for (std::uint64_t task = 0; task < count; ++task) {
      tasks["task"].push_as(task);
      tasks["person"].push_as(random.next() % 40);
      tasks["status"].push(0.0);
      tasks["sex"].push(static_cast<double>(random.below(2)));
      tasks["character"].push(std::string_view("human"));
      tasks["stature_m"].push(random.uniform(1.5, 1.9));
      tasks["mass_kg"].push(random.uniform(50.0, 100.0));
      goals["task"].push_as(task);
      goals["position_m"].push(
          Vec3d{random.uniform(-0.7, 0.7), random.uniform(0.0, 2.0), random.uniform(-0.2, 0.7)});
    }
  }
  [[nodiscard]] Table splits(bool numbered) const {
    Table table = splits_table();
    add_splits(tasks, goals, numbered, table);
    return table;
  }
};

TEST(DatasetSplits, APersonIsInOnePartAlone) {
  const SplitInput input(3000);
  for (const bool numbered : {false, true}) {
    const Table splits = input.splits(numbered);
    const auto parts = splits.find("by_person")->as<std::uint8_t>();
    const auto people = input.tasks.find("person")->as<std::uint64_t>();
    const auto sexes = input.tasks.find("sex")->as<std::uint8_t>();
    const auto statures = input.tasks.find("stature_m")->as<double>();
    const auto masses = input.tasks.find("mass_kg")->as<double>();
    std::map<std::vector<double>, std::set<int>> parts_of;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      std::vector<double> key{static_cast<double>(people[k])};
      if (!numbered) {
        key = {static_cast<double>(sexes[k]), std::round(statures[k] * 100.0),
               std::round(masses[k])};
      }
      parts_of[key].insert(parts[k]);
    }
    for (const auto& [key, own] : parts_of) EXPECT_EQ(own.size(), 1u);
  }
}

TEST(DatasetSplits, ARegionIsInOnePartAlone) {
  const Table splits = SplitInput(3000).splits(false);
  const auto parts = splits.find("by_region")->as<std::uint8_t>();
  const auto regions = splits.find("region")->as<std::uint16_t>();
  std::map<std::uint16_t, std::set<int>> parts_of;
  for (std::size_t k = 0; k < parts.size(); ++k) parts_of[regions[k]].insert(parts[k]);
  EXPECT_GT(parts_of.size(), 50u);
  for (const auto& [region, own] : parts_of) EXPECT_EQ(own.size(), 1u);
}

TEST(DatasetSplits, SharesAreThoseThatAreTold) {
  std::array<int, 4> count{};
  for (std::uint64_t person = 0; person < 10'000; ++person) {
    ++count[static_cast<std::size_t>(split_of_person({.number = person}, true))];
  }
  // five standard deviations of a draw of 10,000
  EXPECT_NEAR(count[0], 8000, 200);
  EXPECT_NEAR(count[1], 1000, 150);
  EXPECT_NEAR(count[2], 1000, 150);
  EXPECT_EQ(count[3], 0);
}

TEST(DatasetSplits, CellsOfTheWorldAreRegions) {
  const Vec3d here{0.1, 1.1, 0.4};
  EXPECT_EQ(region_of(here), region_of({0.11, 1.12, 0.41}));
  EXPECT_NE(region_of(here), region_of({0.1, 1.3, 0.4}));   // higher
  EXPECT_NE(region_of(here), region_of({0.1, 1.1, 0.7}));   // farther
  EXPECT_NE(region_of(here), region_of({0.4, 1.1, 0.1}));   // to the left
  EXPECT_NE(region_of(here), region_of({0.1, 1.1, -0.4}));  // behind
  // ahead is the middle of a direction, behind too
  EXPECT_EQ(region_of({0.01, 1.1, 0.4}), region_of({-0.01, 1.1, 0.4}));
  EXPECT_EQ(region_of({0.01, 1.1, -0.4}), region_of({-0.01, 1.1, -0.4}));
  EXPECT_EQ(region_of({kNoNumber, 1.1, 0.4}), kNoRegion);
  EXPECT_LT(region_of({1e300, -1e300, 1e300}), kNoRegion);
}

}  // namespace
}  // namespace shigusa
