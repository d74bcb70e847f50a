// SPDX-License-Identifier: MIT
#include "export_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "motion_table.hpp"

namespace shigusa {
namespace {

int find_name(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::vector<int> parents_of(const Table& table, const std::vector<std::string>& names) {
  std::vector<int> parents;
  for (const std::string& parent : *table.names_of("node_parents")) {
    parents.push_back(parent.empty() ? -1 : find_name(names, parent));
  }
  return parents;
}

std::vector<Vec3d> points_in(const Row& row, std::string_view column) {
  const std::vector<double> numbers = row.numbers(column);
  std::vector<Vec3d> points(numbers.size() / 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
  }
  return points;
}

double frame_time_of(double duration, std::size_t frames) {
  return frames > 1 ? duration / static_cast<double>(frames - 1) : duration;
}

// Nodes of a row that stores their rotations.
Result<NodeMotion> turns_in(const Row& row, const std::string& id) {
  NodeMotion motion{.names = *row.table->names_of("nodes"),
                    .parents = {},
                    .offsets = {},
                    .turns = {},
                    .root = {}};
  motion.parents = parents_of(*row.table, motion.names);
  motion.offsets = points_in(row, "offsets_m");
  motion.root = points_in(row, "root_m");
  const std::vector<double> numbers = row.numbers("nodes");
  for (std::size_t k = 0; k + 3 < numbers.size(); k += 4) {
    motion.turns.push_back({numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3]});
  }
  motion.frame_time = frame_time_of(row.number("duration_s"), motion.frames());
  if (motion.turns.empty() || motion.turns.size() != motion.frames() * motion.names.size() ||
      motion.offsets.size() != motion.names.size()) {
    return fail(ErrorCode::parse, "has no whole series `nodes`", id);
  }
  return motion;
}

Result<NodePlaces> places_in(const Row& row, const std::string& id) {
  NodePlaces motion{.names = *row.table->names_of("nodes"), .parents = {}, .places = {}};
  motion.parents = parents_of(*row.table, motion.names);
  motion.places = points_in(row, word_of(DatasetSeries::positions));
  if (motion.names.empty() || motion.places.empty() ||
      motion.places.size() % motion.names.size() != 0) {
    return fail(ErrorCode::parse, "has no whole series `positions`", id);
  }
  motion.frame_time = frame_time_of(row.number("duration_s"), motion.frames());
  return motion;
}

// A body's degree of freedom for a data set's joint, and the sign of its values.
std::pair<int, double> dof_of(const PosedBody& posed, const std::string& joint) {
  if (!posed.robot) return {posed.body.find_dof(joint).value_or(-1), 1.0};
  for (const RobotJoint& one : posed.robot->joints) {
    if (one.name == joint) return {one.dof, one.sign};
  }
  return {-1, 1.0};
}

// Clip of a row's stored angles; empty if they are not stored.
std::optional<Clip> clip_in(const Row& row, const PosedBody& posed) {
  const std::vector<double> angles = row.numbers(word_of(DatasetSeries::angles));
  const std::vector<std::string>* joints = row.table->names_of("joints");
  if (angles.empty() || joints == nullptr || joints->empty()) return std::nullopt;
  Clip clip{.dofs = posed.body.dof_count(),
            .frames = static_cast<int>(angles.size() / joints->size()),
            .angles = {}};
  clip.frame_time = frame_time_of(row.number("duration_s"), static_cast<std::size_t>(clip.frames));
  for (int f = 0; f < clip.frames; ++f) {
    clip.angles.insert(clip.angles.end(), posed.home.angles.begin(), posed.home.angles.end());
  }
  const auto dofs = static_cast<std::size_t>(clip.dofs);
  for (std::size_t j = 0; j < joints->size(); ++j) {
    const auto [dof, sign] = dof_of(posed, (*joints)[j]);
    if (dof < 0) return std::nullopt;
    for (std::size_t f = 0; f < angles.size() / joints->size(); ++f) {
      clip.angles[f * dofs + static_cast<std::size_t>(dof)] = sign * angles[f * joints->size() + j];
    }
  }
  return clip;
}

// Row of a motion made again with the missing series; table and row.
Result<Table> made_again(const DatasetPlan& plan, const DataMotion& motion,
                         std::span<const DatasetSeries> series) {
  SHG_TRY_ASSIGN(DrawnAgain again, drawn_again(plan, motion));
  if (!again.misfit.empty()) return fail(ErrorCode::parse, again.misfit, motion.id());
  GenerateResult generation;
  if (std::optional<Clip> clip = clip_in(motion.motion, again.task)) {
    Candidate candidate;
    candidate.parameters = again.parameters;
    candidate.motion.clip = *std::move(clip);
    generation.candidates.push_back(std::move(candidate));
  } else if (!again.task.actions.empty()) {
    return fail(ErrorCode::unsupported, "is a piece of work whose plan keeps no angles",
                motion.id());
  } else {
    SHG_TRY_ASSIGN(generation, regenerate(again.task, again.parameters));
  }
  MotionTable rows(again.file, again.task, series);
  rows.add(motion.number(), 1, generation);
  return rows.take();
}

// Clip that carries numbers of any kind in place of joint angles, for resampling.
Clip clip_of(std::vector<double> numbers, std::size_t frames, double frame_time) {
  const auto dofs = static_cast<int>(numbers.size() / frames);
  return {.dofs = dofs,
          .frames = static_cast<int>(frames),
          .frame_time = frame_time,
          .angles = std::move(numbers)};
}

void push(const Vec3d& v, std::vector<double>& numbers) {
  for (int k = 0; k < 3; ++k) numbers.push_back(v[k]);
}

Quatd unit(const Quatd& q) {
  const double scale = 1.0 / sqrt(squared_length(q));
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

// Sets a plan's parameters from a row; returns the name of one that the row lacks, if any.
std::string set_parameters(const Row& row, const ParameterList& list, Parameters& values) {
  const std::vector<std::string>* names = row.table->names_of("parameters");
  const std::vector<double> numbers = row.numbers("parameters");
  if (names == nullptr) return "any";
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::string name = list.all[i].spelled("_rad");
    const int place = find_name(*names, name);
    if (place < 0) return name;
    const double value = numbers[static_cast<std::size_t>(place)];
    const bool none = !is_finite(value);
    values.locked[i] = none && list.all[i].kind == ParameterKind::weight;
    if (!none) values.values[i] = value;
  }
  return {};
}

}  // namespace

int NodeMotion::find(std::string_view name) const { return find_name(names, name); }
int NodePlaces::find(std::string_view name) const { return find_name(names, name); }

bool Poses::keeps(DatasetSeries series) const {
  const auto& kept = plan_->series();
  return std::find(kept.begin(), kept.end(), series) != kept.end();
}

std::vector<DatasetSeries> Poses::series_for_turns() const {
  if (keeps(DatasetSeries::nodes)) return {DatasetSeries::nodes};
  return {DatasetSeries::angles};
}

std::vector<DatasetSeries> Poses::series_for_places() const {
  if (keeps(DatasetSeries::positions)) return {DatasetSeries::positions};
  return series_for_turns();
}

Result<NodeMotion> Poses::turns(const DataMotion& motion) const {
  if (keeps(DatasetSeries::nodes)) return turns_in(motion.motion, motion.id());
  constexpr DatasetSeries kNeeded[] = {DatasetSeries::nodes};
  SHG_TRY_ASSIGN(const Table again, made_again(*plan_, motion, kNeeded));
  return turns_in({&again, 0}, motion.id());
}

Result<NodePlaces> Poses::places(const DataMotion& motion) const {
  if (keeps(DatasetSeries::positions)) return places_in(motion.motion, motion.id());
  if (keeps(DatasetSeries::nodes)) {
    SHG_TRY_ASSIGN(const NodeMotion turning, turns_in(motion.motion, motion.id()));
    return places_of(turning);
  }
  constexpr DatasetSeries kNeeded[] = {DatasetSeries::positions};
  SHG_TRY_ASSIGN(const Table again, made_again(*plan_, motion, kNeeded));
  return places_in({&again, 0}, motion.id());
}

NodeMotion at_rate(const NodeMotion& motion, double rate) {
  std::vector<double> numbers;
  const std::size_t nodes = motion.names.size();
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    push(motion.root[f], numbers);
    for (std::size_t n = 0; n < nodes; ++n) {
      const Quatd& q = motion.turns[f * nodes + n];
      numbers.insert(numbers.end(), {q.x, q.y, q.z, q.w});
    }
  }
  // neighbours are a few degrees apart, so quaternion components may be interpolated linearly
  const Clip clip =
      resampled(clip_of(std::move(numbers), motion.frames(), motion.frame_time), rate);
  NodeMotion made{.names = motion.names,
                  .parents = motion.parents,
                  .offsets = motion.offsets,
                  .frame_time = clip.frame_time,
                  .turns = {},
                  .root = {}};
  for (int f = 0; f < clip.frames; ++f) {
    const auto frame = clip.frame(f);
    made.root.push_back({frame[0], frame[1], frame[2]});
    for (std::size_t k = 3; k < frame.size(); k += 4) {
      made.turns.push_back(unit({frame[k], frame[k + 1], frame[k + 2], frame[k + 3]}));
    }
  }
  return made;
}

NodePlaces at_rate(const NodePlaces& motion, double rate) {
  std::vector<double> numbers;
  for (const Vec3d& place : motion.places) push(place, numbers);
  const Clip clip =
      resampled(clip_of(std::move(numbers), motion.frames(), motion.frame_time), rate);
  NodePlaces made{.names = motion.names,
                  .parents = motion.parents,
                  .frame_time = clip.frame_time,
                  .places = {}};
  for (std::size_t k = 0; k < clip.angles.size(); k += 3) {
    made.places.push_back({clip.angles[k], clip.angles[k + 1], clip.angles[k + 2]});
  }
  return made;
}

NodePlaces places_of(const NodeMotion& motion) {
  NodePlaces made{.names = motion.names,
                  .parents = motion.parents,
                  .frame_time = motion.frame_time,
                  .places = {}};
  const std::size_t nodes = motion.names.size();
  std::vector<Mat3d> turn(nodes);
  std::vector<Vec3d> place(nodes);
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    for (std::size_t n = 0; n < nodes; ++n) {
      const Mat3d own = to_matrix(motion.turns[f * nodes + n]);
      const bool root = motion.parents[n] < 0;
      const auto parent = static_cast<std::size_t>(root ? 0 : motion.parents[n]);
      turn[n] = root ? own : turn[parent] * own;
      place[n] = root ? motion.root[f] : place[parent] + turn[parent] * motion.offsets[n];
    }
    made.places.insert(made.places.end(), place.begin(), place.end());
  }
  return made;
}

Result<DrawnAgain> drawn_again(const DatasetPlan& plan, const DataMotion& motion,
                               const CharacterSpec* person) {
  SHG_TRY_ASSIGN(DrawnTask drawn, plan.task(motion.number()));
  TaskFile& file = drawn.file;
  if (person != nullptr) {
    const CharacterSpec own = file.character;
    file.character = *person;
    file.character.seat = own.seat;
    file.character.heels = own.heels;
  }
  // the duration found by the search, if the task gives none; each action has its own
  if (file.actions.empty()) file.duration = motion.task.number("duration_s");
  SHG_TRY_ASSIGN(Task task, make_task(file, {}));
  task.batch.threads = 1;
  task.layers.store = limb_store();
  SHG_TRY_ASSIGN(const ParameterList list, parameter_list(task.body, task.start, task));
  Parameters values = list.start();
  values.posed = list.has_posture();
  DrawnAgain again{std::move(file), std::move(task), std::move(values)};
  const std::string unknown = set_parameters(motion.motion, list, again.parameters);
  if (!unknown.empty()) {
    again.misfit = fmt::format("has no value for {}, which this body moves by", unknown);
  } else if (const Result<void> fits = list.check(again.parameters); !fits) {
    again.misfit = fits.error().to_string();
  }
  return again;
}

}  // namespace shigusa
