// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/report.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "commands.hpp"
#include "files/file.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "table.hpp"
#include "task_input.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ReachOptions {
  TaskInput input;
  std::optional<double> seconds;  // of the search at most
  std::string out = "out";
  FileOptions files;
  bool json = false;
  std::string report;  // file, or empty
};

// Writes the report of the first candidate's cost, with the changes that would help.
Result<void> write_report(const ReachOptions& options, const TaskFile& file, const Task& task,
                          const GenerateResult& generation) {
  const Candidate& best = generation.candidates.front();
  const Ergonomics ergonomics = ergonomics_of(file, file.character.sex);
  SHG_TRY_ASSIGN(const MotionCost cost, candidate_cost(task, best, ergonomics));
  SHG_TRY_ASSIGN(const std::vector<TriedChange> changes,
                 try_changes(task, best, ergonomics, terminal_progress()));
  end_progress_line();
  SHG_TRY_ASSIGN(const std::string html, cost_report({task, best, cost, ergonomics, changes, {}}));
  SHG_TRY(placed("--report", write_file(to_path(options.report), html)));
  if (!options.json) print_out("\n{}\n", options.report);
  return {};
}

Result<int> reach(const ReachOptions& options) {
  SHG_TRY(placed("--formats", parse_formats(options.files.formats.value_or(""))));
  SHG_TRY_ASSIGN(const BatchSettings batch, batch_settings(options.input));
  SHG_TRY_ASSIGN(TaskFile file, task_file_of(options.input));
  const std::filesystem::path folder = folder_of(options.input);
  const std::filesystem::path character = is_complete(file.character)
                                              ? std::filesystem::path{}
                                              : folder / to_path(file.character.source);
  SHG_TRY_ASSIGN(const std::vector<Message> scene_notes, add_scene(file, folder));
  for (const Message& left_out : scene_notes) note("scene", left_out.text);
  SHG_TRY_ASSIGN(Task task, make_task(file, folder));
  SHG_TRY_ASSIGN(
      const ExportSettings settings,
      export_settings(options.files, file.character,
                      {.formats = usual_formats(file.character), .character = character}));
  note_other_axes(task);
  task.batch = batch;
  task.layers.store = limb_store();
  const bool works = !task.actions.empty();
  Result<std::optional<PreparedTask>> prepared = std::nullopt;
  if (!works) prepared = PreparedTask::of(task);
  if (!prepared) return tl::unexpected(in_task(prepared.error(), options.input, "reach"));
  for (const Message& odd : goal_notes(task)) note("goal", odd.text);
  SHG_TRY(prepare_out(to_path(options.out)));
  // a folder that is not there is told before the search
  if (const auto within = to_path(options.report).parent_path(); !within.empty()) {
    SHG_TRY(placed("--report", prepare_folder(within)));
  }
  const auto begin = std::chrono::steady_clock::now();
  Progress progress = terminal_progress();
  if (options.seconds) {
    progress.deadline = begin + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                    std::chrono::duration<double>(*options.seconds));
  }
  const Result<GenerateResult> generation =
      works ? perform(task, progress) : generate(**prepared, progress);
  end_progress_line();
  if (!generation) {
    return tl::unexpected(works ? in_task(generation.error(), options.input, "reach")
                                : generation.error());
  }
  SHG_TRY_ASSIGN(
      const int code,
      deliver({file, task, *generation, search_info(task, begin)},
              {.folder = to_path(options.out), .settings = settings, .json = options.json}));
  if (!options.report.empty()) SHG_TRY(write_report(options, file, task, *generation));
  return code;
}

void add_search_options(CLI::App& c, ReachOptions& o) {
  const std::string group = heading(OptionGroup::search);
  describe(c.add_option("--seconds", o.seconds)->check(number(1e-3, 1e6)),
           {.group = group,
            .brief = "Time limit of the search; the result depends on speed",
            .full = "Time limit of the search in seconds; what is found depends on speed.",
            .form = "SECONDS"});
  add_batch_options(c, o.input);
}

}  // namespace

Result<void> prepare_out(const std::filesystem::path& folder) {
  return with_hint(prepare_folder(folder), "; give another by --out");
}

void add_reach(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ReachOptions>();
  ReachOptions& o = *options;
  CLI::App* c = app.add_subcommand(
      "reach",
      "Find natural motions that bring hands, feet or other joints to their goals\nPlaces are in "
      "metres from the floor between the feet: X to the body's left, Y up, Z ahead.");
  c->group(kMakeMotions)
      ->footer(
          "shigusa reach --goal right_hand=-0.2,1.1,0.4\n"
          "shigusa reach --goal right_hand=-0.3,0.1,0.3 --load right_hand=5 --out low\n"
          "shigusa reach --goal left_hand=0.3,0.9,0.4 --palm left_hand=up --candidates 3\n"
          "shigusa reach task.json --seed 7");
  add_task_input(*c, o.input);
  add_search_options(*c, o);
  describe(c->add_option("--out", o.out), {.group = heading(OptionGroup::output),
                                           .brief = "Folder for the result (default out)",
                                           .form = "FOLDER"});
  add_file_options(*c, o.files, {.usual = usual_formats_help(), .rate = "60"});
  describe(c->add_flag("--json", o.json), {.group = heading(OptionGroup::output),
                                           .brief = "Print summary.json instead of the table"});
  describe(c->add_option("--report", o.report),
           {.group = heading(OptionGroup::output),
            .brief = "Report of what the first motion costs the body (HTML, two pages)",
            .full = "Writes what the first motion costs the body as one HTML file that prints on "
                    "two A4 pages, with the changes of the task that would help most; each of "
                    "these is searched anew.",
            .form = "FILE",
            .rare = true});
  c->callback([options, &exit_code] { exit_code = exit_code_of(reach(*options)); });
}

}  // namespace shigusa::app
