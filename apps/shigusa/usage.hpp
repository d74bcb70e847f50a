// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::app {

// Properties of an option for help, manual and completion (see read_manual).
struct OptionHelp {
  std::string group{};  // its heading
  std::string brief{};  // its line in --help
  std::string full{};   // text of --help-all and the manual in place of the line; empty: the line
  // form of its value: choices "paper|flat"; FILE or FOLDER for a path; else a pattern, "X,Y,Z".
  // Empty for a flag.
  std::string form{};
  bool rare = false;  // only in --help-all and the manual
};
// Describes an option. CLI11 stores a group, a description and a type name, so the five properties
// are encoded in these three. A malformed number is refused with this program's message.
CLI::Option* describe(CLI::Option* option, const OptionHelp& help);

// Parts of an option's description and group, as joined by describe.
[[nodiscard]] OptionHelp help_of(const CLI::Option& option);

// Accepts whole numbers in a range; CLI11's own conversion takes -1 for the largest unsigned one.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);
// Accepts whole numbers whose range is checked by the library.
[[nodiscard]] CLI::Validator whole_number();

// Accepts numbers in a range, with a decimal point in every locale.
[[nodiscard]] CLI::Validator number(double low, double high);

// Accepts only these words; `kind`: noun for messages, "extent".
[[nodiscard]] CLI::Validator one_of(const std::string& kind, const std::vector<std::string>& words);

// Accepts a frame number, from 0, or "rest", which becomes kRestPose.
[[nodiscard]] CLI::Validator frame_or_rest();

// Whether a text looks like a file's path.
[[nodiscard]] bool is_path(std::string_view text);

// Hint "; decimals have a point: 1.5" if a text has a comma within a number; else empty.
[[nodiscard]] std::string comma_hint(std::string_view text);

// Commands chosen by a call, outermost first: "dataset", "merge".
[[nodiscard]] std::vector<std::string> chosen_words(const CLI::App& app);

// Names of a command's subcommands: "merge", "check", …
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

// Reports an error of the call, with the nearest name for an unknown one, and returns the exit
// code.
int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace shigusa::app
