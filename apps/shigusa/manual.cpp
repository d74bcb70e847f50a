// SPDX-License-Identifier: MIT
#include "manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "usage.hpp"

namespace shigusa::app {
namespace {

constexpr const char* kHelpHeading = "Help";

// Ending of a form with several choices: "bvh|csv,…".
constexpr std::string_view kListMark = ",…";

std::vector<std::string> split_at(std::string_view text, char sign) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(sign), text.size());
    if (end > 0) parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

OptionManual read_option(const CLI::Option& option) {
  const OptionHelp help = help_of(option);
  OptionManual manual;
  manual.argument = option.get_positional();
  manual.name = manual.argument ? upper(option.get_name(true)) : "--" + option.get_lnames().front();
  manual.form = help.form;
  manual.brief = help.brief;
  manual.full = help.full.empty() ? help.brief + "." : help.full;
  manual.required = option.get_required();
  manual.repeatable = option.get_items_expected_max() > 1;
  manual.rare = help.rare;
  return manual;
}

// Options that CLI11 adds to each command.
OptionGroupManual help_options(const CLI::App& app) {
  OptionGroupManual group{kHelpHeading, {}};
  const auto add = [&group](const char* name, const char* brief) {
    group.options.push_back(
        {.name = name, .form = "", .brief = brief, .full = std::string(brief) + ".", .rare = true});
  };
  add("--help", "The common options, a line each; -h is the same");
  add("--help-all", "All options with all that is to be said about them");
  if (app.get_version_ptr() != nullptr) add("--version", "The program's version");
  return group;
}

OptionGroupManual& group_of(CommandManual& command, const std::string& heading) {
  const auto has_it = [&heading](const OptionGroupManual& g) { return g.heading == heading; };
  const auto found = std::find_if(command.groups.begin(), command.groups.end(), has_it);
  if (found != command.groups.end()) return *found;
  return command.groups.emplace_back(OptionGroupManual{heading, {}});
}

CommandManual read_command(const CLI::App& app, const std::string& path) {
  CommandManual command;
  command.path = path;
  command.group = app.get_group();
  const std::string text = app.get_description();
  const std::size_t end = std::min(text.find('\n'), text.size());
  command.brief = text.substr(0, end);
  command.full = end < text.size() ? text.substr(end + 1) : "";
  command.examples = split_at(app.get_footer(), '\n');
  for (const CLI::Option* option : app.get_options()) {
    const bool of_help = option == app.get_help_ptr() || option == app.get_help_all_ptr() ||
                         option == app.get_version_ptr();
    if (of_help || option->get_group().empty()) continue;
    const OptionManual read = read_option(*option);
    group_of(command, read.argument ? "" : help_of(*option).group).options.push_back(read);
  }
  const auto is_of_arguments = [](const OptionGroupManual& g) { return g.heading.empty(); };
  std::stable_partition(command.groups.begin(), command.groups.end(), is_of_arguments);
  command.groups.push_back(help_options(app));
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    command.commands.push_back(read_command(*below, path + " " + below->get_name()));
  }
  return command;
}

bool has_choice(const OptionManual& option, std::string_view choice) {
  const std::vector<std::string> choices = split_at(option.form, '|');
  return std::find(choices.begin(), choices.end(), choice) != choices.end();
}

}  // namespace

CommandManual read_manual(const CLI::App& app) { return read_command(app, app.get_name()); }

const CommandManual* find_command(const CommandManual& from,
                                  const std::vector<std::string>& words) {
  const CommandManual* found = &from;
  for (const std::string& word : words) {
    const auto is_it = [&word](const CommandManual& c) { return c.name() == word; };
    const auto next = std::find_if(found->commands.begin(), found->commands.end(), is_it);
    if (next == found->commands.end()) return nullptr;
    found = &*next;
  }
  return found;
}

std::vector<const CommandManual*> all_commands(const CommandManual& from) {
  std::vector<const CommandManual*> all{&from};
  for (const CommandManual& command : from.commands) {
    const auto below = all_commands(command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

std::string label_of(const OptionManual& option) {
  std::string label = option.name;
  if (!option.argument && !option.form.empty()) label += " " + option.form;
  return option.repeatable ? label + " …" : label;
}

std::string usage_of(const CommandManual& command) {
  std::string usage = command.path;
  if (!command.commands.empty() && command.groups.size() == 1) usage += " COMMAND";
  for (const bool arguments : {true, false}) {
    for (const OptionGroupManual& group : command.groups) {
      for (const OptionManual& option : group.options) {
        if (option.argument != arguments || !(option.argument || option.required)) continue;
        const std::string label = label_of(option);
        usage += option.required ? " " + label : " [" + label + "]";
      }
    }
  }
  return usage + " [OPTION]…";
}

std::vector<std::string> words_of(const OptionManual& option) {
  std::string_view form = option.form;
  if (form.ends_with(kListMark)) form.remove_suffix(kListMark.size());
  std::vector<std::string> words = split_at(form, '|');
  if (words.size() < 2) return {};
  std::erase_if(words, [](const std::string& word) {
    return std::any_of(word.begin(), word.end(),
                       [](unsigned char c) { return std::isupper(c) != 0 || c == '='; });
  });
  return words;
}

bool takes_file(const OptionManual& option) { return has_choice(option, "FILE"); }
bool takes_folder(const OptionManual& option) { return has_choice(option, "FOLDER"); }

}  // namespace shigusa::app
