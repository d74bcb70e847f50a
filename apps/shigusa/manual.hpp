// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa::app {

// One option or argument in help, manual and completion.
struct OptionManual {
  std::string name{};   // "--goal"; of an argument "TASK"
  std::string form{};   // of its value, as in OptionHelp; empty for a flag
  std::string brief{};  // its line
  std::string full{};   // full description; the line if that is complete
  bool argument = false;
  bool required = false;
  bool repeatable = false;
  bool rare = false;
};

// The options under one heading, in the order of their command.
struct OptionGroupManual {
  std::string heading;  // empty of arguments
  std::vector<OptionManual> options;
};

// Whether these are the help options common to all commands.
[[nodiscard]] inline bool is_of_help(const OptionGroupManual& group) {
  return group.heading == "Help";
}

// A command, or the whole program, with its subcommands.
struct CommandManual {
  std::string path;   // "shigusa dataset merge"
  std::string group;  // its heading: "Many"
  std::string brief;
  std::string full;  // further sentences, or nothing
  std::vector<std::string> examples;
  std::vector<OptionGroupManual> groups;
  std::vector<CommandManual> commands;

  // Last word of its name: "merge".
  [[nodiscard]] std::string name() const { return path.substr(path.rfind(' ') + 1); }
};

// A word with its explanation.
struct Term {
  std::string_view name;
  std::string_view says;
};
// Exit codes of the program.
inline constexpr std::array kExitCodes{
    Term{"0", "All is done."},
    Term{"1", "A fault of the program."},
    Term{"2",
         "The call or a file is wrong, or an output cannot be written: a message on the standard "
         "error says what, where and what is allowed. Of dataset check: it found problems."},
    Term{"3",
         "A goal is out of reach, or no motion that meets it and that the body could make was "
         "found: what is nearest is "
         "written. Of dataset and dataset export: stopped by Ctrl-C, what is written is whole."},
    Term{"130", "Ended by a second Ctrl-C; the first one asks for the best so far."},
};
// Environment variables that the program reads.
inline constexpr std::array kEnvironment{
    Term{
        "SHIGUSA_CACHE",
        "Folder, by its absolute path, in which limb libraries of the presets layers and human are "
        "kept between runs. When not set, shigusa in XDG_CACHE_HOME, or else .cache/shigusa in "
        "HOME."},
    Term{"XDG_CACHE_HOME", "See SHIGUSA_CACHE."},
    Term{"HOME", "See SHIGUSA_CACHE."},
};

// Reads the program's commands and options, as described by describe().
[[nodiscard]] CommandManual read_manual(const CLI::App& app);
// Subcommand by its words: {"dataset", "merge"}; null if there is none.
[[nodiscard]] const CommandManual* find_command(const CommandManual& from,
                                                const std::vector<std::string>& words);
// A command and all its descendants, each before its own subcommands.
[[nodiscard]] std::vector<const CommandManual*> all_commands(const CommandManual& from);

[[nodiscard]] inline bool is_program(const CommandManual& command) {
  return command.path.find(' ') == std::string::npos;
}

// Usage of an option, "--goal EFFECTOR=X,Y,Z …"; "…" means that it is repeatable.
[[nodiscard]] std::string label_of(const OptionManual& option);
// Synopsis, "shigusa dataset export FOLDER --out FOLDER [OPTION]…".
[[nodiscard]] std::string usage_of(const CommandManual& command);
// Choices for its value; empty if it is not a choice.
[[nodiscard]] std::vector<std::string> words_of(const OptionManual& option);
// Whether its value may be a file, or a folder.
[[nodiscard]] bool takes_file(const OptionManual& option);
[[nodiscard]] bool takes_folder(const OptionManual& option);

// Breaks a text into lines of up to `width` characters, indented by `indent` blanks.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);
// Number of characters of a UTF-8 text.
[[nodiscard]] std::size_t width_of(std::string_view text);

// --help: common options in a line each.
[[nodiscard]] std::string short_help(const CommandManual& command);
// --help-all: every option in full.
[[nodiscard]] std::string long_help(const CommandManual& command);
// Manual of a command as text: its long help, exit codes and environment.
[[nodiscard]] std::string manual_text(const CommandManual& command);
// Manual as a man page, with subcommands as sections; that of the whole program has none.
[[nodiscard]] std::string manual_page(const CommandManual& command);
// Manual as Markdown, with all subcommands on one page.
[[nodiscard]] std::string manual_markdown(const CommandManual& command);

// Shell scripts that complete commands, options, words and paths.
[[nodiscard]] std::string bash_completion(const CommandManual& program);
[[nodiscard]] std::string zsh_completion(const CommandManual& program);
[[nodiscard]] std::string fish_completion(const CommandManual& program);

// Adds `shigusa manual` and `shigusa completion`, which describe the program at the time of the
// call.
void add_manual(CLI::App& app, int& exit_code);
void add_completion(CLI::App& app, int& exit_code);

}  // namespace shigusa::app
