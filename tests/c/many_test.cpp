// SPDX-License-Identifier: MIT
// Many tasks in one call.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "c/handles.hpp"

namespace shigusa_c_test {
namespace {

constexpr const char* kWork =
    R"({"version": 2, "evaluations": 60, "candidates": 1, "actions": [
        {"goals": [{"effector": "right_hand", "position_m": [-0.2, 1, 0.5]}]}, {"wait_s": 0.2}]})";
constexpr std::array<const char*, 5> kTasks{kLowReach, R"({"goals": 3})", kWork, nullptr,
                                            R"({"goals": [{"effector": "left_hand",
    "position_m": [0.25, 1.2, 0.4]}], "seed": 5, "evaluations": 200})"};

struct Many {
  std::array<Outcome, kTasks.size()> results;
  Json failures;
};

Many many(int32_t threads, const shigusa_watch* watch = nullptr) {
  std::array<shigusa_result*, kTasks.size()> results{};
  shigusa_bytes* failures = nullptr;
  const Character human = character_of(R"("human")");
  EXPECT_EQ(shigusa_generate_all(human.get(), kTasks.data(), kTasks.size(), threads, watch,
                                 results.data(), &failures),
            SHIGUSA_OK)
      << shigusa_message();
  Many made;
  for (std::size_t i = 0; i < results.size(); ++i) made.results[i].reset(results[i]);
  made.failures =
      Json::parse(std::string(shigusa_bytes_data(failures), shigusa_bytes_size(failures)));
  shigusa_bytes_free(failures);
  return made;
}

TEST(CInterfaceOfMany, IsTheSameAsOneAtATime) {
  for (const int32_t threads : {1, 3}) {
    const Many made = many(threads);
    ASSERT_EQ(made.failures.size(), kTasks.size());
    for (const std::size_t i : {0U, 2U, 4U}) {
      ASSERT_NE(made.results[i], nullptr) << i;
      EXPECT_TRUE(made.failures.at(i).is_null()) << i;
      const Outcome one = outcome_of(nullptr, kTasks[i]);
      EXPECT_TRUE(json_of(made.results[i].get()).at("candidates") ==
                  json_of(one.get()).at("candidates"))
          << i;
    }
  }
}

TEST(CInterfaceOfMany, WrongTasksFailAlone) {
  const Many made = many(1);
  for (const std::size_t i : {1U, 3U}) EXPECT_EQ(made.results[i], nullptr);
  EXPECT_THAT(made.failures.at(1).at("place").get<std::string>(), testing::StartsWith("tasks[1]"));
  EXPECT_THAT(made.failures.at(3).dump(), testing::HasSubstr("tasks[3] is null"));
  shigusa_bytes* none = nullptr;
  EXPECT_EQ(shigusa_generate_all(nullptr, kTasks.data(), 1, 1, nullptr, nullptr, &none),
            SHIGUSA_INVALID_ARGUMENT);
  shigusa_result* result = nullptr;
  EXPECT_EQ(shigusa_generate_all(nullptr, kTasks.data(), 1, -1, nullptr, &result, &none),
            SHIGUSA_INVALID_ARGUMENT);
  EXPECT_EQ(shigusa_generate_all(nullptr, kTasks.data(), 0, 1, nullptr, &result, &none),
            SHIGUSA_OK);
  EXPECT_STREQ(shigusa_bytes_data(none), "[]");
  shigusa_bytes_free(none);
}

TEST(CInterfaceOfMany, StopsWhenTold) {
  const shigusa_watch stop{[](void*, double, int32_t, double) { return int32_t{1}; }, nullptr};
  const Many made = many(1, &stop);
  // what had begun has its best so far
  EXPECT_NE(made.results[0], nullptr);
  EXPECT_EQ(made.results[2], nullptr);
  EXPECT_THAT(made.failures.at(2).dump(), testing::HasSubstr("not begun"));
}

}  // namespace
}  // namespace shigusa_c_test
