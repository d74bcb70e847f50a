// SPDX-License-Identifier: MIT
#include <cstdio>
#include <deque>
#include <memory>
#include <shigusa/shigusa.hpp>

#include "assistant/assistant.hpp"
#include "commands.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "picture.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct McpOptions {
  std::string folder;
  int threads = 0;
};

// Lines that arrive during a call, at most; more stay with the sender.
constexpr std::size_t kWaitingMost = 8;

void send_line(std::string_view line) {
  write_out(line);
  write_out("\n");
  std::fflush(stdout);
}

Result<int> mcp(const McpOptions& options) {
  std::error_code ignored;
  if (!options.folder.empty() && !std::filesystem::is_directory(to_path(options.folder), ignored)) {
    return fail(ErrorCode::not_found, "is no folder", "--folder " + options.folder);
  }
  InputLines lines(kAssistantLineMost);
  std::deque<std::string> waiting;
  Assistant* session = nullptr;
  const auto stops = [&] {
    std::erase_if(waiting, [&](const std::string& line) { return session->cancel_by(line); });
    while (waiting.size() < kWaitingMost) {
      std::optional<std::string> line = lines.next(false);
      if (!line) break;
      if (!session->cancel_by(*line)) waiting.push_back(std::move(*line));
    }
    return interrupted().load();
  };
  Assistant assistant(
      {.folder = to_path(options.folder), .from_svg = picture_from, .threads = options.threads},
      {.version = SHIGUSA_VERSION, .send = send_line, .stops = stops});
  session = &assistant;
  while (!interrupted()) {
    std::optional<std::string> line;
    if (waiting.empty()) {
      line = lines.next(true);
    } else {
      line = std::move(waiting.front());
      waiting.pop_front();
    }
    if (!line) break;
    if (const auto answer = assistant.answer(*line)) send_line(*answer);
  }
  return kDone;
}

}  // namespace

void add_mcp(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<McpOptions>();
  McpOptions& o = *options;
  CLI::App* c = app.add_subcommand(
      "mcp",
      "Serve assistants by the Model Context Protocol\nMessages come from the standard input, and "
      "answers go to the standard output, until the input ends. There is no network, and no file "
      "is written.");
  c->group(kMore)->footer("shigusa mcp\nshigusa mcp --folder .");
  const std::string group = "The session";
  describe(c->add_option("--folder", o.folder),
           {.group = group,
            .brief = "Folder below which files may be read (default: none are)",
            .full = "Folder below which characters, scenes and clips may be read, by their paths "
                    "in it; when not given, no file is.",
            .form = "FOLDER"});
  describe(c->add_option("--threads", o.threads)->check(whole_number(0, kMaxThreads)),
           {.group = group,
            .brief = "Threads of a search (default 0: one for each core)",
            .form = "N",
            .rare = true});
  c->callback([options, &exit_code] { exit_code = exit_code_of(mcp(*options)); });
}

}  // namespace shigusa::app
