// SPDX-License-Identifier: MIT
#include "document/facts.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>

#include "criteria/built_in_criteria.hpp"

namespace shigusa {
namespace {

using Json = nlohmann::json;

Json facts() { return Json::parse(format_facts()); }

// A task with a number in its place.
Result<TaskFile> task_with(const std::string& key, double value) {
  const bool whole = key == "candidates" || key == "evaluations";
  const Json number = whole ? Json(static_cast<std::uint64_t>(value)) : Json(value);
  Json task{{"character", {{"source", "human"}}},
            {"goals", {{{"effector", "right_hand"}, {"position_m", {0, 1, 0}}}}}};
  Json& goal = task["goals"][0];
  if (key == "position_m") goal[key][0] = number;
  if (key == "tolerance_m") goal[key] = {number, 0, 0};
  if (key == "load_kg") goal[key] = number;
  if (key == "stature_m" || key == "mass_kg" || key == "seat_m") task["character"][key] = number;
  if (key == "duration_s" || key == "ease" || key == "gaze_lead" || whole) task[key] = number;
  return parse_task(task.dump(), "task");
}

TEST(Facts, RangesAreThoseOfTheReader) {
  const Json ranges = facts().at("ranges");
  for (const auto& [key, range] : ranges.items()) {
    if (key == "fps" || key == "obstacles") continue;
    const double low = range.at(0);
    const double high = range.at(1);
    EXPECT_TRUE(task_with(key, low)) << key;
    EXPECT_TRUE(task_with(key, high)) << key;
    EXPECT_FALSE(task_with(key, high + 1.0)) << key;
    EXPECT_FALSE(task_with(key, low - 1.0)) << key;
  }
  EXPECT_EQ(ranges.at("obstacles").at(1), kObstaclesMax);
  for (const double rate : ranges.at("fps")) EXPECT_TRUE(check_rate(rate, "fps")) << rate;
  EXPECT_FALSE(check_rate(ranges.at("fps").at(1).get<double>() + 1.0, "fps"));
}

Json weights_of(CriteriaSettings criteria) {
  Json json;
  for (const CriterionTraits& criterion : kCriteria) {
    json[std::string(criterion.word)] = criteria[criterion.kind].weight;
  }
  return json;
}

TEST(Facts, PresetsAndParetoRankByTheMixtureThatTheReaderGivesThem) {
  const Json told = facts();
  ASSERT_EQ(told.at("presets").size(), kPresets.size());
  for (const Json& preset : told.at("presets")) {
    const Json plain{{"preset", preset.at("name")}, {"goals", Json::array()}};
    const TaskFile task = parse_task(plain.dump(), "task").value();
    EXPECT_EQ(told.at("mixtures").at(preset.at("mixture")), weights_of(task.criteria)) << preset;
    EXPECT_EQ(preset.at("candidates"), task.candidates) << preset;
  }
  const TaskFile front = parse_task(R"({"pareto": true, "goals": []})", "task").value();
  EXPECT_EQ(told.at("mixtures").at(told.at("pareto_mixture")), weights_of(front.criteria));
}

TEST(Facts, HabitsAreWordsOfTasksTheDefaultFirst) {
  const Json habits = facts().at("habits");
  EXPECT_EQ(habits.size(), kHabits.size());
  for (const Json& habit : habits) {
    const Json plain{{"habit", habit.at("name")}, {"goals", Json::array()}};
    const TaskFile task = parse_task(plain.dump(), "task").value();
    EXPECT_EQ(task.habit == Habit{}, habit == habits.at(0)) << habit;
    EXPECT_FALSE(habit.at("about").get<std::string>().empty()) << habit;
  }
}

TEST(Facts, CriteriaStandInTheOrderOfScoresWithTheKeysOfTheirScales) {
  const Json told = facts();
  std::size_t at = 0;
  for (const CriterionTraits& known : kCriteria) {
    const Json& criterion = told.at("criteria").at(at++);
    EXPECT_EQ(criterion.at("name"), known.word);
    EXPECT_EQ(criterion.at("scale"), known.scale_name);
  }
  EXPECT_EQ(told.at("criteria").size(), at);
}

TEST(Facts, FormatsAreThoseThatAreReadAndWritten) {
  const Json told = facts();
  for (const Json& format : told.at("formats")) {
    const std::string name = format.at("name");
    const bool by_program = name == "png" || name == "pdf";
    EXPECT_EQ(parse_formats(name).has_value(), by_program || format.at("written")) << name;
    for (const std::string ending : format.at("endings")) {
      const bool character = format.at("person") || format.at("robot");
      EXPECT_EQ(check_source({.source = "name" + ending}).has_value(), character) << ending;
    }
  }
  for (const FormatInfo& info : kFileFormats) {
    EXPECT_EQ(
        check_formats({}, {info.format}).has_value(),
        info.written && (info.needs == NeededFile::none || (info.mannequin && has_mannequin())))
        << info.word;
  }
}

TEST(Facts, TimingIsThatOfParametersAndOfTheTask) {
  std::vector<std::string> names;
  const Json all = facts();
  for (const Json& number : all.at("timing")) {
    names.push_back(number.at("name"));
    EXPECT_LT(number.at("low"), number.at("high")) << names.back();
    EXPECT_FALSE(number.at("sentence").get<std::string>().empty()) << names.back();
  }
  EXPECT_EQ(names, (std::vector<std::string>{"delay", "bow", "skew", "sway", "ease", "gaze_lead"}));
}

TEST(Facts, JointNamesAreOfEachBone) {
  const Json all = facts();
  for (const Json& names : all.at("joint_names")) {
    EXPECT_EQ(names.at("bones").size(), 22u) << names;
    EXPECT_EQ(names.at("name") == "own", names.at("bones").at("hips") == "hips") << names;
  }
}

}  // namespace
}  // namespace shigusa
