// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <shigusa/edit.hpp>
#include <utility>

#include "commands.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

// Heading of options for a result's motion and its change.
constexpr const char* kOfResult = "The motion";

struct EditOptions {
  std::string result;
  int candidate = 1;
  std::vector<std::string> assignments;
  bool mirror = false;                   // left for right
  int action = 1;                        // of a piece of work
  std::string again;                     // actions that are searched anew
  std::string keep;                      // those that stay as they are
  std::optional<std::uint64_t> seed;     // of the search anew
  std::optional<std::string> character;  // the file of the result's person
  std::string out;                       // empty: a new folder beside the result
  FileOptions files;
  bool json = false;
};

// Folder of the result.
fs::path folder_of(const EditOptions& options) {
  const fs::path result = to_path(options.result);
  std::error_code ignored;
  const fs::path folder = fs::is_directory(result, ignored) ? result : result.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// Refuses to overwrite the original.
Result<void> check_folder(const EditOptions& options) {
  std::error_code ignored;
  if (options.out.empty() || !fs::equivalent(to_path(options.out), folder_of(options), ignored))
    return {};
  return fail(ErrorCode::invalid_argument,
              "is the result's own folder, which an edit never writes over; give another",
              "--out " + options.out);
}

// Creates the output folder: the user's, or else a new "edit-1", "edit-2", … or "mirror-1", …
// beside the result, for which `own` is set.
Result<fs::path> make_folder(const EditOptions& options, std::optional<EditFolder>& own) {
  fs::path folder = to_path(options.out);
  if (options.out.empty()) {
    SHG_TRY_ASSIGN(own, EditFolder::make(folder_of(options), options.mirror ? "mirror" : "edit"));
    folder = own->path();
  }
  SHG_TRY(prepare_out(folder));
  return folder;
}

// Finds the file of the result's person: the user's, or else the one named in the result, which may
// be missing. Returns its path.
Result<fs::path> attach_character(const EditOptions& options, StoredResult& stored) {
  CharacterSpec& person = stored.task.character;
  if (options.character) {
    const auto attached = attach_file(person, to_path(*options.character));
    return attached ? Result<fs::path>(to_path(*options.character))
                    : tl::unexpected(attached.error());
  }
  if (!person.landmarks) return fs::path{};
  fs::path file;
  std::string why = "the result does not say where that is";
  if (!stored.character.empty()) {
    file = folder_of(options) / to_path(stored.character);
    const auto attached = attach_file(person, file);
    if (attached) return file;
    why = attached.error().to_string();
  }
  note(person.source,
       "without the file the motion leaves on the measured body's own skeleton, and not as " +
           format_words([](const FormatInfo& info) { return info.needs != NeededFile::none; },
                        "or") +
           ": give it by --character FILE (" + why + ")");
  return file;
}

// Formats of the result, except those that need the person's missing file.
ExportSettings usual_settings(const StoredResult& stored, int candidate, const fs::path& file) {
  ExportSettings usual{.formats = {}, .character = file};
  // formats of another usual rate keep theirs
  if (stored.rate != kUsualRate) usual.rate = stored.rate;
  const auto index = static_cast<std::size_t>(candidate) - 1;
  if (index < stored.files.size()) {
    for (const auto& [name, written] : stored.files[index]) {
      const auto format = parse_formats(name);
      if (!format || !check_formats(stored.task.character, *format)) continue;
      usual.formats.push_back(format->front());
    }
  }
  if (usual.formats.empty()) usual.formats = usual_formats(stored.task.character);
  return usual;
}

// Numbers of actions, "1,2".
Result<std::vector<int>> actions_of(const char* option, const std::string& text, int most) {
  std::vector<int> actions;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    int action = 0;
    const char* const last = text.data() + end;
    const auto [at, error] = std::from_chars(text.data() + begin, last, action);
    if (error != std::errc{} || at != last || action < 1 || action > most) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("'{}' is no list of the actions 1 to {}, such as 1,2",
                              text.substr(0, 80), most),
                  option);
    }
    actions.push_back(action);
    begin = end + 1;
  }
  return actions;
}

Result<WorkEdit> work_edit(const EditOptions& options, const Task& task) {
  WorkEdit edit{.action = options.action,
                .assignments = options.assignments,
                .again = {},
                .keep = {},
                .seed = options.seed};
  const int most = static_cast<int>(task.actions.size());
  const bool given = !options.again.empty() || !options.keep.empty() || options.action != 1;
  if (most == 0 && given) {
    return fail(ErrorCode::invalid_argument, "the result's task has no actions",
                "--action, --again, --keep");
  }
  SHG_TRY_ASSIGN(edit.again, actions_of("--again", options.again, most));
  SHG_TRY_ASSIGN(edit.keep, actions_of("--keep", options.keep, most));
  return edit;
}

Result<int> edit(const EditOptions& options) {
  SHG_TRY(placed("--formats", parse_formats(options.files.formats.value_or(""))));
  SHG_TRY(check_folder(options));
  const bool is_clip = file_ending(options.result) != ".json" && format_of_file(options.result);
  SHG_TRY_ASSIGN(StoredResult stored,
                 with_hint(read_result(to_path(options.result), options.candidate),
                           is_clip ? "; give the folder that it is in, as a result" : ""));
  if (options.mirror) {
    SHG_TRY(mirror_result(stored));
  }
  SHG_TRY_ASSIGN(const Task task, make_task(stored.task, {}));
  SHG_TRY_ASSIGN(const WorkEdit work, work_edit(options, task));
  SHG_TRY_ASSIGN(const fs::path file, attach_character(options, stored));
  SHG_TRY_ASSIGN(const ExportSettings settings,
                 export_settings(options.files, stored.task.character,
                                 usual_settings(stored, options.candidate, file)));
  const auto begin = std::chrono::steady_clock::now();
  const Result<GenerateResult> generation = [&]() -> Result<GenerateResult> {
    if (!task.actions.empty()) return replay_work(task, stored, options.candidate, work);
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    return replay(player, stored, options.candidate, options.assignments);
  }();
  if (!generation) {
    const Error& error = generation.error();
    const auto& given = options.assignments;
    const bool by_call = std::find(given.begin(), given.end(), error.place) != given.end();
    const std::string place = error.place.empty() ? options.result : error.place;
    const std::string hint = by_call ? comma_hint(place.substr(place.find('=') + 1)) : "";
    return fail(error.code, error.message.text + hint, (by_call ? "--set " : "") + place);
  }
  if (!options.mirror && options.assignments.empty() && work.again.empty() && work.keep.empty() &&
      options.files == FileOptions{}) {
    note("edit",
         "nothing was changed: --set NAME=VALUE changes a parameter, such as squat_deg=60; the "
         "result's " +
             std::string(kSummaryName) + " lists them");
  }
  RunInfo info = replay_info(options.mirror ? "mirror" : "edit", begin);
  std::optional<EditFolder> own;
  SHG_TRY_ASSIGN(const fs::path folder, make_folder(options, own));
  return deliver({stored.task, task, *generation, std::move(info)},
                 {.folder = folder, .settings = settings, .json = options.json});
}

// Options shared by edit and mirror.
void add_result_options(CLI::App* c, EditOptions& o) {
  const std::string output = heading(OptionGroup::output);
  describe(c->add_option("result", o.result)->required(),
           {.brief = "Folder of a result, or its summary.json", .form = "FILE|FOLDER"});
  describe(c->add_option("--candidate", o.candidate),
           {.group = kOfResult, .brief = "Rank of the candidate (default 1)", .form = "RANK"});
  describe(c->add_option("--character", o.character),
           {.group = kOfResult,
            .brief = "The person's file (default: where the result says it is)",
            .full = "The person's file, which " + format_words(needs_file, "or") +
                    " and a BVH of the file's own nodes need; when not given, it is where the "
                    "result says it is.",
            .form = "FILE"});
  describe(c->add_option("--out", o.out),
           {.group = output,
            .brief = "Folder for the new result (default: a new one beside)",
            .full = "Folder for the new result; when not given, a new one in the old one's, named "
                    "as the command: edit-1, mirror-1.",
            .form = "FOLDER"});
  add_file_options(*c, o.files, {.usual = "those of the result", .rate = "the result's"});
  describe(c->add_flag("--json", o.json),
           {.group = output, .brief = "Print summary.json instead of the table"});
}

// Options for results of tasks with actions.
void add_work_options(CLI::App* c, EditOptions& o) {
  describe(c->add_option("--action", o.action)->check(whole_number(1, kActionsMax)),
           {.group = kOfResult,
            .brief = "Of several actions the one that --set changes (default 1)",
            .full = "Of a task with actions the one whose motion --set changes; those behind it "
                    "go on from where it then ends. The first when not given.",
            .form = "N"});
  describe(c->add_option("--again", o.again),
           {.group = kOfResult,
            .brief = "Actions that are searched anew, such as 3",
            .full = "Actions that are searched anew, such as 3 or 2,3, for several candidates; "
                    "with another --seed they differ from the result's.",
            .form = "N,…"});
  describe(c->add_option("--keep", o.keep),
           {.group = kOfResult,
            .brief = "Actions that stay; all others are searched anew",
            .full = "Actions that stay as they are, such as 1,2; without --again all others are "
                    "searched anew.",
            .form = "N,…"});
  describe(c->add_option("--seed", o.seed),
           {.group = kOfResult, .brief = "Seed of the search anew", .form = "N", .rare = true});
}

}  // namespace

void add_edit(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<EditOptions>();
  CLI::App* c = app.add_subcommand("edit", "Change a candidate's parameters; no search");
  c->group(kMakeMotions)
      ->footer(
          "shigusa edit out --set squat_deg=20\n"
          "shigusa edit out --candidate 2 --set right_swivel_deg=20 --set left_knee.weight=3");
  describe(c->add_option("--set", options->assignments)->allow_extra_args(false),
           {.group = kOfResult,
            .brief = "A parameter's value: squat_deg=20, right_elbow.locked=true",
            .full = "NAME.weight=NUMBER or NAME.locked=true|false, NAME a joint or a freedom such "
                    "as right_shoulder.flexion, which the result's summary.json lists; or of the "
                    "posture squat_deg=NUMBER and so on. Of the preset layers "
                    "also legs.contraction=NUMBER (0 to 15), and right_arm.NAME for the arm's own; "
                    "of human right_arm.swivel_deg=NUMBER and left_elbow.final_deg=NUMBER. "
                    "Repeatable.",
            .form = "NAME=VALUE"});
  add_work_options(c, *options);
  add_result_options(c, *options);
  c->callback([options, &exit_code] { exit_code = exit_code_of(edit(*options)); });
}

void add_mirror(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<EditOptions>();
  CLI::App* c = app.add_subcommand(
      "mirror", "A candidate for the other hand: left for right, by the same person");
  c->group(kMakeMotions)->footer("shigusa mirror out --candidate 2");
  options->mirror = true;
  add_result_options(c, *options);
  c->callback([options, &exit_code] { exit_code = exit_code_of(edit(*options)); });
}

}  // namespace shigusa::app
