// SPDX-License-Identifier: MIT
#include "task_rows.hpp"

#include <chrono>
#include <shigusa/files.hpp>

#include "motion_table.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kNameSize = 32;
constexpr std::size_t kMessageSize = 160;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<std::string> status_words() {
  std::vector<std::string> words = all_words<ReachStatus>();
  words.emplace_back(kRefused);
  return words;
}

Column task_column() {
  return {.name = "task", .type = ElementType::u64, .says = "number of the task"};
}
Column name_column(std::string name, std::string says) {
  return {.name = std::move(name),
          .type = ElementType::text,
          .says = std::move(says),
          .text_size = kNameSize};
}
Column point_column(std::string name, std::string says) {
  return {.name = std::move(name), .shape = {3}, .unit = "m", .says = std::move(says)};
}

Table tasks_table() {
  return {kTasksTable,
          {task_column(),
           {.name = "person", .type = ElementType::u64, .says = "number of the person"},
           {.name = "status",
            .type = ElementType::u8,
            .says = "whether the goals are met",
            .words = status_words()},
           {.name = "motions", .type = ElementType::u16, .says = "that are kept of the task"},
           {.name = "seed", .type = ElementType::u64, .says = "of the search"},
           {.name = "evaluations", .type = ElementType::u64, .says = "motions that were scored"},
           name_column("character", "built-in body, or the file's name"),
           name_column("preset", ""),
           {.name = "stature_m", .unit = "m"},
           {.name = "mass_kg", .unit = "kg"},
           {.name = "sex", .type = ElementType::u8, .words = all_words<Sex>()},
           {.name = "seat_m", .unit = "m", .says = "height of the seat; NaN of who stands"},
           {.name = "duration_s", .unit = "s", .says = "of the motions"},
           {.name = "refused",
            .type = ElementType::text,
            .says = "why no motion can be asked for",
            .text_size = kMessageSize}}};
}

Table goals_table() {
  return {kGoalsTable,
          {task_column(),
           name_column("effector", "hand, foot or joint that is to get there"),
           point_column("position_m", "in the world"),
           {.name = "rotation_xyzw", .shape = {4}, .says = "NaN where any will do"},
           {.name = "axis", .shape = {3}, .says = "in the effector's frame; NaN without one"},
           {.name = "direction", .shape = {3}, .says = "of the axis, in the world"},
           point_column("tolerance_m", "half the sides of the box where any place will do"),
           {.name = "load_kg", .unit = "kg", .says = "in that hand"}}};
}

Table obstacles_table() {
  return {kObstaclesTable,
          {task_column(),
           name_column("name", ""),
           point_column("position_m", "its middle"),
           point_column("size_m", "along its own axes"),
           {.name = "radius_m", .unit = "m", .says = "of its round edges"},
           {.name = "rotation_xyzw", .shape = {4}}}};
}

Table missed_table() {
  return {kMissedTable,
          {task_column(),
           name_column("effector", ""),
           point_column("nearest_m", "where the best motion ends"),
           {.name = "error_m", .unit = "m", .says = "from the goal"},
           {.name = "turn_error_rad", .unit = "rad", .says = "of its turn; 0 where any will do"}}};
}

void add_goals(const MadeTask& made, const TaskFile& file, Table& goals) {
  for (const Goal& goal : file.goals) {
    const Vec3d none{kNoNumber, kNoNumber, kNoNumber};
    goals["task"].push_as(made.number);
    goals["effector"].push(std::string_view(goal.effector));
    goals["position_m"].push(goal.position);
    goals["rotation_xyzw"].push(
        goal.rotation.value_or(Quatd{kNoNumber, kNoNumber, kNoNumber, kNoNumber}));
    goals["axis"].push(goal.axis ? goal.axis->axis : none);
    goals["direction"].push(goal.axis ? goal.axis->direction : none);
    goals["tolerance_m"].push(goal.tolerance);
    goals["load_kg"].push(goal.load);
  }
}

void add_obstacles(const MadeTask& made, const TaskFile& file, Table& obstacles) {
  for (const Obstacle& obstacle : file.obstacles) {
    obstacles["task"].push_as(made.number);
    obstacles["name"].push(std::string_view(obstacle.name));
    obstacles["position_m"].push(obstacle.position);
    obstacles["size_m"].push(obstacle.size);
    obstacles["radius_m"].push(obstacle.radius);
    obstacles["rotation_xyzw"].push(obstacle.rotation);
  }
}

void add_missed(const MadeTask& made, const GenerateResult& generation, Table& missed) {
  if (generation.meets_goals()) return;
  for (const GoalResult& goal : generation.candidates.front().goals) {
    missed["task"].push_as(made.number);
    missed["effector"].push(std::string_view(goal.asked.effector));
    missed["nearest_m"].push(goal.reached);
    missed["error_m"].push(goal.error);
    missed["turn_error_rad"].push(goal.turn.error.value_or(0.0));
  }
}

// Fields of a task's row beyond its drawn values.
struct TaskOutcome {
  const Task* task = nullptr;
  const GenerateResult* generation = nullptr;
  std::string refused{};
};

void add_task(const MadeTask& made, const TaskOutcome& outcome, Table& tasks) {
  const TaskFile none;
  const TaskFile& file = made.drawn ? made.drawn->file : none;
  const GenerateResult* generation = outcome.generation;
  const CharacterSpec& who = file.character;
  tasks["task"].push_as(made.number);
  tasks["person"].push_as(made.drawn ? made.drawn->person : std::uint64_t{0});
  tasks["status"].push(generation != nullptr ? static_cast<double>(generation->status)
                                             : static_cast<double>(kEnumWords<ReachStatus>.size()));
  tasks["motions"].push(static_cast<double>(made.motions));
  tasks["seed"].push_as(std::uint64_t{file.seed});
  tasks["evaluations"].push(generation != nullptr ? generation->log.evaluations : 0);
  tasks["character"].push(std::string_view(who.source));
  tasks["preset"].push(word_of(file.preset));
  tasks["stature_m"].push(outcome.task ? outcome.task->body.stature() : kNoNumber);
  tasks["mass_kg"].push(outcome.task ? outcome.task->body.mass() : kNoNumber);
  tasks["sex"].push(static_cast<double>(who.sex));
  tasks["seat_m"].push(who.seat.value_or(kNoNumber));
  tasks["duration_s"].push(generation != nullptr ? generation->duration : kNoNumber);
  tasks["refused"].push(std::string_view(outcome.refused));
}

bool is_kept(const Candidate& candidate, const GenerateResult& generation, KeptMotions kept) {
  if (candidate.motion.clip.frames < 2) return false;  // of work that began with nothing
  if (kept == KeptMotions::all) return true;
  if (!generation.meets_goals()) return false;
  return kept == KeptMotions::reached || candidate.judgement.verdict != Verdict::impossible;
}

// Makes the motions of a task and adds them to its tables.
void generate_rows(const DatasetPlan& plan, SimdSet simd, MadeTask& made) {
  TaskOutcome outcome;
  const auto refuse = [&](const Error& error) {
    outcome.refused = error.to_string();
    add_task(made, outcome, made.tables[0]);
  };
  if (!made.drawn) return refuse(made.drawn.error());
  TaskFile& file = made.drawn->file;
  add_goals(made, file, made.tables[1]);
  add_obstacles(made, file, made.tables[2]);
  Result<Task> task = make_task(file, {});
  if (!task) return refuse(task.error());
  task->batch = {.simd = simd, .threads = 1};
  task->layers.store = limb_store();
  outcome.task = &*task;
  const auto begin = Clock::now();
  const Result<GenerateResult> generation =
      task->actions.empty() ? generate(*task) : perform(*task);
  made.search_seconds = seconds_since(begin);
  if (!generation) return refuse(generation.error());
  outcome.generation = &*generation;
  MotionTable motions(file, *task, plan.series());
  for (std::size_t k = 0; k < generation->candidates.size(); ++k) {
    if (!is_kept(generation->candidates[k], *generation, plan.motions())) continue;
    motions.add(made.number, k + 1, *generation);
    ++made.motions;
  }
  if (made.motions > 0) made.tables.push_back(motions.take());
  add_missed(made, *generation, made.tables[3]);
  add_task(made, outcome, made.tables[0]);
}

}  // namespace

std::vector<Table> empty_tables() {
  std::vector<Table> tables;
  tables.push_back(tasks_table());
  tables.push_back(goals_table());
  tables.push_back(obstacles_table());
  tables.push_back(missed_table());
  return tables;
}

MadeTask make_task_rows(const DatasetPlan& plan, std::uint64_t number, SimdSet simd) {
  const auto begin = Clock::now();
  MadeTask made{.number = number, .drawn = plan.task(number), .tables = empty_tables()};
  generate_rows(plan, simd, made);
  made.seconds = seconds_since(begin);
  return made;
}

std::uint64_t motion_bytes(const TaskFile& file, const Task& task,
                           std::span<const DatasetSeries> series) {
  return MotionTable(file, task, series).row_size();
}

}  // namespace shigusa
