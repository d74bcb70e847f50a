// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/score.hpp>

#include "kinematics/skeleton_motion.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;

Task reach_of(const Habit& habit) {
  Task task(human_body());
  task.goals = {{"right_hand", {-0.2, 0.25, 0.45}}};
  adopt_habit(task, habit);
  return task;
}

Candidate best_of(const Task& task) { return generate(task).value().candidates.front(); }

Habit named(std::string_view word) {
  for (const NamedHabit& each : kHabits) {
    if (each.word == word) return each.habit;
  }
  return {};
}

TEST(Habit, OfMostPeopleIsTheDefault) {
  EXPECT_EQ(named("natural"), Habit{});
  EXPECT_EQ(Request{}.habit, Habit{});
}

TEST(Habit, MoreKneesBendMore) {
  double before = 0.0;
  for (const char* word : {"stoop", "half", "natural", "squat"}) {
    const double knees = best_of(reach_of(named(word))).final_posture.knee_flexion;
    EXPECT_GT(knees, before + radians(5.0)) << word;
    before = knees;
  }
}

TEST(Habit, KeepsOnAPersonOfAnotherStature) {
  for (const double scale : {0.9, 1.1}) {
    const double stature = 1.741 * scale;
    Task task(human_body({.stature = stature, .mass = default_mass(stature, Sex::male)}));
    task.goals = {{"right_hand", Vec3d{-0.2, 0.25, 0.45} * scale}};
    adopt_habit(task, named("stoop"));
    EXPECT_LT(best_of(task).final_posture.knee_flexion, radians(45.0)) << scale;
  }
}

double back_of(const Candidate& candidate, const BodyModel& body) {
  const Clip& clip = candidate.motion.clip;
  double bent = 0.0;
  for (const JointKind joint : kBackJoints) {
    bent += clip.frame(clip.frames -
                       1)[static_cast<std::size_t>(*body.find_dof(joint, FreedomKind::flexion))];
  }
  return bent;
}

TEST(Habit, RoundsTheBackAndBendsTheFreeElbow) {
  const Task usual = reach_of({});
  Habit habit;
  habit.round = radians(30.0);
  EXPECT_GT(back_of(best_of(reach_of(habit)), usual.body),
            back_of(best_of(usual), usual.body) + radians(4.0));
  habit = {.free_arm = 1.4};
  const int elbow = *usual.body.find_dof(JointKind::elbow, FreedomKind::flexion, Side::left);
  const auto bends = [&](const Habit& by) {
    const Clip clip = best_of(reach_of(by)).motion.clip;
    return clip.frame(clip.frames - 1)[static_cast<std::size_t>(elbow)];
  };
  EXPECT_GT(bends(habit), bends({}) + radians(15.0));
}

TEST(Habit, IsNoneOfThePapersPresets) {
  Task task = with_preset(reach_of(named("squat")), Preset::paper);
  EXPECT_THAT(generate(task).error().to_string(), HasSubstr("without a habit"));
  task.habit = {};
  task.evaluations = 64;
  EXPECT_TRUE(generate(task).has_value());
}

TEST(Habit, RangesAreChecked) {
  for (const Habit& habit : {Habit{.knees = -0.1}, Habit{.round = 1.0}, Habit{.eyes = -0.1},
                             Habit{.free_arm = 2.5}, Habit{.knees = std::nan("")}}) {
    EXPECT_THAT(generate(reach_of(habit)).error().to_string(), HasSubstr("of the habit is"));
  }
}

TEST(Habit, OfOnesOwnWeighsMore) {
  const auto weight = [](const Request& request) {
    return request.criteria[CriterionKind::coordination].weight;
  };
  Request request;
  const double usual = weight(request);
  for (int k = 0; k < 2; ++k) {
    adopt_habit(request, named("squat"));
    EXPECT_EQ(weight(request), kOwnKneesWeigh * usual);
    adopt_habit(request, named("stoop"));
    EXPECT_EQ(weight(request), kOwnKneesWeigh * usual);
    adopt_habit(request, {.free_arm = 0.1});
    EXPECT_EQ(weight(request), usual);
  }
  for (const char* preset : {"flat", "human"}) {
    const std::string head = std::string("{\"version\": 1, \"preset\": \"") + preset + "\", ";
    EXPECT_EQ(weight(parse_task(head + "\"habit\": \"squat\"}", "task").value()),
              kOwnKneesWeigh * usual);
    EXPECT_EQ(weight(parse_task(head + "\"habit\": \"squat\", \"criteria\": {\"coordination\": "
                                       "{\"weight\": 0.5}}}",
                                "task")
                         .value()),
              0.5);
  }
}

TEST(HabitJson, IsAWordOrNumbers) {
  for (const NamedHabit& each : kHabits) {
    EXPECT_EQ(parse_habit("\"" + std::string(each.word) + "\"", "habit").value(), each.habit);
  }
  const Habit habit{.knees = 2.2, .round = 0.1, .eyes = 0.3, .free_arm = 0.4};
  EXPECT_EQ(parse_habit(format_habit(habit), "habit").value(), habit);
  EXPECT_EQ(parse_habit("{\"knees\": 2.2}", "habit").value(), Habit{.knees = 2.2});
  for (const char* wrong : {"\"squats\"", "{\"knee\": 2}", "{\"knees\": 99}", "[]", "3", "{"}) {
    EXPECT_FALSE(parse_habit(wrong, "habit").has_value()) << wrong;
  }
}

TEST(HabitJson, OfATaskIsKept) {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 0.25, 0.45}}};
  EXPECT_EQ(format_task(file).find("habit"), std::string::npos);
  file.habit = named("squat");
  EXPECT_THAT(format_task(file), HasSubstr("\"habit\": \"squat\""));
  EXPECT_EQ(parse_task(format_task(file), "task").value().habit, file.habit);
  file.habit = {.knees = 2.0, .eyes = 0.1};
  EXPECT_EQ(parse_task(format_task(file), "task").value().habit, file.habit);
}

// The motion of a task as a recording.
RecordedMotion recorded(const Task& task, const Candidate& best) {
  const std::string bvh = format_bvh(skeleton_motion(task.body, best.motion.clip));
  return parse_recorded(bvh, "made.bvh", {.source = "made.bvh", .extent = BodyExtent::human}, 0)
      .value();
}

TEST(LearnHabit, FindsTheKneesAndTheBackOfAMotion) {
  for (const char* word : {"stoop", "natural", "squat"}) {
    const Task task = reach_of(named(word));
    const Candidate best = best_of(task);
    const LearnedHabit learned = learn_habit(recorded(task, best)).value();
    EXPECT_EQ(learned.reaches, 1);
    EXPECT_NEAR(learned.habit.knees, named(word).knees, 0.45) << word;
    EXPECT_LT(std::abs(learned.habit.round), radians(20.0)) << word;
  }
}

TEST(LearnHabit, WhereNobodyReachesDownIsRefused) {
  Task task(human_body());
  task.goals = {{"right_hand", {-0.2, 1.3, 0.4}}};
  const RecordedMotion upright = recorded(task, best_of(task));
  EXPECT_THAT(learn_habit(upright).error().to_string(), HasSubstr("nobody reaches down"));
  const std::vector<FrameRange> beyond{{0, 100000}};
  EXPECT_FALSE(learn_habit(upright, beyond).has_value());
}

}  // namespace
}  // namespace shigusa
