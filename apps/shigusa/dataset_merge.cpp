// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/shigusa.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "paced_line.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

// Largest number of ranges of missing shards that are listed.
constexpr std::size_t kToldStretches = 10;

Result<int> dataset_merge(const std::string& folder) {
  PacedLine line;
  const auto report = [&line](const MergeReport& now) {
    if (line.is_due()) line.show(fmt::format("{} of {} shards read", now.shards, now.of));
  };
  SHG_TRY_ASSIGN(const MergeRun run, merge_dataset(folder, {.program = "shigusa " SHIGUSA_VERSION,
                                                            .report = report,
                                                            .cancel = &interrupted()}));
  end_progress_line();
  print_out("{}: {} shards, {} tasks, {} motions; {} bytes, in {:.1f} s\n",
            printable((std::filesystem::path(folder) / kIndexName).string()), run.shards, run.tasks,
            run.motions, run.bytes, run.seconds);
  if (!run.missing.empty()) note("not there", missing_shards_text(run.missing));
  if (!run.mapped) {
    note(kIndexName, fmt::format("has no virtual datasets, as there are more than {} shards: read "
                                 "the shards one by one",
                                 kMostMappedShards));
  }
  return kDone;
}

}  // namespace

std::string missing_shards_text(const std::vector<std::uint64_t>& missing) {
  std::string text = number_of(missing.size(), "shard") + ": ";
  std::size_t stretches = 0;
  for (std::size_t k = 0; k < missing.size();) {
    std::size_t last = k;
    while (last + 1 < missing.size() && missing[last + 1] == missing[last] + 1) ++last;
    if (stretches == kToldStretches) return text + ", …";
    text += stretches++ == 0 ? "" : ", ";
    text += last == k ? fmt::format("{}", missing[k])
                      : fmt::format("{} to {}", missing[k], missing[last]);
    k = last + 1;
  }
  return text;
}

void add_dataset_merge(CLI::App& dataset, int& exit_code) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* c = dataset.add_subcommand(
      "merge", "Write a data set's index (index.h5), statistics and data card (README.md)");
  c->group(kOfDataset)->footer("shigusa dataset merge motions");
  describe(c->add_option("folder", *folder)->required(),
           {.brief = "Folder of the data set", .form = "FOLDER"});
  c->callback([folder, &exit_code] { exit_code = exit_code_of(dataset_merge(*folder)); });
}

}  // namespace shigusa::app
