// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/hierarchy/layered_generator.hpp>

#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kFrontLow{-0.15, 0.5, 0.5};

Task task_for(const BodyModel& body, const Vec3d& goal, std::uint64_t seed = 1) {
  Task task{.body = body, .goals = {{"right_hand", goal}}};
  task.genetic.seed = seed;
  return task;
}

LayeredGeneration generated(const Task& task, const LayeredSettings& settings = {}) {
  return generate_layered(task, settings).value();
}

TEST(GenerateLayered, HandArrivesAndFeetStay) {
  for (const BodyModel& body : {half_body(), full_body()}) {
    const Task task = task_for(body, kFrontLow);
    const LayeredGeneration generation = generated(task);
    EXPECT_EQ(generation.status, ReachStatus::reached);
    const ReachProblem problem = make_layered_problem(task).value().reach;
    for (const LayeredCandidate& candidate : generation.candidates) {
      const MeasuredMotion measured(problem, candidate.motion.clip);
      EXPECT_EQ(measured.start_error, 0.0);
      EXPECT_LT(measured.goal_error, 1e-8);
      EXPECT_LT(measured.path_error, 1e-4);
      EXPECT_LT(measured.contact_slide, body.feet().size() == 1 ? 1e-12 : 1e-4);
      EXPECT_LT(measured.contact_tilt, 1e-4);
      EXPECT_LT(degrees(measured.largest_step), 20.0);
      EXPECT_EQ(candidate.score.total, score_motion(body, candidate.motion, {}).total);
    }
  }
}

}  // namespace
}  // namespace shigusa
