// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/dataset_check.hpp>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "paced_line.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct CheckOptions {
  std::string folder;
  double share = CheckSettings{}.share;
  int threads = 0;
};

Result<int> dataset_check(const CheckOptions& options) {
  PacedLine line;
  const auto report = [&line](const CheckReport& now) {
    if (!line.is_due()) return;
    line.show(fmt::format("{} of {} shards, {} tasks made again, {} problems", now.shards, now.of,
                          now.replayed, now.problems));
  };
  SHG_TRY_ASSIGN(const CheckRun run, check_dataset(options.folder, {.share = options.share,
                                                                    .threads = options.threads,
                                                                    .report = report,
                                                                    .cancel = &interrupted()}));
  end_progress_line();
  for (const DatasetProblem& problem : run.problems) {
    print_out("{}: {}\n", printable(problem.file), printable(problem.says));
  }
  if (run.problem_count > run.problems.size()) {
    print_out("and {} more\n", run.problem_count - run.problems.size());
  }
  if (!run.missing.empty()) note("not there", missing_shards_text(run.missing));
  if (!run.index) note("index", "there is none: shigusa dataset merge makes it");
  print_out("{} shards, {} bytes; {} tasks made again, {} motions; {}; in {:.1f} s\n", run.shards,
            run.bytes, run.replayed, run.motions,
            run.problem_count == 0 ? std::string("all as it should be")
                                   : fmt::format("{} problems", run.problem_count),
            run.seconds);
  return run.problem_count == 0 ? kDone : kWrongInput;
}

}  // namespace

void add_dataset_check(CLI::App& dataset, int& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CheckOptions& o = *options;
  CLI::App* c = dataset.add_subcommand(
      "check", "Check a data set: its bytes, and a share of its tasks by making them again");
  c->group(kOfDataset)
      ->footer("shigusa dataset check motions\nshigusa dataset check motions --share 0.2");
  describe(c->add_option("folder", o.folder)->required(),
           {.brief = "Folder of the data set", .form = "FOLDER"});
  const std::string group = "The check";
  describe(c->add_option("--share", o.share)->check(number(0.0, 1.0)),
           {.group = group,
            .brief = fmt::format("Of tasks that are made again, 0 to 1 (default {:g})", o.share),
            .full = fmt::format("Share of the tasks that are made again, 0 to 1; {:g} when not "
                                "given; at least one task is.",
                                o.share),
            .form = "SHARE"});
  describe(c->add_option("--threads", o.threads)->check(whole_number(0, kMaxThreads)),
           {.group = group,
            .brief = "Tasks that are made at once (default 0: one for each core)",
            .form = "N"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(dataset_check(*options)); });
}

}  // namespace shigusa::app
