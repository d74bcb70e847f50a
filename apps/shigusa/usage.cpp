// SPDX-License-Identifier: MIT
#include "usage.hpp"

#include <fmt/format.h>

#include <charconv>
#include <shigusa/words.hpp>
#include <vector>

#include "commands.hpp"

namespace shigusa::app {
namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// A message for errors of which CLI11 only says that something is there or missing.
std::string usage_message(const CLI::App& app, const CLI::App& command,
                          const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  const bool is_option = !unknown.empty() && unknown.front().starts_with('-');
  if (&command == &app) {
    const std::vector<std::string> names = command_names(app);
    if (unknown.empty()) return fmt::format("give a command: {}", fmt::join(names, ", "));
    return is_option ? unknown_name("option", unknown.front(), option_names(app)).text
                     : unknown_name("command", unknown.front(), names).text;
  }
  if (unknown.empty()) return error.what();
  return is_option ? unknown_name("option", unknown.front(), option_names(command)).text
                   : fmt::format("'{}' is one argument too many", unknown.front().substr(0, 80));
}

}  // namespace

CLI::Validator frame_or_rest() {
  const auto accept = [](std::string& text) {
    if (text != "rest") return whole_number(0, kFrameMax)(text);
    text = std::to_string(kRestPose);
    return std::string();
  };
  return {accept, "INT|rest"};
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto wrong = [low, high](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code == std::errc{} && stop == end && value >= low && value <= high) return {};
    return fmt::format("is '{}'; allowed are whole numbers from {} to {}", text.substr(0, 80), low,
                       high);
  };
  return CLI::Validator(wrong, fmt::format("{}..{}", low, high));
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string called = chosen.empty() ? "shigusa" : "shigusa " + command.get_name();
  print_err("{}: {}\n`{} --help` tells what can be given.\n", called,
            printable(usage_message(app, command, error)), called);
  return kWrongInput;
}

}  // namespace shigusa::app
