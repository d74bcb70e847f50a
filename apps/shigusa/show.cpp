// SPDX-License-Identifier: MIT
#include "show.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <shigusa/draw.hpp>
#include <shigusa/edit.hpp>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "files/file.hpp"
#include "files/path.hpp"
#include "picture.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ShowOptions {
  std::vector<std::string> results;
  std::vector<std::string> titles;
  std::string heading;
  std::string out = "index.html";
  std::vector<std::string> pictures;
};

// A result with its motions, recomputed from its file.
struct PlayedResult {
  Task task;
  GenerateResult generation;
};

Result<PlayedResult> played(const std::string& path) {
  SHG_TRY_ASSIGN(StoredResult stored, read_result(to_path(path)));
  SHG_TRY_ASSIGN(Task task, make_task(stored.task, {}));
  Result<GenerateResult> generation = replay_all(task, stored, terminal_progress());
  end_progress_line();
  if (!generation) return fail(generation.error().code, generation.error().to_string(), path);
  return PlayedResult{std::move(task), std::move(*generation)};
}

// Refuses a call that would fail later, before the motions are computed.
Result<void> check_call(const ShowOptions& options) {
  for (const std::string& picture : options.pictures) {
    SHG_TRY(picture_format(to_path(picture)));
  }
  if (options.titles.size() <= options.results.size()) return {};
  return fail(ErrorCode::invalid_argument,
              fmt::format("is given {} times; allowed is once for each result, and there {} {}",
                          options.titles.size(), options.results.size() == 1 ? "is" : "are",
                          options.results.size()),
              "--title");
}

Result<int> show(const ShowOptions& options) {
  SHG_TRY(check_call(options));
  std::vector<PlayedResult> results;
  for (const std::string& path : options.results) {
    SHG_TRY_ASSIGN(PlayedResult result, played(path));
    results.push_back(std::move(result));
  }
  std::vector<ShownResult> shown;
  for (std::size_t k = 0; k < results.size(); ++k) {
    shown.push_back({results[k].task, results[k].generation,
                     k < options.titles.size() ? options.titles[k] : std::string()});
  }
  std::vector<std::pair<std::string, std::string>> files;  // all are made before one is written
  SHG_TRY_ASSIGN(std::string page, motion_page(shown, options.heading));
  files.emplace_back(options.out, std::move(page));
  for (const std::string& picture : options.pictures) {
    SHG_TRY_ASSIGN(const FileFormat format, picture_format(to_path(picture)));
    SHG_TRY_ASSIGN(const std::string svg, result_strips(shown));
    SHG_TRY_ASSIGN(std::string drawn, picture_from(svg, format));
    files.emplace_back(picture, std::move(drawn));
  }
  for (const auto& [path, bytes] : files) {
    SHG_TRY(write_file(to_path(path), bytes));
    print_out("{}\n", printable(path));
  }
  return kDone;
}

}  // namespace

void add_show(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ShowOptions>();
  ShowOptions& o = *options;
  CLI::App* c = app.add_subcommand("show", "Show results as one page of moving figures");
  c->group(kLook)->footer(
      "shigusa show out --out out/index.html\n"
      "shigusa show out low --title 'In front' --title 'Low' --picture both.svg");
  describe(c->add_option("results", o.results)->required(),
           {.brief = "Folders of results, or their summary.json", .form = "FILE|FOLDER"});
  const std::string output = heading(OptionGroup::output);
  describe(c->add_option("--out", o.out),
           {.group = output,
            .brief = fmt::format("The page, which needs no other file (default {})", o.out),
            .form = "FILE"});
  describe(c->add_option("--title", o.titles)->allow_extra_args(false),
           {.group = output,
            .brief = "Of a result, in their order (default: the goal in words)",
            .full = "The title of a result, the first for the first one and so on; when not given, "
                    "the goal in words. Repeatable.",
            .form = "TEXT"});
  describe(c->add_option("--heading", o.heading),
           {.group = output,
            .brief = "Of the page (default: Motions by shigusa)",
            .form = "TEXT",
            .rare = true});
  describe(c->add_option("--picture", o.pictures)->allow_extra_args(false),
           {.group = output,
            .brief = "The first candidates' strips: .svg, .png or .pdf",
            .full = "A picture of the first candidate of each result, under each other: a file "
                    "that ends in .svg, .png or .pdf. Repeatable.",
            .form = "FILE"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(show(*options)); });
}

}  // namespace shigusa::app
