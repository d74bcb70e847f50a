// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/report.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "commands.hpp"
#include "files/file.hpp"
#include "next_step.hpp"
#include "table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ReachOptions {
  std::string task;  // file, or empty
  std::optional<std::string> character;
  CharacterOptions person;
  TaskOptions asked;
  std::optional<double> seconds;  // of the search at most
  int threads = 0;                // 0: one for each core
  std::optional<std::string> simd;
  std::string out = "out";
  FileOptions files;
  bool json = false;
  std::string report;  // file, or empty
};

// Options for the computation that do not change results.
Result<BatchSettings> batch_settings(const ReachOptions& options) {
  BatchSettings batch;
  batch.threads = options.threads;
  if (options.simd) {
    SHG_TRY_ASSIGN(batch.simd, simd_named(*options.simd));
  }
  return batch;
}

Result<void> apply_options(const ReachOptions& options, TaskFile& file) {
  if (options.character) {
    file.character = {};
    file.character.source = *options.character;
  }
  SHG_TRY(apply_character_options(options.person, file.character));
  auto applied = apply_task_options(options.asked, file);
  if (!applied || !options.asked.has("--layer-reading") || traits_of(file.preset).layers) {
    return applied;
  }
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("is of the presets layers and human, and the preset is {}", word_of(file.preset)),
      "--layer-reading");
}

// Places of goals in the task file, for errors about them.
Error in_task(const Error& error, const ReachOptions& options) {
  if (options.task.empty() && error.message.key == "no_goal") {
    return {error.code,
            fmt::format("no goal: give one, such as --goal {}, or a task file (JSON)",
                        option_example("--goal")),
            "reach"};
  }
  if (options.task.empty() || options.asked.has("--goal")) return error;
  return {error.code, error.to_string(), std::filesystem::path(options.task).filename().string()};
}

// Adds a hint to an error about a task file that was meant as a goal or a character.
Error about_task(const Error& error, const std::string& task) {
  std::error_code ignored;
  const std::string& text = error.message.text;
  std::string hint;
  if (!std::filesystem::exists(task, ignored)) {
    if (task.find('=') != task.npos) {
      hint = "; a goal is given by --goal " + task;
    } else if (task.find_first_not_of("0123456789.,-+") == task.npos) {
      hint = "; a goal is EFFECTOR=X,Y,Z: --goal right_hand=" + task;
    } else if (parse_formats(task)) {
      hint = "; formats are joined by commas, as in --formats bvh,glb";
    }
  } else if (std::filesystem::is_directory(task, ignored)) {
    hint = "; a task file (JSON) is expected";
  } else if (error.code == ErrorCode::parse && format_of_file(task)) {
    hint = "; a task file is JSON, and a character is given by --character " + task;
  } else if (text.starts_with("not JSON") || text == "the file is empty") {
    hint = "; `shigusa schema` prints what a task file holds";
  }
  return {error.code, text + hint, error.place};
}

Result<TaskFile> file_of(const ReachOptions& options) {
  if (options.task.empty()) return TaskFile{};
  Result<TaskFile> file = read_task(options.task);
  if (!file) return tl::unexpected(about_task(file.error(), options.task));
  return file;
}

// Distance (m) beyond any reach: the numbers are in another unit.
constexpr double kFarAway = 5.0;  // m

// Hint for a goal that is far away, converted from centimetres or millimetres.
void note_other_units(const TaskFile& file) {
  for (const Goal& goal : file.goals) {
    const Vec3d& at = goal.position;
    const double far = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    if (!(far > kFarAway) || !std::isfinite(far)) continue;
    const double unit = far <= 100.0 * kFarAway ? 100.0 : 1000.0;
    note("goal of " + goal.effector,
         fmt::format("{:g},{:g},{:g} are metres, a place {:.0f} m away; if {} are meant, give "
                     "{:g},{:g},{:g}",
                     at.x, at.y, at.z, norm(at), unit == 100.0 ? "centimetres" : "millimetres",
                     at.x / unit, at.y / unit, at.z / unit));
  }
}

// Whether a person of that height could reach a place, so that it is plausible.
bool looks_near(const Vec3d& place, double stature) {
  return place.y >= 0.0 && place.y <= 1.3 * stature &&
         norm(Vec3d{place.x, 0.0, place.z}) <= 0.75 * stature;
}

// Hint for an unreachable goal, converted from the axes of robots: x ahead, y to the left, z up.
void note_other_axes(const Task& task) {
  for (const Goal& goal : task.goals) {
    const Vec3d& at = goal.position;
    const Vec3d other{at.y, at.z, at.x};
    if (looks_near(at, task.body.stature()) || !looks_near(other, task.body.stature())) continue;
    note("goal of " + goal.effector,
         fmt::format("X is to the left, Y up and Z ahead; if x ahead, y left, z up are meant, give "
                     "{}={:g},{:g},{:g}",
                     goal.effector, other.x, other.y, other.z));
  }
}

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
  SHG_TRY(placed("--report", write_file(options.report, html)));
  if (!options.json) print_out("\n{}\n", options.report);
  return {};
}

Result<int> reach(const ReachOptions& options) {
  SHG_TRY(placed("--formats", parse_formats(options.files.formats.value_or(""))));
  SHG_TRY_ASSIGN(const BatchSettings batch, batch_settings(options));
  SHG_TRY_ASSIGN(TaskFile file, file_of(options));
  SHG_TRY(apply_options(options, file));
  // files on the command line are relative to the working directory
  if (options.asked.has("--scene")) file.scene = std::filesystem::absolute(file.scene).string();
  note_other_units(file);
  const auto folder = options.character || options.task.empty()
                          ? std::filesystem::path{}
                          : std::filesystem::path(options.task).parent_path();
  const std::filesystem::path character =
      is_complete(file.character) ? std::filesystem::path{} : folder / file.character.source;
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
  if (!prepared) return tl::unexpected(in_task(prepared.error(), options));
  for (const Message& odd : goal_notes(task)) note("goal", odd.text);
  SHG_TRY(prepare_out(options.out));
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
    return tl::unexpected(works ? in_task(generation.error(), options) : generation.error());
  }
  SHG_TRY_ASSIGN(const int code,
                 deliver({file, task, *generation, search_info(task, begin)},
                         {.folder = options.out, .settings = settings, .json = options.json}));
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
  describe(c.add_option("--threads", o.threads)->check(whole_number(0, kMaxThreads)),
           {.group = group,
            .brief = "Threads of the search (default 0: one for each core)",
            .full = "Threads of the search; 0, when not given, is one for each core. Results do "
                    "not depend on it.",
            .form = "N",
            .rare = true});
  describe(c.add_option("--simd", o.simd),
           {.group = group,
            .brief = "Instructions of the search (default: the widest)",
            .full = "Instructions of the search; the widest of the machine when not given. Results "
                    "do not depend on it.",
            .form = simd_choices(),
            .rare = true});
}

}  // namespace

Result<void> prepare_out(const std::filesystem::path& folder) {
  return with_hint(prepare_folder(folder), "; give another by --out");
}

Result<SimdSet> simd_named(const std::string& name) {
  std::vector<std::string> names;
  for (const SimdSet set : usable_simd_sets()) {
    if (name == simd_name(set)) return set;
    names.emplace_back(simd_name(set));
  }
  return fail(ErrorCode::invalid_argument,
              unknown_name("SIMD set, or one that this machine lacks,", name, names), "--simd");
}

std::string simd_choices() {
  // all SIMD sets, so that the help text is the same on every machine
  std::vector<std::string_view> names;
  for (const SimdSet set : {SimdSet::scalar, SimdSet::lanes_4, SimdSet::avx2, SimdSet::avx512}) {
    names.push_back(simd_name(set));
  }
  return fmt::format("{}", fmt::join(names, "|"));
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
  describe(c->add_option("task", o.task),
           {.brief = "Task file (JSON); options take precedence over it", .form = "FILE"});
  describe(c->add_option("--character", o.character),
           {.group = heading(OptionGroup::body),
            .brief = fmt::format("Who moves (default {}); a file is a person's or a robot's",
                                 kBuiltInCharacters.front()),
            .full = "Who moves: " + character_help(),
            .form = character_form()});
  add_character_options(*c, o.person);
  add_task_options(*c, o.asked);
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
