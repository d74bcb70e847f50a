// SPDX-License-Identifier: MIT
// Layers on characters of other authors.
#include <gtest/gtest.h>

#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "generate/layered_approaches.hpp"
#include "support/layered.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

struct Recorded {
  const char* file;
  int frame;
  BodyExtent extent;
  const char* name;
};

class LayeredCharacter : public testing::TestWithParam<Recorded> {
 protected:
  void SetUp() override {
    const std::string shared = SHIGUSA_SHARED_DIR;
    if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
    file_.character.source = shared + "/characters/" + GetParam().file;
    file_.character.frame = GetParam().frame;
    file_.character.extent = GetParam().extent;
    file_.goals = {{"right_hand", {0, 1, 0}}};
    file_.preset = Preset::layers;
  }

  TaskFile file_;
};

TEST_P(LayeredCharacter, MeetsItsGoalWithPlantedFeet) {
  Task task = make_task(file_, {}).value();
  // forwards from the shoulder by a bit less than the arm
  const BodyLimb arm = find_limbs(task.body, task.home).value().arms[0];
  const Vec3d shoulder =
      placed(task.body, task.home.angles).origin[static_cast<std::size_t>(arm.flexion)];
  task.goals[0].position = shoulder + Vec3d{0.1, -0.3, 0.9} * arm.segments.longest();
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  const ReachProblem problem = testing_support::make_layered_problem(task).reach;
  for (const Candidate& candidate : generation.candidates) {
    const MeasuredMotion measured(problem, candidate.motion.clip);
    EXPECT_EQ(measured.start_error, 0.0);
    EXPECT_LE(measured.goal_error, kReachTolerance);
    EXPECT_LE(measured.path_error, kReachTolerance);
    EXPECT_LE(measured.contact_slide, kReachTolerance);
    EXPECT_LE(measured.contact_tilt, kTiltTolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bvh, LayeredCharacter,
    testing::Values(Recorded{"blender-cli-rendering__102_01.bvh", 0, BodyExtent::full,
                             "Basketball"},
                    Recorded{"blender-cli-rendering__102_01.bvh", 200, BodyExtent::full, "Running"},
                    Recorded{"pybvh__bvh_test1.bvh", 0, BodyExtent::full, "Small"},
                    Recorded{"pybvh__bvh_test1.bvh", 50, BodyExtent::half, "SmallHalf"},
                    Recorded{"assimp__Boxing_Toes.bvh", 60, BodyExtent::full, "Boxing"}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace shigusa
