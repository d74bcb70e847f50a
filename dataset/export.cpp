// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/dataset_export.hpp>
#include <shigusa/files.hpp>

#include "export_glb.hpp"
#include "files/staging.hpp"

namespace shigusa {
namespace {

// Output folder of an export. Files are completed in one staging folder and renamed, as write_file
// would scan the folder each time.
class ExportFolder {
 public:
  // Fails if the folder is not writable.
  [[nodiscard]] Result<void> open(const std::filesystem::path& path) {
    if (const int reason = staging_.open(path)) return refused(path, "open", reason);
    if (const int reason = staging_.make()) return refused(path, "write to", reason);
    return {};
  }
  // Writes a file of the folder, such as "motions/0000/000012-1.glb", creating its parent folders.
  [[nodiscard]] Result<void> put(const std::string& name, std::string_view bytes) {
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

 private:
  Staging staging_;
  std::string last_;  // folder that was made last
};

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

// File of a motion: a folder per thousand tasks, as folders of very many files are slow.
std::string motion_file(const DataMotion& motion) {
  constexpr std::uint64_t kTasksOfFolder = 1000;
  return fmt::format("motions/{:04}/{}.glb", motion.number() / kTasksOfFolder, motion.id());
}

// Beginning of a README.md: source and selection of the motions.
std::string about_export(const DatasetPlan& plan, const DataExportSettings& settings,
                         std::uint64_t motions) {
  std::string text = fmt::format(
      "# {}\n\n{} motions of a data set that shigusa made, exported as GLB. Plan {} (SHA-256), "
      "seed "
      "{}{}.\nA motion's name is its task's number in the plan and its rank among the task's "
      "motions.\n",
      plan.name().empty() ? "Motions" : plan.name(), motions, plan.digest(), plan.seed(),
      plan.licence().empty() ? "" : ", licence " + plan.licence());
  if (settings.verdict) {
    text += fmt::format("Only motions of the verdict `{}` or a better one are here.\n",
                        word_of(*settings.verdict));
  }
  if (settings.split) {
    text += fmt::format("Only people of the part `{}` are here.\n", *settings.split);
  }
  return text;
}

// An export in progress. Borrows all but the counts.
struct Exporting {
  const DataExportSettings& settings;
  const DataFolder& data;
  ExportFolder& folder;
  GlbWriter& writer;
  std::optional<Split> split{};
  DataExportReport report{};
  DataExportRun run{};

  [[nodiscard]] bool is_asked(const DataMotion& motion) const {
    const std::uint64_t task = motion.number();
    if (settings.tasks && (task < settings.tasks->first || task >= settings.tasks->last)) {
      return false;
    }
    if (split && split_of(motion, data.plan) != *split) return false;
    return !settings.verdict ||
           motion.motion.whole("verdict") <= static_cast<std::uint64_t>(*settings.verdict);
  }
  bool is_over() {
    run.stopped = settings.cancel != nullptr && settings.cancel->load();
    return run.stopped || (settings.most && run.motions >= *settings.most);
  }
  void tell() const {
    if (settings.report) settings.report(report);
  }
  Result<void> add(const DataMotion& motion) {
    const Result<std::string> bytes = writer.file_of(motion);
    if (bytes) {
      SHG_TRY(folder.put(motion_file(motion), *bytes));
      report.motions = ++run.motions;
      return {};
    }
    if (bytes.error().code != ErrorCode::unsupported) return tl::unexpected(bytes.error());
    if (run.left_out++ == 0) {
      run.why = fmt::format("motion {}: {}", motion.id(), bytes.error().to_string());
    }
    return {};
  }
  Result<void> add_shard(std::uint64_t shard) {
    const TaskRange tasks = data.plan.tasks_of(shard);
    if (has_asked(settings, tasks)) {
      SHG_TRY_ASSIGN(const ShardRows rows, read_rows(data, shard));
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

Result<DataExportRun> export_dataset(const DataExportSettings& settings) {
  SHG_TRY_ASSIGN(const DataFolder data, DataFolder::open(settings.from));
  SHG_TRY(check_rate(settings.rate, "--fps"));
  SHG_TRY(check_tasks(settings, data.plan));
  SHG_TRY_ASSIGN(const std::optional<Split> split, asked_split(settings));
  SHG_TRY_ASSIGN(GlbWriter writer, GlbWriter::of(data.plan, settings));
  SHG_TRY(prepare(settings));
  ExportFolder folder;
  SHG_TRY(folder.open(settings.to));
  Exporting work{settings, data, folder, writer, split};
  work.report.of = data.tasks;
  work.tell();
  for (const std::uint64_t shard : data.shards) {
    if (work.is_over()) break;
    SHG_TRY(work.add_shard(shard));
  }
  DataExportRun& run = work.run;
  if (run.motions == 0 && !run.stopped) {
    return fail(ErrorCode::invalid_argument,
                run.left_out > 0
                    ? fmt::format("no motion can leave as GLB: {}", run.why)
                    : "has no motion that is asked for: ask for other tasks, verdicts or people",
                settings.from.string());
  }
  SHG_TRY(folder.put("README.md", about_export(data.plan, settings, run.motions) + writer.about()));
  run.searched = writer.searched();
  run.missed = writer.missed();
  return run;
}

}  // namespace shigusa
