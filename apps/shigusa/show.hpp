// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace shigusa::app {

// Command that shows results as one page, and their first candidates as one picture.
void add_show(CLI::App& app, int& exit_code);

}  // namespace shigusa::app
