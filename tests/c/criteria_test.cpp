// SPDX-License-Identifier: MIT
// Criteria of the host.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "c/handles.hpp"

namespace shigusa_c_test {
namespace {

// A host's criterion, and what it was asked.
struct Asked {
  int calls = 0;
  size_t most = 0;
  size_t motions = 0;
  bool elsewhere = false;
  int32_t answer = 0;
  bool throws = false;
  bool undefined = false;
  size_t knee = 0;
  std::thread::id caller = std::this_thread::get_id();
};

// The most that a knee bends (rad).
int32_t knee_bend(void* user, const shigusa_motions* motions, double* values) {
  Asked& asked = *static_cast<Asked*>(user);
  ++asked.calls;
  asked.motions += motions->motions;
  asked.most = std::max(asked.most, motions->motions);
  asked.elsewhere = asked.elsewhere || std::this_thread::get_id() != asked.caller;
  if (asked.throws) throw std::runtime_error("sore");
  for (size_t m = 0; m < motions->motions; ++m) {
    values[m] = asked.undefined ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    for (size_t f = 0; f < motions->frames; ++f) {
      const double* row = motions->angles + (m * motions->frames + f) * motions->dofs;
      values[m] = std::max(values[m], row[asked.knee]);
    }
  }
  return asked.answer;
}

shigusa_criterion named(const char* name, double weight, double scale) {
  return {.name = name, .weight = weight, .scale = scale, .values = knee_bend, .user = nullptr};
}

size_t knee_of(const shigusa_character* human) {
  const Json joints = Json::parse(text_of(shigusa_character_describe, human)).at("joints");
  for (size_t i = 0; i < joints.size(); ++i) {
    if (joints.at(i).at("name") == "left_knee.flexion") return i;
  }
  ADD_FAILURE() << "no knee";
  return 0;
}

constexpr const char* kFloor =
    R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.3, 0.45]}],
        "seed": 3, "evaluations": 600})";

shigusa_status by(Asked& asked, shigusa_criterion criterion, Outcome& outcome, int32_t threads = 1,
                  const char* task = kFloor) {
  const Character human = character_of(R"("human")");
  asked.knee = knee_of(human.get());
  criterion.user = &asked;
  shigusa_result* made = nullptr;
  const shigusa_status status =
      shigusa_generate_by(human.get(), task, &criterion, 1, threads, nullptr, &made);
  outcome.reset(made);
  return status;
}

double most_bent(const shigusa_result* result, size_t knee) {
  const Table angles = table_of(result, 1, SHIGUSA_ANGLES);
  double most = 0.0;
  for (size_t f = 0; f < angles.frames; ++f) most = std::max(most, angles.at(f, knee));
  return most;
}

TEST(CInterfaceOfCriteria, ChangeWhatIsChosenInBatchesOnTheCallingThread) {
  const Outcome without = outcome_of(nullptr, kFloor);
  Asked asked;
  Outcome with;
  ASSERT_EQ(by(asked, named("sore_knees", 3.0, 1.57), with, 3), SHIGUSA_OK) << shigusa_message();
  EXPECT_LT(most_bent(with.get(), asked.knee), 0.7 * most_bent(without.get(), asked.knee));
  EXPECT_FALSE(asked.elsewhere);
  EXPECT_GE(asked.most, 8U);
  EXPECT_LT(2 * asked.calls, static_cast<int>(asked.motions));
  const Json first = json_of(with.get()).at("candidates").at(0);
  EXPECT_NEAR(first.at("criteria").at("sore_knees").get<double>(),
              std::min(most_bent(with.get(), asked.knee) / 1.57, 1.0), 1e-9);

  // on one thread the same
  Asked again;
  Outcome same;
  ASSERT_EQ(by(again, named("sore_knees", 3.0, 1.57), same), SHIGUSA_OK);
  EXPECT_TRUE(json_of(same.get()).at("candidates") == json_of(with.get()).at("candidates"));
}

TEST(CInterfaceOfCriteria, AreNotCalledAfterTheSearch) {
  Asked asked;
  Outcome found;
  ASSERT_EQ(by(asked, named("sore_knees", 3.0, 1.57), found), SHIGUSA_OK);
  const int calls = asked.calls;
  shigusa_result* edited = nullptr;
  ASSERT_EQ(shigusa_replay(found.get(), 1, R"(["squat_deg=40"])", &edited), SHIGUSA_OK)
      << shigusa_message();
  const Outcome kept(edited);
  const std::string summary = text_of(shigusa_result_describe, found.get());
  shigusa_result* restored = nullptr;
  ASSERT_EQ(shigusa_restore(nullptr, summary.c_str(), &restored), SHIGUSA_OK) << shigusa_message();
  const Outcome again(restored);
  EXPECT_EQ(table_of(again.get(), 1, SHIGUSA_ANGLES).values,
            table_of(found.get(), 1, SHIGUSA_ANGLES).values);
  EXPECT_EQ(asked.calls, calls);
}

TEST(CInterfaceOfCriteria, OfWorkAreAskedOnTheCallingThread) {
  Asked asked;
  Outcome found;
  ASSERT_EQ(by(asked, named("sore_knees", 1.0, 1.57), found, 3,
               R"({"version": 2, "evaluations": 200, "actions": [
                   {"goals": [{"effector": "right_hand", "position_m": [-0.2, 1, 0.5]}]},
                   {"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.4, 0.5]}]}]})"),
            SHIGUSA_OK)
      << shigusa_message();
  EXPECT_GT(asked.calls, 0);
  EXPECT_FALSE(asked.elsewhere);
}

TEST(CInterfaceOfCriteria, UndefinedValuesRankLast) {
  Asked asked{.undefined = true};
  Outcome found;
  ASSERT_EQ(by(asked, named("none", 1.0, 1.0), found), SHIGUSA_OK);
  EXPECT_GT(shigusa_result_candidates(found.get()), 0);
}

TEST(CInterfaceOfCriteria, WhatTheHostThrowsOrReturnsEndsTheCall) {
  Outcome none;
  Asked throwing{.throws = true};
  EXPECT_EQ(by(throwing, named("sore", 1.0, 1.0), none), SHIGUSA_HOST);
  EXPECT_STREQ(shigusa_message(), "sore");
  EXPECT_EQ(throwing.calls, 1);
  Asked failing{.answer = 7};
  EXPECT_EQ(by(failing, named("sore", 1.0, 1.0), none), SHIGUSA_HOST);
  EXPECT_STREQ(shigusa_message(), "the criterion sore returned 7");
  EXPECT_EQ(none, nullptr);
}

TEST(CInterfaceOfCriteria, WrongOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [wrong, said] : {std::pair(named(nullptr, 1.0, 1.0), "no name"),
                                    {named("", 1.0, 1.0), "no name"},
                                    {named("low_back", 1.0, 1.0), "low_back already"},
                                    {named("own", -1.0, 1.0), "weight"},
                                    {named("own", nan, 1.0), "weight"},
                                    {named("own", 1.0, 0.0), "scale"},
                                    {named("own", 1.0, nan), "scale"}}) {
    Asked asked;
    Outcome none;
    EXPECT_EQ(by(asked, wrong, none), SHIGUSA_INVALID_ARGUMENT);
    EXPECT_THAT(shigusa_message(), testing::HasSubstr(said));
    EXPECT_EQ(asked.calls, 0);
  }
  shigusa_result* none = nullptr;
  EXPECT_EQ(shigusa_generate_by(nullptr, kFloor, nullptr, 1, 1, nullptr, &none),
            SHIGUSA_INVALID_ARGUMENT);
  shigusa_criterion empty = named("own", 1.0, 1.0);
  empty.values = nullptr;
  EXPECT_EQ(shigusa_generate_by(nullptr, kFloor, &empty, 1, 1, nullptr, &none),
            SHIGUSA_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace shigusa_c_test
