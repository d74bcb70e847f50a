// SPDX-License-Identifier: MIT
// Commands in the place of those that this build does not have, which say what it lacks.
#include "commands.hpp"
#include "usage.hpp"

namespace shigusa::app {

#if !defined(SHIGUSA_HAS_STUDIO) || !defined(SHIGUSA_HAS_DATASETS)
namespace {

void add_lacking(CLI::App& app, int& exit_code, const char* name, const char* what,
                 const char* library) {
  CLI::App* c = app.add_subcommand(name, fmt::format("{}: not in this build", what));
  c->group(kMore)->allow_extras();
  c->callback([=, &exit_code] {
    exit_code = exit_code_of(
        fail(ErrorCode::unsupported,
             fmt::format("is not in this build of shigusa, which has no {}; Debian's package and "
                         "the container image have it",
                         library),
             name));
  });
}

}  // namespace
#endif

#ifndef SHIGUSA_HAS_STUDIO
void add_studio(CLI::App& app, int& exit_code) {
  add_lacking(app, exit_code, "studio", "Open the studio, a page for the browser", "libmicrohttpd");
}
#endif

#ifndef SHIGUSA_HAS_DATASETS
void add_dataset(CLI::App& app, int& exit_code) {
  add_lacking(app, exit_code, "dataset", "Make data sets of motions", "HDF5");
}
#endif

}  // namespace shigusa::app
