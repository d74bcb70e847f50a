// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <shigusa/project/replay.hpp>
#include <utility>

#include "commands.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

// The folder that the edit goes to; one that the user gives, or else "edit-1", "edit-2", … or
// "mirror-1", … beside the result. An edit never writes over what it started from.
Result<std::filesystem::path> edit_folder(const EditOptions& options) {
  const std::filesystem::path result = options.result;
  std::error_code ignored;
  const auto base = std::filesystem::is_directory(result, ignored) ? result : result.parent_path();
  const std::filesystem::path out = options.out;
  if (!out.empty() && !std::filesystem::equivalent(out, base.empty() ? "." : base, ignored)) {
    return out;
  }
  if (!out.empty()) {
    return fail(ErrorCode::invalid_argument,
                "is the result's own folder, which an edit never writes over; give another",
                "--out " + options.out);
  }
  for (int k = 1;; ++k) {
    const auto folder = base / fmt::format("{}-{}", options.mirror ? "mirror" : "edit", k);
    if (!std::filesystem::exists(folder, ignored)) return folder;
  }
}

}  // namespace

int edit(const EditOptions& options) {
  if (const auto formats = parse_formats(options.formats.value_or("")); !formats) {
    return report(formats.error());
  }
  const Result<std::filesystem::path> folder = edit_folder(options);
  if (!folder) return report(folder.error());
  Result<StoredResult> stored = read_result(options.result);
  if (!stored) return report(stored.error());
  if (options.mirror) {
    if (const auto done = mirror_result(*stored); !done) return report(done.error());
  }
  const Result<Task> task = make_task(stored->task, {});
  if (!task) return report(task.error());
  if (options.character) {
    const auto attached = attach_file(stored->task.character, *options.character);
    if (!attached) return report(attached.error());
  }
  const Result<ExportSettings> settings =
      export_settings(options.formats, options.one_file, stored->task.character);
  if (!settings) return report(settings.error());
  const auto begin = std::chrono::steady_clock::now();
  const Result<Generation> generation =
      replay(*task, *stored, options.candidate, options.assignments);
  if (!generation) {
    const Error& error = generation.error();
    const auto& given = options.assignments;
    const bool by_call = std::find(given.begin(), given.end(), error.place) != given.end();
    const std::string place = error.place.empty() ? options.result : error.place;
    return report({error.code, error.message, (by_call ? "--set " : "") + place});
  }
  RunInfo info{.search = options.mirror ? "mirror" : "edit"};
  info.elapsed_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (const auto ready = prepare_folder(*folder); !ready) return report(ready.error());
  return deliver(*folder, stored->task, *task, *generation, info, *settings, options.json);
}

}  // namespace shigusa::app
