// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>
#include <utility>

namespace shigusa::testing_support {

// A result of a task, in the form of its file.
struct ResultSample {
  TaskFile file;
  Task task;
  GenerateResult generation;

  // `generations`: the most of a genetic search.
  explicit ResultSample(TaskFile asked, int generations = GeneticSettings{}.max_generations)
      : file(std::move(asked)),
        task(make_task(file, {}).value()),
        generation(make(task, generations)) {}

  [[nodiscard]] std::string text() const { return format_result({file, task, generation}); }

 private:
  static GenerateResult make(Task& task, int generations) {
    task.genetic.max_generations = generations;
    return generate(task).value();
  }
};

// The first fault of a result; empty if there is none.
inline std::string message(const nlohmann::ordered_json& json) {
  const Result<StoredResult> result = parse_result(json.dump(), "summary.json");
  return result ? "" : result.error().to_string();
}

}  // namespace shigusa::testing_support
