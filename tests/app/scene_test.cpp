// SPDX-License-Identifier: MIT
// Work in a scene of a GLB file.
#include <filesystem>

#include "app/result_checks.hpp"
#include "support/scene_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;

const Json kMoveCup{{"version", 2},
                    {"evaluations", 200},
                    {"candidates", 1},
                    {"actions",
                     {{{"grasp", "cup"}, {"with", {"right_hand"}}},
                      {{"place", "cup"}, {"position_m", {0.15, 0.78, 0.5}}}}}};

TEST(SceneOfATask, ACupIsMovedOnItsTable) {
  const WorkFolder work;
  SceneFile scene = cup_scene();
  work.put("room/kitchen.glb", scene.bytes());
  Json task = kMoveCup;
  task["scene"] = "kitchen.glb";
  const std::string file = work.put("room/task.json", task.dump());
  const ProgramRun run =
      run_shigusa({"reach", file, "--formats", "csv,svg", "--out", "out"}, {.folder = work.path()});
  EXPECT_THAT(run.exit_code, delivered()) << run.err;
  EXPECT_THAT(run.err, HasSubstr("floor ends at the floor"));
  EXPECT_THAT(run.err, Not(HasSubstr("mass")));
  const StoredRun stored(work, "out");
  const Json& told = stored.summary().at("task");
  EXPECT_FALSE(told.contains("scene"));
  EXPECT_EQ(told.at("obstacles").size(), 5u);
  EXPECT_EQ(told.at("things").at("cup").at("mass_kg"), 0.4);
  EXPECT_EQ(told.at("things").at("cup").at("shape"), "cylinder");
  // it needs the file no more
  std::filesystem::remove_all(work / "room");
  const ProgramRun again =
      run_shigusa({"show", "out", "--out", "again.html"}, {.folder = work.path()});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST(SceneOfATask, TheOptionIsRelativeToTheWorkingFolder) {
  const WorkFolder work;
  SceneFile scene = cup_scene();
  work.put("kitchen.glb", scene.bytes());
  const std::string file = work.put("tasks/task.json", kMoveCup.dump());
  const ProgramRun run =
      run_shigusa({"reach", file, "--scene", "kitchen.glb", "--formats", "csv", "--out", "out"},
                  {.folder = work.path()});
  EXPECT_THAT(run.exit_code, delivered()) << run.err;
  EXPECT_EQ(StoredRun(work, "out").summary().at("task").at("obstacles").size(), 5u);
}

TEST(SceneOfATask, WhatIsNotInItIsTold) {
  const WorkFolder work;
  SceneFile scene = cup_scene();
  work.put("kitchen.glb", scene.bytes());
  const auto told = [&](const std::string& file, const std::string& action) {
    const ProgramRun run =
        run_shigusa({"reach", "--scene", file, "--then", action}, {.folder = work.path()});
    EXPECT_EQ(run.exit_code, 2);
    return run.err;
  };
  EXPECT_THAT(told("kitchen.glb", "grasp=cap"), HasSubstr("'cup'"));
  EXPECT_THAT(told("kitchens.glb", "grasp=cup"), HasSubstr("kitchens.glb"));
  work.put("broken.glb", "glTF");
  EXPECT_THAT(told("broken.glb", "grasp=cup"), HasSubstr("broken.glb"));
}

}  // namespace
}  // namespace shigusa
