// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "c/handles.hpp"
#include "support/gltf_file.hpp"
#include "support/host_locale.hpp"
#include "support/person_file.hpp"
#include "support/robot_file.hpp"

namespace shigusa_c_test {
namespace {

using shigusa::testing_support::HostLocale;

// The functions' answers, by a name for each.
using Texts = std::map<std::string, std::string>;

constexpr const char* kReach =
    R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.5],
                   "load_kg": 1.25, "tolerance_m": [0.001, 0.0015, 0.001]}],
        "duration_s": 1.25, "seed": 3, "evaluations": 64, "candidates": 2, "fixed": ["bow=0.025"]})";

// A person's motion is found, changed, taken away and brought back.
void add_search(Texts& said) {
  const Character human = character_of(R"({"source": "human", "stature_m": 1.625})");
  said["character"] = text_of(shigusa_character_describe, human.get());
  const Outcome found = outcome_of(human.get(), kReach);
  ASSERT_NE(found, nullptr);
  const std::string summary = text_of(shigusa_result_describe, found.get());
  said["result"] = summary;
  for (const char* format : {"bvh", "csv", "svg", "png", "pdf"}) {
    said[format] = text_of(shigusa_result_export, found.get(), 1, format);
  }
  shigusa_result* changed = nullptr;
  EXPECT_EQ(shigusa_replay(found.get(), 1, R"(["bow=0.05", "right_elbow.weight=2.5"])", &changed),
            SHIGUSA_OK)
      << shigusa_message();
  ASSERT_NE(changed, nullptr);
  const Outcome edited(changed);
  said["edited"] = text_of(shigusa_result_describe, changed);
  said["parameters"] = text_of(shigusa_result_parameters, changed, 1);
  shigusa_result* again = nullptr;
  EXPECT_EQ(shigusa_restore(human.get(), summary.c_str(), &again), SHIGUSA_OK) << shigusa_message();
  ASSERT_NE(again, nullptr);
  const Outcome restored(again);
  said["restored"] = text_of(shigusa_result_export, again, 1, "csv");
}

// A character from a file reaches.
void add_character(Texts& said, const std::string& name, const std::string& file) {
  const Character read = character_of(R"({"source": ")" + name + R"("})", file);
  ASSERT_NE(read, nullptr) << name;
  said[name] = text_of(shigusa_character_describe, read.get());
  const Outcome found = outcome_of(read.get(), kReach);
  ASSERT_NE(found, nullptr) << name;
  const bool is_gltf = name.ends_with(".gltf");
  said[name + " reaches"] = text_of(shigusa_result_export, found.get(), 1, is_gltf ? "glb" : "csv");
}

Texts everything() {
  Texts said;
  add_search(said);
  const std::string bvh = shigusa::testing_support::person_bvh();
  add_character(said, "person.bvh", bvh);
  add_character(said, "person.gltf", shigusa::testing_support::person_gltf().dump());
  add_character(said, "robot.urdf", shigusa::testing_support::RobotFile().text());
  said["score"] = text_of(shigusa_score_clip, "person.bvh", bvh.data(), bvh.size(),
                          R"({"criteria": "paper", "smoothed_hz": 0.5})");
  shigusa_result* none = nullptr;
  const Character human = character_of(R"("human")");
  EXPECT_EQ(shigusa_generate(human.get(), R"({"goals": [{"effector": "right_hand",
                             "position_m": [0.25, 0.9, 0.5]}], "fixed": ["bow=0,05"]})",
                             1, nullptr, &none),
            SHIGUSA_INVALID_ARGUMENT);
  said["message"] = shigusa_message();
  return said;
}

// Without the line that tells how long a search took.
std::string timeless(std::string text) {
  const std::size_t line = text.find("\"elapsed_ms\"");
  return line == text.npos ? text : text.erase(line, text.find('\n', line) - line);
}

class InALocale : public testing::TestWithParam<const char*> {};

TEST_P(InALocale, TheInterfaceGivesTheSameBytes) {
  const Texts usual = everything();
  Texts there;
  {
    const HostLocale host(GetParam());
    if (!host.chosen()) GTEST_SKIP() << "no locale " << GetParam() << " and no localedef";
    there = everything();
  }
  EXPECT_THAT(usual.at("message"), testing::HasSubstr("'0,05'"));
  for (const auto& [name, text] : usual)
    EXPECT_TRUE(timeless(there[name]) == timeless(text)) << name;
}

INSTANTIATE_TEST_SUITE_P(CInterface, InALocale, testing::Values("de_DE", "ps_AF"),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace shigusa_c_test
