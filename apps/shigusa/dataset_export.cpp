// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <shigusa/dataset_export.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
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
  std::string character;
};

// "FIRST:LAST", either of which may be missing; nothing where it is no such range.
std::optional<TaskRange> parse_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return std::nullopt;
  TaskRange range{0, kDatasetMaxTasks};
  const auto read = [](std::string_view digits, std::uint64_t& number) {
    if (digits.empty()) return true;
    const char* const end = digits.data() + digits.size();
    const auto [stop, code] = std::from_chars(digits.data(), end, number);
    return code == std::errc{} && stop == end;
  };
  const std::string_view view = text;
  if (!read(view.substr(0, colon), range.first) || !read(view.substr(colon + 1), range.last)) {
    return std::nullopt;
  }
  return range;
}

// The range of tasks that is asked for; to the plan's last where no end is given.
Result<std::optional<TaskRange>> asked_tasks(const ExportOptions& options) {
  if (options.tasks.empty()) return std::optional<TaskRange>{};
  std::optional<TaskRange> range = parse_range(options.tasks);
  if (!range) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is FIRST:LAST, such as 0:100, the last one not among "
                            "them",
                            options.tasks.substr(0, 80)),
                "--tasks");
  }
  if (options.tasks.ends_with(':')) {
    SHG_TRY_ASSIGN(const DatasetPlan plan,
                   DatasetPlan::read(std::filesystem::path(options.from) / kPlanName));
    range->last = plan.tasks();
  }
  return range;
}

std::function<void(const DataExportReport&)> reporter() {
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
                              .character = options.character,
                              .report = reporter(),
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
         fmt::format("{} motions, as the character moves by other freedoms than the data set's "
                     "person",
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

}  // namespace

void add_dataset_export(CLI::App& dataset, int& exit_code) {
  const auto options = std::make_shared<ExportOptions>();
  ExportOptions& o = *options;
  CLI::App* c = dataset.add_subcommand("export", "Write a data set's motions for other programs");
  c->add_option("folder", o.from, "Folder of the data set")->required();
  c->add_option("--to", o.format, formats_help())
      ->required()
      ->type_name(fmt::format("{}", fmt::join(all_words<DataFormat>(), "|")));
  c->add_option("--out", o.to, "Folder for the files, new or empty")->required();
  c->add_flag("--force", o.force,
              "Into a folder that is not empty: files of the same names are replaced");
  c->add_option("--split", o.split, "Only people of this part: train, validation or test");
  c->add_option("--tasks", o.tasks, "FIRST:LAST of the tasks, the last one not among them");
  c->add_option("--verdict", o.verdict,
                "Only motions of this verdict or a better one: possible, strains or impossible");
  c->add_option("--most", o.most, "No more motions than these")
      ->check(whole_number(1, std::uint64_t{1} << 40));
  c->add_option("--fps", o.fps, "Frames a second of npz and glb (default: 60)");
  c->add_flag("--series", o.series, "Of csv: a file of each motion's series too");
  c->add_option("--character", o.character,
                "Of glb: the file of the one who moves (default: the tasks' own)");
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_export(*options)); });
}

}  // namespace shigusa::app
