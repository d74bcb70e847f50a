// SPDX-License-Identifier: MIT
// Tasks with actions and things through the C interface.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "c/handles.hpp"

namespace shigusa_c_test {
namespace {

constexpr const char* kBoxPutUp =
    R"({"version": 2, "seed": 3, "evaluations": 200, "candidates": 2,
        "things": {"box": {"size_m": [0.4, 0.3, 0.3], "mass_kg": 4, "position_m": [0, 0.15, 0.42]},
                   "cup": {"shape": "cylinder", "size_m": [0.08, 0.1, 0.08],
                           "position_m": [-0.3, 0.9, 0.35]}},
        "actions": [{"grasp": "box"}, {"place": "box", "position_m": [0, 0.9, 0.45]}]})";
constexpr std::size_t kPose = 7;  // numbers of a pose

const shigusa_result* box_put_up() {
  static const Outcome made = outcome_of(nullptr, kBoxPutUp);
  return made.get();
}

void expect_at(const Table& poses, std::size_t frame, std::size_t thing, const double (&at)[3]) {
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(poses.at(frame, kPose * thing + k), at[k], 1e-3) << frame << ": " << k;
  }
}

TEST(CInterfaceOfWork, GivesActionsAndTheWaysOfThings) {
  const shigusa_result* result = box_put_up();
  ASSERT_NE(result, nullptr);
  const Json summary = json_of(result);
  EXPECT_EQ(summary.at("status"), "reached");
  ASSERT_GE(shigusa_result_candidates(result), 1);
  const Json& actions = summary.at("candidates").at(0).at("actions");
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(actions.at(0).at("kind"), "grasp");
  EXPECT_EQ(actions.at(0).at("start_s"), 0.0);
  EXPECT_EQ(actions.at(1).at("start_s"), actions.at(0).at("end_s"));
  EXPECT_NE(actions.at(1).at("verdict"), "impossible");
  EXPECT_LE(actions.at(1).at("placed").at("error_mm"), 1.0);
  const Table times = table_of(result, 1, SHIGUSA_TIME);
  const Table poses = table_of(result, 1, SHIGUSA_THINGS);
  ASSERT_EQ(poses.columns, 2 * kPose);
  ASSERT_EQ(poses.frames, times.frames);
  EXPECT_NEAR(times.values.back(), actions.at(1).at("end_s").get<double>(), 1e-9);
  expect_at(poses, 0, 0, {0, 0.15, 0.42});
  expect_at(poses, poses.frames - 1, 0, {0, 0.9, 0.45});
  for (const std::size_t f : {std::size_t{0}, poses.frames / 2, poses.frames - 1}) {
    expect_at(poses, f, 1, {-0.3, 0.9, 0.35});
    double square = 0.0;
    for (std::size_t k = 3; k < kPose; ++k) square += poses.at(f, k) * poses.at(f, k);
    EXPECT_NEAR(square, 1.0, 1e-12);
  }
}

TEST(CInterfaceOfWork, ThingsMoveAtAnyRate) {
  shigusa_bytes* bytes = nullptr;
  std::size_t frames = 0;
  std::size_t columns = 0;
  ASSERT_EQ(
      shigusa_result_series_at(box_put_up(), 1, SHIGUSA_THINGS, 24.0, &bytes, &frames, &columns),
      SHIGUSA_OK);
  Table poses{frames, columns, std::vector<double>(frames * columns)};
  ASSERT_EQ(shigusa_bytes_size(bytes), poses.values.size() * sizeof(double));
  std::memcpy(poses.values.data(), shigusa_bytes_data(bytes), shigusa_bytes_size(bytes));
  shigusa_bytes_free(bytes);
  ASSERT_EQ(columns, 2 * kPose);
  expect_at(poses, 0, 0, {0, 0.15, 0.42});
  expect_at(poses, frames - 1, 0, {0, 0.9, 0.45});
}

TEST(CInterfaceOfWork, IsTheSameAfterItsSummary) {
  const std::string summary = text_of(shigusa_result_describe, box_put_up());
  shigusa_result* again = nullptr;
  ASSERT_EQ(shigusa_restore(nullptr, summary.c_str(), &again), SHIGUSA_OK) << shigusa_message();
  const Outcome restored(again);
  ASSERT_EQ(shigusa_result_candidates(again), shigusa_result_candidates(box_put_up()));
  for (std::int32_t k = 1; k <= shigusa_result_candidates(again); ++k) {
    for (const shigusa_series series : {SHIGUSA_ANGLES, SHIGUSA_THINGS}) {
      EXPECT_EQ(table_of(again, k, series).values, table_of(box_put_up(), k, series).values);
    }
  }
}

TEST(CInterfaceOfWork, AnEditAndAMirrorImageAreWhole) {
  shigusa_result* made = nullptr;
  ASSERT_EQ(shigusa_replay(box_put_up(), 1, R"(["squat_deg=30"])", &made), SHIGUSA_OK)
      << shigusa_message();
  const Outcome edited(made);
  const Json one = json_of(made).at("candidates").at(0);
  EXPECT_EQ(one.at("actions").size(), 2U);
  EXPECT_NE(table_of(made, 1, SHIGUSA_ANGLES).values,
            table_of(box_put_up(), 1, SHIGUSA_ANGLES).values);
  ASSERT_EQ(shigusa_mirror(box_put_up(), &made), SHIGUSA_OK) << shigusa_message();
  const Outcome mirrored(made);
  expect_at(table_of(made, 1, SHIGUSA_THINGS), 0, 1, {0.3, 0.9, 0.35});
}

constexpr const char* kThreeReaches =
    R"({"version": 2, "seed": 3, "evaluations": 200, "candidates": 2, "actions": [
        {"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.0, 0.5]}]},
        {"wait_s": 0.5},
        {"goals": [{"effector": "right_hand", "position_m": [-0.3, 0.6, 0.45]}]},
        {"goals": [{"effector": "left_hand", "position_m": [0.3, 1.3, 0.4]}]}]})";

const shigusa_result* three_reaches() {
  static const Outcome made = outcome_of(nullptr, kThreeReaches);
  return made.get();
}

Outcome worked(const char* edit) {
  shigusa_result* made = nullptr;
  EXPECT_EQ(shigusa_replay_work(three_reaches(), 1, edit, nullptr, &made), SHIGUSA_OK)
      << shigusa_message();
  return Outcome(made);
}

// The motions' values, by which they are made.
Json motions_of(const shigusa_result* result) {
  return json_of(result).at("candidates").at(0).at("motions");
}

// Angles until the end of an action, from 1, of the first candidate.
std::vector<double> angles_until(const shigusa_result* result, std::size_t action) {
  const Table times = table_of(result, 1, SHIGUSA_TIME);
  const Table angles = table_of(result, 1, SHIGUSA_ANGLES);
  const double end =
      json_of(result).at("candidates").at(0).at("actions").at(action - 1).at("end_s");
  std::vector<double> until;
  for (std::size_t f = 0; f < times.frames && times.at(f, 0) <= end + 1e-9; ++f) {
    for (std::size_t d = 0; d < angles.columns; ++d) until.push_back(angles.at(f, d));
  }
  return until;
}

TEST(CInterfaceOfWork, AnEditOfOneActionLeavesThoseBeforeIt) {
  const Outcome edited = worked(R"({"action": 3, "set": ["squat_deg=70"]})");
  ASSERT_NE(edited, nullptr);
  EXPECT_EQ(shigusa_result_candidates(edited.get()), 1);
  EXPECT_EQ(angles_until(edited.get(), 2), angles_until(three_reaches(), 2));
  EXPECT_NE(angles_until(edited.get(), 3), angles_until(three_reaches(), 3));
  const Json actions = json_of(edited.get()).at("candidates").at(0).at("actions");
  ASSERT_EQ(actions.size(), 4U);
  EXPECT_LE(actions.at(3).at("reached").at(0).at("error_mm"), 1.0);
  const auto value_of = [&](const shigusa_result* result, int action) {
    for (const Json& one :
         Json::parse(text_of(shigusa_result_action_parameters, result, 1, action))) {
      if (one.at("name") == "squat_deg") return one.at("value").get<double>();
    }
    return 0.0;
  };
  EXPECT_EQ(value_of(edited.get(), 3), 70.0);
  EXPECT_EQ(value_of(edited.get(), 4), value_of(three_reaches(), 4));
  EXPECT_EQ(text_of(shigusa_result_action_parameters, edited.get(), 1, 1),
            text_of(shigusa_result_parameters, edited.get(), 1));
  EXPECT_EQ(Json::parse(text_of(shigusa_result_action_parameters, edited.get(), 1, 2)),
            Json::array());
}

TEST(CInterfaceOfWork, AnEditOfNothingIsTheCandidate) {
  EXPECT_EQ(table_of(worked(nullptr).get(), 1, SHIGUSA_ANGLES).values,
            table_of(three_reaches(), 1, SHIGUSA_ANGLES).values);
}

TEST(CInterfaceOfWork, AnActionIsSearchedAnewWithAnotherSeed) {
  const Outcome again = worked(R"({"again": [3], "seed": 11})");
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(json_of(again.get()).at("task").at("seed"), 11);
  const Json motions = motions_of(again.get());
  const Json own = motions_of(three_reaches());
  ASSERT_EQ(motions.size(), own.size());
  EXPECT_EQ(motions.at(0), own.at(0));
  EXPECT_NE(motions.at(1), own.at(1));
  EXPECT_EQ(motions.at(2), own.at(2));
  // the others are kept, and an edit of the edit is of its own seed
  const Outcome kept = worked(R"({"keep": [1, 2, 4], "seed": 11})");
  EXPECT_EQ(motions_of(kept.get()), motions);
  shigusa_result* made = nullptr;
  ASSERT_EQ(shigusa_replay_work(again.get(), 1, R"({"again": [3]})", nullptr, &made), SHIGUSA_OK);
  EXPECT_EQ(motions_of(Outcome(made).get()), motions);
}

TEST(CInterfaceOfWork, ASearchAnewCanBeWatched) {
  int reports = 0;
  const shigusa_watch watch{[](void* user, double, std::int32_t, double) {
                              ++*static_cast<int*>(user);
                              return 0;
                            },
                            &reports};
  shigusa_result* made = nullptr;
  ASSERT_EQ(shigusa_replay_work(three_reaches(), 1, R"({"again": [4]})", &watch, &made),
            SHIGUSA_OK);
  shigusa_result_free(made);
  EXPECT_GT(reports, 0);
}

TEST(CInterfaceOfWork, WrongEditsAreTold) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"action": 5})", "no action 5; the task has 4"},
      {R"({"again": [1, 9]})", "no action 9"},
      {R"({"keep": [7]})", "no action 7"},
      {R"({"again": 3})", "again: must be a list of actions, 1 to 64"},
      {R"({"keep": [0]})", "keep: must be a list of actions"},
      {R"({"action": 2, "set": ["squat_deg=20"]})", "action 2 has no motion"},
      {R"({"set": ["squatt_deg=20"]})", "squatt_deg"},
      {R"({"sett": []})", "sett"},
      {R"([])", "edit"}};
  for (const auto& [edit, says] : wrong) {
    shigusa_result* none = nullptr;
    EXPECT_NE(shigusa_replay_work(three_reaches(), 1, edit, nullptr, &none), SHIGUSA_OK) << edit;
    EXPECT_THAT(shigusa_message(), testing::HasSubstr(says));
    EXPECT_EQ(none, nullptr);
  }
  shigusa_result* none = nullptr;
  const Outcome one = outcome_of(nullptr, kLowReach);
  EXPECT_EQ(shigusa_replay_work(one.get(), 1, nullptr, nullptr, &none), SHIGUSA_INVALID_ARGUMENT);
  EXPECT_THAT(shigusa_message(), testing::HasSubstr("the task has 0"));
}

// Nothing moves, so that there are no parameters of a search.
TEST(CInterfaceOfWork, WaitingAloneIsWork) {
  const Outcome result = outcome_of(nullptr, R"({"version": 2, "actions": [{"wait_s": 0.5}]})");
  ASSERT_NE(result, nullptr);
  const Json summary = json_of(result.get());
  EXPECT_EQ(summary.at("status"), "reached");
  EXPECT_EQ(summary.at("candidates").at(0).at("duration_s"), 0.5);
  EXPECT_FALSE(text_of(shigusa_result_parameters, result.get(), 1).empty());
  shigusa_result* again = nullptr;
  ASSERT_EQ(shigusa_restore(nullptr, summary.dump().c_str(), &again), SHIGUSA_OK)
      << shigusa_message();
  EXPECT_EQ(table_of(Outcome(again).get(), 1, SHIGUSA_ANGLES).values,
            table_of(result.get(), 1, SHIGUSA_ANGLES).values);
}

TEST(CInterfaceOfWork, WrongActionsAreTold) {
  shigusa_result* none = nullptr;
  EXPECT_EQ(shigusa_generate(nullptr, R"({"version": 2, "actions": [{"release": "box"}]})", 1,
                             nullptr, &none),
            SHIGUSA_NOT_FOUND);
  EXPECT_THAT(shigusa_message(), testing::HasSubstr("actions[0]"));
  EXPECT_EQ(none, nullptr);
}

}  // namespace
}  // namespace shigusa_c_test
