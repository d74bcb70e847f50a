// SPDX-License-Identifier: MIT
// A humanoid of an MJCF file through a search, a result and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "formats/mjcf.hpp"
#include "support/mjcf_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class MjcfCharacter : public testing::Test {
 protected:
  WorkFolder folder_;
  TaskFile file_;

  Task task_of(const std::string& text) {
    file_.character.source = folder_.put("humanoid.xml", text);
    file_.goals = {{"right_hand", {-0.2, 0.6, 0.35}}};
    file_.evaluations = 200;
    return make_task(file_, {}).value();
  }
};

TEST_F(MjcfCharacter, HasItsJointsNamedAsAPersons) {
  const Task task = task_of(research_mjcf());
  for (const char* name : {"right_ankle.inversion", "left_knee.flexion", "right_hip.rotation",
                           "spine.lateral", "left_elbow.flexion"}) {
    EXPECT_TRUE(task.body.find_dof(name)) << name;
  }
  const Dof& knee = task.body.dof(task.body.find_dof("left_knee.flexion").value());
  EXPECT_NEAR(degrees(knee.upper), 150.0, 1e-9);
  EXPECT_EQ(knee.torque_positive, 80.0);
}

TEST_F(MjcfCharacter, OfEachLayoutReachesItsGoal) {
  for (const std::string& text :
       {research_mjcf(), research_mjcf(false), research_mjcf(false, false), makers_mjcf()}) {
    EXPECT_TRUE(generate(task_of(text)).value().meets_goals());
  }
}

TEST_F(MjcfCharacter, AxesOfOneJointNeedNoMass) {
  const Task task = task_of(research_mjcf());
  EXPECT_THAT(std::vector(task.doubts.begin(), task.doubts.end()),
              Each(Not(HasSubstr("weighs nothing"))));
}

TEST_F(MjcfCharacter, HandThatIsAShapeOfItsForearmIsTheHand) {
  const Task task = task_of(research_mjcf(false));
  EXPECT_EQ(task.body.effectors()[0].node, "right_hand");
  EXPECT_THAT(std::vector(task.doubts.begin(), task.doubts.end()),
              Each(Not(HasSubstr("ends its arm"))));
}

TEST_F(MjcfCharacter, WithoutAnklesGetsThemWithADoubt) {
  const Task task = task_of(research_mjcf(true, false));
  EXPECT_TRUE(task.body.find_dof("left_ankle.flexion"));
  EXPECT_THAT(std::vector(task.doubts.begin(), task.doubts.end()),
              Contains(AllOf(HasSubstr("the legs have no ankles"), HasSubstr("left_foot_ankle"))));
  // the added ankle stands above the sole as a person's does, in 0.137 of the knee's height
  EXPECT_NEAR(task.body.base().translation.y, 0.137 / 0.863 * 0.386, 0.02);
}

TEST_F(MjcfCharacter, ResultIsPlayedAgainWithTheSameBytesAndDoubts) {
  const std::string box = "<body name=\"box\"><geom size=\"1\"/></body>";
  std::string text = research_mjcf();
  text.insert(text.find("<body name=\"torso\""), box);
  const Task task = task_of(text);
  const GenerateResult generation = generate(task).value();
  StoredResult stored =
      parse_result(format_result({file_, task, generation}), "summary.json").value();
  const Task again = make_task(stored.task, "/nowhere").value();
  EXPECT_THAT(again.doubts, Contains("body 'box' of the world is no part of the robot"));
  const GenerateResult replayed = regenerate(again, stored.candidates.at(0)).value();
  for (const FileFormat format : {FileFormat::csv, FileFormat::bvh}) {
    EXPECT_EQ(export_candidate(again, replayed.candidates[0], format).value(),
              export_candidate(task, generation.candidates[0], format).value());
  }
}

TEST_F(MjcfCharacter, IncludesItsNeighboursFromItsFileAndNoneFromMemory) {
  folder_.put("robot.xml", research_mjcf());
  const std::string scene = "<mujoco><include file=\"robot.xml\"/></mujoco>";
  CharacterSpec from_file{.source = folder_.put("scene.xml", scene)};
  EXPECT_TRUE(measure_character(from_file, {}));
  CharacterSpec from_memory{.source = "scene.xml"};
  const Result<void> read = load_character(scene, from_memory);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().to_string(), HasSubstr("which is not here: it was read without it"));
}

// The model with key frames of all its numbers, the free joint's first.
std::string with_keys(const std::string& model, const std::string& keys) {
  std::string text = model;
  return text.insert(text.rfind("</mujoco>"), "<keyframe>" + keys + "</keyframe>");
}

TEST_F(MjcfCharacter, KeyframeIsTheStart) {
  const Robot robot = parse_mjcf(research_mjcf(), "humanoid.xml").value();
  // knees by 30°, as the hinges stand in the file: the ankles and hips take that back
  const auto numbers = [&](double knee, double elbow) {
    std::string text = "0 0 1 1 0 0 0";
    for (const Robot::Joint& joint : robot.joints) {
      if (!joint.moves) continue;
      double angle = 0.0;
      if (joint.name.ends_with("knee")) angle = -knee;
      if (joint.name.ends_with("hip_y") || joint.name.ends_with("ankle_y")) angle = -0.5 * knee;
      if (joint.name.ends_with("elbow")) angle = elbow;
      text += fmt::format(" {}", radians(angle));
    }
    return text;
  };
  const std::string model =
      with_keys(research_mjcf(), fmt::format("<key name=\"crouch\" qpos=\"{}\"/><key qpos=\"{}\"/>",
                                             numbers(40.0, 20.0), numbers(24.0, -30.0)));
  for (const auto& [key, knee, elbow] :
       {std::tuple("crouch", 40.0, 20.0), std::tuple("0", 40.0, 20.0),
        std::tuple("1", 24.0, -30.0)}) {
    file_.character = {};
    file_.character.animation = key;
    const Task task = task_of(model);
    const auto start = [&](const char* freedom) {
      return degrees(task.home.angles[static_cast<std::size_t>(*task.body.find_dof(freedom))]);
    };
    EXPECT_NEAR(start("left_knee.flexion"), knee, 1.0) << key;
    EXPECT_NEAR(abs(start("left_elbow.flexion")), abs(elbow), 1.0) << key;
    // and so it is where the result is read again
    const TaskFile again = parse_task(format_task(file_), "task.json").value();
    TaskFile copy = again;
    const Task same = make_task(copy, "/nowhere").value();
    EXPECT_EQ(same.home.angles, task.home.angles);
  }
}

TEST_F(MjcfCharacter, KeyframeThatIsNotThereOrDoesNotStandIsToldSo) {
  const auto refusal = [&](const std::string& model, const char* key) {
    file_.character = {};
    file_.character.animation = key;
    file_.character.source = folder_.put("humanoid.xml", model);
    file_.goals = {{"right_hand", {-0.2, 0.6, 0.35}}};
    const Result<Task> task = make_task(file_, {});
    return task ? "" : task.error().to_string();
  };
  EXPECT_THAT(refusal(research_mjcf(), "home"), HasSubstr("no keyframe 'home': the file has none"));
  const Robot robot = parse_mjcf(research_mjcf(), "humanoid.xml").value();
  std::string one_leg = "0 0 1 1 0 0 0";
  for (const Robot::Joint& joint : robot.joints) {
    if (joint.moves) one_leg += joint.name == "left_hip_y" ? " -1.2" : " 0";
  }
  const std::string model =
      with_keys(research_mjcf(), "<key name=\"kick\" qpos=\"" + one_leg + "\"/>");
  EXPECT_THAT(refusal(model, "home"), HasSubstr("the file has 'kick'"));
  EXPECT_THAT(refusal(model, "kick"), HasSubstr("does not stand with both feet flat"));
}

TEST_F(MjcfCharacter, AnimalOfFourLegsIsRefused) {
  std::string legs;
  for (const char* part : {"front", "hind"}) {
    for (const char* side : {"left", "right"}) {
      const bool front = part[0] == 'f';
      const double s = side[0] == 'l' ? 0.1 : -0.1;
      legs += fmt::format(
          "<body name=\"{0}_{1}_{2}\" pos=\"{3} {4} 0\"><joint axis=\"0 1 0\"/>"
          "<geom type=\"capsule\" fromto=\"0 0 0 0 0 -0.2\" size=\"0.03\"/>"
          "<body name=\"{0}_{1}_{5}\" pos=\"0 0 -0.25\"><joint axis=\"0 1 0\"/>"
          "<geom type=\"capsule\" fromto=\"0 0 0 0 0 -0.2\" size=\"0.03\"/>"
          "<body name=\"{0}_{1}_{6}\" pos=\"0 0 -0.25\"><joint axis=\"0 1 0\"/>"
          "<geom size=\"0.03\"/></body></body></body>",
          side, part, front ? "upperarm" : "thigh", front ? 0.35 : -0.35, s,
          front ? "forearm" : "shin", front ? "hand" : "foot");
    }
  }
  CharacterSpec dog{.source = "dog.xml"};
  const Result<void> read = load_character(
      "<mujoco><worldbody><body name=\"trunk\" pos=\"0 0 0.6\"><freejoint/>"
      "<geom type=\"capsule\" fromto=\"-0.3 0 0 0.3 0 0\" size=\"0.1\"/>" +
          legs + "</body></worldbody></mujoco>",
      dog);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().to_string(), HasSubstr("four legs"));
}

TEST_F(MjcfCharacter, UrdfUnderItsEndingIsNamed) {
  CharacterSpec spec{.source = "robot.xml"};
  EXPECT_THAT(load_character("<robot name=\"r\"/>", spec).error().to_string(),
              HasSubstr("this is a URDF file, not a .xml file"));
}

}  // namespace
}  // namespace shigusa
