// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <shigusa.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace shigusa_c_test {

using Json = nlohmann::ordered_json;

struct Free {
  void operator()(shigusa_character* handle) const { shigusa_character_free(handle); }
  void operator()(shigusa_result* handle) const { shigusa_result_free(handle); }
};
using Character = std::unique_ptr<shigusa_character, Free>;
using Outcome = std::unique_ptr<shigusa_result, Free>;

inline Character character_of(const std::string& spec, const std::string& file = {}) {
  shigusa_character* made = nullptr;
  EXPECT_EQ(shigusa_character_create(spec.c_str(), file.empty() ? nullptr : file.data(),
                                     file.size(), &made),
            SHIGUSA_OK)
      << shigusa_message();
  return Character(made);
}

inline Outcome outcome_of(const shigusa_character* character, const std::string& task) {
  shigusa_result* made = nullptr;
  EXPECT_EQ(shigusa_generate(character, task.c_str(), 1, nullptr, &made), SHIGUSA_OK)
      << shigusa_message();
  return Outcome(made);
}

// The text that a function returns in its last argument.
template <class Function, class... Arguments>
std::string text_of(Function function, Arguments... arguments) {
  shigusa_bytes* bytes = nullptr;
  EXPECT_EQ(function(arguments..., &bytes), SHIGUSA_OK) << shigusa_message();
  std::string text(shigusa_bytes_data(bytes), shigusa_bytes_size(bytes));
  shigusa_bytes_free(bytes);
  return text;
}

inline Json json_of(const shigusa_result* result) {
  return Json::parse(text_of(shigusa_result_describe, result));
}

struct Table {
  size_t frames = 0;
  size_t columns = 0;
  std::vector<double> values;

  [[nodiscard]] double at(size_t frame, size_t column) const {
    return values[frame * columns + column];
  }
};

inline Table table_of(const shigusa_result* result, int32_t candidate, shigusa_series series) {
  const double* values = nullptr;
  Table table;
  EXPECT_EQ(
      shigusa_result_series(result, candidate, series, &values, &table.frames, &table.columns),
      SHIGUSA_OK)
      << shigusa_message();
  if (values != nullptr) table.values.assign(values, values + table.frames * table.columns);
  return table;
}

constexpr const char* kLowReach =
    R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.5]}],
        "seed": 3, "evaluations": 600})";

}  // namespace shigusa_c_test
