// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/dataset_export.hpp>
#include <shigusa/files.hpp>

#include "export_writer.hpp"

namespace shigusa {
namespace {

using MakeWriter = Result<std::unique_ptr<DataWriter>> (*)(const ExportJob&);

// Writers in the order of DataFormat.
template <std::size_t... place>
constexpr std::array<MakeWriter, sizeof...(place)> all_writers(std::index_sequence<place...>) {
  return {make_writer<kDataFormats[place].format>...};
}
constexpr auto kWriters = all_writers(std::make_index_sequence<kDataFormats.size()>());

// Fails on a folder that holds foreign files.
Result<void> prepare(const DataExportSettings& settings) {
  SHG_TRY(prepare_folder(settings.to));
  std::error_code refused;
  const bool empty = std::filesystem::is_empty(settings.to, refused);
  if (!refused && !empty && !settings.force) {
    return fail(
        ErrorCode::invalid_argument,
        "is not empty: give a new folder, or --force to write into this one, in which files "
        "of the same names are replaced and others stay",
        settings.to.string());
  }
  return {};
}

Result<double> rate_of(const DataExportSettings& settings) {
  const DataFormatInfo& info = info_of(settings.format);
  if (!settings.rate) return info.rate;
  if (info.rate_fixed) {
    return fail(ErrorCode::invalid_argument,
                info.rate > 0.0
                    ? fmt::format("is {}; motions leave as {} at {} frames a second alone",
                                  *settings.rate, info.word, info.rate)
                    : fmt::format("is {}; motions leave as {} with their own frames alone",
                                  *settings.rate, info.word),
                "--fps");
  }
  SHG_TRY(check_rate(*settings.rate, "--fps"));
  return *settings.rate;
}

Result<void> check_tasks(const DataExportSettings& settings, const DatasetPlan& plan) {
  if (!settings.tasks) return {};
  const TaskRange& tasks = *settings.tasks;
  if (tasks.first < tasks.last && tasks.last <= plan.tasks()) return {};
  return fail(ErrorCode::invalid_argument,
              fmt::format("is {}:{}; allowed is FIRST:LAST with FIRST < LAST, and the plan has {} "
                          "tasks: 0:{} is all of them",
                          tasks.first, tasks.last, plan.tasks(), plan.tasks()),
              "--tasks");
}

Result<std::optional<Split>> asked_split(const DataExportSettings& settings) {
  if (!settings.split) return std::optional<Split>{};
  const Result<Split> split = value_of<Split>(*settings.split, "part");
  if (split && *split != Split::none) return *split;
  return fail(ErrorCode::invalid_argument,
              fmt::format("is '{}'; allowed are train, validation and test", *settings.split),
              "--split");
}

// Whether a shard has a requested task.
bool has_asked(const DataExportSettings& settings, const TaskRange& tasks) {
  return !settings.tasks ||
         (tasks.first < settings.tasks->last && tasks.last > settings.tasks->first);
}

// An export in progress.
struct Exporting {
  const ExportJob& job;
  DataWriter& writer;
  std::optional<Split> split{};
  DataExportReport report{};
  DataExportRun run{};

  [[nodiscard]] bool is_asked(const DataMotion& motion) const {
    const DataExportSettings& asked = job.settings;
    const std::uint64_t task = motion.number();
    if (asked.tasks && (task < asked.tasks->first || task >= asked.tasks->last)) return false;
    if (split && split_of(motion, job.data.plan) != *split) return false;
    return !asked.verdict ||
           motion.motion.whole("verdict") <= static_cast<std::uint64_t>(*asked.verdict);
  }
  bool is_over() {
    run.stopped = job.settings.cancel != nullptr && job.settings.cancel->load();
    return run.stopped || (job.settings.most && run.motions >= *job.settings.most);
  }
  void tell() const {
    if (job.settings.report) job.settings.report(report);
  }
  Result<void> add(const DataMotion& motion) {
    Result<void> added = writer.add(motion);
    if (added) {
      report.motions = ++run.motions;
      return {};
    }
    if (added.error().code != ErrorCode::unsupported) return added;
    if (run.left_out++ == 0) {
      run.why = fmt::format("motion {}: {}", motion.id(), added.error().to_string());
    }
    return {};
  }
  Result<void> add_shard(std::uint64_t shard) {
    const TaskRange tasks = job.data.plan.tasks_of(shard);
    if (has_asked(job.settings, tasks)) {
      SHG_TRY_ASSIGN(const ShardRows rows, read_rows(job.data, shard, writer.series()));
      for (const DataMotion& motion : rows.motions) {
        if (is_over()) return {};
        if (!is_asked(motion)) continue;
        SHG_TRY(add(motion));
        tell();
      }
    }
    report.tasks += tasks.last - tasks.first;
    tell();
    return {};
  }
};

}  // namespace

Result<void> ExportFolder::open(const std::filesystem::path& path) {
  if (const int reason = staging_.open(path)) return refused(path, "open", reason);
  if (const int reason = staging_.make()) return refused(path, "write to", reason);
  return {};
}

Result<void> ExportFolder::put(const std::string& name, std::string_view bytes) {
  const std::filesystem::path& path = staging_.path();
  const std::size_t slash = name.find_last_of('/');
  const std::string above = slash == std::string::npos ? "" : name.substr(0, slash);
  if (!above.empty() && above != last_) {
    std::error_code failed;
    std::filesystem::create_directories(path / above, failed);
    if (failed) return refused(path / above, "make", failed.value());
    last_ = above;
  }
  constexpr const char* kMade = "made";
  int reason = staging_.add(kMade, bytes, false);
  if (reason == 0) reason = staging_.move_out(kMade, name);
  return reason == 0 ? Result<void>{} : refused(path / name, "write", reason);
}

std::string motion_file(const DataMotion& motion, std::string_view ending) {
  constexpr std::uint64_t kTasksOfFolder = 1000;
  return fmt::format("motions/{:04}/{}.{}", motion.number() / kTasksOfFolder, motion.id(), ending);
}

std::string about_export(const ExportJob& job, std::uint64_t motions) {
  const DatasetPlan& plan = job.data.plan;
  std::string text = fmt::format(
      "# {}\n\n{} motions of a data set that shigusa made, exported as {}. Plan {} (SHA-256), seed "
      "{}{}.\nA motion's name is its task's number in the plan and its rank among the task's "
      "motions.\n",
      plan.name().empty() ? "Motions" : plan.name(), motions, word_of(job.settings.format),
      plan.digest(), plan.seed(), plan.licence().empty() ? "" : ", licence " + plan.licence());
  if (job.settings.verdict) {
    text += fmt::format("Only motions of the verdict `{}` or a better one are here.\n",
                        word_of(*job.settings.verdict));
  }
  if (job.settings.split) {
    text += fmt::format("Only people of the part `{}` are here.\n", *job.settings.split);
  }
  return text;
}

Result<DataExportRun> export_dataset(const DataExportSettings& settings) {
  SHG_TRY_ASSIGN(const DataFolder data, DataFolder::open(settings.from));
  SHG_TRY_ASSIGN(const double rate, rate_of(settings));
  SHG_TRY(check_tasks(settings, data.plan));
  SHG_TRY_ASSIGN(const std::optional<Split> split, asked_split(settings));
  ExportFolder folder;
  const ExportJob job{settings, data, folder, rate};
  SHG_TRY_ASSIGN(const std::unique_ptr<DataWriter> writer,
                 kWriters[static_cast<std::size_t>(settings.format)](job));
  SHG_TRY(prepare(settings));
  SHG_TRY(folder.open(settings.to));
  Exporting work{job, *writer, split};
  work.report.of = data.tasks;
  work.tell();
  for (const std::uint64_t shard : data.shards) {
    if (work.is_over()) break;
    SHG_TRY(work.add_shard(shard));
  }
  if (work.run.motions == 0 && !work.run.stopped) {
    return fail(
        ErrorCode::invalid_argument,
        work.run.left_out > 0
            ? fmt::format("no motion can leave as {}: {}", word_of(settings.format), work.run.why)
            : "has no motion that is asked for: ask for other tasks, verdicts or people",
        settings.from.string());
  }
  SHG_TRY(writer->finish());
  writer->count(work.run);
  return work.run;
}

}  // namespace shigusa
