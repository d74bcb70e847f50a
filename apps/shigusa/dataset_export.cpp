// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/dataset_export.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "number_range.hpp"
#include "paced_line.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ExportOptions {
  std::string from;
  std::string to;
  bool force = false;
  std::optional<std::string> split;
  std::string tasks;  // FIRST:LAST, or empty for all
  std::optional<std::string> verdict;
  std::optional<std::uint64_t> most;
  double fps = kUsualRate;
  std::string character;
};

// Requested range of tasks; up to the plan's last if no end is given.
Result<std::optional<TaskRange>> asked_tasks(const ExportOptions& options) {
  if (options.tasks.empty()) return std::optional<TaskRange>{};
  const std::optional<NumberRange> asked = parse_range(options.tasks);
  if (!asked) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is FIRST:LAST, such as 0:100, the last one not among "
                            "them",
                            options.tasks.substr(0, 80)),
                "--tasks");
  }
  TaskRange range{asked->first.value_or(0), asked->last.value_or(0)};
  if (!asked->last) {
    SHG_TRY_ASSIGN(const DatasetPlan plan,
                   DatasetPlan::read(std::filesystem::path(options.from) / kPlanName));
    range.last = plan.tasks();
  }
  return std::optional(range);
}

std::function<void(const DataExportReport&)> export_reporter() {
  return [line = PacedLine()](const DataExportReport& now) mutable {
    if (!line.is_due()) return;
    line.show(
        fmt::format("{} motions written; {} of {} tasks seen", now.motions, now.tasks, now.of));
  };
}

Result<DataExportSettings> settings_of(const ExportOptions& options) {
  DataExportSettings settings{.from = options.from,
                              .to = options.to,
                              .force = options.force,
                              .split = options.split,
                              .most = options.most,
                              .rate = options.fps,
                              .character = options.character,
                              .report = export_reporter(),
                              .cancel = &interrupted()};
  SHG_TRY_ASSIGN(settings.tasks, asked_tasks(options));
  if (options.verdict) {
    const auto verdict = value_of<Verdict>(*options.verdict, "verdict");
    if (!verdict) return fail(verdict.error().code, verdict.error().message, "--verdict");
    settings.verdict = *verdict;
  }
  return settings;
}

Result<int> dataset_export(const ExportOptions& options) {
  SHG_TRY_ASSIGN(const DataExportSettings settings, settings_of(options));
  SHG_TRY_ASSIGN(const DataExportRun run, export_dataset(settings));
  end_progress_line();
  print_out("{} motions as GLB in {}\n", run.motions, printable(options.to));
  if (run.left_out > 0) {
    note("left out", fmt::format("{} motions; the first: {}", run.left_out, run.why));
  }
  if (run.searched > 0) {
    note("searched anew",
         fmt::format("{} motions: pieces of work, or as the character moves by other freedoms "
                     "than the data set's person",
                     run.searched));
  }
  if (run.missed > 0) {
    note("out of reach",
         fmt::format("{} motions end as near to their goals as the character gets", run.missed));
  }
  if (run.stopped) note("stopped", "what is written so far is whole");
  return run.stopped ? kUnreachable : kDone;
}

// Options that select motions.
void add_choice_options(CLI::App& c, ExportOptions& o) {
  const std::string group = "The motions";
  describe(c.add_option("--split", o.split), {.group = group,
                                              .brief = "Only people of this part of the data set",
                                              .form = "train|validation|test"});
  describe(c.add_option("--tasks", o.tasks),
           {.group = group,
            .brief = "Only these tasks, the last one not among them",
            .form = "FIRST:LAST"});
  describe(c.add_option("--verdict", o.verdict),
           {.group = group,
            .brief = "Only motions of this verdict or a better one",
            .form = choices<Verdict>()});
  describe(c.add_option("--most", o.most)->check(whole_number(1, std::uint64_t{1} << 40)),
           {.group = group, .brief = "No more motions than these", .form = "N"});
}

}  // namespace

void add_dataset_export(CLI::App& dataset, int& exit_code) {
  const auto options = std::make_shared<ExportOptions>();
  ExportOptions& o = *options;
  CLI::App* c = dataset.add_subcommand(
      "export",
      "Write a data set's motions as GLB, on any character\nNumPy archives, HumanML3D's folders, "
      "tables and plots come by the Python package: shigusa.dataset.");
  c->group(kOfDataset)
      ->footer(
          "shigusa dataset export motions --out clips --split test --most 20\n"
          "shigusa dataset export motions --character hero.glb --out clips");
  describe(c->add_option("folder", o.from)->required(),
           {.brief = "Folder of the data set", .form = "FOLDER"});
  add_choice_options(*c, o);
  const std::string output = heading(OptionGroup::output);
  describe(c->add_option("--out", o.to)->required(),
           {.group = output, .brief = "Folder for the files, new or empty", .form = "FOLDER"});
  describe(c->add_flag("--force", o.force),
           {.group = output,
            .brief = "Into a folder that is not empty",
            .full = "Into a folder that is not empty: files of the same names are replaced."});
  describe(c->add_option("--fps", o.fps),
           {.group = output, .brief = "Frames a second (default 60)", .form = "RATE"});
  describe(c->add_option("--character", o.character),
           {.group = output,
            .brief = "The file of who moves (default: the tasks' own)",
            .form = "FILE"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_export(*options)); });
}

}  // namespace shigusa::app
