// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/gltf_file.hpp"
#include "support/host_locale.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;

class Body : public testing::Test {
 protected:
  Body() { work_.put("person.bvh", person_bvh()); }

  ProgramRun body(Words arguments) {
    arguments.insert(arguments.begin(), "body");
    return run_shigusa(arguments, {.folder = work_.path()});
  }
  Json json(Words arguments) {
    arguments.push_back("--json");
    return Json::parse(body(arguments).out);
  }

  WorkFolder work_;
};

TEST_F(Body, JsonHasTheFieldsOfTheContract) {
  for (const char* source : {"half_body", "full_body", "person.bvh"}) {
    const Json object = json({source});
    EXPECT_EQ(object.at("name"), source);
    EXPECT_NEAR(object.at("stature_m").get<double>(), 1.741, 1e-3);
    EXPECT_GT(object.at("mass_kg").get<double>(), 50.0);
    EXPECT_EQ(object.at("dof"), object.at("joints").size());
    EXPECT_TRUE(object.at("humanoid").is_object());
    EXPECT_TRUE(object.at("doubts").is_array());
    for (const Json& joint : object.at("joints")) {
      EXPECT_TRUE(joint.at("name").is_string());
      EXPECT_TRUE(joint.at("parent").is_null() || joint.at("parent").is_string());
      EXPECT_EQ(joint.at("dof"), 1);
      EXPECT_LT(joint.at("limits_rad").at(0), joint.at("limits_rad").at(1));
    }
  }
}

TEST_F(Body, TwistBonesAreListedWithTheirShares) {
  nlohmann::json file = person_gltf();
  nlohmann::json& nodes = file["nodes"];
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].value("name", "") != "right_lower_arm") continue;
    const auto child = nodes[i]["children"][0].get<std::size_t>();
    const std::vector<double> hand = nodes[child]["translation"];
    nodes[i]["children"].push_back(nodes.size());
    nodes.push_back({{"name", "lowerarm_twist_01_r"},
                     {"translation", {0.5 * hand[0], 0.5 * hand[1], 0.5 * hand[2]}}});
    break;
  }
  work_.put("person.glb", glb(file.dump()));
  EXPECT_THAT(body({"person.glb"}).out,
              HasSubstr("twist bone         lowerarm_twist_01_r, 50 % along right_lower_arm"));
  const Json told = json({"person.glb"}).at("twist_bones");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].at("node"), "lowerarm_twist_01_r");
  EXPECT_EQ(told[0].at("along"), "right_lower_arm");
  EXPECT_NEAR(told[0].at("share").get<double>(), 0.5, 1e-9);
  EXPECT_TRUE(json({"person.bvh"}).at("twist_bones").empty());
}

TEST_F(Body, MapOfTheCallerGoesBeforeNames) {
  EXPECT_EQ(json({"person.bvh", "--map", "neck=head"}).at("humanoid").at("neck"), "head");
}

// Names with spaces, non-ASCII letters and duplicates are accepted as printed.
TEST_F(Body, MapTakesWhatBodyPrinted) {
  nlohmann::json file = testing_support::person_gltf();
  for (nlohmann::json& node : file["nodes"]) {
    const std::string name = node.value("name", "");
    if (name == "right_hand") node["name"] = "NPC R Hand [RHnd]";
    if (name == "left_hand") node["name"] = "左手首";
    if (name.ends_with("_foot")) node["name"] = "Foot";
  }
  work_.put("odd.glb", testing_support::glb(file.dump()));
  const Json humanoid = json({"odd.glb"}).at("humanoid");
  EXPECT_EQ(humanoid.at("right_hand"), "NPC R Hand [RHnd]");
  EXPECT_EQ(humanoid.at("left_foot").get<std::string>().substr(0, 4), "Foot");
  EXPECT_NE(humanoid.at("left_foot"), humanoid.at("right_foot"));
  for (const bool as_json : {false, true}) {
    const ProgramRun printed = as_json ? body({"odd.glb", "--json"}) : body({"odd.glb"});
    work_.put("map.txt", printed.out);
    EXPECT_EQ(json({"odd.glb", "--map", "map.txt"}).at("humanoid"), humanoid) << as_json;
  }
}

TEST_F(Body, MapTakesANodesPlaceInTheFile) {
  const nlohmann::json file = testing_support::person_gltf();
  work_.put("person.glb", testing_support::glb(file.dump()));
  std::size_t head = 0;
  while (file["nodes"][head].value("name", "") != "head") ++head;
  const std::string place = "neck=#" + std::to_string(head);
  EXPECT_EQ(json({"person.glb", "--map", place}).at("humanoid").at("neck"), "head");
}

TEST_F(Body, StatureMayBeAPercentile) {
  EXPECT_EQ(json({"human", "--stature", "p5", "--sex", "female"}).at("stature_m"), 1.528);
  EXPECT_EQ(json({"human", "--stature", "p95"}).at("stature_m"), 1.867);
  EXPECT_EQ(json({"human", "--stature", "1.6"}).at("stature_m"), 1.6);
  EXPECT_EQ(body({"human", "--stature", "1.6m"}).exit_code, 2);
}

TEST_F(Body, NumbersHaveAPointWhateverTheShellsLanguage) {
  const Words asked{"human", "--stature", "1.625", "--mass", "61.5"};
  const Json usual = json(asked);
  const HostLocale host("de_DE");
  if (!host.chosen()) GTEST_SKIP() << "no locale de_DE and no localedef";
  setenv("LC_ALL", "de_DE.UTF-8", 1);
  const Json there = json(asked);
  unsetenv("LC_ALL");
  EXPECT_EQ(there, usual);
  EXPECT_EQ(there.at("stature_m"), 1.625);
}

TEST_F(Body, PlacementTellsWhereGoalsAreInTheFile) {
  const Json placement = json({"person.bvh"}).at("placement");
  EXPECT_NEAR(placement.at("unit_m").get<double>(), 0.01, 1e-12);
  // the person of the file stands as shigusa's own does, in centimetres
  EXPECT_NEAR(placement.at("up").at(1).get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(placement.at("ahead").at(2).get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(placement.at("origin").at(0).get<double>(), 0.0, 1e-4);
  EXPECT_FALSE(json({"half_body"}).contains("placement"));
}

TEST_F(Body, StatureMassAndSexAreTaken) {
  const Json object = json({"half_body", "--stature", "1.6", "--mass", "55", "--sex", "female"});
  EXPECT_EQ(object.at("stature_m"), 1.6);
  // the segments' shares of the anthropometric table sum to 0.9999
  EXPECT_NEAR(object.at("mass_kg").get<double>(), 55.0, 0.01);
  EXPECT_EQ(json({"person.bvh", "--stature", "1.5"}).at("stature_m"), 1.5);
}

TEST_F(Body, TextListsEveryFreedomInDegrees) {
  const ProgramRun run = body({"half_body"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, testing::StartsWith("half_body: 1.741 m, 73.0 kg, 9 dof\n"));
  EXPECT_THAT(run.out, testing::ContainsRegex("right_elbow.flexion +10.0 +0 to +150"));
  EXPECT_THAT(run.out, Not(HasSubstr("-0.0 "))) << "nothing is minus zero";
}

}  // namespace
}  // namespace shigusa
