// SPDX-License-Identifier: MIT
#include "motion_columns.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kWordsSize = 64;

std::size_t size_of_list(const Table& table, std::string_view list) {
  const std::vector<std::string>* names = table.names_of(list);
  return names == nullptr ? 0 : names->size();
}

void add_series_columns(DatasetSeries series, Table& table) {
  const std::size_t nodes = size_of_list(table, "nodes");
  const std::size_t frames = frames_of(table);
  const std::string name(word_of(series));
  switch (series) {
    case DatasetSeries::angles:
      table.columns.push_back(
          {name, ElementType::f32, {frames, size_of_list(table, "joints")}, "rad", "of `joints`"});
      break;
    case DatasetSeries::torques:
      table.columns.push_back(
          {name, ElementType::f32, {frames, size_of_list(table, "joints")}, "N m", "of `joints`"});
      break;
    case DatasetSeries::nodes:
      table.columns.push_back(
          {name,
           ElementType::f32,
           {frames, nodes, 4},
           "",
           "quaternions xyzw of `nodes`, each in its parent; 0, 0, 0, 1 where the body stands "
           "upright with arms hanging"});
      table.columns.push_back(
          {"root_m", ElementType::f32, {frames, 3}, "m", "place of the first node"});
      table.columns.push_back(
          {"offsets_m", ElementType::f32, {nodes, 3}, "m", "of `nodes`, each in its parent"});
      break;
    case DatasetSeries::positions:
      table.columns.push_back(
          {name, ElementType::f32, {frames, nodes, 3}, "m", "of `nodes`, in the world"});
      break;
    case DatasetSeries::centre_of_mass:
      table.columns.push_back({name, ElementType::f32, {frames, 3}, "m", "in the world"});
      break;
    case DatasetSeries::pressure:
      table.columns.push_back({name,
                               ElementType::f32,
                               {frames, 2},
                               "m",
                               "x and z of the centre of pressure on the floor"});
      break;
    case DatasetSeries::contacts:
      table.columns.push_back({name,
                               ElementType::u8,
                               {frames, size_of_list(table, "feet")},
                               "",
                               "of `feet`, what it stands on",
                               {"air", "sole", "forefoot"}});
      break;
    case DatasetSeries::actions:
      if (!is_of_work(table)) break;
      table.columns.push_back(
          {name, ElementType::u8, {frames, 1}, "", "of `actions`, which is done, from 0"});
      break;
    case DatasetSeries::things:
      if (size_of_list(table, "things") == 0) break;
      table.columns.push_back({name,
                               ElementType::f32,
                               {frames, size_of_list(table, "things"), kPoseNumbers},
                               "m",
                               "of `things`, in the world: the middle, and the quaternion xyzw of "
                               "the turn"});
      break;
  }
}

void add_work_columns(Table& table) {
  const std::size_t actions = size_of_list(table, "actions");
  const std::size_t things = size_of_list(table, "things");
  table.columns.push_back({.name = "action_start_s",
                           .shape = {actions},
                           .unit = "s",
                           .says = "of `actions`; NaN of those that the work did not come to"});
  table.columns.push_back({.name = "action_end_s",
                           .shape = {actions},
                           .unit = "s",
                           .says = "of `actions`, when each is done and its hold is over"});
  table.columns.push_back({.name = "action_verdict",
                           .type = ElementType::u8,
                           .shape = {actions},
                           .says = "of `actions`, whether the body could make the motion",
                           .words = all_words<Verdict>()});
  if (things == 0) return;
  table.columns.push_back({.name = "thing_mass_kg", .shape = {things}, .unit = "kg"});
  table.columns.push_back({.name = "thing_size_m",
                           .shape = {things, 3},
                           .unit = "m",
                           .says = "of `things`, along their own axes"});
}

}  // namespace

bool is_of_work(const Table& table) { return table.names_of("actions") != nullptr; }

std::size_t frames_of(const Table& table) { return is_of_work(table) ? kWorkFrames : kDataFrames; }

void add_motion_columns(std::span<const DatasetSeries> all, Table& table) {
  table.columns.push_back({.name = "task", .type = ElementType::u64, .says = "number of the task"});
  table.columns.push_back(
      {.name = "rank", .type = ElementType::u8, .says = "of the task's candidates, from 1"});
  table.columns.push_back(
      {.name = "score", .says = "weighted sum of the penalties; less is better"});
  table.columns.push_back({.name = "penalties",
                           .shape = {size_of_list(table, "criteria")},
                           .says = "of `criteria`; NaN where the score does without"});
  table.columns.push_back({.name = "verdict",
                           .type = ElementType::u8,
                           .says = "whether the body could make the motion",
                           .words = all_words<Verdict>()});
  table.columns.push_back({.name = "words",
                           .type = ElementType::text,
                           .says = "how the motion ends",
                           .text_size = kWordsSize});
  table.columns.push_back({.name = "duration_s", .unit = "s"});
  table.columns.push_back(
      {.name = "error_m", .unit = "m", .says = "the farthest that a goal is missed by"});
  table.columns.push_back({.name = "turn_error_rad",
                           .unit = "rad",
                           .says = "the most that a goal's turn is missed by"});
  table.columns.push_back(
      {.name = "knee_flexion_rad", .unit = "rad", .says = "at the end, mean of the knees"});
  table.columns.push_back(
      {.name = "trunk_lean_rad", .unit = "rad", .says = "at the end, forwards above 0"});
  table.columns.push_back(
      {.name = "trunk_turn_rad", .unit = "rad", .says = "at the end, to the left above 0"});
  table.columns.push_back(
      {.name = "elbow_swivel_rad", .unit = "rad", .says = "at the end, outwards above 0"});
  table.columns.push_back({.name = "stoop_squat_index",
                           .says = "at the end: below 30 a full squat, above 90 a full stoop; NaN "
                                   "of who stays up or whose hands do"});
  table.columns.push_back(
      {.name = "most_loaded_share", .says = "of its strength, of the joint that needs most"});
  table.columns.push_back(
      {.name = "balance_m",
       .unit = "m",
       .says = "the least that the plumb line of the centre of mass is inside the feet"});
  table.columns.push_back(
      {.name = "parameters",
       .shape = {size_of_list(table, "parameters")},
       .says = "of `parameters`, which the motion is made from; NaN where locked"});
  if (is_of_work(table)) add_work_columns(table);
  for (const DatasetSeries series : all) add_series_columns(series, table);
}

}  // namespace shigusa
