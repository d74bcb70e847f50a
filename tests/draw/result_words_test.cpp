// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/draw.hpp>

#include "criteria/built_in_criteria.hpp"

namespace shigusa {
namespace {

constexpr double kStature = 1.741;

TEST(ResultWords, PlacesAreToldAsTheBodySeesThem) {
  EXPECT_EQ(place_words({0.25, 0.55, 0.5}), "0.25 m left, 0.55 m up, 0.5 m ahead");
  EXPECT_EQ(place_words({-0.2, 1.1, -0.4}), "0.2 m right, 1.1 m up, 0.4 m behind");
  EXPECT_EQ(place_words({0.0, -0.1, 0.3}), "0.1 m below the floor, 0.3 m ahead");
  EXPECT_EQ(place_words({0.3, 0.0, 0.0}), "0.3 m left, on the floor");
  EXPECT_EQ(place_words({}), "the floor");
}

TEST(ResultWords, GoalsTellLoadsAndTurns) {
  Goal goal{.effector = "right_hand", .position = {0.0, 1.0, 0.5}, .load = 5.0};
  goal.axis = GoalAxis{};
  EXPECT_EQ(goal_words(goal), "right hand to 1 m up, 0.5 m ahead, turned as asked, holding 5 kg");
}

TEST(ResultWords, RequestsWithoutGoalsTellTheFeetThatStand) {
  Request request;
  request.contacts = std::vector<std::string>{"right_foot"};
  EXPECT_EQ(asked_words(request), "standing on the right foot");
  request.goals = {{"head", {0.0, 1.7, 0.0}}};
  EXPECT_EQ(asked_words(request), "head to 1.7 m up; standing on the right foot");
}

TEST(ResultWords, ActionsTellWhatIsDoneWithWhat) {
  const std::vector<Action> actions{{.grasp = "red_box"},
                                    {.place = "red_box", .position = Vec3d{0, 0.9, 0.45}},
                                    {.wait = 1.5},
                                    {.goals = {{.effector = "left_hand", .position = {0.2, 1, 0}}}},
                                    {.stand = Stance{}}};
  EXPECT_EQ(action_words(actions[1]), "place the red box at 0.9 m up, 0.45 m ahead");
  EXPECT_EQ(action_words(actions[2]), "wait for 1.5 s");
  EXPECT_EQ(action_words(actions[3]), "left hand to 0.2 m left, 1 m up");
  EXPECT_EQ(action_words({.look_at = Vec3d{0, 1, 1}}), "look");
  EXPECT_EQ(action_words(actions[4]), "stand");
  EXPECT_EQ(actions_title(actions),
            "Grasp the red box, place the red box, wait for 1.5 s, move the left hand, and 1 more");
}

TEST(ResultWords, TitlesTellWhereGoalsAre) {
  const auto title = [](std::vector<Goal> goals) { return goals_title(goals, kStature); };
  EXPECT_EQ(title({{"right_hand", {0.25, 0.55, 0.5}}}), "Right hand low in front on the left");
  EXPECT_EQ(title({{"right_hand", {0.0, 2.0, 0.05}}}), "Right hand overhead");
  EXPECT_EQ(title({{"left_foot", {0.1, 0.0, -0.5}}}), "Left foot on the floor behind");
  EXPECT_EQ(title({{"left_hand", {0.2, 0.9, 0.4}}, {"right_hand", {-0.2, 0.9, 0.4}}}),
            "Both hands at hip height in front");
  EXPECT_EQ(title({{"head", {0.0, 1.2, 0.4}}, {"hips", {0.0, 0.5, 0.0}}, {"chest", {0, 1, 0}}}),
            "Head at chest height in front, hips low, and 1 more goals");
  EXPECT_EQ(title({}), "A foot that lifts");
}

TEST(ResultWords, EachCriterionHasWordsOfItsOwn) {
  for (const CriterionTraits& criterion : kCriteria) {
    EXPECT_NE(criterion_words(criterion.word), criterion.word);
  }
  EXPECT_EQ(criterion_words("my_own"), "my_own");
}

TEST(ResultWords, ReasonsHavePlainNames) {
  EXPECT_EQ(reason_sentence({.kind = ReasonKind::strength,
                             .amount = 7.94,
                             .subject = "right_ankle.flexion",
                             .torque = 715.0,
                             .strength = 90.0,
                             .time = 0.11}),
            "The right ankle (flexion) needs 715 N·m at 0.11 s, 7.9 times its strength of 90.");
  EXPECT_EQ(reason_sentence({.kind = ReasonKind::pressure, .amount = 0.921, .time = 0.5}),
            "The floor would have to press 92 cm outside the feet at 0.50 s.");
  EXPECT_EQ(reason_sentence({.kind = ReasonKind::collision,
                             .amount = 0.078,
                             .subject = "right_forearm",
                             .other = "trunk",
                             .time = 0.92}),
            "The right forearm is 78 mm in the trunk at 0.92 s.");
  EXPECT_EQ(
      reason_sentence(
          {.kind = ReasonKind::limit, .amount = radians(37.0), .subject = "right_hip.rotation"}),
      "The right hip (rotation) goes 37° beyond its range.");
}

TEST(ResultWords, VerdictsAreSentences) {
  EXPECT_EQ(verdict_sentence({}), "Possible: strong and steady enough.");
  EXPECT_EQ(verdict_sentence({.verdict = Verdict::impossible, .reasons = {}, .possible_in = 2.13}),
            "Impossible so fast: 2.2 s would do.")
      << "rounded up, as 2.1 s are not enough";
  EXPECT_EQ(enough_words(2.1), "2.1 s");
}

TEST(ResultWords, LengthsAreInTheUnitThatFits) {
  EXPECT_EQ(length_words(0.0), "0 mm");
  EXPECT_EQ(length_words(0.0123), "12 mm");
  EXPECT_EQ(length_words(0.0996), "10 cm");
  EXPECT_EQ(length_words(0.996), "1.00 m");
}

}  // namespace
}  // namespace shigusa
