// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/dataset.hpp>
#include <shigusa/run.hpp>

#include "cast.hpp"
#include "core/hash.hpp"
#include "draws.hpp"
#include "files/file.hpp"
#include "files/sha256.hpp"
#include "formats/json_reader.hpp"
#include "task_rows.hpp"

namespace shigusa {

struct DatasetPlan::Made {
  explicit Made(std::filesystem::path folder) : cast(std::move(folder)) {}

  std::string name;
  std::string licence;
  std::uint64_t seed = 0;
  std::uint64_t tasks = 0;
  std::uint64_t people = 0;
  std::uint64_t shard_tasks = 0;
  std::vector<DatasetSeries> series;
  KeptMotions motions = KeptMotions::reached;
  Json task;
  Json whole;  // the file without the paths of its characters
  std::vector<std::string> files;
  std::string text;
  std::string digest;
  mutable Cast cast;  // a cache behind a lock
};

namespace {

// Names of a task's further random streams, which differ from all places of values.
std::uint64_t stream_of(std::string_view name, std::uint64_t task) {
  Fnv1a hash;
  hash.add(name);
  hash.add(task);
  return hash.value();
}

// A task of a drawn character with at most one goal.
Result<Task> task_of(Cast& cast, const Json& character, const Json& goal) {
  Json json = Json::object();
  if (!character.is_null()) json["character"] = character;
  if (!goal.is_null()) json["goals"] = Json::array({goal});
  SHG_TRY_ASSIGN(TaskFile file, parse_task(json.dump(), "character"));
  SHG_TRY_ASSIGN(file.character, cast.measured(file.character));
  return make_task(file, cast.folder());
}

Result<Json> drawn_of(const Json& task, Cast& cast, const DrawSource& source) {
  return drawn(task, source, [&cast](const Json& character, const Json& goal) {
    return task_of(cast, character, goal);
  });
}

// Tasks at the ends of all draws: all low, or all high, with one alternative of each choice.
Result<std::vector<TaskFile>> ends_of(const Json& task, Cast& cast, const std::string& place) {
  std::vector<TaskFile> ends;
  const std::size_t alternatives = most_alternatives(task);
  for (std::size_t k = 0; k < alternatives; ++k) {
    for (const DrawMode mode : {DrawMode::lowest, DrawMode::highest}) {
      SHG_TRY_ASSIGN(const Json json, drawn_of(task, cast, {.mode = mode, .alternative = k}));
      SHG_TRY_ASSIGN(TaskFile file, parse_task(json.dump(), place));
      ends.push_back(std::move(file));
    }
  }
  return ends;
}

// Files of the characters among these, each once.
std::vector<std::string> files_of(const std::vector<TaskFile>& ends) {
  std::vector<std::string> sources;
  for (const TaskFile& end : ends) {
    if (!is_complete(end.character)) sources.push_back(end.character.source);
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

// Largest memory (bytes) of the motions of one of these tasks.
Result<std::uint64_t> task_bytes(const std::vector<TaskFile>& ends, Cast& cast,
                                 std::span<const DatasetSeries> series, const std::string& place) {
  std::uint64_t most = 0;
  for (TaskFile end : ends) {
    SHG_TRY_ASSIGN(end.character, cast.measured(end.character));
    const Result<Task> task = make_task(end, cast.folder());
    if (!task) return fail(task.error().code, task.error().to_string(), place);
    most = std::max(
        most, motion_bytes(end, *task, series) * static_cast<std::uint64_t>(task->candidates));
  }
  return most;
}

// Number of tasks of a shard: the plan's, or, if it gives none, a round number within the memory
// limit.
Result<std::uint64_t> shard_tasks_of(std::uint64_t asked, std::uint64_t bytes,
                                     const std::string& name) {
  const std::uint64_t most =
      std::max<std::uint64_t>(1, kShardMaxBytes / std::max<std::uint64_t>(1, bytes));
  if (asked > most) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {}; with these series and candidates a shard has at most {} tasks",
                            asked, most),
                name + ": shard_tasks");
  }
  if (asked > 0) return asked;
  std::uint64_t round = 1;
  for (std::uint64_t power = 1; power <= kShardTasks; power *= 10) {
    for (const std::uint64_t one : {power, 2 * power, 5 * power}) {
      if (one <= std::min(most, kShardTasks)) round = one;
    }
  }
  return round;
}

Result<void> read_series(JsonReader& reader, std::vector<DatasetSeries>& series) {
  if (!reader.has("series")) {
    series = {DatasetSeries::angles, DatasetSeries::torques, DatasetSeries::centre_of_mass};
    return {};
  }
  std::vector<std::string> words;
  reader.texts("series", words);
  for (const std::string& word : words) {
    const Result<DatasetSeries> known = value_of<DatasetSeries>(word, "series");
    if (!known) {
      reader.wrong("series", known.error().message);
    } else if (std::find(series.begin(), series.end(), *known) == series.end()) {
      series.push_back(*known);
    }
  }
  // a fixed order, independent of the file's
  std::sort(series.begin(), series.end());
  return {};
}

// Adds the series that pieces of work have more, unless the plan names its series.
void adapt_series(const std::vector<TaskFile>& ends, bool named,
                  std::vector<DatasetSeries>& series) {
  const bool works = std::any_of(ends.begin(), ends.end(),
                                 [](const TaskFile& end) { return !end.actions.empty(); });
  if (works && !named) {
    series.insert(series.end(), {DatasetSeries::actions, DatasetSeries::things});
  }
}

}  // namespace

Result<DatasetPlan> DatasetPlan::parse(std::string_view text, std::string_view name,
                                       const std::filesystem::path& folder) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  const std::string place(name);
  JsonReader reader(json, place + ": ");
  std::string beside;
  reader.text("characters_in", beside);
  const auto made = std::make_shared<Made>(folder / beside);
  int version = kDatasetVersion;
  for (const char* key : {"tasks", "task"}) reader.require(key);
  reader.integer("version", version, kDatasetVersion, kDatasetVersion);
  reader.text("name", made->name);
  reader.text("licence", made->licence);
  reader.integer("seed", made->seed, 0, UINT64_MAX);
  reader.integer("tasks", made->tasks, 1, kDatasetMaxTasks);
  reader.integer("people", made->people, 0, kDatasetMaxTasks);
  std::uint64_t shard_tasks = 0;
  reader.integer("shard_tasks", shard_tasks, 1, kDatasetMaxTasks);
  SHG_TRY(read_series(reader, made->series));
  reader.word("motions", made->motions);
  if (reader.has("task") && !reader.value("task").is_object()) {
    reader.wrong("task", "must be an object: a task, in which values may be draws");
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  made->task = json["task"];
  made->whole = json;
  made->whole.erase("characters_in");
  SHG_TRY(check_draws(made->task, place + ": task"));
  SHG_TRY_ASSIGN(const std::vector<TaskFile> ends,
                 ends_of(made->task, made->cast, place + ": task"));
  adapt_series(ends, json.contains("series"), made->series);
  SHG_TRY_ASSIGN(const std::uint64_t bytes,
                 task_bytes(ends, made->cast, made->series, place + ": task"));
  SHG_TRY_ASSIGN(made->shard_tasks, shard_tasks_of(shard_tasks, bytes, place));
  const std::uint64_t shards = (made->tasks - 1) / made->shard_tasks + 1;
  if (shards > kDatasetMaxShards) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("makes {} shards of {} tasks; the most are {}: give fewer tasks, or "
                            "fewer series or candidates, of which more tasks go into a shard",
                            shards, made->shard_tasks, kDatasetMaxShards),
                place + ": tasks");
  }
  // title and number of tasks of a data set do not change its tasks
  Json same{{"version", kDatasetVersion},
            {"seed", made->seed},
            {"people", made->people},
            {"shard_tasks", made->shard_tasks},
            {"series", Json::array()}};
  for (const DatasetSeries series : made->series) same["series"].push_back(word_of(series));
  same["motions"] = word_of(made->motions);
  same["task"] = made->task;
  made->text = same.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string all = made->text;
  made->files = files_of(ends);
  for (const std::string& source : made->files) {
    SHG_TRY_ASSIGN(const std::string bytes_of,
                   read_text_file(made->cast.folder() / source, kCharacterMaxBytes));
    all += "\n" + sha256(bytes_of);
  }
  made->digest = sha256(all);
  return DatasetPlan(made);
}

Result<DatasetPlan> DatasetPlan::read(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kPlanMaxBytes));
  return parse(text, path.filename().string(), path.parent_path());
}

const std::string& DatasetPlan::name() const { return made_->name; }
const std::string& DatasetPlan::licence() const { return made_->licence; }
std::uint64_t DatasetPlan::seed() const { return made_->seed; }
std::uint64_t DatasetPlan::tasks() const { return made_->tasks; }
std::uint64_t DatasetPlan::people() const { return made_->people; }
std::uint64_t DatasetPlan::shard_tasks() const { return made_->shard_tasks; }
std::uint64_t DatasetPlan::shards() const { return (tasks() - 1) / shard_tasks() + 1; }
const std::vector<DatasetSeries>& DatasetPlan::series() const { return made_->series; }
KeptMotions DatasetPlan::motions() const { return made_->motions; }
const std::string& DatasetPlan::text() const { return made_->text; }
const std::string& DatasetPlan::digest() const { return made_->digest; }

const std::vector<std::string>& DatasetPlan::character_files() const { return made_->files; }

std::string DatasetPlan::text_in(const std::filesystem::path& folder) const {
  Json json = made_->whole;
  if (!made_->files.empty()) {
    std::error_code failed;
    const auto whole = [&failed](const std::filesystem::path& path) {
      return std::filesystem::absolute(path / ".", failed).lexically_normal();
    };
    const auto here = whole(folder);
    const auto there = whole(made_->cast.folder());
    json["characters_in"] = there.lexically_relative(here).generic_string();
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

TaskRange DatasetPlan::tasks_of(std::uint64_t shard) const {
  const std::uint64_t first = shard * shard_tasks();
  return {first, std::min(tasks(), first + shard_tasks())};
}

Result<DrawnTask> DatasetPlan::task(std::uint64_t index) const {
  DrawnTask task;
  task.person = index;
  if (people() > 0) {
    Random random(seed(), stream_of("person", index));
    task.person = random.next() % people();
  }
  SHG_TRY_ASSIGN(Json json, drawn_of(made_->task, made_->cast,
                                     {.seed = seed(), .task = index, .person = task.person}));
  if (!json.contains("seed")) {
    // 53 bits, which every reader of JSON preserves
    json["seed"] = Random(seed(), stream_of("seed", index)).next() >> 11;
  }
  SHG_TRY_ASSIGN(task.file, parse_task(json.dump(), fmt::format("task {}", index)));
  SHG_TRY_ASSIGN(task.file.character, made_->cast.measured(task.file.character));
  return task;
}

}  // namespace shigusa
