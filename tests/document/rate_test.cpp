// SPDX-License-Identifier: MIT
// Files at any rate: feet stay, the hand keeps to its path, and the last frame is on the goal.
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "kinematics/forward_kinematics.hpp"
#include "support/exported.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kRates[] = {1.0, 24.0, 25.0, 29.97, 30.0, 60.0, 120.0, 240.0};
constexpr double kMillimetre = 1e-3;
constexpr double kWritten = 1e-6;  // m, rounding of a BVH's digits

struct Reach {
  Task task;
  Candidate candidate;
};

// The first candidates of a low and a high reach, for both bodies.
std::vector<Reach> reaches() {
  std::vector<Reach> all;
  for (const char* body : {"full_body", "human"}) {
    for (const Vec3d& goal : {Vec3d{-0.15, 0.05, 0.45}, Vec3d{-0.3, 1.8, 0.3}}) {
      TaskFile file;
      file.character.source = body;
      file.goals = {{"right_hand", goal}};
      file.evaluations = 200;
      file.candidates = 1;
      const Task task = make_task(file, {}).value();
      all.push_back({task, generate(task).value().candidates[0]});
    }
  }
  return all;
}

TEST(Rate, FramesAreAtTheirTimesAndTheLastIsOnTheGoal) {
  for (const Reach& reach : reaches()) {
    const double duration = reach.candidate.motion.clip.duration();
    for (const double rate : kRates) {
      const ExportedMotion motion(
          export_candidate(reach.task, reach.candidate, FileFormat::bvh, {.rate = rate}).value(),
          0.01);
      EXPECT_EQ(motion.motion().clip.frame_time, 1.0 / rate);
      EXPECT_EQ(motion.frames(), static_cast<int>(std::ceil(duration * rate - 1e-6)) + 1);
      const GoalResult& goal = reach.candidate.goals[0];
      EXPECT_LE(norm(motion.at_end(goal.node) - goal.reached), kWritten);
      EXPECT_LE(norm(motion.at_end(goal.node) - goal.asked.position), kMillimetre);
    }
  }
}

TEST(Rate, FeetStayBetweenTheMotionsFramesToo) {
  double slide = 0.0;
  double tilt = 0.0;
  for (const Reach& reach : reaches()) {
    for (const double rate : kRates) {
      const ExportedMotion motion(
          export_candidate(reach.task, reach.candidate, FileFormat::bvh, {.rate = rate}).value(),
          0.01);
      for (const ContactResult& contact : reach.candidate.contacts) {
        slide = std::fmax(slide, motion.slide(contact.node));
        tilt = std::fmax(tilt, motion.tilt(contact.node));
      }
    }
  }
  std::printf("feet slide %.4f mm and tilt %.5f degrees at most\n", 1e3 * slide, degrees(tilt));
  EXPECT_LE(slide, kMillimetre);
  EXPECT_LE(tilt, radians(0.1));
}

// Between two frames of the motion the hand is on a smooth curve through its positions: a cubic
// through four of them, with an error of 3/128 of the fourth differences.
TEST(Rate, TheHandKeepsToItsWayBetweenTheMotionsFrames) {
  double most = 0.0;
  for (const Reach& reach : reaches()) {
    const Clip& clip = reach.candidate.motion.clip;
    const std::vector<Vec3d>& places = reach.candidate.motion.effectors[0];
    const Clip fine = motion_at(reach.task.body, reach.candidate, 240.0);
    const Effector& hand = reach.task.body.effector(*reach.task.body.find_effector("right_hand"));
    Kinematics<double> now(reach.task.body);
    for (int f = 0; f < fine.frames - 1; ++f) {
      const double at = f / 240.0 / clip.frame_time;
      const int k = static_cast<int>(at);
      if (k < 1 || k > clip.frames - 4) continue;
      const double t = at - k;
      const auto i = static_cast<std::size_t>(k);
      const Vec3d way = places[i - 1] * (-t * (t - 1.0) * (t - 2.0) / 6.0) +
                        places[i] * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
                        places[i + 1] * (-(t + 1.0) * t * (t - 2.0) / 2.0) +
                        places[i + 2] * ((t + 1.0) * t * (t - 1.0) / 6.0);
      forward_kinematics<double>(reach.task.body, fine.frame(f), now);
      most = std::fmax(most, norm(now.point(hand.link, hand.point) - way));
    }
  }
  std::printf("the hand is %.4f mm from its way at most\n", 1e3 * most);
  // it is 0.5 mm from its path in the motion's own frames, too
  EXPECT_LE(most, 0.5 * kMillimetre);
}

TEST(Rate, AnimationsOfGltfHaveItToo) {
  CharacterSpec character{.source = "person.glb"};
  ASSERT_TRUE(load_character(glb(person_gltf().dump(), "data"), character));
  TaskFile file;
  file.character = character;
  file.goals = {{"right_hand", {-0.2, 0.7, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Candidate candidate = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  for (const double rate : kRates) {
    const ExportedGlb out(
        export_candidate(character, task, candidate, FileFormat::glb, {.rate = rate}).value());
    const int frames = out.frames("shigusa");
    EXPECT_EQ(frames, frames_at(candidate.motion.clip.duration(), rate));
    const auto& sampler = out.json().at("animations").at(0).at("samplers").at(0);
    const std::size_t times = sampler.at("input");
    for (int f = 0; f < frames; ++f) {
      EXPECT_EQ(out.element(times, f)[0], static_cast<float>(f / rate));
    }
    EXPECT_EQ(out.json().at("accessors").at(times).at("max").at(0),
              out.element(times, frames - 1)[0]);
  }
}

TEST(Rate, WhatIsNoneIsRefused) {
  const Reach reach = reaches().front();
  for (const double rate : {0.0, -24.0, 0.5, 241.0, 1e300, std::nan("")}) {
    const auto file =
        export_candidate(reach.task, reach.candidate, FileFormat::bvh, {.rate = rate});
    ASSERT_FALSE(file) << rate;
    EXPECT_NE(file.error().message.text.find("allowed are 1 to 240"), std::string::npos);
  }
}

TEST(Rate, CsvAndFiguresKeepTheMotionsOwnFrames) {
  const Reach reach = reaches().front();
  for (const FileFormat format : {FileFormat::csv, FileFormat::svg}) {
    const auto at = [&](double rate) {
      return export_candidate(reach.task, reach.candidate, format, {.rate = rate}).value();
    };
    EXPECT_EQ(at(24.0), at(60.0));
  }
}

}  // namespace
}  // namespace shigusa
