// SPDX-License-Identifier: MIT
// Pieces of work, drawn at random: places and grips are exact, feet stay, velocities are
// continuous.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <vector>

namespace shigusa {
namespace {

constexpr double kExact = 1e-3;              // m
constexpr double kExactTurn = radians(1.0);  // rad
constexpr double kSmoothVelocity = 0.5;      // rad/s between two frames at a boundary
constexpr double kMetShare = 0.97;

// Measures of a candidate of a piece of work.
struct Measured {
  double place = 0.0;      // m, of placed things from where they were to be
  double turn = 0.0;       // rad
  double grip = 0.0;       // m, of a hand from its place on the thing while that moves
  double grip_turn = 0.0;  // rad
  double slide = 0.0;      // m, of feet
  double jump = 0.0;       // rad/s, change of a joint's velocity at a boundary of actions
};

double angle_between(const Mat3d& a, const Mat3d& b) {
  return norm(rotation_vector(a * transpose(b)));
}

// Adds the errors of a hand on a thing over the frames in which that moves.
void add_grip(const ThingMotion& thing, const Effector& hand, const std::vector<Posture>& postures,
              Measured& m) {
  std::optional<Transformd> grip;
  for (std::size_t f = 1; f < postures.size(); ++f) {
    const Vec3d way = thing.poses[f].translation - thing.poses[f - 1].translation;
    if (norm(way) < 1e-5) continue;
    const Transformd now = inverse(thing.poses[f]) * postures[f].place(hand.link);
    if (!grip) grip.emplace(now);
    m.grip = max(m.grip, norm(now * hand.point - *grip * hand.point));
    m.grip_turn = max(m.grip_turn, angle_between(now.rotation, grip->rotation));
  }
}

Measured measure(const Task& task, const Candidate& candidate) {
  Measured m;
  for (const ActionResult& action : candidate.actions) {
    if (!action.placed) continue;
    m.place = max(m.place, action.placed->error);
    m.turn = max(m.turn, action.placed->turn_error);
  }
  const Clip& clip = candidate.motion.clip;
  std::vector<Posture> postures;
  for (int f = 0; f < clip.frames; ++f) postures.emplace_back(task.body, clip.frame(f));
  // a thing that moves is in the hands that have grasped it
  for (std::size_t a = 0; a < candidate.actions.size(); ++a) {
    const std::string& name = task.actions[a].grasp;
    for (const ThingMotion& thing : candidate.things) {
      if (thing.thing.name != name) continue;
      for (const GoalResult& goal : candidate.actions[a].goals) {
        const Effector& hand = task.body.effector(*task.body.find_effector(goal.asked.effector));
        add_grip(thing, hand, postures, m);
      }
    }
  }
  for (const Foot& foot : task.body.feet()) {
    for (const Posture& posture : postures) {
      m.slide = max(m.slide, norm(posture.place(foot.link) * foot.centre -
                                  postures.front().place(foot.link) * foot.centre));
    }
  }
  for (std::size_t a = 1; a < candidate.actions.size(); ++a) {
    const int at = static_cast<int>(candidate.actions[a].start / clip.frame_time + 0.5);
    if (at < 1 || at + 1 >= clip.frames) continue;
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double before = clip.frame(at)[k] - clip.frame(at - 1)[k];
      const double after = clip.frame(at + 1)[k] - clip.frame(at)[k];
      m.jump = max(m.jump, abs(after - before) / clip.frame_time);
    }
  }
  return m;
}

// A place for a thing near the body, in easy reach of both hands.
Vec3d near_place(Random& random, double low) {
  return {random.uniform(-0.3, 0.3), max(low, random.uniform(0.1, 1.3)), random.uniform(0.3, 0.45)};
}

Task drawn(std::uint64_t seed) {
  Random random(seed, 0x3053);
  Task task(build_character({}).value());
  task.seed = seed;
  Thing thing{.name = "thing"};
  const bool two = random.uniform(0.0, 1.0) < 0.5;
  if (two) {
    thing.size = {random.uniform(0.2, 0.4), random.uniform(0.1, 0.3), random.uniform(0.15, 0.3)};
    thing.mass = random.uniform(0.5, 15.0);
  } else {
    const double wide = random.uniform(0.05, 0.09);
    thing.shape = random.uniform(0.0, 1.0) < 0.5 ? ThingShape::cylinder : ThingShape::box;
    thing.size = {wide, random.uniform(0.08, 0.2), wide};
    thing.mass = random.uniform(0.1, 3.0);
  }
  thing.position = near_place(random, 0.5 * thing.size.y);
  task.things = {thing};
  task.actions.push_back({.grasp = "thing"});
  if (random.uniform(0.0, 1.0) < 0.3) task.actions.push_back({.wait = random.uniform(0.0, 1.0)});
  task.actions.push_back({.place = "thing",
                          .position = near_place(random, 0.5 * thing.size.y),
                          .turn_deg = two ? random.uniform(-20.0, 20.0) : 0.0});
  if (random.uniform(0.0, 1.0) < 0.5) task.actions.push_back({.stand = Stance{}});
  return task;
}

TEST(Pieces, DrawnWorkIsExact) {
  const char* const number = std::getenv("SHIGUSA_PIECES");
  const int night = std::getenv("SHIGUSA_NIGHT") != nullptr ? 300 : 30;
  const int pieces = number != nullptr ? std::atoi(number) : night;
  int met = 0;
  int possible = 0;
  Measured worst;
  std::string told;
  for (int k = 0; k < pieces; ++k) {
    const Task task = drawn(static_cast<std::uint64_t>(k));
    const auto result = perform(task);
    ASSERT_TRUE(result.has_value()) << k << ": " << result.error().to_string();
    if (!result->meets_goals()) {
      EXPECT_FALSE(result->conflict.empty()) << k;
      told += fmt::format("{}: {}\n", k, result->conflict.text);
      continue;
    }
    ++met;
    for (const Candidate& candidate : result->candidates) {
      const Measured m = measure(task, candidate);
      EXPECT_LE(m.place, kExact) << k;
      EXPECT_LE(m.turn, kExactTurn) << k;
      EXPECT_LE(m.grip, kExact) << k;
      EXPECT_LE(m.grip_turn, kExactTurn) << k;
      EXPECT_LE(m.slide, kExact) << k;
      EXPECT_LE(m.jump, kSmoothVelocity) << k;
      worst = {max(worst.place, m.place), max(worst.turn, m.turn),
               max(worst.grip, m.grip),   max(worst.grip_turn, m.grip_turn),
               max(worst.slide, m.slide), max(worst.jump, m.jump)};
    }
    if (result->candidates.front().judgement.verdict == Verdict::impossible) {
      told += fmt::format("{}: {}\n", k,
                          reason_words(result->candidates.front().judgement.reasons.front()));
    }
    possible += result->candidates.front().judgement.verdict != Verdict::impossible ? 1 : 0;
  }
  std::cout << fmt::format(
      "{} of {} met, {} of them can be made; places {:.3f} mm {:.3f} deg, grips {:.3f} mm {:.3f} "
      "deg, feet {:.3f} mm, jumps {:.3f} rad/s\n{}",
      met, pieces, possible, 1e3 * worst.place, degrees(worst.turn), 1e3 * worst.grip,
      degrees(worst.grip_turn), 1e3 * worst.slide, worst.jump, told);
  EXPECT_GE(met, kMetShare * pieces);
}

}  // namespace
}  // namespace shigusa
