// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/dataset_show.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "files/file.hpp"
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
  c->group(kOfDataset)->footer("shigusa dataset show motions --out motions.html");
  describe(c->add_option("folder", options->folder)->required(),
           {.brief = "Folder of the data set", .form = "FOLDER"});
  const std::string output = heading(OptionGroup::output);
  describe(c->add_option("--out", options->out),
           {.group = output,
            .brief = fmt::format("The page, which needs no other file (default {})", options->out),
            .form = "FILE"});
  describe(c->add_option("--motions", options->motions)->check(whole_number(0, kShownMax)),
           {.group = output,
            .brief = fmt::format("Motions that are drawn (default {})", options->motions),
            .form = "N"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_show(*options)); });
}

}  // namespace shigusa::app
