// SPDX-License-Identifier: MIT
// The manual as a man page, with the macros of man(7), and as Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <shigusa/shigusa.hpp>

#include "manual.hpp"

namespace shigusa::app {
namespace {

constexpr std::size_t kPageWidth = 100;  // characters of a line of Markdown

// First code point of a UTF-8 text, and its length in bytes.
std::pair<std::uint32_t, std::size_t> first_point(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  std::uint32_t point = bytes == 1 ? lead : lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < std::min(bytes, text.size()); ++i) {
    point = (point << 6) | (static_cast<unsigned char>(text[i]) & 0x3fU);
  }
  return {point, bytes};
}

// A text for roff: ASCII, with requests and escapes neutralised.
std::string roff(std::string_view text) {
  std::string escaped;
  if (text.starts_with('.') || text.starts_with('\'')) escaped = "\\&";
  while (!text.empty()) {
    const auto [point, bytes] = first_point(text);
    if (point >= 0x80) {
      escaped += fmt::format("\\[u{:04X}]", point);
    } else if (point == '\\') {
      escaped += "\\e";
    } else if (point == '-' || point == '\'' || point == '`' || point == '^' || point == '~') {
      // literal ASCII signs rather than hyphens and typographic quotes
      escaped += point == '-'    ? "\\-"
                 : point == '\'' ? "\\(aq"
                 : point == '`'  ? "\\(ga"
                 : point == '^'  ? "\\(ha"
                                 : "\\(ti";
    } else {
      escaped += static_cast<char>(point);
    }
    text.remove_prefix(std::min(bytes, text.size()));
  }
  return escaped;
}

std::string tagged(std::string_view label, std::string_view says) {
  return fmt::format(".TP\n.B {}\n{}\n", roff(label), roff(says));
}

std::string roff_options(const CommandManual& command) {
  std::string text;
  for (const OptionGroupManual& group : command.groups) {
    text += fmt::format(".SS {}\n", roff(group.heading.empty() ? "Arguments" : group.heading));
    for (const OptionManual& option : group.options) {
      text += tagged(label_of(option), option.full);
    }
  }
  return text;
}

std::string roff_examples(const CommandManual& command) {
  if (command.examples.empty()) return {};
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".fi\n";
}

std::string roff_terms(const char* heading, const auto& table) {
  std::string text = fmt::format(".SH {}\n", heading);
  for (const Term& term : table) text += tagged(term.name, term.says);
  return text;
}

// Page name with escapes, "shigusa\-reach" for "shigusa reach".
std::string page_name(const CommandManual& command) {
  std::string name = command.path;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

// Commands of the program with their pages; for a command its subcommands with their options.
std::string roff_commands(const CommandManual& command, bool of_program) {
  std::string text;
  std::string heading;
  for (const CommandManual& below : command.commands) {
    if (!of_program) {
      text += fmt::format(".SH {}\n{}\n.PP\n.B {}\n", roff(below.path), roff(below.brief + "."),
                          roff(usage_of(below)));
      text += roff_options(below);
      for (const std::string& example : below.examples) {
        text += fmt::format(".PP\n.EX\n{}\n.EE\n", roff(example));
      }
      continue;
    }
    if (below.group != heading) text += fmt::format(".SS {}\n", roff(below.group));
    heading = below.group;
    text += tagged(page_name(below) + "(1)", below.brief + ".");
  }
  return text.empty() || !of_program ? text : ".SH COMMANDS\n" + text;
}

std::string markdown_options(const CommandManual& command) {
  std::string text;
  for (const OptionGroupManual& group : command.groups) {
    text += fmt::format("\n**{}**\n\n", group.heading.empty() ? "Arguments" : group.heading);
    for (const OptionManual& option : group.options) {
      text += fmt::format("- `{}`  \n{}", label_of(option), wrapped(option.full, 2, kPageWidth));
    }
  }
  return text;
}

std::string markdown_examples(const CommandManual& command) {
  if (command.examples.empty()) return {};
  std::string text = "\n```sh\n";
  for (const std::string& example : command.examples) text += example + "\n";
  return text + "```\n";
}

std::string markdown_terms(const char* heading, const auto& table) {
  std::string text = fmt::format("\n## {}\n\n", heading);
  for (const Term& term : table) {
    text += fmt::format("- `{}`  \n{}", term.name, wrapped(term.says, 2, kPageWidth));
  }
  return text;
}

// A line as a sentence: with a capital letter and a full stop.
std::string sentence(std::string line) {
  if (line.front() >= 'a' && line.front() <= 'z')
    line.front() = static_cast<char>(line.front() - 32);
  return line + ".";
}

// Writes a command as a section, and its subcommands as subsections.
std::string markdown_section(const CommandManual& command) {
  const auto words = std::count(command.path.begin(), command.path.end(), ' ');
  std::string text = fmt::format(
      "\n{} {}\n\n{}\n```text\n{}\n```\n", std::string(static_cast<std::size_t>(words) + 1, '#'),
      command.path, wrapped(sentence(command.brief), 0, kPageWidth), usage_of(command));
  if (!command.full.empty()) text += "\n" + wrapped(command.full, 0, kPageWidth);
  return text + markdown_examples(command) + markdown_options(command);
}

}  // namespace

std::string manual_page(const CommandManual& command) {
  const bool of_program = is_program(command);
  std::string title = page_name(command);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  std::string text =
      fmt::format(".TH {} 1 \"\" \"shigusa {}\" \"shigusa\"\n", roff(title), SHIGUSA_VERSION);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roff(page_name(command)), roff(command.brief));
  text += fmt::format(".SH SYNOPSIS\n.B {}\n", roff(usage_of(command)));
  if (!command.full.empty()) text += fmt::format(".SH DESCRIPTION\n{}\n", roff(command.full));
  if (of_program) text += roff_commands(command, true);
  text += ".SH OPTIONS\n" + roff_options(command);
  if (!of_program) text += roff_commands(command, false);
  text += roff_examples(command) + roff_terms("EXIT STATUS", kExitCodes);
  text += roff_terms("ENVIRONMENT", kEnvironment);
  if (!of_program) text += ".SH SEE ALSO\n.BR shigusa (1)\n";
  return text;
}

std::string manual_markdown(const CommandManual& command) {
  std::string text;
  for (const CommandManual* below : all_commands(command)) text += markdown_section(*below);
  return text.substr(1) + markdown_terms("Exit codes", kExitCodes) +
         markdown_terms("Environment", kEnvironment);
}

}  // namespace shigusa::app
