// SPDX-License-Identifier: MIT
#include <exception>
#include <shigusa/shigusa.hpp>

#include "commands.hpp"
#include "manual.hpp"
#include "show.hpp"
#include "usage.hpp"

namespace {

using namespace shigusa::app;

// The commands in their order in `shigusa --help`, with their headings.
void add_commands(CLI::App& app, int& exit_code) {
  add_reach(app, exit_code);
  add_edit(app, exit_code);
  add_mirror(app, exit_code);
  add_show(app, exit_code);
  add_render(app, exit_code);
  add_limit(app, exit_code);
  add_map(app, exit_code);
  add_body(app, exit_code);
  add_score(app, exit_code);
  add_habit(app, exit_code);
  add_dataset(app, exit_code);
  add_studio(app, exit_code);
  add_mcp(app, exit_code);
  add_schema(app);
  add_completion(app, exit_code);
  add_manual(app, exit_code);  // of those before it
}

// CLI11 reports help and version as errors too; they refer to the last chosen command.
int answer(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) return report_usage(app, error);
  const std::string kind = error.get_name();
  if (kind == "CallForVersion") {
    write_out(std::string(error.what()) + "\n");
    return finish_output(kDone);
  }
  const CommandManual program = read_manual(app);
  const CommandManual& command = *find_command(program, chosen_words(app));
  write_out(kind == "CallForAllHelp" ? long_help(command) : short_help(command));
  return finish_output(kDone);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  catch_interrupts();
  CLI::App app("natural whole-body motions from the final state of hands and feet", "shigusa");
  app.set_version_flag("--version", SHIGUSA_VERSION);
  app.set_help_all_flag("--help-all");
  app.allow_windows_style_options(false);  // of "/x", which is a path
  app.require_subcommand(1);
  int exit_code = kDone;
  add_commands(app, exit_code);
  try {
    argv = utf8_arguments(argc, argv);
    app.parse(argc, argv);
    return finish_output(exit_code);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  } catch (const std::exception& error) {
    print_err("shigusa: internal fault: {}\n", error.what());
    return kFault;
  }
}
