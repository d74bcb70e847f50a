// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/dataset_show.hpp>
#include <shigusa/file.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct DatasetShowOptions {
  std::string folder;
  std::string out = "show.html";
  std::uint64_t motions = ShowSettings{}.motions;
};

Result<int> dataset_show(const DatasetShowOptions& options) {
  SHG_TRY_ASSIGN(const std::string page, show_dataset(options.folder, {.motions = options.motions,
                                                                       .cancel = &interrupted()}));
  SHG_TRY(write_file(options.out, page));
  print_out("{}\n", printable(options.out));
  return kDone;
}

}  // namespace

void add_dataset_show(CLI::App& dataset, int& exit_code) {
  const auto options = std::make_shared<DatasetShowOptions>();
  CLI::App* c = dataset.add_subcommand("show", "Show a data set as one page: motions and plots");
  c->add_option("folder", options->folder, "Folder of the data set")->required();
  c->add_option("--out", options->out, "The page (HTML), which needs no other file")
      ->capture_default_str();
  c->add_option("--motions", options->motions, "Motions that are drawn")
      ->check(whole_number(0, kShownMax))
      ->capture_default_str();
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_show(*options)); });
}

}  // namespace shigusa::app
