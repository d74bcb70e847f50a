// SPDX-License-Identifier: MIT
// The floor bears what the hands hold: balance of whole candidates beside what the search measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

namespace shigusa {
namespace {

struct Found {
  Task task;
  Candidate candidate;
};

Found found(const char* text) {
  TaskFile file = parse_task(text, "task").value();
  Task task = make_task(file, {}).value();
  task.batch.threads = 1;
  const GenerateResult result = (task.actions.empty() ? generate(task) : perform(task)).value();
  return {std::move(task), result.candidates.front()};
}

SupportFrame least(const std::vector<SupportFrame>& frames) {
  SupportFrame all = frames.front();
  for (const SupportFrame& frame : frames) {
    all.centre_of_mass = std::min(all.centre_of_mass, frame.centre_of_mass);
    all.pressure = std::min(all.pressure, frame.pressure);
  }
  return all;
}

TEST(LoadedFrames, AreThoseOfTheSearchWithALoadInTheHand) {
  const auto [task, candidate] = found(R"({"seed": 3, "evaluations": 200, "goals": [
      {"effector": "right_hand", "position_m": [-0.2, 1.1, 0.5], "load_kg": 6}]})");
  const SupportFrame whole = least(support_frames(task, candidate));
  const SupportMargins& margins = *candidate.measures.support;
  EXPECT_DOUBLE_EQ(whole.centre_of_mass, margins.centre_of_mass.distance);
  EXPECT_DOUBLE_EQ(whole.pressure, margins.pressure.distance);
  // 6 kg half a metre ahead of some 75 kg
  EXPECT_GT(norm(centres_of_pressure(task, candidate).back() -
                 centres_of_pressure(task.body, candidate.motion).back()),
            0.02);
}

TEST(LoadedFrames, ArePlacedOnTheFootThatStands) {
  const auto [task, candidate] = found(R"({"seed": 3, "evaluations": 200, "goals": [
      {"effector": "right_hand", "position_m": [-0.2, 1.1, 0.5]}], "contacts": ["left_foot"]})");
  EXPECT_DOUBLE_EQ(least(support_frames(task, candidate)).pressure,
                   candidate.measures.support->pressure.distance);
}

TEST(LoadedFrames, BearTheThingsOfAPieceOfWorkWhileTheyAreHeld) {
  const auto [task, candidate] =
      found(R"({"version": 2, "seed": 3, "evaluations": 200, "candidates": 1,
      "things": {"box": {"size_m": [0.4, 0.3, 0.3], "mass_kg": 8, "position_m": [0, 0.15, 0.42]}},
      "actions": [{"grasp": "box"}, {"place": "box", "position_m": [0, 0.9, 0.45]},
                  {"stand": {"position_m": [0, 0]}}]})");
  ASSERT_EQ(candidate.actions.size(), 3U);
  const Clip& clip = candidate.motion.clip;
  const std::vector<SupportFrame> frames = support_frames(task, candidate);
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(clip.frames));
  // the search measured each motion at its own frames
  const SupportMargins& margins = *candidate.measures.support;
  EXPECT_NEAR(least(frames).centre_of_mass, margins.centre_of_mass.distance, 0.002);
  EXPECT_NEAR(least(frames).pressure, margins.pressure.distance, 0.01);
  const auto loaded = centres_of_pressure(task, candidate);
  const auto empty = centres_of_pressure(task.body, candidate.motion);
  ASSERT_EQ(loaded.size(), empty.size());
  const HandUse& use = candidate.hands.back();
  ASSERT_EQ(use.thing, "box");
  const int take = static_cast<int>(use.there / clip.frame_time + 0.5);
  const int put = static_cast<int>(*use.end / clip.frame_time + 0.5);
  double farthest = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f);
    const double off = norm(loaded[k] - empty[k]);
    if (f <= take || f > put) {
      EXPECT_EQ(off, 0.0) << f;
    }
    farthest = std::max(farthest, off);
  }
  // 8 kg half a metre ahead of some 70 kg
  EXPECT_GT(farthest, 0.03);
  EXPECT_LT(farthest, 0.12);
}

}  // namespace
}  // namespace shigusa
