// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <shigusa/project/mirror.hpp>
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

// Makes all assignments to parameters; `of` is what tells their names.
template <class Names, class Edited>
Result<void> assign_all(const EditOptions& options, const Names& of, Edited& parameters) {
  for (const std::string& assignment : options.assignments) {
    if (const auto ok = assign_parameter(of, assignment, parameters); !ok) {
      return fail(ok.error().code, ok.error().message, "--set " + assignment);
    }
  }
  return {};
}

// The result's mirror image: task and parameters on the other side.
Result<void> mirror(StoredResult& stored) {
  const Result<BodyModel> body = build_body(stored.task);
  if (!body) return tl::unexpected(body.error());
  Result<TaskFile> image = mirrored(std::move(stored.task));
  if (!image) return tl::unexpected(image.error());
  stored.task = std::move(*image);
  const Result<Task> task = make_task(stored.task, {});
  if (!task) return tl::unexpected(task.error());
  for (Parameters& parameters : stored.candidates) {
    parameters = mirrored(*body, task->body, parameters);
  }
  for (LayeredParameters& parameters : stored.layered) {
    Result<LayeredParameters> other = mirrored(*task, parameters);
    if (!other) return tl::unexpected(other.error());
    parameters = std::move(*other);
  }
  return {};
}

// The candidate's motion anew, from what the assignments make of its parameters.
Result<Generation> edited(const EditOptions& options, StoredResult& stored, const Task& task) {
  const auto index = static_cast<std::size_t>(options.candidate - 1);
  if (!preset_layers(task.preset)) {
    Parameters& parameters = stored.candidates[index];
    if (const auto ok = assign_all(options, task.body, parameters); !ok) {
      return tl::unexpected(ok.error());
    }
    return regenerate(task, parameters);
  }
  const auto layers = layers_to_goals(task);
  if (!layers) return tl::unexpected(layers.error());
  LayeredParameters& parameters = stored.layered[index];
  if (const auto ok = assign_all(options, *layers, parameters); !ok) {
    return tl::unexpected(ok.error());
  }
  return regenerate(task, parameters);
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
  const auto count = static_cast<int>(stored->candidates.size() + stored->layered.size());
  if (options.candidate < 1 || options.candidate > count) {
    return report({ErrorCode::invalid_argument,
                   fmt::format("candidate {} does not exist; the result has the candidates 1 to {}",
                               options.candidate, count),
                   options.result});
  }
  if (options.mirror) {
    if (const auto done = mirror(*stored); !done) return report(done.error());
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
  const Result<Generation> generation = edited(options, *stored, *task);
  if (!generation) return report(generation.error());
  RunInfo info{.search = options.mirror ? "mirror" : "edit"};
  info.elapsed_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (const auto ready = prepare_folder(*folder); !ready) return report(ready.error());
  return deliver(*folder, stored->task, *task, *generation, info, *settings, options.json);
}

}  // namespace shigusa::app
