// SPDX-License-Identifier: MIT
// Robots from URDF files: the exported motion checked by urdfdom's model and KDL's frames.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "dynamics/centre_of_mass.hpp"
#include "support/robot_file.hpp"
#include "support/robot_reader.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kReached = 1e-3;                         // m
constexpr double kSlide = 1e-3;                           // m
constexpr double kTilt = 0.1 * 3.14159265358979 / 180.0;  // rad

struct RobotCase {
  const char* name;
  const char* file;  // in the folder of characters; empty: our own
};
void PrintTo(const RobotCase& robot, std::ostream* out) { *out << robot.name; }

struct Spot {
  const char* name;
  Vec3d at;  // as a share of the stature, shigusa's world
};
constexpr Spot kSpots[] = {{"low_front", {0.0, 0.35, 0.30}},
                           {"at_the_feet", {0.0, 0.08, 0.15}},
                           {"high_right", {-0.20, 0.90, 0.20}}};

// The path of the robot's file, or nothing without these files.
std::string path_of(const RobotCase& robot, const WorkFolder& folder) {
  if (*robot.file == '\0') {
    return folder.put("small.urdf", RobotFile().text());
  }
  const std::string path = std::string(SHIGUSA_SHARED_DIR) + "/characters/" + robot.file;
  return std::filesystem::exists(path) ? path : "";
}

KDL::Vector in_robot_world(const Vec3d& p) { return {p.z, p.x, p.y}; }

class RobotReach : public testing::TestWithParam<RobotCase> {};

void check_limits(const RobotReader& reader, const Table& table) {
  for (const auto& [name, joint] : reader.model().joints_) {
    if (joint->type != urdf::Joint::REVOLUTE) continue;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double angle = table.at(name + " [rad]", row);
      ASSERT_GE(angle, joint->limits->lower) << name << " row " << row;
      ASSERT_LE(angle, joint->limits->upper) << name << " row " << row;
    }
  }
}

void check_feet(const RobotReader& reader, const Table& table, const Candidate& candidate) {
  ASSERT_EQ(candidate.contacts.size(), 2u);
  for (const ContactResult& contact : candidate.contacts) {
    const KDL::Frame first = reader.place(contact.node, table, 0);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const KDL::Twist off = KDL::diff(first, reader.place(contact.node, table, row));
      ASSERT_LE(off.vel.Norm(), kSlide) << contact.node << " row " << row;
      ASSERT_LE(off.rot.Norm(), kTilt) << contact.node << " row " << row;
    }
  }
}

void check_masses(const RobotReader& reader, const Table& table) {
  for (const std::size_t row : {std::size_t{0}, table.rows() - 1}) {
    KDL::Vector moment;
    double mass = 0.0;
    for (const auto& [name, link] : reader.model().links_) {
      if (!link->inertial) continue;
      const auto& com = link->inertial->origin.position;
      moment +=
          reader.place(name, table, row) * KDL::Vector(com.x, com.y, com.z) * link->inertial->mass;
      mass += link->inertial->mass;
    }
    const KDL::Vector told{table.at("centre_of_mass.x [m]", row),
                           table.at("centre_of_mass.y [m]", row),
                           table.at("centre_of_mass.z [m]", row)};
    EXPECT_LT((moment / mass - told).Norm(), 1e-9);
  }
}

TEST_P(RobotReach, ReachesWithEitherHandByASecondReader) {
  const WorkFolder folder;
  const std::string path = path_of(GetParam(), folder);
  if (path.empty()) GTEST_SKIP() << "no " << GetParam().file;
  const RobotReader reader(text_of(path));
  for (const char* hand : {"right_hand", "left_hand"}) {
    for (const Spot& spot : kSpots) {
      SCOPED_TRACE(std::string(hand) + " " + spot.name);
      TaskFile file;
      file.character.source = path;
      Result<Task> task = make_task(file, {});
      ASSERT_TRUE(task) << task.error().to_string();
      task->goals = {{hand, spot.at * task->body.stature()}};
      const Result<GenerateResult> generation = generate(*task);
      ASSERT_TRUE(generation) << generation.error().to_string();
      EXPECT_TRUE(generation->meets_goals()) << generation->remaining_distance;
      for (const Candidate& candidate : generation->candidates) {
        const Table table(export_candidate(*task, candidate, FileFormat::csv).value());
        ASSERT_GT(table.rows(), 10u);
        const KDL::Frame end = reader.place(candidate.goals[0].node, table, table.rows() - 1);
        EXPECT_LE((end.p - in_robot_world(task->goals[0].position)).Norm(), kReached);
        check_feet(reader, table, candidate);
        check_limits(reader, table);
        check_masses(reader, table);
        if (HasFailure()) return;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, RobotReach,
    testing::Values(RobotCase{"small", ""}, RobotCase{"g1", "unitree_ros__g1_29dof.urdf"},
                    RobotCase{"simple", "example-robot-data__simple_humanoid.urdf"},
                    RobotCase{"romeo", "example-robot-data__romeo.urdf"},
                    RobotCase{"subject", "human-gazebo__humanSubject01_66dof.urdf"},
                    RobotCase{"icub", "icub-models__model.urdf"}),
    [](const testing::TestParamInfo<RobotCase>& test) { return test.param.name; });

}  // namespace
}  // namespace shigusa
