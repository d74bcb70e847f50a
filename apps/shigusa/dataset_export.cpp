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
  std::string format;
  std::string to;
  bool force = false;
  std::optional<std::string> split;
  std::string tasks;  // FIRST:LAST, or empty for all
  std::optional<std::string> verdict;
  std::optional<std::uint64_t> most;
  std::optional<double> fps;
  bool series = false;
  std::optional<std::size_t> least_frames;
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
                              .series = options.series,
                              .least_frames = options.least_frames.value_or(0),
                              .character = options.character,
                              .report = export_reporter(),
                              .cancel = &interrupted()};
  const auto format = value_of<DataFormat>(options.format, "format");
  if (!format) return fail(format.error().code, format.error().message, "--to");
  settings.format = *format;
  SHG_TRY_ASSIGN(settings.tasks, asked_tasks(options));
  if (options.verdict) {
    const auto verdict = value_of<Verdict>(*options.verdict, "verdict");
    if (!verdict) return fail(verdict.error().code, verdict.error().message, "--verdict");
    settings.verdict = *verdict;
  }
  const auto alone = [&](bool given, const char* option, DataFormat of) -> Result<void> {
    if (!given || settings.format == of) return {};
    return fail(ErrorCode::invalid_argument,
                fmt::format("is for --to {} alone; the format is {}", word_of(of), options.format),
                option);
  };
  SHG_TRY(alone(options.series, "--series", DataFormat::csv));
  SHG_TRY(alone(options.least_frames.has_value(), "--least-frames", DataFormat::humanml3d));
  SHG_TRY(alone(!options.character.empty(), "--character", DataFormat::glb));
  return settings;
}

Result<int> dataset_export(const ExportOptions& options) {
  SHG_TRY_ASSIGN(const DataExportSettings settings, settings_of(options));
  SHG_TRY_ASSIGN(const DataExportRun run, export_dataset(settings));
  end_progress_line();
  print_out("{} motions as {} in {}\n", run.motions, options.format, printable(options.to));
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

std::string formats_help() {
  std::string text;
  for (const DataFormatInfo& info : kDataFormats) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : " ", info.word, info.about);
  }
  return text;
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
  CLI::App* c = dataset.add_subcommand("export", "Write a data set's motions for other programs");
  c->group(kOfDataset)
      ->footer(
          "shigusa dataset export motions --to csv --out tables\n"
          "shigusa dataset export motions --to glb --out clips --split test --most 20");
  describe(c->add_option("folder", o.from)->required(),
           {.brief = "Folder of the data set", .form = "FOLDER"});
  add_choice_options(*c, o);
  const std::string output = heading(OptionGroup::output);
  describe(c->add_option("--to", o.format)->required(), {.group = output,
                                                         .brief = "Format of the files",
                                                         .full = formats_help(),
                                                         .form = choices<DataFormat>()});
  describe(c->add_option("--out", o.to)->required(),
           {.group = output, .brief = "Folder for the files, new or empty", .form = "FOLDER"});
  describe(c->add_flag("--force", o.force),
           {.group = output,
            .brief = "Into a folder that is not empty",
            .full = "Into a folder that is not empty: files of the same names are replaced."});
  describe(
      c->add_option("--fps", o.fps),
      {.group = output, .brief = "Frames a second of npz and glb (default 60)", .form = "RATE"});
  describe(c->add_flag("--series", o.series),
           {.group = output, .brief = "Of csv: a file of each motion's series too"});
  describe(c->add_option("--least-frames", o.least_frames)->check(whole_number(1, 10'000)),
           {.group = output,
            .brief = "Of humanml3d: shorter motions hold their last pose",
            .full = "Of humanml3d: motions of fewer frames hold their last pose up to that; its "
                    "usual readers leave out those of fewer than 40.",
            .form = "N"});
  describe(c->add_option("--character", o.character),
           {.group = output,
            .brief = "Of glb: the file of who moves (default: the tasks' own)",
            .form = "FILE"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_export(*options)); });
}

}  // namespace shigusa::app
