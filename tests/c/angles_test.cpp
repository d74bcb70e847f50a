// SPDX-License-Identifier: MIT
// Motions of given angles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "c/handles.hpp"

namespace shigusa_c_test {
namespace {

Outcome of_angles(const Table& angles, double fps, const char* task = nullptr) {
  const Character human = character_of(R"("human")");
  shigusa_result* made = nullptr;
  EXPECT_EQ(shigusa_result_of_angles(human.get(), task, angles.values.data(), angles.frames,
                                     angles.columns, fps, &made),
            SHIGUSA_OK)
      << shigusa_message();
  return Outcome(made);
}

// The angles of a generated motion give what was told of it.
TEST(CInterfaceOfAngles, MeasuresAMotionAsTheSearchDid) {
  const Outcome own = outcome_of(nullptr, kLowReach);
  const Table times = table_of(own.get(), 1, SHIGUSA_TIME);
  const Outcome given = of_angles(table_of(own.get(), 1, SHIGUSA_ANGLES), 1.0 / times.at(1, 0));
  ASSERT_NE(given, nullptr);
  EXPECT_EQ(shigusa_result_candidates(given.get()), 1);
  for (const shigusa_series series :
       {SHIGUSA_ANGLES, SHIGUSA_UPPER_LIMITS, SHIGUSA_NODE_ROTATIONS, SHIGUSA_CENTRE_OF_MASS}) {
    const Table a = table_of(own.get(), 1, series);
    const Table b = table_of(given.get(), 1, series);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      ASSERT_NEAR(a.values[i], b.values[i], 1e-9) << series;
    }
  }
  // the first frame's speeds are not in the angles
  const Table torques = table_of(own.get(), 1, SHIGUSA_TORQUES);
  const Table again = table_of(given.get(), 1, SHIGUSA_TORQUES);
  for (std::size_t f = 0; f < torques.frames; ++f) {
    for (std::size_t d = 0; d < torques.columns; ++d) {
      ASSERT_NEAR(torques.at(f, d), again.at(f, d), 1e-6) << f;
    }
  }
  const Json told = json_of(own.get()).at("candidates").at(0);
  const Json measured = json_of(given.get()).at("candidates").at(0);
  EXPECT_EQ(measured.at("verdict"), told.at("verdict"));
  EXPECT_NEAR(measured.at("duration_s"), told.at("duration_s"), 1e-9);
  EXPECT_EQ(measured.at("most_loaded").at("joint"), told.at("most_loaded").at("joint"));
  EXPECT_NEAR(measured.at("criteria").at("low_back"), told.at("criteria").at("low_back"), 1e-6);
  EXPECT_THAT(text_of(shigusa_result_export, given.get(), 1, "bvh"),
              testing::StartsWith("HIERARCHY"));
}

TEST(CInterfaceOfAngles, TakesTheCriteriaOfATask) {
  const Table angles = table_of(outcome_of(nullptr, kLowReach).get(), 1, SHIGUSA_ANGLES);
  const Outcome given = of_angles(angles, 60.0, R"({"criteria": "paper", "goals": [
      {"effector": "right_hand", "position_m": [0, 1, 0.4]}]})");
  const Json told = json_of(given.get());
  EXPECT_EQ(told.at("candidates").at(0).at("criteria").size(), 3U);
  EXPECT_EQ(told.at("goals"), Json::array());
}

TEST(CInterfaceOfAngles, IsNotPlayedAgain) {
  const Table angles = table_of(outcome_of(nullptr, kLowReach).get(), 1, SHIGUSA_ANGLES);
  const Outcome given = of_angles(angles, 60.0);
  shigusa_result* none = nullptr;
  EXPECT_NE(shigusa_replay(given.get(), 1, nullptr, &none), SHIGUSA_OK);
  EXPECT_NE(shigusa_mirror(given.get(), &none), SHIGUSA_OK);
  EXPECT_NE(shigusa_restore(nullptr, text_of(shigusa_result_describe, given.get()).c_str(), &none),
            SHIGUSA_OK);
  EXPECT_EQ(none, nullptr);
}

TEST(CInterfaceOfAngles, RefusesWhatIsNoMotion) {
  const Character human = character_of(R"("human")");
  std::vector<double> angles(2 * 45);
  shigusa_result* none = nullptr;
  const auto refused = [&](std::size_t frames, std::size_t columns, double fps) {
    EXPECT_EQ(
        shigusa_result_of_angles(human.get(), nullptr, angles.data(), frames, columns, fps, &none),
        SHIGUSA_INVALID_ARGUMENT);
    return std::string(shigusa_message());
  };
  EXPECT_THAT(refused(1, 45, 60.0), testing::HasSubstr("1 frames of 45 angles"));
  EXPECT_THAT(refused(2, 44, 60.0), testing::HasSubstr("of 45 angles"));
  EXPECT_THAT(refused(2, 45, 0.0), testing::HasSubstr("fps"));
  EXPECT_THAT(refused(std::numeric_limits<std::size_t>::max(), 45, 60.0),
              testing::HasSubstr("frames of 45"));
  angles[50] = std::nan("");
  EXPECT_THAT(refused(2, 45, 60.0), testing::HasSubstr("finite"));
}

}  // namespace
}  // namespace shigusa_c_test
