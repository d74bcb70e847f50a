// SPDX-License-Identifier: MIT
#include "regularities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "../experiments/report.hpp"
#include "files/file.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kFoundMaxBytes = 1 << 20;

// One run of the tests.
struct Found {
  std::string options;  // "--sex female"; empty by default
  nlohmann::json tests;

  [[nodiscard]] auto holding() const {
    return std::count_if(tests.begin(), tests.end(),
                         [](const nlohmann::json& test) { return test.at("holds").get<bool>(); });
  }
};

Result<Found> read_found(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kFoundMaxBytes));
  const std::string stem = path.stem().string();
  const std::size_t space = stem.find(' ');
  Found found{space == stem.npos ? "" : stem.substr(space + 1),
              nlohmann::json::parse(text, nullptr, false)};
  if (found.tests.is_array() && !found.tests.empty()) return found;
  return fail(ErrorCode::parse, "is no list of tests", path.string());
}

// Tests whose result depends on the options of a run.
std::string changed(const Found& usual, const Found& other) {
  std::string text;
  for (std::size_t i = 0; i < std::min(usual.tests.size(), other.tests.size()); ++i) {
    const nlohmann::json& test = other.tests[i];
    const bool holds = test.at("holds").get<bool>();
    if (holds == usual.tests[i].at("holds").get<bool>()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", holds ? "+" : "−",
                        test.at("test").get<std::string>());
  }
  return text.empty() ? "–" : text;
}

std::string tables(const std::vector<Found>& all) {
  const Found& usual = all.front();
  Table measured({"regularity", "source", "measured", "holds"});
  for (const nlohmann::json& test : usual.tests) {
    const auto word = [&](const char* key) { return test.at(key).get<std::string>(); };
    measured.add({word("test"), word("source"), word("measured"),
                  test.at("holds").get<bool>() ? "yes" : "**no**"});
  }
  Table others({"the same with", "hold", "beside the above"});
  for (std::size_t i = 1; i < all.size(); ++i) {
    others.add({"`" + all[i].options + "`",
                fmt::format("{} of {}", all[i].holding(), all[i].tests.size()),
                changed(usual, all[i])});
  }
  return fmt::format("{} of {} hold.\n\n", usual.holding(), usual.tests.size()) + measured.text() +
         "\n" + others.text();
}

}  // namespace

Result<std::string> regularities_section(const std::filesystem::path& folder) {
  std::string text =
      "## What people do\n\nRegularities that were published or measured of people, as "
      "`../shared/people/regularities.py` tests them by the command line: medians over 3 seeds of "
      "the best-scored candidate of the default preset on the body `human`. The bands were set "
      "from the sources, which `../shared/people/people.md` lists by their numbers, before the "
      "first run.\n\n";
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (files.empty()) return text + "Not measured: that takes Python 3 and the file.\n";
  std::sort(files.begin(), files.end());
  std::vector<Found> all;
  for (const std::filesystem::path& file : files) {
    SHG_TRY_ASSIGN(Found found, read_found(file));
    all.push_back(std::move(found));
  }
  return text + tables(all);
}

}  // namespace shigusa::bench
