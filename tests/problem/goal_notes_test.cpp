// SPDX-License-Identifier: MIT
// Goals that are valid, but odd.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <shigusa/request.hpp>

#include "human/at_ease.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> notes_on(const Vec3d& place, const char* effector = "right_hand") {
  std::vector<std::string> texts;
  for (const Message& note : goal_notes(Task(human_body(), {.goals = {{effector, place}}}))) {
    texts.push_back(note.text);
  }
  return texts;
}

// The middle of the lines of the part with that name, and its radius.
struct Part {
  Vec3d middle{};
  double radius = 0.0;

  explicit Part(const std::string& name) {
    const PosedBody posed = human_body();
    for (const Capsule& capsule : posed.body.capsules()) {
      if (capsule.name != name) continue;
      middle = home_kinematics(posed).point(capsule.link, (capsule.from + capsule.to) * 0.5);
      radius = capsule.radius;
    }
  }
};

TEST(GoalNotes, TellOfWhatIsInAndBelowTheFloor) {
  EXPECT_THAT(notes_on({-0.2, -0.1, 0.4}),
              ElementsAre(HasSubstr("m below the floor: the hand goes through it")));
  EXPECT_THAT(notes_on({-0.2, 0.01, 0.4}), ElementsAre(HasSubstr("it goes into the floor")));
  EXPECT_THAT(notes_on({-0.2, 0.05, 0.4}), IsEmpty());
}

TEST(GoalNotes, TellOfWhatIsInTheHead) {
  const Part head("head");
  EXPECT_THAT(notes_on(head.middle), ElementsAre(HasSubstr("is in the body's own head")));
  EXPECT_THAT(notes_on(Part("jaw").middle), ElementsAre(HasSubstr("is in the body's own head")));
  EXPECT_THAT(notes_on(Part("left_foot").middle), ElementsAre(HasSubstr("own left_foot")));
  // at the skin people reach
  EXPECT_THAT(notes_on(head.middle + Vec3d{0, head.radius - 0.005, 0}), IsEmpty());
  EXPECT_THAT(notes_on(Part("pelvis").middle), IsEmpty());
  // feet may stand where they are
  EXPECT_THAT(notes_on(Part("left_foot").middle, "right_foot"), IsEmpty());
}

TEST(GoalNotes, TellWherePeopleTakeAStep) {
  EXPECT_THAT(notes_on({-0.2, 0.9, -0.5}), ElementsAre(HasSubstr("is behind them")));
  EXPECT_THAT(notes_on({-0.6, 0.15, 0.05}), ElementsAre(HasSubstr("is low beside them")));
  EXPECT_THAT(notes_on({-0.2, 0.15, 0.85}), ElementsAre(HasSubstr("is far from their feet")));
  EXPECT_THAT(notes_on({-0.2, 0.9, 1.05}), ElementsAre(HasSubstr("is far from their feet")));
  for (const Vec3d& near : {Vec3d{-0.2, 0.15, 0.5}, {-0.7, 1.2, 0.0}, {-0.2, 0.9, 0.8}}) {
    EXPECT_THAT(notes_on(near), IsEmpty());
  }
  // who sits stays
  const PosedBody sitting = build_human(
      seated(standing_landmarks(1.7, kStandingToeOut), 1.7, 0.42),
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70.0, .sits = true});
  const Task behind(sitting, {.goals = {{"right_hand", {-0.2, 0.9, -0.5}}}});
  EXPECT_THAT(goal_notes(behind), IsEmpty());
}

}  // namespace
}  // namespace shigusa
