// SPDX-License-Identifier: MIT
// generate() with the body `human` near the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "generate/archive.hpp"

namespace shigusa {
namespace {

constexpr Vec3d kLowGoals[] = {
    {-0.15, 0.12, 0.30}, {-0.05, 0.15, 0.30}, {-0.10, 0.25, 0.35}, {-0.20, 0.30, 0.40}};

GenerateResult reached(const Vec3d& goal, double load, std::uint64_t seed,
                       std::optional<int> evaluations = {}) {
  Task task(human_body(), {.goals = {{.position = goal, .load = load}}});
  task.seed = seed;
  task.evaluations = evaluations;
  return generate(task).value();
}

double penalty(const Candidate& candidate, const std::string& name) {
  for (const ScoreTerm& term : candidate.score.terms) {
    if (term.name == name) return term.penalty;
  }
  ADD_FAILURE() << name;
  return 1.0;
}

// the trunk leans less for the same knee flexion: nearer to a squat
TEST(WholeHuman, LoadMakesASquatterPosture) {
  double light = 0.0;
  double heavy = 0.0;
  for (const Vec3d& goal : kLowGoals) {
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}}) {
      light +=
          reached(goal, 0.1, seed, 6000).candidates[0].final_posture.stoop_squat_index.value() /
          8.0;
      heavy +=
          reached(goal, 15.0, seed, 6000).candidates[0].final_posture.stoop_squat_index.value() /
          8.0;
    }
  }
  RecordProperty("light", std::to_string(light));
  RecordProperty("heavy", std::to_string(heavy));
  EXPECT_LT(light, kStoopIndex);
  EXPECT_LT(heavy, light - 1.0);
}

TEST(WholeHuman, StandsOnItsFeetAndHasSeveralAnswers) {
  double pressure = 0.0;
  std::size_t candidates = 0;
  for (const Vec3d& goal : kLowGoals) {
    const GenerateResult generation = reached(goal, 0.0, 0);
    pressure += penalty(generation.candidates[0], "centre_of_pressure") / 4.0;
    candidates += generation.candidates.size();
  }
  EXPECT_LT(pressure, 0.1);  // it was 0.33 with hips that flex alone
  EXPECT_GE(candidates, 13U);
}

// For goals straight ahead of the chest people use one posture, with the elbow in or out.
TEST(WholeHuman, HasSeveralAnswersToWhatIsEasyAsWell) {
  std::size_t candidates = 0;
  for (const Vec3d& goal : {Vec3d{-0.08, 0.99, 0.54}, {0.57, 1.71, 0.31}, {-0.24, 1.55, 0.23}}) {
    const GenerateResult generation = reached(goal, 0.0, 0);
    const std::vector<Candidate>& all = generation.candidates;
    EXPECT_GE(all.size(), 1U) << generation.fewer.text;
    candidates += all.size();
    const PosedBody posed = human_body();
    PostureMeter meter(posed.body, posed.home, 0);
    std::vector<Look> looks;
    for (const Candidate& candidate : all) {
      const Look look = meter.look(candidate.motion.clip);
      for (const Look& better : looks) EXPECT_FALSE(look_alike(better, look, 0.98));
      looks.push_back(look);
    }
  }
  EXPECT_GE(candidates, 9U);
}

// The grip is 5 cm above the floor and the fingertips are 8 cm further on: the hand must lie flat.
TEST(WholeHuman, HandsStayAboveTheFloor) {
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{3}}) {
    const GenerateResult generation = reached({-0.25, 0.05, 0.35}, 0.0, seed);
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_LE(candidate.measures.collides.depth, kCollisionDepth) << seed;
    }
  }
}

TEST(WholeHuman, SquatsBesideStoops) {
  int squats = 0;
  int stoops = 0;
  for (const Vec3d& goal : kLowGoals) {
    Task task(human_body(), {.goals = {{.position = goal}}});
    task.seed = 1;
    task.duration = 2.0;  // enough time for the ankles' strength to lower a body into a squat
    const GenerateResult generation = generate(task).value();
    const auto has = [&](Style style) {
      return std::any_of(generation.candidates.begin(), generation.candidates.end(),
                         [style](const Candidate& c) {
                           return style_of(c.final_posture.stoop_squat_index) == style;
                         });
    };
    squats += has(Style::squat) ? 1 : 0;
    stoops += has(Style::stoop) ? 1 : 0;
  }
  EXPECT_GE(squats, 2);
  EXPECT_GE(stoops, 3);
}

}  // namespace
}  // namespace shigusa
