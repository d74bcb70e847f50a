// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/error.hpp>

#include "commands.hpp"
#include "files/file.hpp"
#include "files/path.hpp"
#include "manual.hpp"
#include "next_step.hpp"
#include "usage.hpp"

namespace shigusa {
namespace app {

// Formats of the manual, and the shells with completion.
enum class ManualForm { text, man, markdown };
enum class Shell { bash, zsh, fish };

}  // namespace app

template <>
inline constexpr std::array kEnumWords<app::ManualForm>{
    EnumWord{app::ManualForm::text, "text"},
    EnumWord{app::ManualForm::man, "man"},
    EnumWord{app::ManualForm::markdown, "markdown"},
};
template <>
inline constexpr std::array kEnumWords<app::Shell>{
    EnumWord{app::Shell::bash, "bash"},
    EnumWord{app::Shell::zsh, "zsh"},
    EnumWord{app::Shell::fish, "fish"},
};

namespace app {
namespace {

struct ManualOptions {
  std::vector<std::string> command;
  std::string form = "text";
  std::string out;  // folder for all man pages, or empty
};

// Writes the pages of the program and of each of its commands: "shigusa.1", "shigusa-reach.1", ….
Result<int> write_pages(const CommandManual& program, const std::string& folder) {
  SHG_TRY(prepare_out(to_path(folder)));
  const std::filesystem::path into = to_path(folder);
  SHG_TRY(write_file(into / (program.name() + ".1"), manual_page(program)));
  for (const CommandManual& command : program.commands) {
    const std::string name = program.name() + "-" + command.name() + ".1";
    SHG_TRY(write_file(into / name, manual_page(command)));
  }
  return kDone;
}

Result<int> manual(const CLI::App& app, const ManualOptions& options) {
  const CommandManual program = read_manual(app);
  const CommandManual* command = find_command(program, options.command);
  if (command == nullptr) {
    std::vector<std::string> known;
    for (const CommandManual* one : all_commands(program)) {
      if (one != &program) known.push_back(one->path.substr(program.path.size() + 1));
    }
    const std::string asked = fmt::format("{}", fmt::join(options.command, " "));
    return fail(ErrorCode::not_found, unknown_name("command", asked, known), "manual");
  }
  SHG_TRY_ASSIGN(const ManualForm form, placed("--as", value_of<ManualForm>(options.form, "form")));
  if (!options.out.empty()) {
    if (form == ManualForm::man && command == &program) return write_pages(program, options.out);
    return fail(ErrorCode::invalid_argument,
                "is for the man pages of all commands: shigusa manual --as man --out FOLDER",
                "--out");
  }
  if (form == ManualForm::text) write_out(manual_text(*command));
  if (form == ManualForm::man) write_out(manual_page(*command));
  if (form == ManualForm::markdown) write_out(manual_markdown(*command));
  return kDone;
}

Result<int> completion(const CLI::App& app, const std::string& name) {
  const CommandManual program = read_manual(app);
  SHG_TRY_ASSIGN(const Shell shell, placed("completion", value_of<Shell>(name, "shell")));
  if (shell == Shell::bash) write_out(bash_completion(program));
  if (shell == Shell::zsh) write_out(zsh_completion(program));
  if (shell == Shell::fish) write_out(fish_completion(program));
  return kDone;
}

}  // namespace

void add_manual(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ManualOptions>();
  ManualOptions& o = *options;
  CLI::App* c = app.add_subcommand("manual", "Print the manual of the program or of a command");
  c->group(kMore)->footer("shigusa manual reach\nshigusa manual --as man --out man1");
  describe(c->add_option("command", o.command),
           {.brief = "Such as reach, or dataset merge (default: the program)",
            .form = fmt::format("{}", fmt::join(command_names(app), "|"))});
  describe(c->add_option("--as", o.form),
           {.group = heading(OptionGroup::output),
            .brief = "Its form (default text)",
            .full = "text, when not given; man, a page for man(1); or markdown, of the program all "
                    "commands on one page.",
            .form = choices<ManualForm>()});
  describe(c->add_option("--out", o.out),
           {.group = heading(OptionGroup::output),
            .brief = "Folder for the man pages of all commands",
            .full = "With --as man, and no command: folder for the page of the program and one of "
                    "each command, shigusa.1, shigusa-reach.1 and so on.",
            .form = "FOLDER"});
  c->callback([options, &app, &exit_code] { exit_code = exit_code_of(manual(app, *options)); });
}

void add_completion(CLI::App& app, int& exit_code) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* c = app.add_subcommand(
      "completion",
      "Print what a shell completes calls by\nSource it, as `. <(shigusa completion bash)` in "
      "~/.bashrc; an installed shigusa has it in the shells' own folders.");
  c->group(kMore)->footer("shigusa completion bash");
  describe(c->add_option("shell", *shell)->required(),
           {.brief = "bash, zsh or fish", .form = choices<Shell>()});
  c->callback([shell, &app, &exit_code] { exit_code = exit_code_of(completion(app, *shell)); });
}

}  // namespace app
}  // namespace shigusa
