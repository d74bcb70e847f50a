// SPDX-License-Identifier: MIT
// Results from before each parameter had one name.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <shigusa/files.hpp>

#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Json = nlohmann::ordered_json;

std::string stored(const std::string& name) {
  std::ifstream file(std::string(SHIGUSA_SOURCE_DIR "/tests/fuzz/result_corpus/") + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

class OldResult : public testing::TestWithParam<const char*> {};

TEST_P(OldResult, HasEachValueUnderItsName) {
  const std::string text = stored(GetParam());
  const Json parameters = Json::parse(text)["candidates"][0]["parameters"];
  StoredResult result = parse_result(text, GetParam()).value();
  const Task task = make_task(result.task, {}).value();
  const ParameterList list = parameter_list(task.body, task.start, task).value();
  const Parameters& values = result.candidates[0];
  std::set<std::size_t> seen;
  const auto expect = [&](const std::string& name, const Json& value) {
    const std::size_t at = number_of(list, name);
    EXPECT_EQ(values.values[at], value) << name;
    EXPECT_TRUE(seen.insert(at).second) << name;
  };
  // all of an object's members, by their names in `before` and `after`
  const auto expect_all = [&](const Json& of, const char* group, const std::string& before,
                              const std::string& after) {
    if (!of.contains(group)) return;
    const Json& members = of.at(group);
    for (const auto& [name, value] : members.items()) expect(before + name + after, value);
  };
  const auto expect_weights = [&](const Json& of, const std::string& layer) {
    expect_all(of, "weights", layer, ".weight");
    if (!of.contains("locked")) return;
    for (const std::string name : of.at("locked")) {
      EXPECT_TRUE(values.locked[number_of(list, layer + name + ".weight")]) << name;
    }
  };
  expect_weights(parameters, "");
  expect_all(parameters, "contractions", "", ".contraction");
  expect_all(parameters, "posture", "", "");
  expect_all(parameters, "supports", "", ".support");
  if (parameters.contains("arms")) {
    for (const auto& [arm, own] : parameters.at("arms").items()) {
      expect_weights(own, arm + ".");
      if (own.contains("swivel_rad")) expect(arm + ".swivel_rad", own.at("swivel_rad"));
    }
  }
  if (parameters.contains("rest")) {
    for (const auto& [name, value] : parameters.at("rest").items()) {
      expect(name.substr(0, name.rfind('_')) + ".final_rad", value);
    }
  }
  EXPECT_EQ(values.posed, !parameters.at("posture").empty());
  const bool all = values.posed || !list.has_posture();
  EXPECT_EQ(all, seen.size() == list.size());
}

INSTANTIATE_TEST_SUITE_P(Stored, OldResult,
                         testing::Values("half_body.json", "swivels.json", "layers.json",
                                         "person.json", "posture_and_support.json"),
                         [](const auto& file) {
                           const std::string name = file.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace shigusa
