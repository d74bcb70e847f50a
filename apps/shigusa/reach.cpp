// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <shigusa/limb_cache.hpp>
#include <shigusa/parallel.hpp>
#include <shigusa/words.hpp>

#include "commands.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

// How the search is computed; changes no result.
Result<BatchSettings> batch_settings(const ReachOptions& options) {
  BatchSettings batch;
  batch.threads = options.threads;
  if (options.simd) {
    SHG_TRY_ASSIGN(batch.simd, simd_named(*options.simd));
  }
  return batch;
}

Result<void> apply_options(const ReachOptions& options, TaskFile& file) {
  if (options.character) {
    file.character = {};
    file.character.source = *options.character;
  }
  SHG_TRY(apply_character_options(options.person, file.character));
  auto applied = apply_task_options(options.asked, file);
  if (!applied || !options.asked.has("--layer-reading") || traits_of(file.preset).layers) {
    return applied;
  }
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("is of the presets layers and human, and the preset is {}", word_of(file.preset)),
      "--layer-reading");
}

// Where the goals stand in the task file, an error about them names it.
Error in_task(const Error& error, const ReachOptions& options) {
  if (options.task.empty() || options.asked.has("--goal")) return error;
  return {error.code, error.to_string(), std::filesystem::path(options.task).filename().string()};
}

// The feet know the floor; the hands do not.
void note_goals_below_floor(const Task& task) {
  for (const Goal& goal : task.goals) {
    if (goal.position.y >= 0.0) continue;
    note("goal of " + goal.effector,
         fmt::format("{:g} m below the floor: the hand goes through it", -goal.position.y));
  }
}

}  // namespace

Result<SimdSet> simd_named(const std::string& name) {
  std::vector<std::string> names;
  for (const SimdSet set : usable_simd_sets()) {
    if (name == simd_name(set)) return set;
    names.emplace_back(simd_name(set));
  }
  return fail(ErrorCode::invalid_argument,
              unknown_name("SIMD set, or one that this machine lacks,", name, names));
}

Result<int> reach(const ReachOptions& options) {
  SHG_TRY(parse_formats(options.files.formats.value_or("")));
  SHG_TRY_ASSIGN(const BatchSettings batch, batch_settings(options));
  SHG_TRY_ASSIGN(TaskFile file, options.task.empty() ? TaskFile{} : read_task(options.task));
  SHG_TRY(apply_options(options, file));
  // a character named on the command line is looked for from where the command is given
  const auto folder = options.character || options.task.empty()
                          ? std::filesystem::path{}
                          : std::filesystem::path(options.task).parent_path();
  const std::filesystem::path character =
      is_complete(file.character) ? std::filesystem::path{} : folder / file.character.source;
  SHG_TRY_ASSIGN(Task task, make_task(file, folder));
  SHG_TRY_ASSIGN(
      const ExportSettings settings,
      export_settings(options.files, file.character,
                      {.formats = usual_formats(file.character), .character = character}));
  task.batch = batch;
  task.layers.store = limb_store();
  if (const auto checked = check_task(task); !checked) {
    return tl::unexpected(in_task(checked.error(), options));
  }
  note_goals_below_floor(task);
  SHG_TRY(prepare_folder(options.out));
  const auto begin = std::chrono::steady_clock::now();
  Progress progress = terminal_progress();
  if (options.seconds) {
    progress.deadline = begin + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                    std::chrono::duration<double>(*options.seconds));
  }
  const Result<GenerateResult> generation = generate(task, progress);
  end_progress_line();
  if (!generation) return tl::unexpected(generation.error());
  return deliver({file, task, *generation, search_info(task, begin)},
                 {.folder = options.out, .settings = settings, .json = options.json});
}

}  // namespace shigusa::app
