// SPDX-License-Identifier: MIT
// docs/*.schema.json agree with the readers and writers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <shigusa/files.hpp>

#include "document/schema_check.hpp"
#include "document/task_samples.hpp"
#include "support/work.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Json = nlohmann::json;

const SchemaCheck& task_judge() {
  static const SchemaCheck schema = SchemaCheck::in_docs("task.schema.json");
  return schema;
}
const SchemaCheck& result_judge() {
  static const SchemaCheck schema = SchemaCheck::in_docs("result.schema.json");
  return schema;
}

// A result of a task: of a search, or of an edit.
Json result_of(TaskFile file, bool edit = false) {
  Task task = make_task(file, {}).value();
  task.genetic.max_generations = 1;
  const GenerateResult generation =
      edit ? regenerate(task, uniform_parameters(task.body)).value() : generate(task).value();
  RunInfo info;
  if (edit) info.search = "edit";
  const CandidateFiles written{
      {"bvh", {"candidate-1.bvh", std::string(64, 'a'), ReadBack{1e-6, 2e-6, 1e-7}}},
      {"csv", {"candidate-1.csv", std::string(64, 'b')}}};
  const ResultFiles files{.rate = 29.97,
                          .candidates = {generation.candidates.size(), written},
                          .character = "../hero.glb"};
  return Json::parse(format_result({file, task, generation, info}, files));
}

TaskFile file_with(const Vec3d& goal, const char* body = "half_body") {
  TaskFile file;
  file.character.source = body;
  file.goals = {{"right_hand", goal}};
  return file;
}

TEST(TaskSchema, IsWrittenFromTheTableOfFields) {
  EXPECT_EQ(task_schema(),
            read_text_file(SHIGUSA_SOURCE_DIR "/docs/task.schema.json", 1 << 20).value())
      << "scripts/make_schema writes it";
}

RC_GTEST_PROP(TaskSchema, TakesEveryTaskThatIsWritten, ()) {
  const std::string wrong = task_judge().judge(Json::parse(format_task(any_task())));
  if (!wrong.empty()) RC_FAIL(wrong);
}

TEST(TaskSchema, TakesTheExamples) {
  for (const auto& entry :
       std::filesystem::directory_iterator(SHIGUSA_SOURCE_DIR "/examples/tasks")) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = read_text_file(entry.path(), 1 << 20).value();
    EXPECT_EQ(task_judge().judge(Json::parse(text)), "") << entry.path();
  }
}

TEST(ResultSchema, TakesResultsOfSearchesAndEdits) {
  const Vec3d near{-0.2, 1.1, 0.4};
  EXPECT_EQ(result_judge().judge(result_of(file_with(near))), "");
  EXPECT_EQ(result_judge().judge(result_of(file_with(near, "full_body"), true)), "");
  EXPECT_EQ(result_judge().judge(result_of(file_with({0, 5, 0}))), "") << "out of reach";
  const Json noted = result_of(file_with({-0.2, -0.1, 0.3}));
  EXPECT_EQ(noted.at("goal_note_messages").size(), 1U);
  EXPECT_EQ(result_judge().judge(noted), "");
  TaskFile person = file_with(near);
  person.character.source = "walk.bvh";
  person.character.stature = 1.6;
  person.character.landmarks = asymmetric_person();
  person.character.doubts = {"a guess"};
  EXPECT_EQ(result_judge().judge(result_of(person)), "");
}

TEST(ResultSchema, TakesWork) {
  const auto& work = box_work();
  const Json json = Json::parse(format_result({work.file, work.task, work.generation}));
  EXPECT_EQ(json.at("candidates").at(0).at("actions").size(), 2U);
  EXPECT_EQ(result_judge().judge(json), "");
}

// Every value of a JSON tree, by its place.
void places(const Json& json, const Json::json_pointer& here,
            std::vector<Json::json_pointer>& all) {
  all.push_back(here);
  if (json.is_object()) {
    for (const auto& [key, member] : json.items()) places(member, here / key, all);
  }
  for (std::size_t i = 0; json.is_array() && i < json.size(); ++i) places(json[i], here / i, all);
}

std::vector<Json::json_pointer> places(const Json& json) {
  std::vector<Json::json_pointer> all;
  places(json, Json::json_pointer(), all);
  return all;
}

// The tree with one value changed, in each of many ways.
std::vector<Json> broken(const Json& good) {
  std::vector<Json> all;
  const Json values[] = {nullptr, true, -1, 0, 7.5, 1e308, "", "x", Json::array(), Json::object()};
  for (const Json::json_pointer& place : places(good)) {
    for (const Json& value : values) {
      all.push_back(good);
      all.back()[place] = value;
    }
    if (place.empty()) continue;
    Json less = good;
    Json& parent = less[place.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(place.back());
      all.push_back(less);
      parent["unknown"] = 1;
      all.push_back(less);
    }
  }
  return all;
}

TEST(TaskSchema, RefusesWhatTheReaderRefuses) {
  TaskFile file = file_with({-0.2, 1.1, 0.4}, "full_body");
  file.goals.push_back({"left_hand", {0.2, 1.0, 0.3}});
  file.duration = 1.0;
  file.evaluations = 100;
  file.phases = 2;
  file.character.stature = 1.7;
  file.character.mass = 70.0;
  int refused = 0;
  for (const Json& json : broken(Json::parse(format_task(file)))) {
    const Result<TaskFile> task = parse_task(json.dump(), "task.json");
    const bool taken = task_judge().judge(json).empty();
    // which names exist: no schema of this kind can state it
    const bool by_name =
        !task && task.error().message.text.find("unknown character") != std::string::npos;
    EXPECT_EQ(taken, task.has_value() || by_name)
        << json.dump() << (task ? "" : task.error().to_string());
    refused += taken ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

TEST(ResultSchema, HasTheWordsOfTheTables) {
  const Json schema = Json::parse(
      read_text_file(SHIGUSA_SOURCE_DIR "/docs/result.schema.json", kTaskMaxBytes).value());
  const auto words = [&](const std::string& place) {
    return schema.at(Json::json_pointer(place)).at("enum").get<std::vector<std::string>>();
  };
  const std::string candidate = "/$defs/candidate/properties/";
  EXPECT_EQ(words("/properties/status"), all_words<ReachStatus>());
  EXPECT_EQ(words("/properties/search_detail/properties/end"), all_words<SearchEnd>());
  EXPECT_EQ(words(candidate + "verdict"), all_words<Verdict>());
  EXPECT_EQ(words(candidate + "paths/items/properties/kind"), all_words<PathKind>());
  EXPECT_EQ(words("/$defs/action/properties/kind"), all_words<ActionKind>());
  EXPECT_EQ(words("/$defs/reason/properties/kind"), all_words<ReasonKind>());
}

TEST(ResultSchema, RefusesBrokenResults) {
  // a list or a number of another size may stand in many places; null and true may stand nowhere
  const Json good = result_of(file_with({-0.2, 1.1, 0.4}));
  for (const Json::json_pointer& place : places(good)) {
    // the values of a message are of any kind
    if (place.to_string().find("/values/") != std::string::npos) continue;
    for (const Json& value : {Json(nullptr), Json(true)}) {
      Json json = good;
      json[place] = value;
      EXPECT_NE(result_judge().judge(json), "") << place << ' ' << value;
    }
  }
}

TEST(SchemaCheck, RefusesAKeywordThatItDoesNotKnow) {
  // otherwise a rule of the schemas could go unread
  EXPECT_THROW((void)SchemaCheck(Json{{"multipleOf", 2}}).judge(1), PreconditionError);
}

}  // namespace
}  // namespace shigusa
