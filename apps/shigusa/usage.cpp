// SPDX-License-Identifier: MIT
#include "usage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <shigusa/error.hpp>

#include "commands.hpp"
#include "core/parse_number.hpp"

namespace shigusa::app {
namespace {

// Suffix of CLI11's group for a rare option.
constexpr std::string_view kRareMark = " (rare)";

// Longest text that a message repeats.
constexpr std::size_t kToldText = 80;
// Number of options up to which a message lists all of a command.
constexpr std::size_t kToldOptions = 12;

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// Commands that have an option of this name, for one that is given before a command.
std::string commands_with(const CLI::App& app, const std::string& name) {
  std::vector<std::string> with;
  for (const CLI::App* command : commands_of(app)) {
    const auto names = option_names(*command);
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      with.push_back(command->get_name());
    }
  }
  return fmt::format("{}", fmt::join(with, ", "));
}

// Form for a type name of CLI11, "FLOAT:FLOAT in [1 - 3]"; a form is returned unchanged.
std::string form_of_type(const std::string& type) {
  for (const auto& [own, form] : {std::pair{"FLOAT", "NUMBER"}, std::pair{"UINT", "N"},
                                  std::pair{"INT", "N"}, std::pair{"TEXT", "TEXT"}}) {
    if (type == own || type.starts_with(std::string(own) + ":")) return form;
  }
  return type;
}

// Option named at the beginning of an error of CLI11, "--seed: …" or "clip is required".
const CLI::Option* option_told(const CLI::App& command, std::string told) {
  constexpr std::string_view kNotConverted = "Could not convert: ";
  if (told.starts_with(kNotConverted)) told.erase(0, kNotConverted.size());
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (told.starts_with(name) && told.substr(name.size()).find_first_of(" :") == 0) return option;
  }
  return nullptr;
}

// Sentence for errors that CLI11 words in its own terms.
std::string value_message(const CLI::App& command, const CLI::ParseError& error) {
  const std::string told = error.what();
  const CLI::Option* option = option_told(command, told);
  if (option == nullptr) return told;
  const OptionHelp help = help_of(*option);
  const std::string name = option->get_name();
  const std::string form = help.form.empty() || option->get_positional() ? "" : " " + help.form;
  if (error.get_name() == "RequiredError") {
    return fmt::format("{}{} is required: {}", name, form, help.brief);
  }
  if (error.get_name() == "ExcludesError") {
    const std::string other = told.substr(told.rfind(' ') + 1);
    return fmt::format("{} and {} exclude each other: give one of both", name, other);
  }
  if (error.get_name() == "ConversionError" && help.form.empty()) {
    return fmt::format("{} takes no value: it is given or left out", name);
  }
  if (error.get_name() != "ArgumentMismatch") return told;
  if (told.ends_with(" missing")) {
    return fmt::format("{} needs a value,{}: {}", name, form, help.brief);
  }
  return fmt::format("{} is given {} times; allowed is once", name, option->results().size());
}

// Subcommand that an argument was meant for: "mrge" of `shigusa dataset mrge DIR`.
std::string meant_command(const CLI::App& command) {
  const std::vector<std::string> names = command_names(command);
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || option->count() == 0 || names.empty()) continue;
    const std::string given = option->results().front();
    if (!is_path(given) && !nearest_name(given, names).empty()) {
      return unknown_name("command", given, names).text;
    }
  }
  return {};
}

// Guess at the meaning of a surplus argument.
std::string extra_hint(const CLI::App& command, const std::string& extra) {
  const std::string option = "--" + extra;
  const auto names = option_names(command);
  if (std::find(names.begin(), names.end(), option) != names.end()) {
    return fmt::format("; did you mean '{}'?", option);
  }
  const std::string number = extra.substr(0, extra.find(','));
  if (!parse_number(number)) return {};
  return "; the numbers of one value stand together, with commas and no blanks: 0.2,1.1,0.4";
}

// Names in other tools for options of this one.
struct OtherWord {
  std::string_view word;
  std::string_view option;
};
constexpr OtherWord kOtherWords[] = {
    {"--target", "--goal"},     {"--position", "--goal"}, {"--height", "--stature"},
    {"--weight", "--mass"},     {"--output", "--out"},    {"--body", "--character"},
    {"--model", "--character"}, {"--time", "--duration"}, {"--gender", "--sex"},
    {"--chair", "--seat"},      {"--carry", "--load"},    {"--box", "--obstacle"},
};

std::string_view meant_option(std::string_view name, std::span<const std::string> known) {
  for (const OtherWord& other : kOtherWords) {
    const auto option = std::find(known.begin(), known.end(), other.option);
    if (other.word == name && option != known.end()) return *option;
  }
  return nearest_name(name, known);
}

std::string unknown_option(const CLI::App& app, const CLI::App& command, const std::string& name) {
  // "--gaol=x" refers to --gaol
  const std::string alone = name.substr(0, name.find('='));
  if (&command == &app) {
    const std::string with = commands_with(app, alone);
    if (!with.empty())
      return fmt::format("{} comes after the command that has it: {}", alone, with);
  }
  const std::vector<std::string> names = option_names(command);
  if (names.size() <= kToldOptions) return unknown_name("option", alone, names).text;
  const std::string_view nearest = meant_option(alone, names);
  const std::string text = fmt::format("unknown option '{}'", alone.substr(0, kToldText));
  return nearest.empty() ? text : fmt::format("{}; did you mean '{}'?", text, nearest);
}

// Message for errors of CLI11 that only state that something is present or missing.
std::string usage_message(const CLI::App& app, const CLI::App& command,
                          const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  if (!unknown.empty() && unknown.front().starts_with('-')) {
    return unknown_option(app, command, unknown.front());
  }
  if (&command == &app) {
    const std::vector<std::string> names = command_names(app);
    const std::string all = fmt::format("{}", fmt::join(names, ", "));
    if (unknown.empty()) return fmt::format("give a command: {}", all);
    if (!is_path(unknown.front())) return unknown_name("command", unknown.front(), names).text;
    return fmt::format("'{}' is no command; a file comes after one: {}",
                       unknown.front().substr(0, kToldText), all);
  }
  if (unknown.empty()) return value_message(command, error);
  const std::string meant = meant_command(command);
  if (!meant.empty()) return meant;
  return fmt::format("'{}' is one argument too many{}", unknown.front().substr(0, kToldText),
                     extra_hint(command, unknown.front()));
}

// Refuses an option in the place of a value, which CLI11 would accept.
CLI::Validator value_there(const std::string& form) {
  const auto wrong = [form](const std::string& text) -> std::string {
    if (!text.starts_with("--")) return {};
    return fmt::format("needs a value, {}; {} follows it", form, text.substr(0, kToldText));
  };
  return CLI::Validator(wrong, "");
}

}  // namespace

CLI::Option* describe(CLI::Option* option, const OptionHelp& help) {
  const std::string type = option->get_type_name();
  if (option->get_items_expected_max() > 0) option->check(value_there(help.form));
  if (type == "FLOAT") option->check(number(-HUGE_VAL, HUGE_VAL));
  if (type == "INT") option->check(whole_number());
  if (type == "UINT") option->check(whole_number(0, UINT64_MAX));
  option->description(help.brief + (help.full.empty() ? "" : "\n" + help.full));
  if (!help.form.empty()) option->type_name(help.form);
  const std::string heading = help.group.empty() ? "Options" : help.group;
  return option->group(heading + std::string(help.rare ? kRareMark : ""));
}

OptionHelp help_of(const CLI::Option& option) {
  OptionHelp help;
  const std::string& text = option.get_description();
  const std::size_t end = text.find('\n');
  help.brief = text.substr(0, end);
  help.full = end == text.npos ? "" : text.substr(end + 1);
  help.group = option.get_group();
  help.rare = help.group.ends_with(kRareMark);
  if (help.rare) help.group.resize(help.group.size() - kRareMark.size());
  help.form = option.get_items_expected_max() == 0 ? "" : form_of_type(option.get_type_name());
  return help;
}

CLI::Validator frame_or_rest() {
  const auto accept = [](std::string& text) {
    if (text == "rest") {
      text = std::to_string(kRestPose);
      return std::string();
    }
    const std::string wrong = whole_number(0, kFrameMax)(text);
    return wrong.empty() ? wrong : wrong + ", or rest";
  };
  return {accept, ""};
}

bool is_path(std::string_view text) { return text.find_first_of("./") != text.npos; }

std::string comma_hint(std::string_view text) {
  std::string pointed(text);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  const bool is_number = text.find(',') != text.npos && parse_number(pointed);
  return is_number ? "; decimals have a point: " + pointed : "";
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto wrong = [low, high](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code == std::errc{} && stop == end && value >= low && value <= high) return {};
    return fmt::format("is '{}'; allowed are whole numbers from {} to {}",
                       text.substr(0, kToldText), low, high);
  };
  return CLI::Validator(wrong, "");
}

CLI::Validator whole_number() {
  const auto wrong = [](const std::string& text) -> std::string {
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code == std::errc{} && stop == end) return {};
    return fmt::format("is '{}'; allowed are whole numbers", text.substr(0, kToldText));
  };
  return CLI::Validator(wrong, "");
}

CLI::Validator number(double low, double high) {
  const auto wrong = [low, high](const std::string& text) -> std::string {
    const std::optional<double> value = parse_number(text);
    // non-finite values are refused by the library, with the permitted range
    if (value && (std::isinf(high) || (*value >= low && *value <= high))) return {};
    const std::string range =
        std::isinf(high) ? ", such as 1.5" : fmt::format(" from {} to {}", low, high);
    return fmt::format("is '{}'; allowed are numbers{}{}", text.substr(0, kToldText), range,
                       comma_hint(text));
  };
  return CLI::Validator(wrong, "");
}

CLI::Validator one_of(const std::string& kind, const std::vector<std::string>& words) {
  const auto wrong = [kind, words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    return unknown_name(kind, text, words).text;
  };
  return CLI::Validator(wrong, "");
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> chosen_words(const CLI::App& app) {
  std::vector<std::string> words;
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    words.push_back(command->get_name());
  }
  return words;
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  std::string called = app.get_name();
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    called += " " + command->get_name();
  }
  print_err("{}: {}\n`{} --help` tells what can be given.\n", called,
            printable(usage_message(app, *command, error)), called);
  return kWrongInput;
}

}  // namespace shigusa::app
