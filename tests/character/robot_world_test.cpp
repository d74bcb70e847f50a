// SPDX-License-Identifier: MIT
// Robots' files with more, or less, than a robot: a world, no masses, other units, key frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <sstream>

#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "robot/robot_size.hpp"
#include "support/mjcf_file.hpp"
#include "support/robot_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

// The small robot's file with this text before its first link.
std::string below(const std::string& world) {
  std::string text = RobotFile().text();
  return text.insert(text.find("<link name=\"pelvis\""), world);
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& axis = "1 0 0") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"0 0 0.1\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-9\" upper=\"9\" effort=\"0\" velocity=\"0\"/></joint>";
}

// A world and six joints, each with a link except the last.
std::string six_joints(const std::array<std::string, 3>& slides,
                       const std::array<std::string, 3>& turns) {
  std::string text = "<link name=\"scene\"/>";
  std::string parent = "scene";
  const std::array<std::string, 6> axes{slides[0], slides[1], slides[2],
                                        turns[0],  turns[1],  turns[2]};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::string child = k == 5 ? "pelvis" : fmt::format("between_{}", k);
    text += joint(fmt::format("root_{}", k), k < 3 ? "prismatic" : "continuous", parent, child,
                  axes[k]);
    if (k < 5) text += "<link name=\"" + child + "\"/>";
    parent = child;
  }
  return text;
}

struct Reached {
  Task task;
  Candidate candidate;
  std::map<std::string, std::vector<double>> columns;  // of the CSV
};

class RobotWorld : public testing::Test {
 protected:
  WorkFolder folder_;

  Result<Task> task_of(const std::string& text, const std::string& name,
                       const std::optional<double> mass = {}) {
    TaskFile file;
    file.character.source = folder_.put(name, text);
    file.character.mass = mass;
    file.goals = {{"right_hand", {-0.2, 0.4, 0.35}}};
    file.evaluations = 200;
    return make_task(file, {});
  }
  static std::vector<Message> doubts_of(const Task& task) {
    return {task.doubts.begin(), task.doubts.end()};
  }
  Reached reached(const std::string& text) {
    Task task = task_of(text, "robot.urdf").value();
    Candidate candidate = generate(task).value().candidates.at(0);
    std::istringstream csv(export_candidate(task, candidate, FileFormat::csv).value());
    std::string line;
    std::getline(csv, line);
    std::vector<std::string> names;
    std::istringstream head(line);
    for (std::string name; std::getline(head, name, ',');) names.push_back(name);
    Reached result{std::move(task), std::move(candidate), {}};
    while (std::getline(csv, line)) {
      std::istringstream row(line);
      std::size_t k = 0;
      for (std::string cell; std::getline(row, cell, ',');) {
        result.columns[names[k++]].push_back(std::stod(cell));
      }
    }
    return result;
  }
};

double range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

TEST_F(RobotWorld, AWorldIsNoRoot) {
  const auto usual = reached(RobotFile().text());
  const auto floating =
      reached(below("<link name=\"world\"/>" + joint("free", "floating", "world", "pelvis")));
  const auto bolted =
      reached(below("<link name=\"odom\"/>" + joint("bolt", "fixed", "odom", "pelvis")));
  for (const Reached* each : {&floating, &bolted}) {
    EXPECT_EQ(each->task.robot->root, "pelvis");
    for (const char* column : {"root.x [m]", "root.z [m]", "root.qw"}) {
      const std::vector<double>& theirs = usual.columns.at(column);
      const std::vector<double>& ours = each->columns.at(column);
      ASSERT_EQ(ours.size(), theirs.size());
      for (std::size_t f = 0; f < ours.size(); ++f) EXPECT_NEAR(ours[f], theirs[f], 1e-6) << column;
    }
  }
  EXPECT_THAT(doubts_of(floating.task), Each(Not(HasSubstr("'free'"))));
  EXPECT_THAT(doubts_of(floating.task), Contains(HasSubstr("'drawer' slides")));
  EXPECT_THAT(doubts_of(bolted.task), Contains(HasSubstr("joint 'bolt' bolts the robot")));
}

// A dummy link above the trunk that moves with it stays the root.
TEST_F(RobotWorld, AFrameFixedToTheTrunkIsTheRoot) {
  const auto dummy = reached(
      below("<link name=\"base_footprint\"/>" + joint("f", "fixed", "base_footprint", "pelvis")));
  EXPECT_EQ(dummy.task.robot->root, "base_footprint");
  EXPECT_GT(range_of(dummy.columns.at("root.x [m]")), 1e-3);
}

// Placement of the pelvis by six joints in a frame, in the robot's world.
Transformd carried_to(const Reached& reached, std::size_t frame, const std::array<Vec3d, 6>& axes) {
  Transformd at;
  for (std::size_t k = 0; k < 6; ++k) {
    at.translation += at.rotation * Vec3d{0, 0, 0.1};
    const std::string name = fmt::format("root_{} {}", k, k < 3 ? "[m]" : "[rad]");
    const double value = reached.columns.at(name)[frame];
    if (k < 3) {
      at.translation += at.rotation * (axes[k] * value);
    } else {
      const SinCos<double> half = sin_cos(0.5 * value);
      const Vec3d v = axes[k] * half.sin;
      at.rotation = at.rotation * to_matrix(Quatd{v.x, v.y, v.z, half.cos});
    }
  }
  return at;
}

TEST_F(RobotWorld, SixJointsAboveTheRootCarryIt) {
  const auto usual = reached(RobotFile().text());
  const std::array<Vec3d, 6> straight{Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                      {0, 0, 1},      {0, 1, 0}, {1, 0, 0}};
  const std::array<Vec3d, 6> odd{Vec3d{0, 0, 1}, {0, -1, 0}, {0.6, 0, 0.8},
                                 Vec3d{1, 0, 0}, {0, 0, 1},  {0, -1, 0}};
  for (const auto& axes : {straight, odd}) {
    const auto word = [&](std::size_t k) {
      return fmt::format("{} {} {}", axes[k].x, axes[k].y, axes[k].z);
    };
    const auto six =
        reached(below(six_joints({word(0), word(1), word(2)}, {word(3), word(4), word(5)})));
    EXPECT_EQ(six.task.robot->root, "pelvis");
    EXPECT_THAT(doubts_of(six.task),
                Contains(HasSubstr("6 joints, 'root_0' the first, carry the robot")));
    EXPECT_EQ(range_of(six.columns.at("root.x [m]")), 0.0);
    EXPECT_GT(range_of(six.columns.at("root_0 [m]")), 1e-3);
    const std::size_t frames = six.columns.at("root.x [m]").size();
    for (const std::size_t frame : {std::size_t{0}, frames / 2, frames - 1}) {
      const Vec3d at = carried_to(six, frame, axes).translation;
      EXPECT_NEAR(at.x, usual.columns.at("root.x [m]")[frame], 1e-6);
      EXPECT_NEAR(at.y, usual.columns.at("root.y [m]")[frame], 1e-6);
      EXPECT_NEAR(at.z, usual.columns.at("root.z [m]")[frame], 1e-6);
    }
  }
}

TEST_F(RobotWorld, JointsThatCannotCarryTheRootSaySo) {
  const auto rail = reached(
      below("<link name=\"world\"/>" + joint("rail", "prismatic", "world", "cart") +
            "<link name=\"cart\"/>" + joint("yaw", "continuous", "cart", "pelvis", "0 0 1")));
  EXPECT_THAT(doubts_of(rail.task),
              Contains(HasSubstr("2 joints, 'rail' the first, cannot carry the robot")));
  EXPECT_GT(range_of(rail.columns.at("root.x [m]")), 1e-3);
  EXPECT_EQ(range_of(rail.columns.at("rail [m]")), 0.0);
}

std::string without_masses() {
  std::string text = RobotFile().text();
  for (std::size_t at; (at = text.find("<inertial>")) != text.npos;) {
    text.erase(at, text.find("</inertial>", at) + 11 - at);
  }
  return text;
}

TEST_F(RobotWorld, MassIsSpreadWhereAFileHasNone) {
  const Result<Task> refused = task_of(without_masses(), "light.urdf");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("no link has a mass"));
  EXPECT_THAT(refused.error().to_string(), HasSubstr("--mass 50"));
  for (const double mass : {50.0, 23.5}) {
    const Task task = task_of(without_masses(), "light.urdf", mass).value();
    EXPECT_NEAR(task.body.mass(), mass, 1e-9);
    EXPECT_THAT(doubts_of(task), Contains(HasSubstr(fmt::format("{:g} kg are spread", mass))));
    const int thigh = task.body.find_dof("left_hip.flexion").value();
    const int knee = task.body.find_dof("left_knee.flexion").value();
    EXPECT_NEAR(task.body.definition().masses[index(knee)].mass, 0.0433 * mass, 1e-9);
    EXPECT_NEAR(task.body.definition().masses[index(thigh)].mass, 0.1416 * mass, 1e-9);
    EXPECT_TRUE(generate(task).value().meets_goals());
  }
  const Result<Task> own = task_of(RobotFile().text(), "heavy.urdf", 50.0);
  ASSERT_FALSE(own);
  EXPECT_THAT(own.error().to_string(), HasSubstr("a robot, which has its own"));
}

TEST(RobotSize, IsDoubtedWithItsUnit) {
  EXPECT_FALSE(doubt_of_size(0.58));
  EXPECT_FALSE(doubt_of_size(1.8));
  const auto told = [](double stature) { return doubt_of_size(stature).value().text; };
  EXPECT_THAT(told(1514.8), HasSubstr("1514.80 m tall: its file may be in millimetres"));
  EXPECT_THAT(told(620.0), HasSubstr("millimetres"));
  EXPECT_THAT(told(171.0), HasSubstr("centimetres"));
  EXPECT_THAT(told(65.0), HasSubstr("centimetres"));
  EXPECT_THAT(told(0.151), HasSubstr("0.151 m tall: its file may be 10 times too small"));
  EXPECT_THAT(told(0.0016), HasSubstr("1000 times"));
  EXPECT_THAT(told(8.986), HasSubstr("8.99 m tall: is its file in metres?"));
}

}  // namespace
}  // namespace shigusa
