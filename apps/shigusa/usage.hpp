// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::app {

// The facts of an option that help, manual and completion tell (see read_manual).
struct OptionHelp {
  std::string group{};  // its heading
  std::string brief{};  // its line in --help
  std::string full{};   // what --help-all and the manual say in place of the line; empty: the line
  // of its value: words to choose from, "paper|flat"; FILE or FOLDER of a path; else a picture of
  // it, "X,Y,Z". A flag has none.
  std::string form{};
  bool rare = false;  // only in --help-all and the manual
};
// Gives an option its facts. CLI11 keeps a group, a description and a type name of each option, so
// the five facts are kept in these three. A number that cannot be read is refused in our words.
CLI::Option* describe(CLI::Option* option, const OptionHelp& help);

// The parts of an option's description and group, as describe puts them together.
[[nodiscard]] OptionHelp help_of(const CLI::Option& option);

// Accepts whole numbers in a range; CLI11's own conversion takes -1 for the largest unsigned one.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);
// Accepts whole numbers of which the library knows the range.
[[nodiscard]] CLI::Validator whole_number();

// Accepts numbers in a range, with a point whatever the locale has.
[[nodiscard]] CLI::Validator number(double low, double high);

// Accepts the words alone; `kind` is "extent".
[[nodiscard]] CLI::Validator one_of(const std::string& kind, const std::vector<std::string>& words);

// Accepts a frame, from 0, or "rest", which becomes kRestPose.
[[nodiscard]] CLI::Validator frame_or_rest();

// Whether a text looks like a file's path.
[[nodiscard]] bool is_path(std::string_view text);

// "; decimals have a point: 1.5" where a text has a comma in a number's place, and else nothing.
[[nodiscard]] std::string comma_hint(std::string_view text);

// The commands that a call chose, one below the other: "dataset", "merge".
[[nodiscard]] std::vector<std::string> chosen_words(const CLI::App& app);

// The words that a command has for its own commands: "merge", "check", …
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

// Says what is wrong with the call, with the nearest name for one that is not known, and returns
// the exit code.
int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace shigusa::app
