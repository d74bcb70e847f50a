// SPDX-License-Identifier: MIT
// Arrays for controllers of robots: their shapes, the joints of the CSV, velocities that are
// derivatives, turns without jumps, and bodies where the engine has them.
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <map>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <sstream>

#include "core/bytes.hpp"
#include "core/index.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The files of an archive whose files are stored.
std::map<std::string, std::string> files_of(const std::string& archive) {
  std::map<std::string, std::string> files;
  std::size_t at = 0;
  while (integer_at<std::uint32_t>(archive, at) == 0x04034B50) {
    const std::size_t size = integer_at<std::uint32_t>(archive, at + 18);
    const std::size_t length = integer_at<std::uint16_t>(archive, at + 26);
    files[archive.substr(at + 30, length)] = archive.substr(at + 30 + length, size);
    at += 30 + length + size;
  }
  return files;
}

struct Table {
  std::string shape;  // "(61,52)"
  std::vector<double> values;
};

// An array of numbers.
Table table_of(const std::map<std::string, std::string>& files, const std::string& name) {
  const std::string& file = files.at(name + ".npy");
  const std::size_t header = integer_at<std::uint16_t>(file, 8);
  Table table;
  const std::size_t begin = file.find("'shape': ") + 9;
  table.shape = file.substr(begin, file.find(')', begin) + 1 - begin);
  table.values.resize((file.size() - 10 - header) / sizeof(double));
  std::memcpy(table.values.data(), file.data() + 10 + header, table.values.size() * sizeof(double));
  return table;
}

std::vector<std::string> names_of(const std::map<std::string, std::string>& files,
                                  const std::string& name) {
  const std::string& file = files.at(name + ".npy");
  const std::size_t header = integer_at<std::uint16_t>(file, 8);
  const auto longest = std::stoul(file.substr(file.find("<U") + 2));
  std::vector<std::string> names;
  for (std::size_t at = 10 + header; at < file.size(); at += 4 * longest) {
    names.emplace_back();
    for (std::size_t k = 0; k < longest; ++k) {
      if (const char c = file[at + 4 * k]) names.back() += c;
    }
  }
  return names;
}

// Columns of a CSV.
std::map<std::string, std::vector<double>> columns_of(const std::string& text) {
  std::istringstream csv(text);
  std::string line;
  std::getline(csv, line);
  std::vector<std::string> names;
  std::istringstream head(line);
  for (std::string name; std::getline(head, name, ',');) names.push_back(name);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(csv, line)) {
    std::istringstream row(line);
    std::size_t k = 0;
    for (std::string cell; std::getline(row, cell, ',');) {
      columns[names[k++]].push_back(std::stod(cell));
    }
  }
  return columns;
}

struct Reach {
  TaskFile file;
  Task task;
  Candidate candidate;

  [[nodiscard]] std::string as(FileFormat format, std::optional<double> rate = {}) const {
    return export_candidate(file.character, task, candidate, format, {.rate = rate}).value();
  }
};

Reach reach_of(CharacterSpec character, const Vec3d& goal) {
  TaskFile file;
  file.character = std::move(character);
  file.goals = {{"right_hand", goal}};
  file.evaluations = 200;
  file.candidates = 1;
  Task task = make_task(file, {}).value();
  Candidate candidate = generate(task).value().candidates.at(0);
  return {std::move(file), std::move(task), std::move(candidate)};
}
const Reach& person() {
  static const Reach reach = reach_of({}, {-0.2, 0.5, 0.4});
  return reach;
}
const Reach& robot() {
  static const Reach reach = [] {
    CharacterSpec spec{.source = "small.urdf"};
    EXPECT_TRUE(load_character(RobotFile().text(), spec));
    return reach_of(std::move(spec), {-0.2, 0.4, 0.35});
  }();
  return reach;
}

TEST(Npz, HasFiftyFramesASecondOrThoseAskedFor) {
  for (const Reach* reach : {&person(), &robot()}) {
    const auto usual = files_of(reach->as(FileFormat::npz));
    EXPECT_THAT(table_of(usual, "fps").values, testing::ElementsAre(50.0));
    EXPECT_EQ(table_of(usual, "fps").shape, "()");
    const auto finer = files_of(reach->as(FileFormat::npz, 120.0));
    EXPECT_THAT(table_of(finer, "fps").values, testing::ElementsAre(120.0));
    const auto frames = [&](double rate) {
      return std::to_string(frames_at(reach->candidate.motion.clip.duration(), rate));
    };
    const std::string joints = std::to_string(names_of(usual, "joint_names").size());
    const std::string bodies = std::to_string(names_of(usual, "body_names").size());
    const std::string width = std::to_string(7 + names_of(usual, "joint_names").size());
    EXPECT_EQ(table_of(usual, "joint_pos").shape, "(" + frames(50.0) + "," + width + ")");
    EXPECT_EQ(table_of(finer, "torques").shape, "(" + frames(120.0) + "," + joints + ")");
    EXPECT_EQ(table_of(usual, "body_quat_w").shape, "(" + frames(50.0) + "," + bodies + ",4)");
    EXPECT_EQ(files_of(reach->as(FileFormat::npz)), usual);
  }
}

// Root, joints and torques of a robot are those of its CSV at that rate, of which quaternions end
// with w.
TEST(Npz, ARobotsJointsAreThoseOfItsCsv) {
  const auto files = files_of(robot().as(FileFormat::npz));
  const auto csv = columns_of(robot().as(FileFormat::csv, 50.0));
  const auto joints = names_of(files, "joint_names");
  const Table positions = table_of(files, "joint_pos");
  const Table torques = table_of(files, "torques");
  const std::size_t width = 7 + joints.size();
  const std::size_t frames = csv.at("time [s]").size();
  ASSERT_EQ(positions.values.size(), frames * width);
  const char* root[] = {"root.x [m]", "root.y [m]", "root.z [m]", "root.qw",
                        "root.qx",    "root.qy",    "root.qz"};
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t k = 0; k < 7; ++k) {
      EXPECT_EQ(positions.values[f * width + k], csv.at(root[k])[f]) << root[k];
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const bool slides = csv.contains(joints[j] + " [m]");
      EXPECT_EQ(positions.values[f * width + 7 + j],
                csv.at(joints[j] + (slides ? " [m]" : " [rad]"))[f]);
      const auto torque = csv.find(joints[j] + " torque [N m]");
      EXPECT_EQ(torques.values[f * joints.size() + j],
                torque == csv.end() ? 0.0 : torque->second[f]);
    }
  }
}

// Its bodies follow from its file's joints alone, and meet the engine's hand and both feet.
TEST(Npz, ARobotsBodiesAreWhereTheEngineHasThem) {
  const auto files = files_of(robot().as(FileFormat::npz));
  const auto bodies = names_of(files, "body_names");
  const Table places = table_of(files, "body_pos_w");
  const std::size_t frames = places.values.size() / bodies.size() / 3;
  const auto place = [&](std::size_t frame, const std::string& body) {
    const auto b =
        static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
    const double* const at = places.values.data() + (frame * bodies.size() + b) * 3;
    return Vec3d{at[0], at[1], at[2]};
  };
  ASSERT_EQ(bodies.front(), "pelvis");
  const GoalResult& goal = robot().candidate.goals[0];
  const Vec3d reached{goal.reached.z, goal.reached.x, goal.reached.y};
  EXPECT_LE(norm(place(frames - 1, goal.node) - reached), 1e-9) << goal.node;
  for (const char* sole : {"left_sole", "right_sole"}) {
    double slide = 0.0;
    for (std::size_t f = 0; f < frames; ++f) {
      slide = std::fmax(slide, norm(place(f, sole) - place(0, sole)));
    }
    EXPECT_LE(slide, 1e-3) << sole;
  }
}

// Values of body b at frame f.
Vec3d vector_at(const Table& table, std::size_t k) {
  return {table.values[3 * k], table.values[3 * k + 1], table.values[3 * k + 2]};
}
Quatd turn_at(const Table& table, std::size_t k) {
  const double* const q = table.values.data() + 4 * k;
  return {q[1], q[2], q[3], q[0]};
}

// Turns change by the angular velocity: half of its product with the turn is their derivative, to
// the second order of the frames' distance.
TEST(Npz, VelocitiesAreDerivativesAndTurnsAreContinuous) {
  for (const Reach* reach : {&person(), &robot()}) {
    constexpr double kRate = 200.0;
    const auto files = files_of(reach->as(FileFormat::npz, kRate));
    const std::size_t bodies = names_of(files, "body_names").size();
    const Table places = table_of(files, "body_pos_w");
    const Table turns = table_of(files, "body_quat_w");
    const Table velocities = table_of(files, "body_lin_vel_w");
    const Table spins = table_of(files, "body_ang_vel_w");
    const std::size_t frames = places.values.size() / bodies / 3;
    double most = 0.0;
    double fastest = 0.0;
    for (std::size_t f = 1; f + 1 < frames; ++f) {
      for (std::size_t b = 0; b < bodies; ++b) {
        const std::size_t k = f * bodies + b;
        const Vec3d moved = vector_at(places, k + bodies) - vector_at(places, k - bodies);
        EXPECT_LE(norm(moved * (kRate / 2.0) - vector_at(velocities, k)), 1e-12 * kRate);
        const Quatd before = turn_at(turns, k - bodies);
        const Quatd now = turn_at(turns, k);
        const Quatd after = turn_at(turns, k + bodies);
        EXPECT_NEAR(squared_length(now), 1.0, 1e-12);
        EXPECT_GT(before.x * now.x + before.y * now.y + before.z * now.z + before.w * now.w, 0.9);
        const Vec3d w = vector_at(spins, k);
        const Quatd change = Quatd{0.5 * w.x, 0.5 * w.y, 0.5 * w.z, 0.0} * now;
        const double rates[] = {after.x - before.x, after.y - before.y, after.z - before.z,
                                after.w - before.w};
        const double told[] = {change.x, change.y, change.z, change.w};
        for (int c = 0; c < 4; ++c) {
          most = std::fmax(most, std::fabs(rates[c] * kRate / 2.0 - told[c]));
        }
        fastest = std::fmax(fastest, norm(w));
      }
    }
    std::printf("of %.2f rad/s at most, %.5f differ\n", fastest, most);
    EXPECT_GT(fastest, 0.5);
    // h² / 6 times the third derivative of a turn's components, which stays below 240 / s³
    EXPECT_LE(most, 240.0 / (6.0 * kRate * kRate));
  }
}

TEST(Npz, APersonIsUprightAtAHeightInRobotsAxes) {
  const auto files = files_of(person().as(FileFormat::npz));
  const auto bodies = names_of(files, "body_names");
  ASSERT_EQ(bodies.front(), "hips");
  const Table turns = table_of(files, "body_quat_w");
  EXPECT_GT(turns.values[0], 0.99);
  const Vec3d hips = vector_at(table_of(files, "body_pos_w"), 0);
  EXPECT_GT(hips.z, 0.8);
  EXPECT_THAT(names_of(files, "contact_names"),
              testing::UnorderedElementsAre("left_foot", "right_foot"));
}

// A robot's CSV at a rate has the frames of rated files, and ends as the motion does.
TEST(Npz, ARobotsCsvTakesARateToo) {
  const auto own = columns_of(robot().as(FileFormat::csv));
  const auto at = columns_of(robot().as(FileFormat::csv, 50.0));
  const Clip& clip = robot().candidate.motion.clip;
  EXPECT_EQ(own.at("time [s]").size(), index(clip.frames));
  EXPECT_EQ(at.at("time [s]").size(), index(frames_at(clip.duration(), 50.0)));
  EXPECT_EQ(at.at("time [s]")[1], 0.02);
  for (const auto& [name, values] : own) {
    if (name == "time [s]") continue;
    EXPECT_NEAR(at.at(name).back(), values.back(), 1e-9) << name;
  }
}

TEST(Npz, ARobotWithoutItsFileIsRefused) {
  const auto made = export_candidate(robot().task, robot().candidate, FileFormat::npz);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().to_string(), testing::HasSubstr("the character's file"));
}

}  // namespace
}  // namespace shigusa
