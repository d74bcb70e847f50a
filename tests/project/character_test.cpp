// SPDX-License-Identifier: MIT
// Characters that nobody here made: they start as they were recorded, and keep every promise.
#include <gmock/gmock.h>

#include <shigusa/project/export.hpp>

#include "support/exported.hpp"
#include "support/person_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

struct Recorded {
  const char* file;
  int frame;
  const char* name;
};

class RecordedCharacter : public testing::TestWithParam<Recorded> {
 protected:
  void SetUp() override {
    const std::string shared = SHIGUSA_SHARED_DIR;
    if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
    path_ = shared + "/characters/" + GetParam().file;
  }

  // The landmarks of the file's own posture, measured apart from the body.
  [[nodiscard]] Landmarks recorded() const {
    const SkeletonMotion file = read_bvh(path_).value();
    const auto world = world_transforms(file.skeleton, file.clip, GetParam().frame);
    const HumanoidMap map = find_humanoid(file.skeleton, world).value();
    return measure_person(file.skeleton, world, map).value().landmarks;
  }

  // A reach with the right hand, forwards from the shoulder by a bit less than the arm.
  [[nodiscard]] TaskFile reach_task() const {
    TaskFile file;
    file.character.source = path_;
    file.character.frame = GetParam().frame;
    const Landmarks person = recorded();
    const auto& arm = person.right_arm;
    const double length = norm(arm.elbow - arm.shoulder) + norm(arm.wrist - arm.elbow);
    file.goals = {{"right_hand", arm.shoulder + Vec3d{0.1, -0.3, 0.9} * length}};
    return file;
  }

  std::string path_;
};

TEST_P(RecordedCharacter, StartsInTheRecordedPosture) {
  TaskFile file = reach_task();
  const Task task = make_task(file, {}).value();
  const Generation generation = regenerate(task, uniform_parameters(task.body)).value();
  const ExportedMotion exported(
      export_candidate(task, generation.candidates[0], ExportFormat::bvh).value(), 0.01);
  const Landmarks person = recorded();
  for (const Side side : {Side::left, Side::right}) {
    const std::string of = side == Side::left ? "left_" : "right_";
    const auto& leg = person.leg(side);
    const auto& arm = person.arm(side);
    // what is written moves no origin by more than 1e-6 m
    EXPECT_LE(norm(exported.at(of + "upper_leg", 0) - leg.hip), 1e-6);
    EXPECT_LE(norm(exported.at(of + "lower_leg", 0) - leg.knee), 1e-6);
    EXPECT_LE(norm(exported.at(of + "foot", 0) - leg.ankle), 1e-6);
    EXPECT_LE(norm(exported.at(of + "upper_arm", 0) - arm.shoulder), 1e-6);
    EXPECT_LE(norm(exported.at(of + "lower_arm", 0) - arm.elbow), 1e-6);
    EXPECT_LE(norm(exported.at(of + "hand", 0) - arm.wrist), 1e-6);
  }
}

TEST_P(RecordedCharacter, MeetsItsGoalWithPlantedFeet) {
  TaskFile file = reach_task();
  Task task = make_task(file, {}).value();
  task.genetic.max_generations = 1;
  const Generation generation = generate(task).value();
  EXPECT_EQ(generation.status, ReachStatus::reached);
  for (const Candidate& candidate : generation.candidates) {
    const ExportedMotion exported(export_candidate(task, candidate, ExportFormat::bvh).value(),
                                  0.01);
    EXPECT_LE(norm(exported.at_end(candidate.goals[0].node) - task.goals[0].position), 1e-3);
    for (const ContactResult& foot : candidate.contacts) {
      EXPECT_LE(exported.slide(foot.node), 1e-3) << foot.node;
      EXPECT_LE(exported.tilt(foot.node), radians(0.1)) << foot.node;
    }
  }
}

TEST_P(RecordedCharacter, OnceMeasuredNeedsNoFile) {
  TaskFile file = reach_task();
  const Task first = make_task(file, {}).value();
  TaskFile again = parse_task(format_task(file), "task.json").value();
  const Task second = make_task(again, "/no/such/folder").value();
  const Parameters parameters = uniform_parameters(first.body);
  EXPECT_EQ(regenerate(first, parameters).value().candidates[0].motion.clip.angles,
            regenerate(second, parameters).value().candidates[0].motion.clip.angles);
}

INSTANTIATE_TEST_SUITE_P(
    Bvh, RecordedCharacter,
    testing::Values(Recorded{"blender-cli-rendering__102_01.bvh", 0, "Basketball0"},
                    Recorded{"blender-cli-rendering__102_01.bvh", 200, "Basketball200"},
                    Recorded{"pybvh__bvh_test1.bvh", 0, "Small0"},
                    Recorded{"pybvh__bvh_test1.bvh", 50, "Small50"},
                    Recorded{"assimp__Boxing_Toes.bvh", 0, "Boxing0"},
                    Recorded{"assimp__Boxing_Toes.bvh", 60, "Boxing60"}),
    [](const auto& of) { return std::string(of.param.name); });

TEST(MeasureCharacter, RelativePathStartsAtTheFolder) {
  const WorkFolder work;
  work.put("people/person.bvh", person_bvh());
  CharacterSpec spec;
  spec.source = "people/person.bvh";
  ASSERT_TRUE(measure_character(spec, work.path()));
  EXPECT_EQ(spec.source, "person.bvh");
  EXPECT_TRUE(spec.landmarks.has_value());
  EXPECT_NEAR(*spec.stature, 1.741, 1e-3);
}

TEST(MeasureCharacter, StatureScalesThePerson) {
  const WorkFolder work;
  work.put("person.bvh", person_bvh());
  CharacterSpec spec;
  spec.source = "person.bvh";
  spec.stature = 1.2;
  ASSERT_TRUE(measure_character(spec, work.path()));
  EXPECT_EQ(*spec.stature, 1.2);
  EXPECT_NEAR(spec.landmarks->head_top.y, 1.2, 0.01);
}

TEST(BuildCharacter, MassIsThatOfAnAveragePersonUnlessGiven) {
  CharacterSpec spec;
  EXPECT_NEAR(build_character(spec).value().mass(), 73.0, 0.01);
  spec.mass = 90.0;
  EXPECT_NEAR(build_character(spec).value().mass(), 90.0, 0.01);
}

}  // namespace
}  // namespace shigusa
