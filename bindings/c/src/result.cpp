// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <memory>
#include <shigusa/edit.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "criteria.hpp"
#include "document/facts.hpp"
#include "door.hpp"
#include "watch.hpp"

using namespace shigusa;
using namespace shigusa::door;

namespace {

// The moving page: `shigusa show` writes it from results, and it is no format of a motion.
constexpr std::string_view kPageFormat = "html";

// Replaces the task's character.
void put_character(const shigusa_character* character, TaskFile& file) {
  if (character != nullptr) file.character = character->spec;
}

// Files are never opened: a character that needs one must come from shigusa_character_create.
Result<Task> task_of(TaskFile& file) {
  if (!is_complete(file.character)) {
    return fail(ErrorCode::invalid_argument,
                "is of the file " + file.character.source + ": give the character by its bytes",
                "task: character");
  }
  return make_task(file, {});
}

Result<void> check_threads(int32_t threads) {
  if (threads >= 0 && threads <= kMaxThreads) return {};
  return fail(ErrorCode::invalid_argument,
              "threads are " + std::to_string(threads) + "; allowed are 0 (all cores) to 1024");
}

// A task of many with what came of it.
struct OneOfMany {
  TaskFile file{};
  Result<Task> task = fail(ErrorCode::cancelled, "was not begun");
  Result<GenerateResult> found = fail(ErrorCode::cancelled, "was not begun");
};

OneOfMany one_of_many(const shigusa_character* character, const char* text, size_t index) {
  OneOfMany one;
  const std::string name = "tasks[" + std::to_string(index) + "]";
  one.task = [&]() -> Result<Task> {
    SHG_TRY(need(name.c_str(), text));
    SHG_TRY_ASSIGN(one.file, parse_task(text, name));
    put_character(character, one.file);
    return task_of(one.file);
  }();
  return one;
}

// Tasks without actions beside each other, then each with actions.
void find_all(std::vector<OneOfMany>& all, int threads, const Progress& progress) {
  std::vector<Task> tasks;
  std::vector<size_t> places;
  for (size_t i = 0; i < all.size(); ++i) {
    if (!all[i].task) {
      all[i].found = tl::unexpected(all[i].task.error());
      continue;
    }
    all[i].task->batch.threads = threads;
    if (all[i].task->actions.empty()) {
      tasks.push_back(*all[i].task);
      places.push_back(i);
    }
  }
  std::vector<Result<GenerateResult>> found = generate_all(tasks, threads, progress);
  for (size_t k = 0; k < found.size(); ++k) all[places[k]].found = std::move(found[k]);
  for (OneOfMany& one : all) {
    if (!one.task || one.task->actions.empty() || progress.cancelled()) continue;
    one.found = perform(*one.task, progress);
  }
}

// All candidates of stored values as a result. Those without actions keep their player.
Result<void> replayed(StoredResult stored, const char* how, const Progress& progress,
                      shigusa_result** result) {
  SHG_TRY_ASSIGN(Task task, task_of(stored.task));
  const auto begin = std::chrono::steady_clock::now();
  std::optional<MotionPlayer> player;
  if (task.actions.empty()) {
    SHG_TRY_ASSIGN(player, MotionPlayer::of(task));
  }
  SHG_TRY_ASSIGN(GenerateResult generation, player ? replay_all(*player, stored, progress)
                                                   : replay_all(task, stored, progress));
  *result = new shigusa_result{std::move(stored.task), std::move(task), std::move(generation),
                               replay_info(how, begin), std::move(player)};
  return {};
}

// Player of a result's motions, made on first use.
Result<MotionPlayer*> player_of(const shigusa_result& result, TaskFile& file) {
  if (!result.player) {
    SHG_TRY_ASSIGN(Task task, task_of(file));
    SHG_TRY_ASSIGN(result.player, MotionPlayer::of(std::move(task)));
  }
  return &*result.player;
}

// One candidate of a piece of work after an edit.
Result<void> worked(const shigusa_result& result, int32_t candidate, const WorkEdit& edit,
                    const Progress& progress, shigusa_result** edited) {
  StoredResult stored = stored_result(result.file, result.generation);
  const auto begin = std::chrono::steady_clock::now();
  SHG_TRY_ASSIGN(GenerateResult whole, replay_work(result.task, stored, candidate, edit, progress));
  Task task = result.task;
  task.seed = stored.task.seed;
  *edited = new shigusa_result{std::move(stored.task), std::move(task), std::move(whole),
                               replay_info("edit", begin)};
  return {};
}

// Page of a candidate's moving figure; 0: of all candidates.
Result<std::string> page_of(const shigusa_result& result, int32_t candidate) {
#ifdef __EMSCRIPTEN__
  // it would make the module of a browser, which draws figures itself, 80 kB larger
  (void)result, (void)candidate;
  return fail(ErrorCode::unsupported, "this build writes no page");
#else
  const auto page = [&result](const GenerateResult& of) {
    const ShownResult shown{result.task, of};
    return motion_page({&shown, 1});
  };
  if (candidate == 0) return page(result.generation);
  GenerateResult one = result.generation;
  one.candidates = {one.candidates[static_cast<size_t>(candidate - 1)]};
  return page(one);
#endif
}

// Fails if the result has no candidate of that number.
Result<void> check_candidate(const shigusa_result& result, int32_t candidate) {
  const size_t count = result.generation.candidates.size();
  if (candidate >= 1 && static_cast<size_t>(candidate) <= count) return {};
  return fail(ErrorCode::invalid_argument,
              "candidate " + std::to_string(candidate) +
                  " does not exist; the result has the candidates 1 to " + std::to_string(count));
}

}  // namespace

extern "C" {

shigusa_status shigusa_generate(const shigusa_character* character, const char* task,
                                int32_t threads, const shigusa_watch* watch,
                                shigusa_result** result) {
  return shigusa_generate_by(character, task, nullptr, 0, threads, watch, result);
}

shigusa_status shigusa_generate_by(const shigusa_character* character, const char* task,
                                   const shigusa_criterion* criteria, size_t count, int32_t threads,
                                   const shigusa_watch* watch, shigusa_result** result) {
  return guarded_watched([&](const OwnArithmetic& arithmetic) -> Result<void> {
    SHG_TRY(need("task", task, "result", result));
    if (count > 0) SHG_TRY(need("criteria", criteria));
    SHG_TRY(check_threads(threads));
    SHG_TRY_ASSIGN(TaskFile file, parse_task(task, "task"));
    put_character(character, file);
    SHG_TRY_ASSIGN(Task asked, task_of(file));
    asked.batch.threads = threads;
    Watched watched(watch, arithmetic);
    SHG_TRY(add_criteria(criteria, count, watched, asked.criteria));
    const auto begin = std::chrono::steady_clock::now();
    Result<GenerateResult> found = asked.actions.empty() ? generate(asked, watched.progress())
                                                         : perform(asked, watched.progress());
    watched.pass_on();
    SHG_TRY_ASSIGN(GenerateResult generation, std::move(found));
    RunInfo info = search_info(asked, begin);
    asked.criteria.user.clear();
    *result = new shigusa_result{std::move(file), std::move(asked), std::move(generation),
                                 std::move(info)};
    return {};
  });
}

shigusa_status shigusa_generate_all(const shigusa_character* character, const char* const* tasks,
                                    size_t count, int32_t threads, const shigusa_watch* watch,
                                    shigusa_result** results, shigusa_bytes** failures) {
  return guarded_watched([&](const OwnArithmetic& arithmetic) -> Result<void> {
    SHG_TRY(need("tasks", tasks, "results", results, "failures", failures));
    SHG_TRY(check_threads(threads));
    std::vector<OneOfMany> all;
    for (size_t i = 0; i < count; ++i) all.push_back(one_of_many(character, tasks[i], i));
    Watched watched(watch, arithmetic);
    const auto begin = std::chrono::steady_clock::now();
    find_all(all, threads, watched.progress());
    watched.pass_on();
    std::vector<std::unique_ptr<shigusa_result>> made(count);
    std::string told = "[";
    for (size_t i = 0; i < count; ++i) {
      auto& [file, task, found] = all[i];
      told += i == 0 ? "" : ", ";
      told += found ? "null" : format_failure(found.error());
      if (!found) continue;
      RunInfo info = search_info(*task, begin);
      made[i].reset(new shigusa_result{std::move(file), std::move(*task), std::move(*found),
                                       std::move(info)});
    }
    SHG_TRY(give(told + "]", failures));
    for (size_t i = 0; i < count; ++i) results[i] = made[i].release();
    return {};
  });
}

shigusa_status shigusa_result_of_angles(const shigusa_character* character, const char* task,
                                        const double* angles, size_t frames, size_t columns,
                                        double fps, shigusa_result** result) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("angles", angles, "result", result));
    SHG_TRY(check_rate(fps, "fps"));
    TaskFile file;
    if (task != nullptr) {
      SHG_TRY_ASSIGN(file, parse_task(task, "task"));
    }
    put_character(character, file);
    file.goals.clear();
    SHG_TRY_ASSIGN(Task given, task_of(file));
    const auto begin = std::chrono::steady_clock::now();
    const size_t most = kFrameMax + 1;
    Clip clip{.dofs = static_cast<int>(std::min(columns, most)),
              .frames = static_cast<int>(std::min(frames, most)),
              .frame_time = 1.0 / fps,
              .angles = {}};
    if (frames <= most && columns == static_cast<size_t>(given.body.dof_count())) {
      clip.angles.assign(angles, angles + frames * columns);
    }
    SHG_TRY_ASSIGN(GenerateResult generation, given_motion(given, std::move(clip)));
    *result = new shigusa_result{std::move(file), std::move(given), std::move(generation),
                                 replay_info("angles", begin)};
    return {};
  });
}

shigusa_status shigusa_restore(const shigusa_character* character, const char* summary,
                               shigusa_result** result) {
  return shigusa_restore_watched(character, summary, nullptr, result);
}

shigusa_status shigusa_restore_watched(const shigusa_character* character, const char* summary,
                                       const shigusa_watch* watch, shigusa_result** result) {
  return guarded_watched([&](const OwnArithmetic& arithmetic) -> Result<void> {
    SHG_TRY(need("summary", summary, "result", result));
    SHG_TRY_ASSIGN(StoredResult stored, parse_result(summary, "result"));
    if (character != nullptr && character->spec.rig) {
      SHG_TRY(attach_rig(stored.task.character, character->spec));
    }
    Watched watched(watch, arithmetic);
    Result<void> done = replayed(std::move(stored), "restore", watched.progress(), result);
    watched.pass_on();
    return done;
  });
}

shigusa_status shigusa_replay(const shigusa_result* result, int32_t candidate,
                              const char* assignments, shigusa_result** edited) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "edited", edited));
    SHG_TRY_ASSIGN(const auto changes,
                   parse_assignments(assignments == nullptr ? "[]" : assignments, "assignments"));
    if (!result->task.actions.empty()) {
      return worked(*result, candidate, {.assignments = changes}, {}, edited);
    }
    StoredResult stored = stored_result(result->file, result->generation);
    const auto begin = std::chrono::steady_clock::now();
    SHG_TRY_ASSIGN(MotionPlayer * player, player_of(*result, stored.task));
    SHG_TRY_ASSIGN(GenerateResult generation, replay(*player, stored, candidate, changes));
    *edited = new shigusa_result{std::move(stored.task), player->task(), std::move(generation),
                                 replay_info("edit", begin)};
    return {};
  });
}

shigusa_status shigusa_replay_work(const shigusa_result* result, int32_t candidate,
                                   const char* edit, const shigusa_watch* watch,
                                   shigusa_result** edited) {
  return guarded_watched([&](const OwnArithmetic& arithmetic) -> Result<void> {
    SHG_TRY(need("result", result, "edited", edited));
    SHG_TRY_ASSIGN(const WorkEdit parsed, parse_work_edit(edit == nullptr ? "{}" : edit, "edit"));
    Watched watched(watch, arithmetic);
    Result<void> done = worked(*result, candidate, parsed, watched.progress(), edited);
    watched.pass_on();
    return done;
  });
}

shigusa_status shigusa_mirror(const shigusa_result* result, shigusa_result** mirrored) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "mirrored", mirrored));
    StoredResult stored = stored_result(result->file, result->generation);
    SHG_TRY(mirror_result(stored));
    return replayed(std::move(stored), "mirror", {}, mirrored);
  });
}

void shigusa_result_free(shigusa_result* result) { delete result; }

int32_t shigusa_result_candidates(const shigusa_result* result) {
  return result == nullptr ? 0 : static_cast<int32_t>(result->generation.candidates.size());
}

shigusa_status shigusa_result_describe(const shigusa_result* result, shigusa_bytes** json) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "json", json));
    return give(format_result({result->file, result->task, result->generation, result->info}),
                json);
  });
}

shigusa_status shigusa_result_parameters(const shigusa_result* result, int32_t candidate,
                                         shigusa_bytes** json) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "json", json));
    SHG_TRY(check_candidate(*result, candidate));
    const GenerateResult& generation = result->generation;
    const Candidate& of = generation.candidates[static_cast<size_t>(candidate - 1)];
    return give(format_parameters(editable_parameters(*generation.parameters, of.parameters)),
                json);
  });
}

shigusa_status shigusa_result_action_parameters(const shigusa_result* result, int32_t candidate,
                                                int32_t action, shigusa_bytes** json) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "json", json));
    SHG_TRY(check_candidate(*result, candidate));
    const GenerateResult& generation = result->generation;
    const Candidate& of = generation.candidates[static_cast<size_t>(candidate - 1)];
    return give(format_parameters(action_parameters(*generation.parameters, of, action)), json);
  });
}

shigusa_status shigusa_result_export(const shigusa_result* result, int32_t candidate,
                                     const char* format, shigusa_bytes** file) {
  return shigusa_result_export_with(result, candidate, format, nullptr, file);
}

shigusa_status shigusa_result_export_with(const shigusa_result* result, int32_t candidate,
                                          const char* format, const char* options,
                                          shigusa_bytes** file) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "format", format, "file", file));
    SHG_TRY_ASSIGN(FileSettings settings, parse_file_settings(options == nullptr ? "{}" : options,
                                                              "options", {.animation = {}}));
    if (std::string_view(format) == kPageFormat) {
      if (candidate != 0) SHG_TRY(check_candidate(*result, candidate));
      SHG_TRY_ASSIGN(std::string page, page_of(*result, candidate));
      return give(std::move(page), file);
    }
    SHG_TRY_ASSIGN(const auto formats, parse_formats(format));
    if (formats.size() != 1) return fail(ErrorCode::invalid_argument, "one format at a time");
    const auto& all = result->generation.candidates;
    if (candidate == 0) {
      if (formats.front() != FileFormat::glb) {
        return fail(ErrorCode::invalid_argument, "all candidates in one file are a glb or html");
      }
      SHG_TRY_ASSIGN(std::string bytes,
                     export_all(result->file.character, result->task, all, settings));
      return give(std::move(bytes), file);
    }
    SHG_TRY(check_candidate(*result, candidate));
    const auto rank = static_cast<size_t>(candidate);
    const CharacterSpec& character = result->file.character;
    settings.animation = settings.animation.empty() ? candidate_animation(character, rank)
                                                    : free_animation(character, settings.animation);
    SHG_TRY_ASSIGN(std::string bytes, export_candidate(result->file.character, result->task,
                                                       all[rank - 1], formats.front(), settings));
    return give(std::move(bytes), file);
  });
}

}  // extern "C"
