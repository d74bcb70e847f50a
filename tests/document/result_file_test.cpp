// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>

#include "body/posture_modes.hpp"
#include "document/result_sample.hpp"
#include "document/task_samples.hpp"
#include "plan/assignment.hpp"
#include "support/named_values.hpp"
#include "support/person_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

TaskFile reach_task() {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
  file.seed = 3;
  return file;
}

const ResultSample& sample() {
  static const ResultSample made(reach_task(), 1);
  return made;
}

TEST(ResultFile, HoldsAThousandCandidatesAtMost) {
  Json json = Json::parse(sample().text());
  const Json one = json["candidates"][0];
  json["candidates"] = Json(1000, one);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(message(json), "");
  for (const std::size_t many : {1001u, 2001u}) {
    json["candidates"] = Json(many, one);
    EXPECT_THAT(message(json), HasSubstr(std::to_string(many) + " candidates; up to 1000"));
  }
  // a sanitizer on a busy machine takes long
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST(ResultFile, AListOfVeryManyObjectsIsRefusedWhileItIsRead) {
  std::string text = R"({"candidates":[{})";
  for (int i = 0; i < 200'000; ++i) text += ",{}";
  const auto refused = parse_result(text + "]}", "summary.json");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("more than 2048 objects in one list"));
}

TEST(ResultFile, NamesOfFilesLeadNowhereElse) {
  Json json = Json::parse(sample().text());
  Json& candidate = json["candidates"][0];
  candidate["files"] = {{"bvh", "candidate-1.bvh"}};
  candidate["sha256"] = {{"bvh", std::string(64, '0')}};
  EXPECT_EQ(message(json), "");
  for (const Json& name :
       {Json("../x.bvh"), Json("/etc/passwd"), Json(".."), Json(""), Json("a\\b"),
        Json(std::string("a\0b", 3)), Json(std::string(300, 'a')), Json(7)}) {
    candidate["files"]["bvh"] = name;
    EXPECT_THAT(message(json), HasSubstr("candidates[0].files.bvh: must be the name")) << name;
  }
  candidate["files"] = {{"csv", "candidate-1.csv"}};
  EXPECT_THAT(message(json), HasSubstr("candidates[0].sha256.bvh: must be 64")) << "of no file";
  candidate["sha256"] = {{"csv", "short"}};
  EXPECT_THAT(message(json), HasSubstr("candidates[0].sha256.csv: must be 64"));
  candidate["sha256"] = Json::array();
  EXPECT_THAT(message(json), HasSubstr("candidates[0].sha256: must be an object"));
}

TEST(ResultFile, TaskAndParametersAreReadBackBitForBit) {
  const StoredResult stored = parse_result(sample().text(), "summary.json").value();
  EXPECT_EQ(bits(stored.task), bits(sample().file));
  EXPECT_EQ(words(stored.task.character), words(sample().file.character));
  ASSERT_EQ(stored.candidates.size(), sample().generation.candidates.size());
  for (std::size_t i = 0; i < stored.candidates.size(); ++i) {
    EXPECT_EQ(stored.candidates[i], sample().generation.candidates[i].parameters);
  }
}

TEST(ResultFile, StoredParametersGiveTheSameMotion) {
  StoredResult stored = parse_result(sample().text(), "summary.json").value();
  const Task task = make_task(stored.task, {}).value();
  const GenerateResult again = regenerate(task, stored.candidates[0]).value();
  EXPECT_EQ(again.candidates[0].motion.clip.angles,
            sample().generation.candidates[0].motion.clip.angles);
}

TEST(ResultFile, OfTwoPhasesIsRefusedWithWhatToWrite) {
  Json json = Json::parse(sample().text());
  json["candidates"][0]["parameters"]["later"] = Json::object();
  EXPECT_THAT(message(json), HasSubstr("candidates[0].parameters.later: motions have one phase"));
  TaskFile file = reach_task();
  file.phases = 2;
  const auto task = make_task(file, {});
  EXPECT_THAT(PreparedTask::of(task.value()).error().to_string(), HasSubstr("write two tasks"));
}

TEST(ResultFile, PersonFromAFileIsKeptAsMeasured) {
  const WorkFolder folder;
  TaskFile file = reach_task();
  file.character.source = folder.put("person.bvh", person_bvh());
  file.character.frame = 1;
  const ResultSample made(file, 1);
  const StoredResult stored = parse_result(made.text(), "summary.json").value();
  EXPECT_EQ(stored.task.character.source, "person.bvh") << "a bare name: no folder of this machine";
  EXPECT_EQ(bits(stored.task), bits(made.file));
}

TEST(ResultFile, NeverOpensTheFileThatItNames) {
  const WorkFolder folder;
  Json json = Json::parse(sample().text());
  json["task"]["character"] = {{"source", folder.put("person.bvh", person_bvh())}};
  EXPECT_THAT(message(json), HasSubstr("summary.json: task.character: landmarks_m is missing"));
}

TEST(ResultFile, OtherVersionIsAnError) {
  Json json = Json::parse(sample().text());
  json["version"] = 2;
  EXPECT_THAT(message(json), HasSubstr("version is 2; allowed is 1"));
  json.erase("version");
  EXPECT_THAT(message(json), HasSubstr("version is missing"));
}

TEST(ResultFile, ATaskIsNoResult) {
  EXPECT_THAT(message(Json::parse(format_task(reach_task()))), HasSubstr("not a result"));
  EXPECT_THAT(message(Json::array()), HasSubstr("not a result"));
}

TEST(ResultFile, WithoutCandidatesIsAnError) {
  Json json = Json::parse(sample().text());
  json["candidates"] = Json::array();
  EXPECT_THAT(message(json), HasSubstr("candidates is an empty list"));
}

TEST(ResultFile, WrongParametersAreNamedByTheirPlace) {
  const Json good = Json::parse(sample().text());
  const auto with = [&good](const Json::json_pointer& place, const Json& value) {
    Json json = good;
    json[place] = value;
    return message(json);
  };
  const Json::json_pointer parameters("/candidates/0/parameters");
  EXPECT_THAT(with(Json::json_pointer("/candidates/0"), 1), HasSubstr("candidates[0].parameters"));
  EXPECT_THAT(with(parameters, Json::object()),
              HasSubstr("right_ankle.inversion.weight: is missing"));
  EXPECT_THAT(with(parameters / "right_knee.flexion.weight", 0),
              HasSubstr("right_knee.flexion.weight: is 0; allowed are numbers from 0.001 to 1000"));
  EXPECT_THAT(with(parameters / "tail.flexion.weight", 1), HasSubstr("'tail.flexion.weight'"));
  EXPECT_THAT(with(parameters / "locked", {"tail"}), HasSubstr("parameters.locked"));
  EXPECT_THAT(with(parameters / "locked", "right_knee.flexion.weight"),
              HasSubstr("must be a list"));
  EXPECT_THAT(with(parameters / "lokced", 1), HasSubstr("did you mean 'locked'?"));
}

struct Assignment {
  const char* text;
  const char* wrong;  // part of the message, or nullptr where it is right
  std::vector<int> changed{};
  double weight = 1.0;
  bool locked = false;
};

TEST(AssignParameter, FollowsItsTable) {
  const PosedBody posed = half_body();
  const BodyModel& body = posed.body;
  const auto dof = [&body](const char* name) { return body.find_dof(name).value(); };
  const int knee = dof("right_knee.flexion");
  const std::vector<int> hip{dof("right_hip.rotation"), dof("right_hip.abduction"),
                             dof("right_hip.flexion")};
  const Assignment table[] = {
      {"right_knee.flexion.weight=12", nullptr, {knee}, 12.0},
      {"right_knee.weight=0.5", nullptr, {knee}, 0.5},
      {"right_knee.weight=1e-3", nullptr, {knee}, 1e-3},
      {"right_knee.weight=1e3", nullptr, {knee}, 1e3},
      {"right_hip.weight=3", nullptr, hip, 3.0},
      {"right_hip.flexion.weight=3", nullptr, {hip[2]}, 3.0},
      {"right_hip.locked=true", nullptr, hip, 1.0, true},
      {"right_hip.rotation.locked=false", nullptr},
      {"right_knee.weight", "is not NAME.weight=NUMBER"},
      {"weight=3", "is not NAME.weight=NUMBER"},
      {"", "is not NAME.weight=NUMBER"},
      {"=", "is not NAME.weight=NUMBER"},
      {".weight=3", "unknown joint ''"},
      {"right_kne.weight=3", "did you mean 'right_knee"},
      {"right_knee.wieght=3", "did you mean 'weight'?"},
      {"right_knee.flexion=3", "unknown parameter 'flexion'"},
      {"right_knee.weight=", "weight is ''"},
      {"right_knee.weight=0", "weight is '0'"},
      {"right_knee.weight=-1", "weight is '-1'"},
      {"right_knee.weight=1e4", "allowed are numbers from 0.001 to 1000"},
      {"right_knee.weight=nan", "weight is 'nan'"},
      {"right_knee.weight=inf", "weight is 'inf'"},
      {"right_knee.weight=3 kg", "weight is '3 kg'"},
      {"right_knee.weight=1=2", "weight is '1=2'"},
      {"right_knee.locked=1", "locked is '1'; allowed are true and false"},
  };
  for (const Assignment& row : table) {
    Parameters parameters = uniform_parameters(body);
    Parameters expected = parameters;
    for (const int d : row.changed) {
      expected.values[static_cast<std::size_t>(d)] = row.weight;
      expected.locked[static_cast<std::size_t>(d)] = row.locked;
    }
    const Result<void> assigned = assign_parameter(list_of(posed), row.text, parameters);
    EXPECT_EQ(assigned.has_value(), row.wrong == nullptr) << row.text;
    if (!assigned && row.wrong) {
      EXPECT_THAT(assigned.error().message, HasSubstr(row.wrong)) << row.text;
    }
    EXPECT_EQ(parameters, expected) << row.text;
  }
}

TEST(AssignParameter, WeightFreesALockedFreedom) {
  const PosedBody posed = half_body();
  const BodyModel& body = posed.body;
  Parameters parameters = uniform_parameters(body);
  ASSERT_TRUE(assign_parameter(list_of(posed), "right_knee.locked=true", parameters));
  ASSERT_TRUE(assign_parameter(list_of(posed), "right_knee.weight=4", parameters));
  const std::size_t knee = number_of(list_of(posed), "right_knee.flexion");
  EXPECT_EQ(parameters.values[knee], 4.0);
  EXPECT_FALSE(parameters.locked[knee]);
}

}  // namespace
}  // namespace shigusa
