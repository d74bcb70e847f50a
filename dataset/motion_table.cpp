// SPDX-License-Identifier: MIT
#include "motion_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/score.hpp>

#include "core/hash.hpp"
#include "core/index.hpp"
#include "motion_columns.hpp"
#include "task_rows.hpp"
#include "work_rows.hpp"

namespace shigusa {
namespace {

// Degrees of freedom in the order of the body standing on its right foot, or for a robot the file's
// joints.
std::vector<DataDof> data_dofs(const TaskFile& file, const PosedBody& posed) {
  std::vector<DataDof> dofs;
  if (posed.robot) {
    for (const RobotJoint& joint : posed.robot->joints) {
      if (joint.dof >= 0) dofs.push_back({joint.name, joint.dof, joint.sign});
    }
    return dofs;
  }
  const Result<PosedBody> on_right = build_character(file.character, Side::right);
  for (const Dof& dof : (on_right ? *on_right : posed).body.dofs()) {
    if (const auto own = posed.body.find_dof(dof.name)) dofs.push_back({dof.name, *own, 1.0});
  }
  return dofs;
}

std::vector<std::string> node_names(const BodyModel& body) {
  std::vector<std::string> names;
  for (const BodyNode& node : body.nodes()) {
    const bool named = !node.name.empty() || node.parent < 0;
    names.push_back(named ? node.name : names[index(node.parent)] + "_end");
  }
  return names;
}

std::vector<std::string> node_parents(const BodyModel& body,
                                      const std::vector<std::string>& names) {
  std::vector<std::string> parents;
  for (const BodyNode& node : body.nodes()) {
    parents.push_back(node.parent < 0 ? "" : names[index(node.parent)]);
  }
  return parents;
}

// Kind of body: "human" for the built-in body, "avatar" for a file.
std::string stem_of(const std::string& source) {
  std::string stem = source.substr(source.find_last_of('/') + 1);
  if (const std::size_t dot = stem.rfind('.'); dot != std::string::npos && dot > 0) {
    stem.resize(dot);
  }
  for (char& c : stem) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '_' && c != '-') c = '_';
  }
  return stem;
}

}  // namespace

MotionTable::MotionTable(const TaskFile& file, const Task& task,
                         std::span<const DatasetSeries> series)
    : file_(file), task_(task), series_(series), dofs_(data_dofs(file, task)) {
  const Result<ParameterList> list = parameter_list(task.body, task.start, task);
  list_ = list ? *list : parameter_list(task.body, task.start, Request{}).value();
  parameters_ = list_.names();
  std::sort(parameters_.begin(), parameters_.end());
  for (const std::string& name : parameters_) order_.push_back(list_.find(name).value());
  for (const Foot& foot : task.body.feet()) feet_.push_back(foot.name);
  std::sort(feet_.begin(), feet_.end());
  describe();
}

// Columns, and lists of names for their numbers.
void MotionTable::describe() {
  const std::vector<std::string> nodes = node_names(task_.body);
  std::vector<std::string> dofs;
  for (const DataDof& dof : dofs_) dofs.push_back(dof.name);
  table_.names = {{"joints", dofs},
                  {"parameters", parameters_},
                  {"criteria", criterion_names()},
                  {"nodes", nodes},
                  {"node_parents", node_parents(task_.body, nodes)},
                  {"feet", feet_}};
  if (!task_.actions.empty()) {
    table_.names.emplace_back("actions", action_names(task_));
    if (!task_.things.empty()) table_.names.emplace_back("things", thing_names(task_));
  }
  Fnv1a hash;
  for (const auto& [what, list] : table_.names) {
    for (const std::string& name : list) hash.add(name + "\n");
    hash.add(what);
  }
  // bodies of one name that differ in this get separate tables
  table_.path = fmt::format("{}/{}-{:06x}", kMotionsGroup, stem_of(file_.character.source),
                            hash.value() & 0xFFFFFF);
  add_motion_columns(series_, table_);
}

std::uint64_t MotionTable::row_size() const {
  std::uint64_t size = 0;
  for (const Column& column : table_.columns) size += column.row_size();
  return size;
}

void MotionTable::add(std::uint64_t number, std::size_t rank, const GenerateResult& generation) {
  const bool works = is_of_work(table_);
  const Candidate& own = generation.candidates[rank - 1];
  const Candidate candidate = works ? in_frames(own, kWorkFrames) : own;
  double error = 0.0;
  double turn = 0.0;
  for (const GoalResult& goal : candidate.goals) {
    error = max(error, goal.error);
    turn = max(turn, goal.turn.error.value_or(0.0));
  }
  const FinalPosture& ends = candidate.final_posture;
  table_["task"].push_as(number);
  table_["rank"].push(static_cast<double>(rank));
  table_["score"].push(candidate.score.total);
  for (const std::string& name : *table_.names_of("criteria")) {
    const auto& terms = candidate.score.terms;
    const auto term = std::find_if(terms.begin(), terms.end(),
                                   [&name](const ScoreTerm& one) { return one.name == name; });
    table_["penalties"].push(term == terms.end() ? kNoNumber : term->penalty);
  }
  table_["verdict"].push(static_cast<double>(candidate.judgement.verdict));
  table_["words"].push(std::string_view(posture_words(ends)));
  table_["duration_s"].push(candidate.motion.clip.duration());
  table_["error_m"].push(error);
  table_["turn_error_rad"].push(turn);
  table_["knee_flexion_rad"].push(ends.knee_flexion);
  table_["trunk_lean_rad"].push(ends.trunk_lean);
  table_["trunk_turn_rad"].push(ends.trunk_turn);
  table_["elbow_swivel_rad"].push(ends.elbow_swivel);
  table_["stoop_squat_index"].push(ends.stoop_squat_index.value_or(kNoNumber));
  const JointLoad* load = most_loaded(candidate.measures);
  table_["most_loaded_share"].push(load == nullptr ? kNoNumber : load->share);
  const auto& support = candidate.measures.support;
  table_["balance_m"].push(support ? support->centre_of_mass.distance : kNoNumber);
  add_parameters(candidate);
  if (works) add_work(task_, candidate, table_);
  for (const DatasetSeries series : series_) add_series(series, candidate, own);
}

void MotionTable::add_parameters(const Candidate& candidate) {
  const Parameters& values = candidate.parameters;
  for (const std::size_t i : order_) {
    table_["parameters"].push(values.locked[i] ? kNoNumber : values.values[i]);
  }
}

void MotionTable::add_series(DatasetSeries series, const Candidate& candidate,
                             const Candidate& own) {
  const Motion& motion = candidate.motion;
  switch (series) {
    case DatasetSeries::angles:
    case DatasetSeries::torques: {
      const auto count = index(motion.clip.dofs);
      const auto& numbers = series == DatasetSeries::angles ? motion.clip.angles : motion.torques;
      for (std::size_t f = 0; f < frames_of(table_); ++f) {
        for (const DataDof& dof : dofs_) {
          into(series).push(dof.sign * numbers[f * count + index(dof.dof)]);
        }
      }
      break;
    }
    case DatasetSeries::nodes:
      add_nodes(candidate, true);
      break;
    case DatasetSeries::positions:
      add_nodes(candidate, false);
      break;
    case DatasetSeries::centre_of_mass:
      for (const Vec3d& point : motion.centre_of_mass) into(series).push(point);
      break;
    case DatasetSeries::pressure:
      add_pressure(own);
      break;
    case DatasetSeries::contacts:
      add_contacts(candidate);
      break;
    case DatasetSeries::actions:
      if (is_of_work(table_)) add_present_actions(candidate, into(series));
      break;
    case DatasetSeries::things:
      if (!task_.things.empty()) add_poses(candidate, into(series));
      break;
  }
}

// `turns`: local rotations of nodes; else their positions.
void MotionTable::add_nodes(const Candidate& candidate, bool turns) {
  const std::span<const BodyNode> nodes = task_.body.nodes();
  const Clip& clip = candidate.motion.clip;
  std::vector<Quatd> before(nodes.size());
  for (int f = 0; f < clip.frames; ++f) {
    const std::vector<Transformd> places = node_places(task_.body, clip.frame(f));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto& [turn, place] = places[n];
      if (!turns) {
        table_["positions"].push(place);
        continue;
      }
      if (nodes[n].parent < 0) {
        table_["nodes"].push(before[n] = nearer(to_quat(turn), before[n]));
        table_["root_m"].push(place);
        if (f == 0) table_["offsets_m"].push(Vec3d{});
        continue;
      }
      const Transformd& parent = places[index(nodes[n].parent)];
      table_["nodes"].push(before[n] =
                               nearer(to_quat(transpose(parent.rotation) * turn), before[n]));
      if (f > 0) continue;
      table_["offsets_m"].push(transpose_times(parent.rotation, place - parent.translation));
    }
  }
}

void MotionTable::add_pressure(const Candidate& own) {
  Column& into = table_["pressure"];
  const std::size_t frames = frames_of(table_);
  std::vector<double> numbers;
  if (!task_.body.feet().empty()) {
    for (const Vec3d& centre : centres_of_pressure(task_, own)) {
      numbers.insert(numbers.end(), {centre.x, centre.z});
    }
  }
  if (is_of_work(table_)) numbers = numbers_in_frames(numbers, 2, frames);
  numbers.resize(2 * frames, kNoNumber);
  for (const double number : numbers) into.push(number);
}

void MotionTable::add_contacts(const Candidate& candidate) {
  enum Contact { air, sole, forefoot };
  const Clip& clip = candidate.motion.clip;
  for (int f = 0; f < clip.frames; ++f) {
    for (const std::string& name : feet_) {
      const bool stands =
          std::any_of(candidate.contacts.begin(), candidate.contacts.end(),
                      [&name](const ContactResult& contact) { return contact.effector == name; });
      Contact contact = stands ? sole : air;
      for (const Foot& foot : task_.body.feet()) {
        if (foot.name != name || !foot.heel || !stands) continue;
        if (clip.frame(f)[index(foot.heel->toes)] > kHeelLifts) contact = forefoot;
      }
      table_["contacts"].push(static_cast<double>(contact));
    }
  }
}

}  // namespace shigusa
