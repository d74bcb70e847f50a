// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "c/handles.hpp"
#include "support/gltf_file.hpp"
#include "support/person_file.hpp"
#include "support/robot_file.hpp"

// Results of the C interface, for comparison between hosts.
namespace shigusa_c_test {

// The functions' results by name.
using Texts = std::map<std::string, std::string>;

constexpr const char* kReach =
    R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.5],
                   "load_kg": 1.25, "tolerance_m": [0.001, 0.0015, 0.001]}],
        "duration_s": 1.25, "seed": 3, "evaluations": 64, "candidates": 2, "fixed": ["bow=0.025"]})";

// A person's motion is found, edited, exported and restored.
inline void add_search(Texts& said) {
  const Character human = character_of(R"({"source": "human", "stature_m": 1.625})");
  said["character"] = text_of(shigusa_character_describe, human.get());
  const Outcome found = outcome_of(human.get(), kReach);
  ASSERT_NE(found, nullptr);
  const std::string summary = text_of(shigusa_result_describe, found.get());
  said["result"] = summary;
  for (const char* format : {"bvh", "csv", "npz", "svg"}) {
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
inline void add_character(Texts& said, const std::string& name, const std::string& file) {
  const Character read = character_of(R"({"source": ")" + name + R"("})", file);
  ASSERT_NE(read, nullptr) << name;
  said[name] = text_of(shigusa_character_describe, read.get());
  const Outcome found = outcome_of(read.get(), kReach);
  ASSERT_NE(found, nullptr) << name;
  const bool is_gltf = name.ends_with(".gltf");
  said[name + " reaches"] = text_of(shigusa_result_export, found.get(), 1, is_gltf ? "glb" : "csv");
}

inline Texts everything() {
  Texts said;
  add_search(said);
  // the same files, whatever the host computes in
  static const std::string bvh = shigusa::testing_support::person_bvh();
  static const std::string gltf = shigusa::testing_support::person_gltf().dump();
  static const std::string urdf = shigusa::testing_support::RobotFile().text();
  add_character(said, "person.bvh", bvh);
  add_character(said, "person.gltf", gltf);
  add_character(said, "robot.urdf", urdf);
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

// Removes the line with the search time.
inline std::string timeless(std::string text) {
  const std::size_t line = text.find("\"elapsed_ms\"");
  return line == text.npos ? text : text.erase(line, text.find('\n', line) - line);
}

}  // namespace shigusa_c_test
