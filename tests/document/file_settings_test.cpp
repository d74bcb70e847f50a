// SPDX-License-Identifier: MIT
// Names of joints and clips in files, and motions in place, without the travel of the hips.
#include <gmock/gmock.h>

#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>

#include "document/in_place.hpp"
#include "document/joint_names.hpp"
#include "formats/gltf_animation.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kDigits = 1e-6;  // m, of a BVH

// A low reach, during which the hips travel.
struct Reach {
  CharacterSpec character;
  Task task;
  Candidate candidate;

  explicit Reach(TaskFile file) : task(make_task(file, {}).value()) {
    character = file.character;
    candidate = regenerate(task, uniform_parameters(task.body)).value().candidates.at(0);
  }
  [[nodiscard]] SkeletonMotion bvh(const FileSettings& settings) const {
    const auto bytes = export_candidate(character, task, candidate, FileFormat::bvh, settings);
    EXPECT_TRUE(bytes) << bytes.error().to_string();
    return parse_bvh(*bytes, "reach.bvh").value();
  }
};

TaskFile low_reach() {
  TaskFile file;
  file.character.source = "human";
  file.goals = {{"right_hand", {-0.2, 0.5, 0.5}}};
  return file;
}

TaskFile low_reach_of_a_file() {
  TaskFile file = low_reach();
  file.character.source = "hero.glb";
  EXPECT_TRUE(load_character(glb(person_gltf().dump(), ""), file.character));
  return file;
}

TEST(JointNames, BodyLeavesByTheNamesOfOthersAndIsReadByThem) {
  const Reach reach(low_reach());
  for (const EnumWord<JointNames>& names : kEnumWords<JointNames>) {
    const auto bytes =
        export_candidate(reach.task, reach.candidate, FileFormat::bvh, {.names = names.value});
    ASSERT_TRUE(bytes) << names.word;
    CharacterSpec read{.source = "reach.bvh"};
    const auto loaded = load_character(*bytes, read);
    ASSERT_TRUE(loaded) << names.word << ": " << loaded.error().to_string();
    for (const JointNameRow& row : joint_name_rows()) {
      const auto found = std::find_if(read.humanoid.begin(), read.humanoid.end(),
                                      [&](const auto& bone) { return bone.first == row[0]; });
      ASSERT_NE(found, read.humanoid.end()) << row[0];
      EXPECT_EQ(found->second, joint_name(names.value, row[0])) << names.word;
    }
  }
}

TEST(JointNames, CharacterOfAFileKeepsItsOwn) {
  const Reach reach(low_reach_of_a_file());
  const auto bytes = export_candidate(reach.character, reach.task, reach.candidate, FileFormat::bvh,
                                      {.names = JointNames::unreal});
  ASSERT_FALSE(bytes);
  EXPECT_THAT(bytes.error().to_string(), HasSubstr("joint names: are those of hero.glb"));
}

TEST(InPlace, HipsKeepTheirPlaceAlongTheFloorAndRiseAsTheyDid) {
  for (const TaskFile& file : {low_reach(), low_reach_of_a_file()}) {
    const Reach reach(file);
    const SkeletonMotion plain = reach.bvh({});
    const SkeletonMotion still = reach.bvh({.in_place = true});
    ASSERT_EQ(still.clip.frames, plain.clip.frames);
    const auto hips = static_cast<std::size_t>(plain.skeleton.find("hips"));
    const Vec3d begin = world_transforms(plain.skeleton, plain.clip, 0)[hips].translation;
    double travelled = 0.0;
    for (int f = 0; f < plain.clip.frames; ++f) {
      const auto was = world_transforms(plain.skeleton, plain.clip, f);
      const auto is = world_transforms(still.skeleton, still.clip, f);
      Vec3d travel = was[hips].translation - begin;
      travelled = max(travelled, sqrt(travel.x * travel.x + travel.z * travel.z));
      travel.y = 0.0;
      for (std::size_t i = 0; i < was.size(); ++i) {
        // centimetres
        EXPECT_LE(norm(was[i].translation - travel - is[i].translation), 100 * kDigits);
      }
    }
    EXPECT_GT(travelled, 1.0);  // cm: else this shows nothing
  }
}

TEST(InPlace, GoesByTheWorldAndNotByTheAxesOfAParent) {
  // the parent has z up and is in centimetres
  const Mat3d parent{{0.01, 0, 0}, {0, 0, -0.01}, {0, 0.01, 0}};
  std::vector<LocalTransform> local{{{0, 0, 90}, {}}, {{5, -7, 60}, {}}};
  stay_in_place(0, parent, {0, 1, 0}, 1, local);
  EXPECT_LE(norm(local[1].translation - Vec3d{0, 0, 60}), 1e-9);
}

TEST(ClipName, AnimationsAreCalledAsAsked) {
  const Reach reach(low_reach_of_a_file());
  const auto one = export_candidate(reach.character, reach.task, reach.candidate, FileFormat::glb,
                                    {.animation = "Pick up"});
  EXPECT_THAT(gltf_animation_names(one.value(), "one.glb").value(), ElementsAre("Pick up"));
  const std::vector<Candidate> both(2, reach.candidate);
  const auto named = [&](const FileSettings& settings) {
    const auto all = export_all(reach.character, reach.task, both, settings);
    return gltf_animation_names(all.value(), "all.glb").value();
  };
  EXPECT_THAT(named({.animation = "Pick up"}), ElementsAre("Pick up 1", "Pick up 2"));
  EXPECT_THAT(named({.animation = {}}), ElementsAre("shigusa candidate 1", "shigusa candidate 2"));
}

TEST(FileSettings, AreReadFromTheirObject) {
  const auto read = parse_file_settings(
      R"({"fps": 24, "clip": "Reach", "joint_names": "humanik", "in_place": true})", "options");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->rate, 24.0);
  EXPECT_EQ(read->animation, "Reach");
  EXPECT_EQ(read->names, JointNames::humanik);
  EXPECT_TRUE(read->in_place);
  const auto wrong = parse_file_settings(R"({"joint_names": "mixmao"})", "options");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().to_string(), HasSubstr("did you mean 'mixamo'"));
}

}  // namespace
}  // namespace shigusa
