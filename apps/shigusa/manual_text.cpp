// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/shigusa.hpp>

#include "manual.hpp"

namespace shigusa::app {
namespace {

constexpr std::size_t kTextWidth = 100;  // characters of a line
constexpr std::size_t kColumn = 38;      // where options' lines begin
constexpr std::size_t kDeep = 6;         // where their sentences do

// A label and its line, side by side if there is room.
std::string entry(const std::string& label, const std::string& line) {
  std::string text = "  " + label;
  if (width_of(text) + 1 >= kColumn) {
    text += "\n" + std::string(kColumn, ' ');
  } else {
    text += std::string(kColumn - width_of(text), ' ');
  }
  // continuation lines are aligned with the first
  return text + wrapped(line, kColumn, kTextWidth).substr(kColumn);
}

std::string examples_of(const CommandManual& command) {
  if (command.examples.empty()) return {};
  std::string text = command.examples.size() == 1 ? "\nExample\n" : "\nExamples\n";
  for (const std::string& example : command.examples) text += "  " + example + "\n";
  return text;
}

// Subcommands by their headings, each with its first example.
std::string commands_of(const CommandManual& command) {
  std::string text;
  std::string heading;
  std::size_t longest = 0;
  for (const CommandManual& below : command.commands) {
    longest = std::max(longest, below.name().size());
  }
  for (const CommandManual& below : command.commands) {
    if (below.group != heading) text += "\n" + below.group + "\n";
    heading = below.group;
    const std::size_t column = longest + 4;
    text += fmt::format("  {:<{}}  {}", below.name(), longest,
                        wrapped(below.brief, column, kTextWidth).substr(column));
    if (!below.examples.empty()) {
      text += std::string(column, ' ') + below.examples.front() + "\n";
    }
  }
  return text;
}

std::string title_of(const CommandManual& command) {
  const std::string usage = wrapped("Usage: " + usage_of(command), 0, kTextWidth);
  if (is_program(command)) {
    return fmt::format("{} {}: {}\n\n{}", command.path, SHIGUSA_VERSION, command.brief, usage);
  }
  return usage + wrapped(command.brief + ".", 0, kTextWidth) +
         (command.full.empty() ? "" : wrapped(command.full, 0, kTextWidth));
}

std::string terms(const char* heading, const auto& table) {
  std::string text = fmt::format("\n{}\n", heading);
  for (const Term& term : table) {
    text += fmt::format("  {}\n{}", term.name, wrapped(term.says, kDeep, kTextWidth));
  }
  return text;
}

// Last lines of the program's help.
std::string further_reading(const CommandManual& program) {
  return fmt::format(
      "\n`{0} COMMAND --help` has a command's options, `{0} manual COMMAND` all about it.\n"
      "Tutorials, concepts and reference are in docs/ of the source; `scripts/build_docs` makes a\n"
      "site of them.\n",
      program.path);
}

// Last lines of a command's help: omissions, and the meaning of its signs.
std::string left_out(const CommandManual& command) {
  std::size_t rare = 0;
  bool is_all_said = true;
  bool any_repeatable = false;
  for (const OptionGroupManual& group : command.groups) {
    for (const OptionManual& option : group.options) {
      any_repeatable = any_repeatable || option.repeatable;
      if (is_of_help(group)) continue;
      rare += option.rare ? 1 : 0;
      is_all_said = is_all_said && !option.rare && option.full == option.brief + ".";
    }
  }
  std::string text;
  if (!is_all_said) {
    const std::string more =
        rare == 0 ? "" : fmt::format("{} more option{}, and ", rare, rare == 1 ? "" : "s");
    text = fmt::format("`{} --help-all` has {}all that is to be said about each.\n", command.path,
                       more);
  }
  if (any_repeatable) text += "… marks what may be given more than once.\n";
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::size_t width_of(std::string_view text) {
  // bytes of UTF-8 that go on with a character begin with the bits 10
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string lines;
  std::string line(indent, ' ');
  bool is_empty = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (!is_empty && width_of(line) + 1 + width_of(word) > width) {
      lines += line + "\n";
      line.assign(indent, ' ');
      is_empty = true;
    }
    line += (is_empty ? "" : " ") + std::string(word);
    is_empty = false;
  }
  return lines + line + "\n";
}

std::string short_help(const CommandManual& command) {
  std::string text = title_of(command);
  for (const OptionGroupManual& group : command.groups) {
    std::string lines;
    for (const OptionManual& option : group.options) {
      if (!option.rare) lines += entry(label_of(option), option.brief);
    }
    if (!lines.empty()) text += "\n" + (group.heading.empty() ? "" : group.heading + "\n") + lines;
  }
  text += commands_of(command) + examples_of(command);
  return text + (is_program(command) ? further_reading(command) : left_out(command));
}

std::string long_help(const CommandManual& command) {
  std::string text = title_of(command);
  for (const OptionGroupManual& group : command.groups) {
    text += "\n" + (group.heading.empty() ? "" : group.heading + "\n");
    for (const OptionManual& option : group.options) {
      text += "  " + label_of(option) + "\n" + wrapped(option.full, kDeep, kTextWidth);
    }
  }
  return text + commands_of(command) + examples_of(command);
}

std::string manual_text(const CommandManual& command) {
  return long_help(command) + terms("Exit codes", kExitCodes) + terms("Environment", kEnvironment);
}

}  // namespace shigusa::app
