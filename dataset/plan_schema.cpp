// SPDX-License-Identifier: MIT
#include <shigusa/dataset.hpp>

#include "draws.hpp"

namespace shigusa {
namespace {

Json draw_schema() {
  Json kinds = Json::array();
  for (const DrawInfo& info : kDraws) {
    const std::string word(info.word);
    Json properties;
    properties[word] = {
        {"description", std::string(info.says) + " Its form: " + std::string(info.form) + "."}};
    if (info.word == "choice") {
      properties[word]["type"] = "array";
      properties[word]["minItems"] = 1;
      properties["shares"] = {{"type", "array"}, {"items", {{"type", "number"}, {"minimum", 0}}}};
    }
    kinds.push_back({{"type", "object"},
                     {"properties", properties},
                     {"required", Json::array({word})},
                     {"additionalProperties", false}});
  }
  return {{"description", "A draw in a value's place."}, {"anyOf", kinds}};
}

// Schema with draws permitted in place of values.
Json with_draws(const Json& schema) {
  if (!schema.is_object()) return schema;
  Json result = schema;
  for (const char* key : {"properties", "$defs"}) {
    if (!schema.contains(key)) continue;
    for (const auto& item : schema[key].items()) {
      result[key][item.key()] = with_draws(item.value());
    }
  }
  for (const char* key : {"items", "additionalProperties"}) {
    if (schema.contains(key)) result[key] = with_draws(schema[key]);
  }
  if (schema.contains("anyOf")) {
    for (Json& one : result["anyOf"]) one = with_draws(one);
  }
  // objects are drawn member by member; other values also as a whole
  if (schema.contains("properties")) return result;
  Json description;
  if (result.contains("description")) {
    description = result["description"];
    result.erase("description");
  }
  Json either{{"anyOf", Json::array({result, Json{{"$ref", "#/$defs/draw"}}})}};
  if (!description.is_null()) either["description"] = description;
  return either;
}

Json whole_number(std::uint64_t low, std::uint64_t high, const char* says) {
  return {{"description", says}, {"type", "integer"}, {"minimum", low}, {"maximum", high}};
}

}  // namespace

std::string plan_schema() {
  Json task = Json::parse(task_schema());
  Json definitions;
  for (const auto& item : task["$defs"].items()) {
    definitions[item.key()] = with_draws(item.value());
  }
  definitions["draw"] = draw_schema();
  for (const char* key : {"$defs", "$schema", "title"}) task.erase(key);
  definitions["task"] = with_draws(task);
  Json properties{
      {"version", {{"const", kDatasetVersion}}},
      {"name", {{"description", "For the data card."}, {"type", "string"}}},
      {"licence", {{"description", "Of the data, for the data card."}, {"type", "string"}}},
      {"characters_in",
       {{"description",
         "The folder of the characters' files, from the plan's own; that one when "
         "not given."},
        {"type", "string"}}},
      {"seed", whole_number(0, UINT64_MAX, "Of all draws; 0 when not given.")},
      {"tasks", whole_number(1, kDatasetMaxTasks, "Number of tasks.")},
      {"shard_tasks", whole_number(1, kDatasetMaxTasks,
                                   "Tasks of a shard; as many as memory allows when not given.")},
      {"people", whole_number(0, kDatasetMaxTasks,
                              "Number of people, of whom each task draws one; 0, when not given: "
                              "each task its own.")},
      {"series",
       {{"description", "Kept of each frame; angles, torques and centre_of_mass when not given."},
        {"type", "array"},
        {"items", {{"enum", all_words<DatasetSeries>()}}}}},
      {"motions",
       {{"description", "Kept; reached when not given."}, {"enum", all_words<KeptMotions>()}}},
      {"task", {{"$ref", "#/$defs/task"}}}};
  const Json schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "shigusa plan"},
      {"description", "Many tasks: a task in which any value may be a draw (docs/data.md)."},
      {"type", "object"},
      {"properties", properties},
      {"required", Json::array({"tasks", "task"})},
      {"additionalProperties", false},
      {"$defs", definitions}};
  return schema.dump(2) + "\n";
}

}  // namespace shigusa
