// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <shigusa/dataset_check.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/run.hpp>
#include <system_error>

#include "core/hash.hpp"
#include "core/index.hpp"
#include "files/file.hpp"
#include "index_reader.hpp"
#include "shard_list.hpp"
#include "shard_statistics.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

using Clock = std::chrono::steady_clock;

// Largest number of columns per task whose differences are reported.
constexpr std::size_t kToldColumns = 5;
// Tasks per thread that are made before they are compared; their shards stay open.
constexpr std::size_t kTasksOfThread = 8;

// A task to be made again, and its shard.
struct Replay {
  const ShardReader* shard = nullptr;
  std::uint64_t task = 0;
};

// A check in progress.
struct Check {
  const DatasetPlan& plan;
  const std::filesystem::path& folder;
  const CheckSettings& settings;
  ShardList shards;
  std::uint64_t lone;  // a task that is always made again
  CheckRun run{};
  CheckReport report{};
  std::map<std::uint64_t, std::string> sums{};  // of complete shards
  // tasks to be made again together, from open shards
  std::vector<Replay> waiting{};
  std::list<ShardReader> open{};
  DatasetStatistics statistics{};  // of complete shards

  void tell(std::string file, std::string says) {
    ++run.problem_count;
    ++report.problems;
    if (run.problems.size() < kMostProblems) {
      run.problems.push_back({std::move(file), std::move(says)});
    }
  }
  void show() const {
    if (settings.report) settings.report(report);
  }
};

std::uint64_t stream_of(std::uint64_t task) {
  Fnv1a hash;
  hash.add(std::string_view("check"));
  hash.add(task);
  return hash.value();
}

// A task of the existing shards.
std::uint64_t lone_task(const DatasetPlan& plan, const ShardList& shards) {
  Random random(plan.seed(), stream_of(plan.tasks()));
  const std::uint64_t shard = shards.there[random.next() % shards.there.size()];
  const TaskRange tasks = plan.tasks_of(shard);
  return tasks.first + random.next() % (tasks.last - tasks.first);
}

bool is_drawn(const Check& check, std::uint64_t task) {
  return task == check.lone ||
         Random(check.plan.seed(), stream_of(task)).chance(check.settings.share);
}

// Rows of a table that belong to one task; fails if they are not contiguous.
Result<RowRange> rows_of_task(const ShardReader& shard, const std::string& path,
                              std::uint64_t task) {
  SHG_TRY_ASSIGN(const Table table, read_columns(shard, path, {"task"}));
  if (table.columns.front().type != ElementType::u64) {
    return fail(ErrorCode::parse, "has tasks that are no numbers", path);
  }
  const auto tasks = table.columns.front().as<std::uint64_t>();
  const auto first = std::find(tasks.begin(), tasks.end(), task);
  const auto last = std::find_if(first, tasks.end(), [task](auto one) { return one != task; });
  if (std::find(last, tasks.end(), task) != tasks.end()) {
    return fail(ErrorCode::parse, "has a task's rows in two places", path);
  }
  return RowRange{static_cast<std::size_t>(first - tasks.begin()),
                  static_cast<std::size_t>(last - tasks.begin())};
}

// Difference between a stored and a recomputed column; empty if there is none.
std::string difference(const Column& made, const Column* kept) {
  if (kept == nullptr) return "is not there";
  if (made.type != kept->type || made.shape != kept->shape || made.text_size != kept->text_size) {
    return "has another shape";
  }
  if (made.bytes == kept->bytes) return "";
  if (made.bytes.size() != kept->bytes.size()) return "has another number of rows";
  const std::size_t size = std::max<std::size_t>(1, size_of(made.type));
  std::size_t count = 0;
  for (std::size_t at = 0; at + size <= made.bytes.size(); at += size) {
    if (made.bytes.compare(at, size, kept->bytes, at, size) != 0) ++count;
  }
  return fmt::format("has {} of {} {} otherwise", count, made.bytes.size() / size,
                     made.type == ElementType::text ? "characters" : "numbers");
}

// Compares a task's rows of one table; adds a sentence for each differing column.
Result<void> compare_table(const ShardReader& shard, std::uint64_t task, const std::string& path,
                           const Table* made, std::vector<std::string>& differences) {
  SHG_TRY_ASSIGN(const RowRange rows, rows_of_task(shard, path, task));
  const bool none = rows.first == rows.last;
  if (made == nullptr && !none) differences.push_back(path + " has rows that it should not have");
  if (made == nullptr || (none && made->rows() == 0)) return {};
  SHG_TRY_ASSIGN(const Table kept, shard.table(path, {}, rows));
  for (const auto& [what, list] : made->names) {
    const std::vector<std::string>* same = kept.names_of(what);
    if (same == nullptr || *same != list)
      differences.push_back(fmt::format("{} has other {}", path, what));
  }
  for (const Column& column : made->columns) {
    const std::string how = difference(column, kept.find(column.name));
    if (!how.empty()) differences.push_back(fmt::format("{}/{} {}", path, column.name, how));
  }
  for (const Column& column : kept.columns) {
    if (made->find(column.name) == nullptr) {
      differences.push_back(fmt::format("{}/{} is not among what is made", path, column.name));
    }
  }
  return {};
}

// Tables of a shard and of a recomputed task, each path once.
Result<std::vector<std::string>> paths_of_both(const ShardReader& shard, const MadeTask& made) {
  SHG_TRY_ASSIGN(std::vector<std::string> paths, paths_of(shard));
  for (const Table& table : made.tables) paths.push_back(table.path);
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  return paths;
}

Result<std::vector<std::string>> differences_of(const ShardReader& shard, const MadeTask& made) {
  std::vector<std::string> differences;
  SHG_TRY_ASSIGN(const std::vector<std::string> there, paths_of(shard));
  SHG_TRY_ASSIGN(const std::vector<std::string> paths, paths_of_both(shard, made));
  for (const std::string& path : paths) {
    const auto table = std::find_if(made.tables.begin(), made.tables.end(),
                                    [&path](const Table& one) { return one.path == path; });
    if (std::find(there.begin(), there.end(), path) == there.end()) {
      differences.push_back(path + " is not there");
      continue;
    }
    const Table* own = table == made.tables.end() ? nullptr : &*table;
    SHG_TRY(compare_table(shard, made.number, path, own, differences));
  }
  return differences;
}

// Compares a recomputed task with its rows.
void compare(Check& check, const ShardReader& shard, const MadeTask& made) {
  ++check.run.replayed;
  ++check.report.replayed;
  check.run.motions += made.motions;
  const std::string name = shard_name(shard.head().shard);
  const Result<std::vector<std::string>> differences = differences_of(shard, made);
  if (!differences) return check.tell(name, differences.error().to_string());
  if (differences->empty()) return;
  std::string text = fmt::format("task {} comes out otherwise: ", made.number);
  for (std::size_t k = 0; k < differences->size() && k < kToldColumns; ++k) {
    text += (k > 0 ? "; " : "") + (*differences)[k];
  }
  if (differences->size() > kToldColumns) {
    text += fmt::format("; and {} more", differences->size() - kToldColumns);
  }
  check.tell(name, text);
}

// Recomputes the waiting tasks, several at once, and compares them. HDF5 is called only from this
// thread.
void replay_waiting(Check& check) {
  std::vector<std::optional<MadeTask>> made(check.waiting.size());
  parallel_for(static_cast<int>(made.size()), thread_count(check.settings.threads),
               [&](int k, int) {
                 const auto i = static_cast<std::size_t>(k);
                 made[i] = make_task_rows(check.plan, check.waiting[i].task, check.settings.simd);
               });
  for (std::size_t k = 0; k < made.size(); ++k) compare(check, *check.waiting[k].shard, *made[k]);
  check.waiting.clear();
  // the last shard may have more tasks
  while (check.open.size() > 1) check.open.pop_front();
  check.show();
}

Result<void> not_cancelled(const Check& check) {
  if (check.settings.cancel == nullptr || !check.settings.cancel->load()) return {};
  return fail(ErrorCode::cancelled, "is stopped: not all of it was checked", check.folder.string());
}

// Verifies a shard's bytes and selects its tasks to recompute.
Result<void> check_shard(Check& check, std::uint64_t number) {
  const std::string name = shard_name(number);
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(check.folder / name, failed);
  if (!failed) check.run.bytes += size;
  ++check.report.shards;
  Result<ShardReader> shard = open_shard(check.plan, check.folder, number);
  if (!shard) {
    check.tell(name, shard.error().message.text);
    return {};
  }
  check.sums[number] = shard->head().sha256;
  Table splits = splits_table();
  if (const auto added = add_shard_numbers(*shard, check.plan, check.statistics, splits); !added) {
    check.tell(name, added.error().to_string());
  }
  check.open.push_back(*std::move(shard));
  const std::size_t many = kTasksOfThread * index(thread_count(check.settings.threads));
  const TaskRange tasks = check.plan.tasks_of(number);
  bool used = false;
  for (std::uint64_t task = tasks.first; task < tasks.last; ++task) {
    if (!is_drawn(check, task)) continue;
    used = true;
    check.waiting.push_back({&check.open.back(), task});
    if (check.waiting.size() < many) continue;
    replay_waiting(check);
    SHG_TRY(not_cancelled(check));
  }
  if (!used) check.open.pop_back();
  return {};
}

// Compares the index's list of shards with the existing ones.
void check_index(Check& check) {
  const std::filesystem::path path = check.folder / kIndexName;
  std::error_code failed;
  check.run.index = std::filesystem::exists(path, failed);
  if (!check.run.index) return;
  const Result<IndexHead> head = verified_index(path);
  if (!head) return check.tell(kIndexName, head.error().message.text);
  if (head->plan != check.plan.digest()) return check.tell(kIndexName, "is of another plan");
  const Result<std::vector<ListedShard>> list = listed_shards(path);
  if (!list) return check.tell(kIndexName, list.error().to_string());
  std::set<std::uint64_t> there(check.shards.there.begin(), check.shards.there.end());
  for (const ListedShard& shard : *list) {
    const auto own = check.sums.find(shard.number);
    if (there.erase(shard.number) == 0) {
      check.tell(kIndexName, fmt::format("has {}, which is not there", shard_name(shard.number)));
    } else if (own != check.sums.end() && own->second != shard.sha256) {
      check.tell(kIndexName,
                 fmt::format("was made of another {}: merge again", shard_name(shard.number)));
    }
  }
  if (list->size() != head->shards) check.tell(kIndexName, "lists other shards than its head");
  if (there.empty()) return;
  check.tell(kIndexName,
             fmt::format("is without {} of the shards that are there, {} the first: merge again",
                         there.size(), shard_name(*there.begin())));
}

// Whether a statistics file states that number of shards.
bool is_of_shards(const std::string& text, std::size_t shards) {
  const Json json = Json::parse(text, nullptr, false);
  const auto count = json.is_object() ? json.find("shards") : json.end();
  return count == json.end() || *count == Json(shards);
}

// Compares the statistics file with the shards, if no error of index or shards has been reported.
void check_statistics(Check& check) {
  if (check.run.problem_count > 0) return;
  const std::filesystem::path path = check.folder / kStatisticsName;
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) {
    if (check.run.index) check.tell(kStatisticsName, "is not there: merge again");
    return;
  }
  const Result<std::string> text = read_text_file(path, kShardFileMaxBytes);
  if (!text) return check.tell(kStatisticsName, text.error().message.text);
  const std::size_t shards = check.shards.there.size();
  if (!check.run.index && !is_of_shards(*text, shards)) return;
  if (*text == format_statistics(check.plan, check.shards, check.statistics)) return;
  check.tell(kStatisticsName, "has other numbers than the shards that are there: merge again");
}

}  // namespace

Result<CheckRun> check_dataset(const std::filesystem::path& folder, const CheckSettings& settings) {
  if (!(settings.share >= 0.0 && settings.share <= 1.0)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {}; allowed is 0 to 1", settings.share), "share");
  }
  const Clock::time_point begin = Clock::now();
  SHG_TRY_ASSIGN(const DatasetPlan plan, DatasetPlan::read(folder / kPlanName));
  const ShardList shards = list_shards(plan, folder);
  if (shards.there.empty()) {
    return fail(ErrorCode::not_found, "has no shard to check", folder.string());
  }
  Check check{.plan = plan,
              .folder = folder,
              .settings = settings,
              .shards = shards,
              .lone = lone_task(plan, shards)};
  check.report.of = check.shards.there.size();
  for (const std::uint64_t shard : check.shards.there) {
    SHG_TRY(not_cancelled(check));
    SHG_TRY(check_shard(check, shard));
    check.show();
  }
  replay_waiting(check);
  for (const std::string& name : check.shards.foreign) {
    check.tell(name, fmt::format("is not of the plan, whose last shard is {}",
                                 shard_name(plan.shards() - 1)));
  }
  check_index(check);
  check_statistics(check);
  check.run.shards = check.shards.there.size();
  check.run.missing = std::move(check.shards.missing);
  check.run.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return std::move(check.run);
}

}  // namespace shigusa
