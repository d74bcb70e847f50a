// SPDX-License-Identifier: MIT
// A robot from its file through a search, a result and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/edit.hpp>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "kinematics/forward_kinematics.hpp"
#include "kinematics/penetration.hpp"
#include "support/exported.hpp"
#include "support/robot_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

class RobotCharacter : public testing::Test {
 protected:
  WorkFolder folder_;
  TaskFile file_;

  void SetUp() override {
    file_.character.source = folder_.put("small.urdf", RobotFile().text());
    file_.goals = {{"right_hand", {-0.2, 0.4, 0.35}}};
    file_.evaluations = 200;
  }
};

TEST_F(RobotCharacter, IsReadOnceAndThenStandsInTheTask) {
  ASSERT_TRUE(make_task(file_, {}));
  EXPECT_EQ(file_.character.source, "small.urdf");
  ASSERT_TRUE(file_.character.urdf);
  const Result<TaskFile> again = parse_task(format_task(file_), "task.json");
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->character.urdf, file_.character.urdf);
  TaskFile copy = *again;
  EXPECT_TRUE(make_task(copy, "/nowhere"));
}

TEST_F(RobotCharacter, BeginsWithBentKneesOnFlatFeetWithinItsLimits) {
  const Task task = make_task(file_, {}).value();
  const PosedBody& posed = task;
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, posed.home.angles, kinematics);
  for (const Foot& foot : posed.body.feet()) {
    for (const Vec3d& corner : foot.outline) {
      EXPECT_NEAR(kinematics.point(foot.link, corner).y, 0.0, 1e-6);
    }
  }
  const auto knee = static_cast<std::size_t>(posed.body.find_dof("left_knee.flexion").value());
  EXPECT_NEAR(posed.home.angles[knee], radians(10.0), radians(1.0));
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    EXPECT_GE(posed.home.angles[static_cast<std::size_t>(d)], posed.body.dof(d).lower);
    EXPECT_LE(posed.home.angles[static_cast<std::size_t>(d)], posed.body.dof(d).upper);
  }
}

TEST_F(RobotCharacter, ResultIsPlayedAgainWithTheSameBytes) {
  const Task task = make_task(file_, {}).value();
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_LT(generation.log.replay_difference, 0.1);
  const std::string summary = format_result({file_, task, generation});
  StoredResult stored = parse_result(summary, "summary.json").value();
  const Task again = make_task(stored.task, {}).value();
  const GenerateResult replayed = regenerate(again, stored.candidates.at(0)).value();
  for (const FileFormat format : {FileFormat::csv, FileFormat::bvh, FileFormat::svg}) {
    EXPECT_EQ(export_candidate(again, replayed.candidates[0], format).value(),
              export_candidate(task, generation.candidates[0], format).value());
  }
}

TEST_F(RobotCharacter, BvhHasTheRobotsLinkWhereTheGoalIs) {
  const Task task = make_task(file_, {}).value();
  const Candidate candidate = generate(task).value().candidates.at(0);
  const ExportedMotion bvh(export_candidate(task, candidate, FileFormat::bvh).value(), 0.01);
  EXPECT_EQ(candidate.goals[0].node, "right_palm");
  EXPECT_LT(norm(bvh.at_end("right_palm") - task.goals[0].position), 1e-3);
  for (const ContactResult& contact : candidate.contacts) {
    EXPECT_LT(bvh.slide(contact.node), 1e-3);
    EXPECT_LT(bvh.tilt(contact.node), radians(0.1));
  }
}

TEST_F(RobotCharacter, TableHasTheFilesJointsAndTheRootsPlace) {
  const Task task = make_task(file_, {}).value();
  const Candidate candidate = generate(task).value().candidates.at(0);
  const std::string csv = export_candidate(task, candidate, FileFormat::csv).value();
  const std::string names = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(
      names.starts_with("time [s],root.x [m],root.y [m],root.z [m],root.qx,root.qy,root.qz,"
                        "root.qw,left_hip_yaw [rad],"));
  for (const char* name : {"left_finger [rad]", "left_finger_tip [rad]", "drawer [m]",
                           "right_elbow torque [N m]", "right_hand.z [m]"}) {
    EXPECT_THAT(names, HasSubstr(name));
  }
  EXPECT_THAT(names, testing::Not(HasSubstr("left_finger torque")));
}

// Depth (m) of a limb's line in a box, at the worst moment.
double depth_of_line(const ExportedMotion& motion, const std::string& from, const std::string& to,
                     const Obstacle& box) {
  double deepest = -1e9;
  for (int f = 0; f < motion.frames(); ++f) {
    const Vec3d a = motion.at(from, f);
    const Vec3d b = motion.at(to, f);
    for (int k = 0; k <= 20; ++k) {
      const Vec3d p = a + (b - a) * (0.05 * k);
      deepest = max(deepest, -box_distance(placed_boxes({&box, 1}).front(), p));
    }
  }
  return deepest;
}

TEST_F(RobotCharacter, IsNotToldToBePossibleWithItsForearmInABox) {
  const Task free = make_task(file_, {}).value();
  const Candidate straight = generate(free).value().candidates.at(0);
  const ExportedMotion way(export_candidate(free, straight, FileFormat::bvh).value(), 0.01);
  int possible = 0;
  for (const double share : {0.2, 0.4, 0.6}) {
    const Vec3d elbow = way.at_end("right_lower_arm");
    const Vec3d at = elbow + (way.at_end("right_wrist") - elbow) * share;
    TaskFile boxed = file_;
    boxed.obstacles = {{"box", at - Vec3d{0.0, 0.03, 0.0}, {}, {0.08, 0.08, 0.08}}};
    const Task task = make_task(boxed, {}).value();
    const GenerateResult generation = generate(task).value();
    for (const Candidate& candidate : generation.candidates) {
      if (candidate.judgement.verdict != Verdict::possible) continue;
      ++possible;
      const ExportedMotion motion(export_candidate(task, candidate, FileFormat::bvh).value(), 0.01);
      for (const auto& [from, to] : {std::pair("right_upper_arm", "right_lower_arm"),
                                     std::pair("right_lower_arm", "right_wrist")}) {
        EXPECT_LT(depth_of_line(motion, from, to, boxed.obstacles[0]), 0.02) << share << from;
      }
    }
  }
  EXPECT_GT(possible, 0);
}

TEST_F(RobotCharacter, HasNoMirrorImage) {
  const Result<TaskFile> image = mirrored(file_);
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("is a robot"));
}

TEST_F(RobotCharacter, HasItsOwnStature) {
  file_.character.stature = 1.7;
  const Result<Task> task = make_task(file_, {});
  ASSERT_FALSE(task);
  EXPECT_THAT(task.error().message, HasSubstr("stature is of a person"));
}

TEST_F(RobotCharacter, LayersSayThatTheyAreForPeople) {
  Task task = with_preset(make_task(file_, {}).value(), Preset::layers);
  const Result<GenerateResult> generation = generate(task);
  ASSERT_FALSE(generation);
  EXPECT_THAT(generation.error().message, HasSubstr("layers are for bodies"));
}

// Four legs of three joints each below a level trunk.
TEST_F(RobotCharacter, OnFourLegsIsRefused) {
  std::string text =
      "<robot name=\"dog\"><link name=\"base\"><inertial><mass value=\"9\"/>"
      "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>"
      "</inertial></link>";
  const auto joint = [&](const std::string& parent, const std::string& child, const char* xyz) {
    text += fmt::format(
        "<link name=\"{1}\"/><joint name=\"{1}_joint\" type=\"continuous\"><parent link=\"{0}\"/>"
        "<child link=\"{1}\"/><origin xyz=\"{2}\"/><axis xyz=\"0 1 0\"/></joint>",
        parent, child, xyz);
  };
  for (const auto& [leg, xyz] : {std::pair("FL", "0.3 0.1 0"), std::pair("FR", "0.3 -0.1 0"),
                                 std::pair("RL", "-0.3 0.1 0"), std::pair("RR", "-0.3 -0.1 0")}) {
    const std::string name(leg);
    joint("base", name + "_a", xyz);
    joint(name + "_a", name + "_b", "0 0 -0.2");
    joint(name + "_b", name + "_c", "0 0 -0.2");
    joint(name + "_c", name + "_d", "0.03 0 -0.02");
  }
  file_.character.source = folder_.put("dog.urdf", text + "</robot>");
  const Result<Task> task = make_task(file_, {});
  ASSERT_FALSE(task);
  EXPECT_THAT(task.error().to_string(), HasSubstr("dog.urdf: no person: it stands on four legs"));
}

TEST_F(RobotCharacter, ThatIsNoHumanoidIsToldSo) {
  file_.character.source = folder_.put(
      "arm.urdf",
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"continuous\">"
      "<parent link=\"a\"/><child link=\"b\"/><origin xyz=\"0 0 1\"/></joint></robot>");
  const Result<Task> task = make_task(file_, {});
  ASSERT_FALSE(task);
  EXPECT_THAT(task.error().to_string(), HasSubstr("arm.urdf: no humanoid robot"));
}

// The reader counts lines in the file, not in its copy in a result.
TEST_F(RobotCharacter, ErrorsNameTheLinesOfTheFile) {
  file_.character.source = folder_.put("two.urdf",
                                       "\n<robot name='two'>\n<!-- a comment -->\n\n"
                                       "<link name='hips'/>\n<joint name='neck' type='fixed'>"
                                       "<parent link='hips'/><child link='head'/></joint></robot>");
  const Result<Task> task = make_task(file_, {});
  ASSERT_FALSE(task);
  EXPECT_THAT(task.error().to_string(), HasSubstr("line 6 of two.urdf: joint 'neck'"));
}

}  // namespace
}  // namespace shigusa
