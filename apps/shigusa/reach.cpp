// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <shigusa/core/names.hpp>
#include <shigusa/core/parallel.hpp>
#include <shigusa/project/limb_cache.hpp>

#include "commands.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

// "NAME=1,2.5,-3": a name with so many numbers.
struct Named {
  std::string name;
  std::vector<double> numbers;
};
std::optional<Named> parse_named(const std::string& text, std::size_t count) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) return std::nullopt;
  Named named{text.substr(0, equals), {}};
  const char* at = text.data() + equals + 1;
  const char* end = text.data() + text.size();
  while (named.numbers.size() < count) {
    double& number = named.numbers.emplace_back();
    if (at < end && *at == '+') ++at;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code == std::errc::invalid_argument || next == at) return std::nullopt;
    // too large or too small for a double: infinity or 0, and ranges are told where they are known
    if (code == std::errc::result_out_of_range) {
      number = std::strtod(std::string(at, next).c_str(), nullptr);
    }
    const bool last = named.numbers.size() == count;
    if (last ? next != end : next == end || *next != ',') return std::nullopt;
    at = next + 1;
  }
  return named;
}

tl::unexpected<Error> misread(const char* option, const std::string& text, const char* form) {
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} '{}' is not {}", option, text.substr(0, 80), form));
}

Result<Goal> parse_goal(const std::string& text) {
  const auto goal = parse_named(text, 3);
  if (!goal) return misread("--goal", text, "EFFECTOR=X,Y,Z with three numbers in metres");
  return Goal{goal->name, {goal->numbers[0], goal->numbers[1], goal->numbers[2]}};
}

// The load goes to the effector's goal, wherever that was given.
Result<void> apply_load(const std::string& text, TaskFile& file) {
  const auto load = parse_named(text, 1);
  if (!load) return misread("--load", text, "EFFECTOR=KILOGRAMS");
  for (Goal& goal : file.goals) {
    if (goal.effector != load->name) continue;
    goal.load = load->numbers[0];
    return {};
  }
  return fail(ErrorCode::invalid_argument,
              "--load is for an effector with a goal, and " + load->name + " has none");
}

Result<Obstacle> parse_obstacle(const std::string& text) {
  const auto box = parse_named(text, 6);
  if (!box) {
    return misread("--obstacle", text,
                   "NAME=X,Y,Z,SX,SY,SZ: a box's middle and its size in metres");
  }
  const std::vector<double>& n = box->numbers;
  return Obstacle{.name = box->name, .position = {n[0], n[1], n[2]}, .size = {n[3], n[4], n[5]}};
}

// One of the words that are allowed, or an error that names them.
Result<std::size_t> pick(const char* what, const std::string& word,
                         const std::vector<std::string>& allowed) {
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (allowed[i] == word) return i;
  }
  return fail(ErrorCode::invalid_argument, unknown_name(what, word, allowed));
}

// How the search is computed; changes no result.
Result<BatchSettings> batch_settings(const ReachOptions& options) {
  BatchSettings batch;
  batch.threads = options.threads;
  if (!options.simd) return batch;
  std::vector<std::string> names;
  for (const SimdSet set : usable_simd_sets()) names.emplace_back(simd_name(set));
  const Result<std::size_t> picked =
      pick("SIMD set, or one that this machine lacks,", *options.simd, names);
  if (!picked) return tl::unexpected(picked.error());
  batch.simd = usable_simd_sets()[*picked];
  return batch;
}

Result<void> apply_words(const ReachOptions& options, TaskFile& file) {
  std::vector<std::string> mixtures;
  for (const CriteriaPreset& preset : criteria_presets()) mixtures.emplace_back(preset.name);
  std::vector<std::string> preset_names;
  for (const Preset preset : presets()) preset_names.emplace_back(preset_name(preset));
  std::vector<std::string> readings;
  for (const LayerReading reading : layer_readings()) {
    readings.emplace_back(layer_reading_name(reading));
  }
  std::vector<std::string> searches;
  for (const SearchMethod method : kSearchMethods) searches.emplace_back(search_name(method));
  const struct {
    const char* what;
    const std::optional<std::string>& given;
    std::vector<std::string> allowed;
  } words[] = {{"preset", options.preset, preset_names},
               {"layer reading", options.layer_reading, readings},
               {"criteria", options.criteria, mixtures},
               {"search", options.search, searches},
               {"generator", options.generator, {"weighted_ik", "nlp_ik"}}};
  for (const auto& word : words) {
    if (!word.given) continue;
    if (const auto known = pick(word.what, *word.given, word.allowed); !known) {
      return tl::unexpected(known.error());
    }
  }
  for (const Preset preset : presets()) {
    if (options.preset != preset_name(preset) || preset == file.preset) continue;
    // with its own criteria and number of candidates
    file.preset = preset;
    file.criteria = preset_criteria(preset);
    if (!options.candidates) file.candidates = preset_candidates(preset);
  }
  if (options.layer_reading && !preset_layers(file.preset)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is of the presets layers and human, and the preset is {}",
                            preset_name(file.preset)),
                "--layer-reading");
  }
  for (const LayerReading reading : layer_readings()) {
    if (options.layer_reading == layer_reading_name(reading)) file.layer_reading = reading;
  }
  if (options.search) file.search = search_method(*options.search);
  if (options.pareto) {
    file.pareto = true;
    file.criteria = pareto_criteria();
  }
  for (const MotionGenerator generator : {MotionGenerator::weighted_ik, MotionGenerator::nlp_ik}) {
    if (options.generator == generator_name(generator)) file.generator = generator;
  }
  for (const CriteriaPreset& preset : criteria_presets()) {
    if (options.criteria == preset.name) file.criteria = preset.settings();
  }
  return {};
}

Result<void> apply_options(const ReachOptions& options, TaskFile& file) {
  if (options.character) {
    file.character = {};
    file.character.source = *options.character;
  }
  if (const auto applied = apply_character_options(options.person, file.character); !applied) {
    return applied;
  }
  if (options.duration) file.duration = *options.duration;
  if (options.seed) file.seed = *options.seed;
  if (options.candidates) file.candidates = *options.candidates;
  if (options.phases) file.phases = *options.phases;
  if (options.evaluations) file.evaluations = *options.evaluations;
  for (const std::string& assignment : options.fixed) file.fixed.push_back(assignment);
  if (!options.goals.empty()) file.goals.clear();
  for (const std::string& text : options.goals) {
    Result<Goal> goal = parse_goal(text);
    if (!goal) return tl::unexpected(goal.error());
    file.goals.push_back(std::move(*goal));
  }
  for (const std::string& text : options.loads) {
    if (const auto applied = apply_load(text, file); !applied) return applied;
  }
  for (const std::string& text : options.obstacles) {
    Result<Obstacle> obstacle = parse_obstacle(text);
    if (!obstacle) return tl::unexpected(obstacle.error());
    file.obstacles.push_back(std::move(*obstacle));
  }
  return apply_words(options, file);
}

// Where the goals stand in the task file, an error about them names it.
Error in_task(const Error& error, const ReachOptions& options) {
  if (options.task.empty() || !options.goals.empty()) return error;
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

int reach(const ReachOptions& options) {
  if (const auto formats = parse_formats(options.formats.value_or("")); !formats) {
    return report(formats.error());
  }
  const Result<BatchSettings> batch = batch_settings(options);
  if (!batch) return report(batch.error());
  Result<TaskFile> file = options.task.empty() ? TaskFile{} : read_task(options.task);
  if (!file) return report(file.error());
  if (const auto applied = apply_options(options, *file); !applied) {
    return report(applied.error());
  }
  // a character named on the command line is looked for from where the command is given
  const auto folder = options.character || options.task.empty()
                          ? std::filesystem::path{}
                          : std::filesystem::path(options.task).parent_path();
  Result<Task> task = make_task(*file, folder);
  if (!task) return report(task.error());
  const Result<ExportSettings> settings =
      export_settings(options.formats, options.one_file, file->character);
  if (!settings) return report(settings.error());
  task->batch = *batch;
  task->layers.store = limb_store();
  if (const auto problem = make_problem(*task); !problem) {
    return report(in_task(problem.error(), options));
  }
  note_goals_below_floor(*task);
  if (const auto ready = prepare_folder(options.out); !ready) return report(ready.error());
  const auto begin = std::chrono::steady_clock::now();
  Progress progress = terminal_progress();
  if (options.seconds) {
    progress.deadline = begin + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                    std::chrono::duration<double>(*options.seconds));
  }
  const Result<Generation> generation = generate(*task, progress);
  end_progress_line();
  if (!generation) return report(generation.error());
  RunInfo info;
  info.search = search_name(task->search.value_or(preset_search(task->preset)));
  info.threads = thread_count(batch->threads);
  info.simd = simd_name(batch->simd);
  info.elapsed_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return deliver(options.out, *file, *task, *generation, info, *settings, options.json);
}

}  // namespace shigusa::app
