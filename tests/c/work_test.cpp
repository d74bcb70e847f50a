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
