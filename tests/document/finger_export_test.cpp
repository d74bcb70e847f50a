// SPDX-License-Identifier: MIT
// Fingers of characters from files, measured in the written files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "character/character_rig.hpp"
#include "rig/finger_bones.hpp"
#include "support/exported_glb.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kFloats = 2e-6;  // numbers of a GLB are floats

class FingerExport : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string shared = SHIGUSA_SHARED_DIR;
    const auto path = std::filesystem::path(shared) / "characters" / GetParam();
    if (shared.empty() || !std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
    asked_.character.source = path.string();
    ASSERT_TRUE(measure_character(asked_.character, {}));
    asked_.goals = {{"right_hand", Vec3d{-0.12, 0.6, 0.25} * *asked_.character.stature}};
  }

  // The reach with all weights 1, as a file.
  [[nodiscard]] std::string written(FileFormat format) {
    const Task task = make_task(asked_, {}).value();
    const Candidate best = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
    const auto made = export_candidate(asked_.character, task, best, format, {});
    EXPECT_TRUE(made) << made.error().to_string();
    return made.value_or("");
  }

  [[nodiscard]] const CharacterRig& rig() const { return *asked_.character.rig; }
  [[nodiscard]] int file_node(int node) const {
    return rig().file_node[static_cast<std::size_t>(node)];
  }

  TaskFile asked_;
};

// Both files rest in a T-pose, palms down.
TEST_P(FingerExport, ReachingHandsOpenAndCloseAndOthersAreRelaxed) {
  const ExportedGlb glb(written(FileFormat::glb));
  const std::string animation = "shigusa";
  const int last = glb.frames(animation) - 1;
  int tips = 0;
  for (const FingerBone& bone : rig().rig.fingers) {
    if (bone.joint != kFingerJoints) continue;
    ++tips;
    const bool left = bone.side == Side::left;
    const int hand =
        file_node(rig().rig.bones[left ? HumanoidBone::left_hand : HumanoidBone::right_hand]);
    int root = file_node(bone.node);
    while (glb.parent(root) != hand) root = glb.parent(root);
    const int tip = file_node(bone.node);
    // the last joint from the first one, in the hand as it stands at rest: far out of the palm
    const Transformd rest = glb.place(hand);
    struct Place {
      double out;   // of the palm (m)
      double from;  // the wrist
    };
    const auto in_hand = [&](const std::string& of, int frame) {
      const Transformd now = glb.place(hand, of, frame);
      const Vec3d from_root = glb.at(tip, of, frame) - glb.at(root, of, frame);
      return Place{-(rest.rotation * transpose_times(now.rotation, from_root)).y,
                   norm(glb.at(tip, of, frame) - now.translation)};
    };
    const Place flat = in_hand({}, 0);
    const Place closed = in_hand(animation, last);
    EXPECT_GT(closed.out, flat.out + 0.005) << bone.node;
    EXPECT_LT(closed.from, flat.from) << bone.node;
    double widest = 0.0;
    int widest_at = 0;
    for (int f = 0; f <= last; ++f) {
      const Place now = in_hand(animation, f);
      EXPECT_GT(now.out, flat.out - kFloats) << "frame " << f;
      if (!left && now.from > widest + kFloats) {
        widest = now.from;
        widest_at = f;
      }
      if (left) {
        EXPECT_NEAR(now.out, closed.out, kFloats) << "frame " << f;
      }
    }
    if (left) continue;
    EXPECT_GT(widest, closed.from + 0.002);
    EXPECT_NEAR(static_cast<double>(widest_at) / last, 0.65, 0.05);
    EXPECT_NEAR(in_hand(animation, 0).out, closed.out, kFloats);
  }
  EXPECT_EQ(tips, 10);
}

// A cup of a width (m) is put elsewhere by the right hand.
TaskFile cup_task(const CharacterSpec& character, double width) {
  TaskFile file;
  file.character = character;
  const double unit = *character.stature / 1.7;
  file.things = {{.name = "cup",
                  .shape = ThingShape::cylinder,
                  .size = {width, 0.1, width},
                  .position = Vec3d{-0.2, 0.95, 0.4} * unit}};
  file.actions = {{.grasp = "cup", .with = {"right_hand"}},
                  {.place = "cup", .position = Vec3d{0.0, 0.95, 0.4} * unit},
                  {.wait = 1.0}};
  file.evaluations = 200;
  file.candidates = 1;
  return file;
}

// Distance (m) of each fingertip from the wrist's node in a frame.
std::vector<double> reaches_of(const CharacterRig& rig, const ExportedGlb& glb, Side side,
                               int frame) {
  const auto file_node = [&](int node) { return rig.file_node[static_cast<std::size_t>(node)]; };
  const bool left = side == Side::left;
  const Vec3d wrist =
      glb.at(file_node(rig.rig.bones[left ? HumanoidBone::left_hand : HumanoidBone::right_hand]),
             "shigusa", frame);
  std::vector<double> reaches;
  for (const FingerBone& bone : rig.rig.fingers) {
    if (bone.side != side || bone.joint != kFingerJoints || bone.finger == Finger::thumb) continue;
    reaches.push_back(norm(glb.at(file_node(bone.node), "shigusa", frame) - wrist));
  }
  return reaches;
}

// Fingers open on the way to a thing, hold it by its width, open to let it go and relax.
TEST_P(FingerExport, HandsCloseAboutAThingByItsWidthAndLetItGo) {
  std::vector<double> wider;
  for (const double width : {0.08, 0.03}) {
    TaskFile file = cup_task(asked_.character, width);
    const Task task = make_task(file, {}).value();
    const GenerateResult result = perform(task).value();
    ASSERT_TRUE(result.meets_goals()) << result.conflict.text;
    const Candidate& best = result.candidates.front();
    ASSERT_EQ(best.hands.size(), 1U);
    const HandUse& use = best.hands.front();
    EXPECT_EQ(use.effector, "right_hand");
    EXPECT_EQ(use.thing, "cup");
    ASSERT_TRUE(use.end);
    EXPECT_NEAR(*use.end, best.actions[1].end, 1e-9);
    EXPECT_LT(use.there, best.actions[0].end);
    const auto glb_bytes = export_candidate(file.character, task, best, FileFormat::glb, {});
    ASSERT_TRUE(glb_bytes) << glb_bytes.error().to_string();
    const ExportedGlb glb(*glb_bytes);
    const auto at = [&](double time, Side side = Side::right) {
      const int frame = static_cast<int>(time / best.motion.clip.frame_time + 0.5);
      return reaches_of(rig(), glb, side, frame);
    };
    const std::vector<double> open = at(use.there - 0.35);
    const std::vector<double> taken = at(use.there);
    const std::vector<double> held = at(*use.end - 0.12);
    const std::vector<double> let_go = at(*use.end + 0.1);
    const std::vector<double> after = at(*use.end + 0.7);
    ASSERT_EQ(open.size(), 4U);
    for (std::size_t f = 0; f < open.size(); ++f) {
      EXPECT_GT(open[f], taken[f] + 0.001) << width;
      EXPECT_NEAR(held[f], taken[f], kFloats) << width;
      EXPECT_GT(let_go[f], held[f] + 0.001) << width;
      EXPECT_NEAR(after[f], at(0.0)[f], kFloats) << width;
      if (!wider.empty()) {
        EXPECT_LT(taken[f], wider[f] - 0.001);
      }
      EXPECT_NEAR(at(use.there, Side::left)[f], at(0.0, Side::left)[f], kFloats);
    }
    wider = taken;
    EXPECT_TRUE(export_candidate(file.character, task, best, FileFormat::vrma, {}));
  }
}

// A hand whose goal turns it is compared by the hand, not by the finger that has the goal.
TEST_P(FingerExport, FilesAreReadBackWithGoalsThatTurn) {
  asked_.goals[0].rotation = Quatd{0, 0, 0, 1};
  asked_.finger_play = FingerPlay::grip;
  for (const FileFormat format : {FileFormat::glb, FileFormat::vrma, FileFormat::bvh}) {
    EXPECT_FALSE(written(format).empty());
  }
}

TEST_P(FingerExport, FingersStayWhereNothingIsAsked) {
  asked_.finger_play = FingerPlay::none;
  const ExportedGlb glb(written(FileFormat::glb));
  for (const FingerBone& bone : rig().rig.fingers) {
    const int node = file_node(bone.node);
    for (const auto& channel : glb.json().at("animations").back().at("channels")) {
      EXPECT_NE(channel.at("target").at("node"), node);
    }
  }
  EXPECT_EQ(written(FileFormat::vrma).find("IndexProximal"), std::string::npos);
  asked_.finger_play = FingerPlay::grip;
  adopt_preset(asked_, Preset::paper);
  EXPECT_EQ(written(FileFormat::vrma).find("IndexProximal"), std::string::npos);
  adopt_preset(asked_, Preset::flat);
  asked_.finger_play = FingerPlay::grip;
  EXPECT_NE(written(FileFormat::vrma).find("IndexProximal"), std::string::npos);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  return info.index == 0 ? "BasicArmature" : "DebugRobot";
}

INSTANTIATE_TEST_SUITE_P(Characters, FingerExport,
                         testing::Values("VRM-Addon-for-Blender__basic_armature.vrm",
                                         "VRM-Addon-for-Blender__debug_robot.vrm"),
                         name_of);

}  // namespace
}  // namespace shigusa
