// SPDX-License-Identifier: MIT
#include <charconv>
#include <iostream>
#include <map>
#include <shigusa/human.hpp>
#include <sstream>

#include "../people/record.hpp"
#include "cases.hpp"
#include "files/file.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kTableMaxBytes = 1 << 20;
constexpr const char* kHeldOutPerson = "boxS7";
constexpr std::size_t kHeldOut = 4;       // one reach of the man of this number
constexpr double kWristHeight = 0.486;    // of the stature, with a hanging arm
constexpr double kGripBelowWrist = 0.08;  // m
constexpr double kHangsFrom = 0.74;       // m, lower wrists and
constexpr double kHangsTo = 0.97;         // m, higher ones do not hang at the start
constexpr double kOutOfReach = 2.1;       // m
constexpr const char* kClip = "cmu_02_06_60hz.bvh";

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> values;
    for (std::string cell; std::getline(cells, cell, '\t');) values.push_back(cell);
    if (names.empty()) {
      names = values;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < values.size() && i < names.size(); ++i) row[names[i]] = values[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

// Mean of a column over the rows that have it.
std::optional<double> mean_of(const std::vector<Row>& rows, const std::string& column) {
  double sum = 0.0;
  int count = 0;
  for (const Row& row : rows) {
    const auto found = row.find(column);
    if (found == row.end()) continue;
    const std::string& text = found->second;
    double value = 0.0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

// A person's reach from hanging arms, averaged over repetitions. For a person instructed to squat,
// only the path and its timing are compared.
std::optional<Case> case_of_rows(const std::vector<Row>& rows) {
  const auto from = mean_of(rows, "h0");
  const auto to = mean_of(rows, "h1");
  const auto ahead = mean_of(rows, "f1");
  if (!from || !to || !ahead || *from < kHangsFrom || *from > kHangsTo || *to > kOutOfReach)
    return {};
  const double stature = *from / kWristHeight;
  Task task(human_body({stature, default_mass(stature, Sex::male), Sex::male}));
  const bool both = rows.front().at("hand") != "r";
  const double y = *to < *from ? max(*to - kGripBelowWrist, 0.04) : *to + 0.5 * kGripBelowWrist;
  task.goals = {{"right_hand", {both ? -0.165 : -0.15, y, *ahead}}};
  if (both) task.goals.push_back({"left_hand", {0.165, y, *ahead}});
  Case made = case_of(std::move(task), Side::right);
  const auto know = [&](double Figures::*figure, const char* column, double unit) {
    if (const auto value = mean_of(rows, column)) made.recorded.push_back({figure, *value, unit});
  };
  know(&Figures::bow, "bowf", 0.04);
  know(&Figures::peak, "pf", 0.05);
  if (rows.front().at("action").find("squat") != std::string::npos) return made;
  know(&Figures::knee_change, "kn1", 16.0);
  made.recorded.back().value -= mean_of(rows, "kn0").value_or(0.0);
  know(&Figures::trunk, "tr1", 7.0);
  know(&Figures::drop, "pdy", 0.06);
  made.recorded.back().value *= -1.0;
  if (*to < *from) know(&Figures::free_elbow, "oel1", 20.0);
  return made;
}

std::vector<Unit> people_units(const std::filesystem::path& table) {
  const auto text = read_text_file(table, kTableMaxBytes);
  if (!text) {
    std::cerr << "no recorded persons: " << text.error().to_string() << "\n";
    return {};
  }
  std::map<std::string, std::vector<Row>> reaches;
  for (const Row& row : rows_of(*text)) {
    if (row.at("action").find("rise") != std::string::npos) continue;
    reaches[row.at("person") + " " + row.at("action")].push_back(row);
  }
  std::vector<Unit> units;
  for (const auto& [name, rows] : reaches) {
    auto made = case_of_rows(rows);
    if (!made) continue;
    units.push_back({name, Series::none, {}, rows.front().at("person") == kHeldOutPerson});
    units.back().cases.push_back(std::move(*made));
  }
  return units;
}

std::vector<Unit> man_units(const std::filesystem::path& folder) {
  const auto segments = downward_segments(folder / "manifest.tsv");
  if (!segments) {
    std::cerr << "no recorded man: " << segments.error().to_string() << "\n";
    return {};
  }
  std::vector<Unit> units;
  for (const Segment& segment : *segments) {
    auto reach = read_reach(folder / kClip, segment);
    if (!reach) continue;
    Motion record;
    record.clip = reach->track.angles;
    const Figures his = figures_of(reach->posed, record, Side::right);
    Case made = case_of(reach->task(), Side::right);
    made.recorded = {{&Figures::trunk, his.trunk, 14.0},
                     {&Figures::knee, his.knee, 24.0},
                     {&Figures::drop, his.drop, 0.12},
                     {&Figures::bow, his.bow, 0.04},
                     {&Figures::head, his.head, 0.10}};
    units.push_back({segment.name, Series::none, {}, units.size() % kHeldOut == kHeldOut - 1});
    units.back().cases.push_back(std::move(made));
  }
  return units;
}

}  // namespace

std::vector<Unit> recorded_units(const std::filesystem::path& shared) {
  std::vector<Unit> units = people_units(shared / "people" / "reaches.tsv");
  for (Unit& unit : man_units(shared / "reach")) units.push_back(std::move(unit));
  return units;
}

}  // namespace shigusa::bench
