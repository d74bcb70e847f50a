// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <vector>

#include "support/flesh.hpp"
#include "support/limbs_in_things.hpp"

// Pieces of work drawn at random, and what is measured of them.
namespace shigusa::testing_support {

// Least share of drawn pieces that are met, all of which are in easy reach.
inline constexpr double kMetShare = 0.97;

// Measures of a candidate, in the order of kPieceLimits.
enum PieceMeasure { place, turn, grip, grip_turn, slide, jump, flesh, legs, forearms };

// The largest value that a measure may have; its unit for tables.
struct PieceLimit {
  PieceMeasure measure;
  const char* says;
  const char* unit;
  double in_unit;  // factor
  double most;     // in m, rad, rad/s
};
inline constexpr std::array kPieceLimits{
    PieceLimit{place, "placed things from their places", "mm", 1e3, 1e-3},
    PieceLimit{turn, "placed things from their turns", "deg", degrees(1.0), radians(1.0)},
    PieceLimit{grip, "hands from their places on moving things", "mm", 1e3, 1e-3},
    PieceLimit{grip_turn, "hands from their turns on moving things", "deg", degrees(1.0),
               radians(1.0)},
    PieceLimit{slide, "feet from where they stand", "mm", 1e3, 1e-3},
    PieceLimit{jump, "change of a joint's velocity between frames at a boundary", "rad/s", 1.0,
               1.0},
    PieceLimit{flesh, "depth of arms in head and shanks", "mm", 1e3, 0.02},
    PieceLimit{legs, "depth of legs in things", "mm", 1e3, 0.01},
    PieceLimit{forearms, "depth of forearms in things, which they give way to", "mm", 1e3, 0.02},
};
using PieceMeasures = std::array<double, kPieceLimits.size()>;

// Adds the errors of a hand on a thing over the frames in which that moves.
inline void add_grip(const ThingMotion& thing, const Effector& hand,
                     const std::vector<Posture>& postures, PieceMeasures& m) {
  std::optional<Transformd> held;
  for (std::size_t f = 1; f < postures.size(); ++f) {
    const Vec3d way = thing.poses[f].translation - thing.poses[f - 1].translation;
    if (norm(way) < 1e-5) continue;
    const Transformd now = inverse(thing.poses[f]) * postures[f].place(hand.link);
    if (!held) held.emplace(now);
    m[grip] = max(m[grip], norm(now * hand.point - *held * hand.point));
    m[grip_turn] =
        max(m[grip_turn], norm(rotation_vector(now.rotation * transpose(held->rotation))));
  }
}

inline void add_grips(const Task& task, const Candidate& candidate,
                      const std::vector<Posture>& postures, PieceMeasures& m) {
  // a thing that moves is in the hands that have grasped it
  for (std::size_t a = 0; a < candidate.actions.size(); ++a) {
    for (const ThingMotion& thing : candidate.things) {
      if (thing.thing.name != task.actions[a].grasp) continue;
      for (const GoalResult& goal : candidate.actions[a].goals) {
        const int hand = task.body.find_effector(goal.asked.effector).value();
        add_grip(thing, task.body.effector(hand), postures, m);
      }
    }
  }
}

inline void add_jumps(const Candidate& candidate, PieceMeasures& m) {
  const Clip& clip = candidate.motion.clip;
  for (std::size_t a = 1; a < candidate.actions.size(); ++a) {
    const int at = static_cast<int>(candidate.actions[a].start / clip.frame_time + 0.5);
    if (at < 1 || at + 1 >= clip.frames) continue;
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double before = clip.frame(at)[k] - clip.frame(at - 1)[k];
      const double after = clip.frame(at + 1)[k] - clip.frame(at)[k];
      m[jump] = max(m[jump], abs(after - before) / clip.frame_time);
    }
  }
}

// Whether a candidate is told to collide with nothing, deeper than what gives way.
inline bool told_as_free(const Candidate& candidate) {
  const auto& reasons = candidate.judgement.reasons;
  return candidate.measures.collides.depth <= kCollisionDepth &&
         std::none_of(reasons.begin(), reasons.end(),
                      [](const Reason& reason) { return reason.kind == ReasonKind::collision; });
}

inline PieceMeasures measure_piece(const Task& task, const Candidate& candidate) {
  PieceMeasures m{};
  for (const ActionResult& action : candidate.actions) {
    if (!action.placed) continue;
    m[place] = max(m[place], action.placed->error);
    m[turn] = max(m[turn], action.placed->turn_error);
  }
  const Clip& clip = candidate.motion.clip;
  std::vector<Posture> postures;
  for (int f = 0; f < clip.frames; ++f) postures.emplace_back(task.body, clip.frame(f));
  add_grips(task, candidate, postures, m);
  for (const Foot& foot : task.body.feet()) {
    const Vec3d stands = postures.front().place(foot.link) * foot.centre;
    for (const Posture& posture : postures) {
      m[slide] = max(m[slide], norm(posture.place(foot.link) * foot.centre - stands));
    }
  }
  add_jumps(candidate, m);
  if (!told_as_free(candidate)) return m;
  const ClipPlaces places(task.body, clip);
  const auto depths = Flesh(places, task.body.stature()).deepest();
  m[flesh] = max(depths.head, depths.shank);
  m[legs] = depth_in_things(task.body, places, kLegs, candidate.things);
  m[forearms] = depth_in_things(task.body, places, kForearms, candidate.things);
  return m;
}

// A place for a thing near the body, in easy reach of both hands.
inline Vec3d near_place(Random& random, double low) {
  return {random.uniform(-0.3, 0.3), max(low, random.uniform(0.1, 1.3)), random.uniform(0.3, 0.45)};
}

inline Task drawn_piece(std::uint64_t seed) {
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

// Measures of many drawn pieces together.
struct PiecesTally {
  int pieces = 0;
  int met = 0;
  int possible = 0;  // of which the first candidate can be made
  PieceMeasures worst{};
  std::vector<std::string> faults{};  // what no piece may do
  std::vector<std::string> told{};    // why pieces are not met or cannot be made

  void add(int number) {
    const Task task = drawn_piece(static_cast<std::uint64_t>(number));
    ++pieces;
    const auto result = perform(task);
    if (!result) return fault(number, result.error().to_string());
    if (!result->meets_goals()) {
      if (result->conflict.empty()) fault(number, "fails without a word");
      told.push_back(fmt::format("{}: {}", number, result->conflict.text));
      return;
    }
    ++met;
    const Judgement& first = result->candidates.front().judgement;
    if (first.verdict == Verdict::impossible) {
      told.push_back(fmt::format("{}: {}", number, reason_words(first.reasons.front())));
    } else {
      ++possible;
    }
    for (std::size_t k = 0; k < result->candidates.size(); ++k) {
      add_measures(fmt::format("{}, candidate {}", number, k + 1),
                   measure_piece(task, result->candidates[k]));
    }
  }

  // Whether all that is promised of drawn pieces holds.
  [[nodiscard]] bool holds() const {
    return pieces > 0 && faults.empty() && met >= kMetShare * pieces;
  }

  [[nodiscard]] std::string table() const {
    std::string text = fmt::format("{} of {} met, {} of them can be made\n", met, pieces, possible);
    for (const PieceLimit& limit : kPieceLimits) {
      text += fmt::format("{:>10.3f} {:5} of {:g}  {}\n", worst[limit.measure] * limit.in_unit,
                          limit.unit, limit.most * limit.in_unit, limit.says);
    }
    for (const std::string& line : told) text += "told: " + line + "\n";
    for (const std::string& line : faults) text += "fault: " + line + "\n";
    return text;
  }

 private:
  template <class Number>
  void fault(const Number& number, const std::string& what) {
    faults.push_back(fmt::format("{}: {}", number, what));
  }
  void add_measures(const std::string& number, const PieceMeasures& m) {
    for (const PieceLimit& limit : kPieceLimits) {
      const double value = m[limit.measure];
      worst[limit.measure] = max(worst[limit.measure], value);
      if (value <= limit.most) continue;
      fault(number, fmt::format("{} {:.3f} {}", limit.says, value * limit.in_unit, limit.unit));
    }
  }
};

}  // namespace shigusa::testing_support
