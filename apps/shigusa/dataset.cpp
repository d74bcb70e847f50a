// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <shigusa/dataset.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/limb_cache.hpp>

#include "commands.hpp"
#include "paced_line.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

struct ShardRange {
  std::uint64_t first = 0;
  std::optional<std::uint64_t> last{};
};

std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc{} || stop != end) return std::nullopt;
  return value;
}

// "FIRST:LAST", either of which may be missing, or all shards where the text is empty.
Result<ShardRange> parse_shards(const std::string& text, std::uint64_t shards) {
  ShardRange range;
  if (text.empty()) return range;
  const std::size_t colon = text.find(':');
  const std::string first = text.substr(0, colon);
  const std::string last = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto begin = first.empty() ? std::uint64_t{0} : whole(first);
  const auto end = last.empty() ? shards : whole(last);
  if (colon == std::string::npos || !begin || !end || *begin >= *end || *end > shards) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is FIRST:LAST with FIRST < LAST, and the plan has {} "
                            "shards: 0:{} is all of them",
                            text.substr(0, 80), shards, shards),
                "--shards");
  }
  return ShardRange{*begin, end};
}

// "K/N" with K < N.
Result<ShardRange> parse_part(const std::string& text, std::uint64_t shards) {
  constexpr std::uint64_t kMostParts = 1'000'000;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::uint64_t part = whole(std::string_view(text).substr(0, slash)).value_or(kMostParts);
  const std::uint64_t parts =
      slash < text.size() ? whole(std::string_view(text).substr(slash + 1)).value_or(0) : 0;
  if (parts > kMostParts || part >= parts) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed is K/N with K from 0 to N - 1 and N up to {}",
                            text.substr(0, 80), kMostParts),
                "--part");
  }
  return ShardRange{part * shards / parts, (part + 1) * shards / parts};
}

// "3 h 25 min", "12 s".
std::string time_words(double seconds) {
  const auto whole_seconds = static_cast<std::int64_t>(seconds + 0.5);
  if (whole_seconds >= 86400) {
    return fmt::format("{} d {} h", whole_seconds / 86400, whole_seconds / 3600 % 24);
  }
  if (whole_seconds >= 3600) {
    return fmt::format("{} h {} min", whole_seconds / 3600, whole_seconds / 60 % 60);
  }
  if (whole_seconds >= 60) {
    return fmt::format("{} min {} s", whole_seconds / 60, whole_seconds % 60);
  }
  return fmt::format("{} s", whole_seconds);
}

std::string report_line(const DatasetReport& now) {
  const double rate = now.seconds > 0.0 ? static_cast<double>(now.tasks) / now.seconds : 0.0;
  std::string text = fmt::format("{} of {} tasks, {} motions", now.tasks, now.of, now.motions);
  if (rate > 0.0) {
    text += fmt::format(", {:.1f} tasks/s, {} left", rate,
                        time_words(static_cast<double>(now.of - now.tasks) / rate));
  }
  return text;
}

std::function<void(const DatasetReport&)> reporter() {
  return [line = PacedLine()](const DatasetReport& now) mutable {
    if (line.is_due()) line.show(report_line(now));
  };
}

Result<int> one_task(const DatasetPlan& plan, const DatasetOptions& options) {
  const std::uint64_t number = *options.task;
  if (number >= plan.tasks()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {}; the plan has tasks 0 to {}", number, plan.tasks() - 1),
                "--task");
  }
  SHG_TRY_ASSIGN(DrawnTask drawn, plan.task(number));
  SHG_TRY_ASSIGN(Task task, make_task(drawn.file, {}));
  SHG_TRY_ASSIGN(const ExportSettings settings,
                 export_settings(options.files, drawn.file.character,
                                 {.formats = usual_formats(drawn.file.character)}));
  task.batch.threads = options.threads;
  task.layers.store = limb_store();
  SHG_TRY(prepare_folder(options.folder));
  const auto begin = std::chrono::steady_clock::now();
  SHG_TRY_ASSIGN(const GenerateResult generation, generate(task, terminal_progress()));
  end_progress_line();
  return deliver({drawn.file, task, generation, search_info(task, begin)},
                 {.folder = options.folder, .settings = settings, .json = options.json});
}

}  // namespace

Result<int> dataset(const DatasetOptions& options) {
  if (options.plan.empty()) {
    return fail(ErrorCode::invalid_argument,
                "give a plan: shigusa dataset PLAN.json --out FOLDER (docs/data.md)", "dataset");
  }
  SHG_TRY_ASSIGN(const DatasetPlan plan, DatasetPlan::read(options.plan));
  if (options.check_plan) {
    print_out("{} tasks in {} shards of {}\n", plan.tasks(), plan.shards(), plan.shard_tasks());
    return kDone;
  }
  if (options.folder.empty()) {
    return fail(ErrorCode::invalid_argument, "give a folder for the data set", "--out");
  }
  if (options.task) return one_task(plan, options);
  SHG_TRY_ASSIGN(const ShardRange shards, options.part.empty()
                                              ? parse_shards(options.shards, plan.shards())
                                              : parse_part(options.part, plan.shards()));
  DatasetSettings settings{.folder = options.folder,
                           .first_shard = shards.first,
                           .last_shard = shards.last,
                           .threads = options.threads,
                           .report = reporter(),
                           .cancel = &interrupted()};
  if (options.simd) {
    SHG_TRY_ASSIGN(settings.simd, simd_named(*options.simd));
  }
  SHG_TRY(prepare_folder(options.folder));
  SHG_TRY(keep_plan(plan, options.folder));
  SHG_TRY(write_first_card(plan, options.folder, "shigusa " SHIGUSA_VERSION));
  SHG_TRY_ASSIGN(const DatasetRun run, make_dataset(plan, settings));
  end_progress_line();
  print_out("{} shards made, {} were there: {} tasks, {} motions in {}", run.made, run.there,
            run.tasks, run.motions, time_words(run.seconds));
  if (run.thread_seconds > 0.0) {
    print_out("; {:.1f} motions/s and core, {:.0f} % of it search",
              static_cast<double>(run.motions) / run.thread_seconds,
              100.0 * run.search_seconds / run.thread_seconds);
  }
  print_out("\n");
  if (run.left > 0) {
    note("stopped", fmt::format("{} shards are left; the same command goes on", run.left));
  }
  return run.left > 0 ? kUnreachable : kDone;
}

}  // namespace shigusa::app
