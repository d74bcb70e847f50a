// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "next_step.hpp"
#include "page_server.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

struct StudioOptions {
  int port = 0;        // any that is free
  bool open = true;    // in the person's browser
  std::string folder;  // of the built page; empty: the installed one, or the source tree's
};

// Folder of the page's built files: the user's, the one installed with the program, or the source
// tree's.
Result<fs::path> page_folder(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code ignored;
  const fs::path program = program_path();
  for (const fs::path& folder : {program.parent_path().parent_path() / "share/shigusa/studio",
                                 fs::path(SHIGUSA_STUDIO_BUILT)}) {
    if (fs::is_regular_file(folder / "index.html", ignored)) return folder;
  }
  return fail(ErrorCode::not_found,
              "the page is not built: run scripts/build_studio in the project's folder, which "
              "takes some eight "
              "minutes, and install again what is installed; or tell the folder of a built page by "
              "--folder",
              "studio");
}

Result<int> studio(const StudioOptions& options) {
  SHG_TRY_ASSIGN(const fs::path folder, page_folder(options.folder));
  SHG_TRY_ASSIGN(Page page, with_hint(read_page(folder), "; scripts/build_studio builds the page"));
  block_ends();
  PageServer server(std::move(page));
  SHG_TRY(server.start(options.port));
  const std::string address = fmt::format("http://127.0.0.1:{}/", server.port());
  print_out("{}\n", address);
  std::fflush(stdout);
  print_err("shigusa studio: open this address; Ctrl-C ends it\n");
  if (options.open) open_browser(address);
  wait_for_end();
  return kDone;
}

}  // namespace

void add_studio(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<StudioOptions>();
  StudioOptions& o = *options;
  CLI::App* c = app.add_subcommand(
      "studio",
      "Open the studio, a page for the browser\nThe page is served to this machine alone.");
  c->group(kMore)->footer("shigusa studio\nshigusa studio --port 8080 --no-open");
  const std::string page = "The page";
  describe(c->add_option("--port", o.port)->check(whole_number(0, 65535)),
           {.group = page, .brief = "Port (default 0: any that is free)", .form = "N"});
  describe(c->add_flag("!--no-open", o.open),
           {.group = page, .brief = "Do not open a browser; the address is printed"});
  describe(c->add_option("--folder", o.folder),
           {.group = page,
            .brief = "Folder of the built page (default: the installed one)",
            .form = "FOLDER",
            .rare = true});
  c->callback([options, &exit_code] { exit_code = exit_code_of(studio(*options)); });
}

}  // namespace shigusa::app
