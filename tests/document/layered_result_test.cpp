// SPDX-License-Identifier: MIT
// Results of layered presets in files, and assignments to their parameters.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>

#include "document/result_sample.hpp"
#include "document/schema_check.hpp"
#include "plan/assignment.hpp"
#include "support/layered.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

TaskFile layers_task() {
  TaskFile file;
  file.character.source = "full_body";
  file.preset = Preset::layers;
  file.goals = {{"left_hand", {0.3, 1.1, 0.4}}, {"right_hand", {-0.2, 1.1, 0.4}}};
  file.seed = 3;
  file.evaluations = 100;
  return file;
}

const ResultSample& sample() {
  static const ResultSample made(layers_task());
  return made;
}

TEST(LayeredResult, ParametersAreReadBackBitForBit) {
  for (const auto& [reading, word] : kEnumWords<LayerReading>) {
    // in the paper's code, and in one of any numbers
    for (const SearchMethod method : {SearchMethod::paper_ga, SearchMethod::cma_es}) {
      TaskFile file = layers_task();
      file.layer_reading = reading;
      file.search = method;
      const ResultSample made(file);
      const StoredResult stored = parse_result(made.text(), "summary.json").value();
      EXPECT_EQ(stored.task.preset, Preset::layers);
      EXPECT_EQ(stored.task.layer_reading, reading);
      ASSERT_EQ(stored.candidates.size(), made.generation.candidates.size());
      for (std::size_t i = 0; i < stored.candidates.size(); ++i) {
        EXPECT_EQ(stored.candidates[i], made.generation.candidates[i].parameters);
      }
    }
  }
}

TEST(LayeredResult, StoredParametersGiveTheSameMotion) {
  StoredResult stored = parse_result(sample().text(), "summary.json").value();
  const Task task = make_task(stored.task, {}).value();
  const GenerateResult again = regenerate(task, stored.candidates[0]).value();
  EXPECT_EQ(again.candidates[0].motion.clip.angles,
            sample().generation.candidates[0].motion.clip.angles);
}

TEST(LayeredResult, FollowsTheSchema) {
  const SchemaCheck schema = SchemaCheck::in_docs("result.schema.json");
  EXPECT_EQ(schema.judge(nlohmann::json::parse(sample().text())), "");
  TaskFile far = layers_task();
  far.goals = {{"right_hand", {0, 5, 0}}};
  EXPECT_EQ(schema.judge(nlohmann::json::parse(ResultSample(far).text())), "");
}

TEST(LayeredResult, WrongParametersAreNamedByTheirPlace) {
  const Json good = Json::parse(sample().text());
  ASSERT_EQ(message(good), "");
  const auto with = [&good](const Json::json_pointer& place, const Json& value) {
    Json json = good;
    json[place] = value;
    return message(json);
  };
  const Json::json_pointer parameters("/candidates/0/parameters");
  EXPECT_THAT(with(parameters / "right_hip.flexion.weight", 0),
              HasSubstr("right_hip.flexion.weight: is 0; allowed are numbers from 0.001 to 1000"));
  EXPECT_THAT(with(parameters / "right_knee.flexion.weight", 1),
              HasSubstr("'right_knee.flexion.weight'"));
  EXPECT_THAT(with(parameters / "locked", {"right_knee.flexion.weight"}),
              HasSubstr("parameters.locked"));
  EXPECT_THAT(with(parameters / "locked", {"legs.contraction"}), HasSubstr("parameters.locked"));
  EXPECT_THAT(with(parameters / "legs.contraction", 16),
              HasSubstr("legs.contraction: is 16; allowed are numbers from 0 to 15"));
  EXPECT_THAT(with(parameters, {{"right_hip.flexion.weight", 1}}), HasSubstr("is missing"));
  EXPECT_THAT(with(parameters / "delay", 0.1), HasSubstr("'delay'"));
  EXPECT_THAT(with(parameters / "right_arm.right_elbow.flexion.weight", "x"),
              HasSubstr("right_arm.right_elbow.flexion.weight"));
  EXPECT_THAT(with(parameters / "third_arm", 1), HasSubstr("'third_arm'"));
  EXPECT_THAT(with(Json::json_pointer("/task/goals/0/effector"), "foot"), HasSubstr("'foot'"));
  EXPECT_THAT(with(Json::json_pointer("/task/layer_reading"), "none"), HasSubstr("'none'"));
}

TaskFile human_task() {
  TaskFile file = layers_task();
  file.preset = Preset::human;
  file.criteria = traits_of(file.preset).criteria();
  file.goals = {{"right_hand", {-0.05, 0.1, 0.3}}};
  return file;
}

TEST(HumanResult, IsReadBackBitForBitAndPlayedTheSame) {
  for (const char* body : {"full_body", "half_body"}) {
    TaskFile file = human_task();
    file.character.source = body;
    const ResultSample made(file);
    EXPECT_EQ(SchemaCheck::in_docs("result.schema.json").judge(nlohmann::json::parse(made.text())),
              "");
    StoredResult stored = parse_result(made.text(), "summary.json").value();
    ASSERT_EQ(stored.candidates.size(), made.generation.candidates.size());
    const Task task = make_task(stored.task, {}).value();
    for (std::size_t i = 0; i < stored.candidates.size(); ++i) {
      EXPECT_EQ(stored.candidates[i], made.generation.candidates[i].parameters);
      EXPECT_EQ(regenerate(task, stored.candidates[i]).value().candidates[0].motion.clip.angles,
                made.generation.candidates[i].motion.clip.angles);
    }
  }
}

TEST(HumanResult, WrongParametersAreNamedByTheirPlace) {
  const Json good = Json::parse(ResultSample(human_task()).text());
  ASSERT_EQ(message(good), "");
  const auto with = [&good](const char* name, const Json& value) {
    Json json = good;
    json["candidates"][0]["parameters"][name] = value;
    return message(json);
  };
  EXPECT_THAT(with("right_arm.swivel_rad", 2), HasSubstr("swivel_rad: is 2; allowed are"));
  EXPECT_THAT(with("left_elbow.flexion.final_rad", 9), HasSubstr("is 9; allowed are"));
  EXPECT_THAT(with("right_elbow.flexion.final_rad", 0),
              HasSubstr("'right_elbow.flexion.final_rad'"));
}

TEST(LayeredResult, OtherPresetsHaveNoArms) {
  Json json = Json::parse(sample().text());
  json["task"]["preset"] = "paper";
  EXPECT_THAT(message(json), HasSubstr("candidates[0].parameters"));
}

class AssignLayered : public testing::Test {
 protected:
  void expect(std::string_view name, double value, bool locked = false) {
    value_of(c_.list, c_.expected, name) = value;
    c_.expected.locked[number_of(c_.list, name)] = locked;
  }

  LayeredChange c_{full_body(), {{"left_hand", {}}, {"right_hand", {}}}};
};

TEST_F(AssignLayered, WeightAndLockOfTheUpperLayer) {
  ASSERT_TRUE(assign_parameter(c_.list, "right_hip.weight=3", c_.after));
  for (const char* hip : {"right_hip.flexion", "right_hip.abduction", "right_hip.rotation"}) {
    expect(hip, 3.0);
  }
  EXPECT_EQ(c_.after, c_.expected);
  ASSERT_TRUE(assign_parameter(c_.list, "right_shoulder.flexion.locked=true", c_.after));
  expect("right_shoulder.flexion.weight", 1.0, true);
  EXPECT_EQ(c_.after, c_.expected);
  ASSERT_TRUE(assign_parameter(c_.list, "right_shoulder.flexion.weight=2e2", c_.after));
  expect("right_shoulder.flexion.weight", 200.0);
  EXPECT_EQ(c_.after, c_.expected);
}

TEST_F(AssignLayered, ContractionOfAllLimbsThatShareIt) {
  ASSERT_TRUE(assign_parameter(c_.list, "arms.contraction=7.5", c_.after));
  expect("arms.contraction", 7.5);
  EXPECT_EQ(c_.after, c_.expected);
  EXPECT_NE(c_.after, c_.before);
}

TEST_F(AssignLayered, ArmsOwnLayerByItsName) {
  ASSERT_TRUE(assign_parameter(c_.list, "right_arm.right_elbow.flexion.weight=9", c_.after));
  expect("right_arm.right_elbow.flexion.weight", 9.0);
  EXPECT_EQ(c_.after, c_.expected);
  ASSERT_TRUE(assign_parameter(c_.list, "left_arm.left_shoulder.locked=true", c_.after));
  for (const std::string way : {"flexion", "abduction", "rotation"}) {
    expect("left_arm.left_shoulder." + way + ".weight", 1.0, true);
  }
  EXPECT_EQ(c_.after, c_.expected);
}

TEST_F(AssignLayered, WrongOnesChangeNothing) {
  for (const char* wrong :
       {"", "=", "legs=8", "legs.contraction", "legs.contraction=15.1", "legs.contraction=1e999",
        "right_hip.weight=0", "right_knee.weight=2", "right_elbow.weight=2",
        "right_arm.right_hip.weight=2", "right_hip.locked=1", "right_leg.contraction=3"}) {
    EXPECT_FALSE(assign_parameter(c_.list, wrong, c_.after)) << wrong;
    EXPECT_EQ(c_.after, c_.before) << wrong;
  }
}

class AssignHuman : public testing::Test {
 protected:
  LayeredChange c_{full_body(), {{"right_hand", {}}}, {LayerStack::human}};
};

TEST_F(AssignHuman, SwivelAndFinalAnglesInDegreesOrRadians) {
  ASSERT_TRUE(assign_parameter(c_.list, "right_arm.swivel_deg=20", c_.after));
  ASSERT_TRUE(assign_parameter(c_.list, "left_elbow.final_deg=40", c_.after));
  ASSERT_TRUE(assign_parameter(c_.list, "left_shoulder.abduction.final_rad=0.5", c_.after));
  value_of(c_.list, c_.expected, "right_arm.swivel_rad") = 20.0 * radians(1.0);
  value_of(c_.list, c_.expected, "left_shoulder.abduction.final_rad") = 0.5;
  value_of(c_.list, c_.expected, "left_elbow.flexion.final_rad") = 40.0 * radians(1.0);
  EXPECT_EQ(c_.after, c_.expected);
  ASSERT_TRUE(assign_parameter(c_.list, "arms.contraction=2", c_.after));
  ASSERT_TRUE(assign_parameter(c_.list, "right_hip.flexion.weight=2", c_.after));
}

TEST_F(AssignHuman, WrongOnesChangeNothing) {
  for (const char* wrong :
       {"right_arm.swivel_deg=91", "right_arm.swivel_deg=", "right_arm.swivel_deg=nan",
        "left_arm.swivel_deg=3", "right_arm.swivel=3", "right_elbow.final_deg=40",
        "left_elbow.final_deg=200", "left_elbow.final=40", "left_shoulder.rotation.final_deg=1",
        "right_arm.right_elbow.flexion.weight=2"}) {
    EXPECT_FALSE(assign_parameter(c_.list, wrong, c_.after)) << wrong;
    EXPECT_EQ(c_.after, c_.before) << wrong;
  }
}

}  // namespace
}  // namespace shigusa
