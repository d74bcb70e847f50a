// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <shigusa/dataset.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/shigusa.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "next_step.hpp"
#include "number_range.hpp"
#include "paced_line.hpp"
#include "table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct DatasetOptions {
  std::string plan;    // file
  std::string folder;  // of the data set, or of the one task
  std::string shards;  // FIRST:LAST, or empty for all
  std::string part;    // K/N, or empty for all
  bool check_plan = false;
  std::optional<std::uint64_t> task;
  int threads = 0;
  std::optional<std::string> simd;
  FileOptions files;  // of the one task
  bool json = false;  // of the one task
};

struct ShardRange {
  std::uint64_t first = 0;
  std::optional<std::uint64_t> last{};
};

// Parses "FIRST:LAST" with optional ends; all shards for an empty text.
Result<ShardRange> parse_shards(const std::string& text, std::uint64_t shards) {
  ShardRange range;
  if (text.empty()) return range;
  const std::optional<NumberRange> asked = parse_range(text);
  if (asked) range = {asked->first.value_or(0), asked->last.value_or(shards)};
  if (!asked || range.first >= *range.last || *range.last > shards) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is FIRST:LAST with FIRST < LAST, and the plan has {} "
                            "shards: 0:{} is all of them",
                            text.substr(0, 80), shards, shards),
                "--shards");
  }
  return range;
}

// Parses "K/N" with K < N.
Result<ShardRange> parse_part(const std::string& text, std::uint64_t shards) {
  constexpr std::uint64_t kMostParts = 1'000'000;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::uint64_t part =
      parse_whole(std::string_view(text).substr(0, slash)).value_or(kMostParts);
  const std::uint64_t parts =
      slash < text.size() ? parse_whole(std::string_view(text).substr(slash + 1)).value_or(0) : 0;
  if (parts > kMostParts || part >= parts) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is K/N with K from 0 to N - 1 and N up to {}",
                            text.substr(0, 80), kMostParts),
                "--part");
  }
  return ShardRange{part * shards / parts, (part + 1) * shards / parts};
}

// Words for a duration, "3 h 25 min", "12 s".
std::string time_words(double seconds) {
  const auto whole_seconds = static_cast<std::int64_t>(seconds + 0.5);
  if (whole_seconds >= 86400) {
    return fmt::format("{} d {} h", whole_seconds / 86400, whole_seconds / 3600 % 24);
  }
  if (whole_seconds >= 3600) {
    return fmt::format("{} h {} min", whole_seconds / 3600, whole_seconds / 60 % 60);
  }
  if (whole_seconds >= 60) {
    return fmt::format("{} min {} s", whole_seconds / 60, whole_seconds % 60);
  }
  return fmt::format("{} s", whole_seconds);
}

std::string report_line(const DatasetReport& now) {
  const double rate = now.seconds > 0.0 ? static_cast<double>(now.tasks) / now.seconds : 0.0;
  std::string text = fmt::format("{} of {} tasks, {} motions", now.tasks, now.of, now.motions);
  if (rate > 0.0) {
    text += fmt::format(", {:.1f} tasks/s, {} left", rate,
                        time_words(static_cast<double>(now.of - now.tasks) / rate));
  }
  return text;
}

std::function<void(const DatasetReport&)> reporter() {
  return [line = PacedLine()](const DatasetReport& now) mutable {
    if (line.is_due()) line.show(report_line(now));
  };
}

Result<int> one_task(const DatasetPlan& plan, const DatasetOptions& options) {
  const std::uint64_t number = *options.task;
  if (number >= plan.tasks()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {}; the plan has tasks 0 to {}", number, plan.tasks() - 1),
                "--task");
  }
  SHG_TRY_ASSIGN(DrawnTask drawn, plan.task(number));
  SHG_TRY_ASSIGN(Task task, make_task(drawn.file, {}));
  SHG_TRY_ASSIGN(const ExportSettings settings,
                 export_settings(options.files, drawn.file.character,
                                 {.formats = usual_formats(drawn.file.character)}));
  task.batch.threads = options.threads;
  task.layers.store = limb_store();
  SHG_TRY(prepare_out(options.folder));
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress();
  SHG_TRY_ASSIGN(const GenerateResult generation,
                 task.actions.empty() ? generate(task, progress) : perform(task, progress));
  end_progress_line();
  return deliver({drawn.file, task, generation, search_info(task, begin)},
                 {.folder = options.folder, .settings = settings, .json = options.json});
}

// Recognises a mistyped subcommand, "shigusa dataset mrge": a word near a command that is no file.
Result<void> check_plan_name(const CLI::App& command, const std::string& plan) {
  std::error_code ignored;
  const std::vector<std::string> names = command_names(command);
  if (is_path(plan) || std::filesystem::exists(plan, ignored) ||
      nearest_name(plan, names).empty()) {
    return {};
  }
  return fail(ErrorCode::not_found, unknown_name("command or plan", plan, names).text, "dataset");
}

Result<DatasetPlan> read_plan(const std::string& path) {
  Result<DatasetPlan> plan = DatasetPlan::read(path);
  if (plan || !read_task(path)) return plan;
  return with_hint(std::move(plan),
                   "; this is a task, which `shigusa reach` makes: a plan has it under 'task' "
                   "(docs/data.md)");
}

Result<int> dataset(const DatasetOptions& options) {
  if (options.plan.empty()) {
    return fail(ErrorCode::invalid_argument,
                "give a plan: shigusa dataset PLAN.json --out FOLDER (docs/data.md)", "dataset");
  }
  SHG_TRY_ASSIGN(const DatasetPlan plan, read_plan(options.plan));
  if (options.check_plan) {
    print_out("{} tasks in {} shards of {}\n", plan.tasks(), plan.shards(), plan.shard_tasks());
    return kDone;
  }
  if (options.folder.empty()) {
    return fail(ErrorCode::invalid_argument,
                "give a folder for the data set, such as --out motions", "dataset");
  }
  if (options.task) return one_task(plan, options);
  SHG_TRY_ASSIGN(const ShardRange shards, options.part.empty()
                                              ? parse_shards(options.shards, plan.shards())
                                              : parse_part(options.part, plan.shards()));
  DatasetSettings settings{.folder = options.folder,
                           .first_shard = shards.first,
                           .last_shard = shards.last,
                           .threads = options.threads,
                           .report = reporter(),
                           .cancel = &interrupted()};
  if (options.simd) {
    SHG_TRY_ASSIGN(settings.simd, simd_named(*options.simd));
  }
  SHG_TRY(prepare_out(options.folder));
  SHG_TRY(keep_plan(plan, options.folder));
  SHG_TRY(write_first_card(plan, options.folder, "shigusa " SHIGUSA_VERSION));
  SHG_TRY_ASSIGN(const DatasetRun run, make_dataset(plan, settings));
  end_progress_line();
  print_out("{} made, {} already there: {}, {} in {}", number_of(run.made, "shard"), run.there,
            number_of(run.tasks, "task"), number_of(run.motions, "motion"),
            time_words(run.seconds));
  if (run.thread_seconds > 0.0) {
    print_out("; {:.1f} motions/s and core, {:.0f} % of it search",
              static_cast<double>(run.motions) / run.thread_seconds,
              100.0 * run.search_seconds / run.thread_seconds);
  }
  print_out("\n");
  if (run.left > 0) {
    note("stopped", fmt::format("{} left; the same command goes on", number_of(run.left, "shard")));
  }
  return run.left > 0 ? kUnreachable : kDone;
}

// Options that select tasks of the plan.
void add_task_choice(CLI::App& c, DatasetOptions& o) {
  const std::string group = "The tasks";
  describe(c.add_option("--shards", o.shards),
           {.group = group,
            .brief = "Shards to make, the last one not among them (default: all)",
            .form = "FIRST:LAST"});
  describe(c.add_option("--part", o.part)->excludes("--shards"),
           {.group = group,
            .brief = "Part K (from 0) of N equal ones, for N programs at once",
            .full = "The shards of part K (from 0) of N equal ones, for N programs at once.",
            .form = "K/N"});
  describe(c.add_option("--task", o.task),
           {.group = group,
            .brief = "This one task alone, as reach does",
            .full = "Makes this one task alone, as reach does, into --out.",
            .form = "N"});
  describe(
      c.add_flag("--check-plan", o.check_plan),
      {.group = group,
       .brief = "Prints how many tasks and shards there are; makes none",
       .full = "Checks the plan, prints how many tasks and shards it has, and makes nothing."});
}

// Options for the output and the work.
void add_making_options(CLI::App& c, DatasetOptions& o) {
  const std::string output = heading(OptionGroup::output);
  describe(c.add_option("--out", o.folder),
           {.group = output,
            .brief = "Folder for the data set; shards that are there stay",
            .form = "FOLDER"});
  add_file_options(c, o.files, {.usual = "those of reach, of --task", .rate = "60", .rare = true});
  describe(c.add_flag("--json", o.json),
           {.group = output,
            .brief = "Of --task: print summary.json instead of the table",
            .rare = true});
  const std::string search = heading(OptionGroup::search);
  describe(c.add_option("--threads", o.threads)->check(whole_number(0, kMaxThreads)),
           {.group = search,
            .brief = "Tasks that are made at once (default 0: one for each core)",
            .form = "N"});
  describe(c.add_option("--simd", o.simd),
           {.group = search,
            .brief = "Instructions of the searches (default: the widest)",
            .form = simd_choices(),
            .rare = true});
}

}  // namespace

void add_dataset(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<DatasetOptions>();
  DatasetOptions& o = *options;
  CLI::App* c = app.add_subcommand(
      "dataset",
      "Make a data set of motions: many tasks, drawn as a plan says\nA plan is a task in which "
      "values may be draws: see docs/data.md.");
  c->group(kMany)->footer(
      "shigusa dataset plan.json --out motions\nshigusa dataset plan.json --check-plan");
  // with a subcommand, such as merge, there is no plan
  describe(c->add_option("plan", o.plan),
           {.brief = "Plan (JSON): a task in which values may be draws", .form = "FILE"});
  add_task_choice(*c, o);
  add_making_options(*c, o);
  add_dataset_merge(*c, exit_code);
  add_dataset_check(*c, exit_code);
  add_dataset_export(*c, exit_code);
  c->callback([options, c, &exit_code] {
    if (!c->get_subcommands().empty()) return;
    const Result<void> named = check_plan_name(*c, options->plan);
    exit_code = exit_code_of(named ? dataset(*options) : tl::unexpected(named.error()));
  });
}

}  // namespace shigusa::app
