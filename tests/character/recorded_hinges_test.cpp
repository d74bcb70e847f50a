// SPDX-License-Identifier: MIT
// Start postures from any frame of recorded and animated motion: hips, knees and elbows turn like
// people's.
#include <gtest/gtest.h>

#include <shigusa/character.hpp>

#include "files/file.hpp"

namespace shigusa {
namespace {

struct Frames {
  const char* folder;
  const char* file;
  int first;
  int last;
  int step;
  const char* name;
};

class RecordedHinges : public testing::TestWithParam<Frames> {};

TEST_P(RecordedHinges, BendToTheSideThatPeoplesDo) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
  const std::string path = shared + "/" + GetParam().folder + "/" + GetParam().file;
  const std::string bytes = read_text_file(path, std::size_t{64} << 20).value();
  for (int frame = GetParam().first; frame <= GetParam().last; frame += GetParam().step) {
    CharacterSpec spec{.source = GetParam().file, .frame = frame};
    ASSERT_TRUE(load_character(bytes, spec));
    const PosedBody posed = build_character(spec).value();
    const auto angle = [&](const char* name) {
      return degrees(
          posed.home.angles[static_cast<std::size_t>(posed.body.find_dof(name).value())]);
    };
    for (const char* knee : {"left_knee.flexion", "right_knee.flexion"}) {
      EXPECT_GE(angle(knee), -10.0) << "frame " << frame << " " << knee;
    }
    for (const char* hip : {"left_hip.rotation", "right_hip.rotation"}) {
      EXPECT_LE(std::abs(angle(hip)), 90.0) << "frame " << frame << " " << hip;
    }
    for (const char* elbow : {"left_elbow.flexion", "right_elbow.flexion"}) {
      EXPECT_GE(angle(elbow), -15.0) << "frame " << frame << " " << elbow;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, RecordedHinges,
    testing::Values(Frames{"characters", "lab0_CesiumMan.glb", 1, 120, 1, "Walk"},
                    Frames{"characters", "KayKit_Knight.glb", 1, 61, 10, "Knight"},
                    Frames{"characters", "assimp__Boxing_Toes.bvh", 0, 600, 40, "Boxing"},
                    Frames{"characters", "blender-cli-rendering__102_01.bvh", 0, 270, 15,
                           "Basketball"},
                    Frames{"characters", "fairmotion__pfnn_hierarchy.bvh", 0, 50, 25, "Pfnn"},
                    Frames{"characters", "pybvh__bvh_test1.bvh", 0, 70, 5, "Small"},
                    Frames{"characters", "pybvh__standard_skeleton.bvh", 0, 0, 1, "Standing"},
                    Frames{"reach", "cmu_02_06_60hz.bvh", 0, 1020, 60, "Reaches"}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace shigusa
