// SPDX-License-Identifier: MIT
// Characters of other authors: they start in their recorded posture, and meet every requirement.
#include <gmock/gmock.h>

#include <shigusa/files.hpp>
#include <shigusa/human.hpp>

#include "character/character_file.hpp"
#include "core/check.hpp"
#include "files/file.hpp"
#include "formats/gltf_skin.hpp"
#include "human/at_ease.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "support/exported.hpp"
#include "support/gltf_file.hpp"
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
    const bool bvh = path_.ends_with(".bvh");
    const std::string bytes = bvh ? "" : read_text_file(path_, kGltfMaxBytes).value();
    const GltfCharacter gltf = bvh ? GltfCharacter{} : parse_gltf(bytes, path_).value();
    const SkeletonMotion file = bvh ? read_bvh(path_).value() : gltf.rest;
    const auto world = world_transforms(file.skeleton, file.clip, GetParam().frame);
    const HumanoidMap map = find_humanoid(file.skeleton, world, gltf.humanoid).value();
    const Skin skin = bvh ? Skin{} : read_gltf_skin(bytes, path_, gltf, gltf.places);
    const MeasureSettings settings{.stature = {}, .skin = skin.vertices, .at_rest = !bvh};
    return measure_person(file.skeleton, world, map, settings).value().landmarks;
  }

  // A reach with the right hand, forwards from the shoulder by a bit less than the arm.
  [[nodiscard]] TaskFile reach_task() const {
    TaskFile file;
    file.character.source = path_;
    if (path_.ends_with(".bvh")) file.character.frame = GetParam().frame;
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
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  const ExportedMotion exported(
      export_candidate(task, generation.candidates[0], FileFormat::bvh).value(), 0.01);
  // a rest pose is no posture
  const Landmarks person =
      path_.ends_with(".bvh") ? recorded() : at_ease(recorded(), *file.character.stature);
  for (const Side side : {Side::left, Side::right}) {
    const std::string of = side == Side::left ? "left_" : "right_";
    const auto& leg = person.leg(side);
    const auto& arm = person.arm(side);
    // writing moves no origin by more than 1e-6 m
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
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  for (const Candidate& candidate : generation.candidates) {
    const ExportedMotion exported(export_candidate(task, candidate, FileFormat::bvh).value(), 0.01);
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
    Of, RecordedCharacter,
    testing::Values(Recorded{"blender-cli-rendering__102_01.bvh", 0, "Basketball0"},
                    Recorded{"blender-cli-rendering__102_01.bvh", 200, "Basketball200"},
                    Recorded{"pybvh__bvh_test1.bvh", 0, "Small0"},
                    Recorded{"pybvh__bvh_test1.bvh", 50, "Small50"},
                    Recorded{"assimp__Boxing_Toes.bvh", 0, "Boxing0"},
                    Recorded{"assimp__Boxing_Toes.bvh", 60, "Boxing60"},
                    Recorded{"VRM-Addon-for-Blender__basic_armature.vrm", 0, "Vrm0"},
                    Recorded{"VRM-Addon-for-Blender__debug_robot.vrm", 0, "Vrm1"},
                    Recorded{"KayKit_Knight.glb", 0, "Knight"},
                    Recorded{"lab0_CesiumMan.glb", 0, "CesiumMan"}),
    [](const auto& of) { return std::string(of.param.name); });

// The files of ../shared: the height of each person, or the reason for its absence.
struct Shared {
  const char* file;
  double stature;  // m, or 0
  const char* told;
  const char* left_hand;  // the node
};

class SharedCharacter : public testing::TestWithParam<Shared> {};

TEST_P(SharedCharacter, IsMeasuredOrGivesTheReason) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
  CharacterSpec spec;
  spec.source = shared + "/characters/" + GetParam().file;
  const auto measured = measure_character(spec, {});
  if (GetParam().stature == 0.0) {
    ASSERT_FALSE(measured);
    EXPECT_THAT(measured.error().to_string(), testing::HasSubstr(GetParam().told));
    return;
  }
  ASSERT_TRUE(measured) << measured.error().to_string();
  EXPECT_NEAR(*spec.stature, GetParam().stature, 1e-3);
  if (*GetParam().told == '\0') {
    EXPECT_THAT(spec.doubts, testing::IsEmpty());
  } else {
    EXPECT_THAT(spec.doubts, testing::Contains(testing::HasSubstr(GetParam().told)));
  }
  EXPECT_THAT(spec.humanoid, testing::Contains(testing::Pair("left_hand", GetParam().left_hand)));
  EXPECT_GT(spec.landmarks->left_leg.hip.x, spec.landmarks->right_leg.hip.x);
}

INSTANTIATE_TEST_SUITE_P(
    Of, SharedCharacter,
    testing::Values(
        Shared{"VRM-Addon-for-Blender__basic_armature.vrm", 1.621, "head has no tip", "hand.L"},
        Shared{"VRM-Addon-for-Blender__debug_robot.vrm", 1.977, "at the start they hang", "hand.L"},
        // the whole armature is tilted
        Shared{"VRM-Addon-for-Blender__armature_transform.vrm", 2.306, "along no axis", "hand.L"},
        Shared{"KayKit_Knight.glb", 2.317, "no neck joint", "wrist.l"},
        Shared{"lab0_CesiumMan.glb", 1.518, "nothing follows joint", "Skeleton_arm_joint_L__2_"},
        // his right arm ends at the elbow
        Shared{"mjolnir_BrainStem.glb", 1.841, "right_hand is put", "node 15"},
        // arms end at the forearms, and left and right are exchanged
        Shared{"godot_platformer_player.glb", 2.071, "the file is mirrored", "left_hand"},
        // spines that wind: by the bones 1.90 m
        Shared{"cats_mannyquin.glb", 1.820, "at the start they hang", "DEF-hand.L"},
        Shared{"meshoptimizer__fuzz.glb", 0.0, "no skeleton in this file", ""},
        Shared{"assimp__simple_skin.gltf", 0.0, "no left leg", ""},
        Shared{"assimp__IndexOutOfRange.gltf", 0.0, "no skeleton in this file", ""},
        Shared{"tinygltf__invalid-buffer-index.gltf", 0.0, "no nodes", ""},
        Shared{"bvhtoolbox_walk01.bvh", 1.911, "starts from the rest pose", "LeftHand"},
        // no joint inherits its parent's scale of 0.01
        Shared{"ufbx_humanik_7400_ascii.fbx", 1.722, "head has no tip", "Character1_LeftHand"}),
    [](const auto& of) {
      std::string name = of.param.file;
      std::erase_if(name, [](char c) { return c == '_' || c == '.' || c == '-'; });
      return name;
    });

TEST(MeasureCharacter, GltfAndBvhOfAPersonAreMeasuredAlike) {
  const WorkFolder work;
  work.put("person.bvh", person_bvh());
  work.put("person.glb", glb(person_gltf().dump()));
  work.put("person.GLTF", person_gltf().dump());
  CharacterSpec bvh{.source = "person.bvh"};
  ASSERT_TRUE(measure_character(bvh, work.path()));
  for (const char* file : {"person.glb", "person.GLTF"}) {
    CharacterSpec gltf{.source = file};
    ASSERT_TRUE(measure_character(gltf, work.path()));
    EXPECT_EQ(gltf.source, file);
    // BVH's angles are written so that no origin moves by more than 1e-6 m
    EXPECT_NEAR(*gltf.stature, *bvh.stature, 1e-6);
    EXPECT_LE(norm(gltf.landmarks->left_leg.toe - bvh.landmarks->left_leg.toe), 1e-6);
    // a person in the file's rest pose is posed at ease, and one in a recording's frame stays so
    EXPECT_LE(norm(gltf.landmarks->left_arm.fingertip - bvh.landmarks->left_arm.fingertip), 5e-3);
  }
}

TEST(MeasureCharacter, OtherFilesThanPersonsAreNotParsed) {
  for (const char* source : {"person.txt", "robot.urdf"}) {
    EXPECT_THROW((void)parse_character("", {.source = source}), PreconditionError) << source;
  }
}

TEST(MeasureCharacter, GltfHasOneFrame) {
  const WorkFolder work;
  work.put("person.glb", glb(person_gltf().dump()));
  CharacterSpec spec{.source = "person.glb", .frame = 1};
  const auto measured = measure_character(spec, work.path());
  ASSERT_FALSE(measured);
  EXPECT_EQ(measured.error().to_string(),
            "person.glb: frame 1 does not exist: the file has no animation, only its rest pose; "
            "leave the frame out");
}

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
  EXPECT_NEAR(build_character(spec).value().body.mass(), 73.0, 0.01);
  spec.mass = 90.0;
  EXPECT_NEAR(build_character(spec).value().body.mass(), 90.0, 0.01);
}

// A figure of 1 m below a head of 0.8 m, as in games.
TEST(BuiltCharacter, OfABigHeadIsAsHeavyAndStrongAsItsLimbs) {
  const auto knee = [](const CharacterSpec& spec) {
    const BodyModel body = build_character(spec).value();
    EXPECT_NEAR(body.mass(), default_mass(1.0, Sex::male), 0.1) << spec.source;
    return body.dof(body.find_dof("right_knee.flexion").value()).torque_positive;
  };
  CharacterSpec plain{.source = "plain", .stature = 1.0};
  plain.landmarks = standing_landmarks(1.0, 0.0);
  CharacterSpec big{.source = "big", .stature = 1.66};
  big.landmarks = plain.landmarks;
  big.landmarks->head_top.y += 0.66;
  EXPECT_NEAR(knee(big), knee(plain), 0.01 * knee(plain));
}

}  // namespace
}  // namespace shigusa
