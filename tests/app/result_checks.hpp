// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "support/exported.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

// Requirements on a result on disk, judged from its files alone.
namespace shigusa::testing_support {

using Json = nlohmann::ordered_json;

inline Vec3d to_vec(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

// Exit code of a call that met its goals: 3 if no candidate is possible.
inline auto delivered() { return testing::AnyOf(0, 3); }

// A result in a folder below the work folder.
class StoredRun {
 public:
  StoredRun(const WorkFolder& work, const std::string& folder)
      : work_(work), folder_(folder), summary_(Json::parse(get("summary.json"))) {}

  [[nodiscard]] const Json& summary() const { return summary_; }
  [[nodiscard]] const Json& candidate(std::size_t rank) const {
    return summary_.at("candidates").at(rank - 1);
  }
  [[nodiscard]] std::string get(const std::string& name) const {
    return work_.get(folder_ + "/" + name);
  }
  [[nodiscard]] ExportedMotion motion(const Json& candidate) const {
    return ExportedMotion(get(candidate.at("files").at("bvh")), candidate.at("bvh_unit_m"));
  }

  // Files of the folder itself, without folders.
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(work_ / folder_)) {
      if (entry.is_regular_file()) names.insert(entry.path().filename().string());
    }
    return names;
  }

 private:
  const WorkFolder& work_;
  std::string folder_;
  Json summary_;
};

inline constexpr double kMillimetre = 1e-3;
// Tolerances between numbers of the summary and of the files: the error of an origin of a human
// body in BVH (formats.hpp).
inline constexpr double kWritten = 1e-6;

// Each planted foot stays within 1 mm and 0.1° of its place, by the file's own kinematics, and the
// summary states its slide.
inline void expect_feet_stand(const ExportedMotion& motion, const Json& candidate) {
  for (const Json& contact : candidate.at("contacts")) {
    const std::string joint = contact.at("joint");
    EXPECT_LE(motion.slide(joint), kMillimetre) << joint;
    EXPECT_LE(motion.tilt(joint), radians(0.1)) << joint;
    EXPECT_GE(contact.at("max_slide_mm").get<double>(), 0.0);
    EXPECT_LE(contact.at("max_slide_mm").get<double>(), 1.0);
  }
}

// The nodes named in the summary end at the stated positions.
inline void expect_ends_as_told(const ExportedMotion& motion, const Json& candidate) {
  for (const Json& goal : candidate.at("reached")) {
    const Vec3d end = motion.at_end(goal.at("joint"));
    EXPECT_LE(norm(end - to_vec(goal.at("reached_m"))), kWritten);
    EXPECT_NEAR(norm(end - to_vec(goal.at("goal_m"))), 1e-3 * goal.at("error_mm").get<double>(),
                kWritten);
  }
}

inline void expect_goals_met(const ExportedMotion& motion, const Json& candidate) {
  for (const Json& goal : candidate.at("reached")) {
    EXPECT_LE(norm(motion.at_end(goal.at("joint")) - to_vec(goal.at("goal_m"))), kMillimetre);
  }
}

// All checks, for every candidate of a result that meets its goals.
inline void expect_promises_kept(const StoredRun& run) {
  EXPECT_NE(run.summary().at("status"), "unreachable");
  EXPECT_EQ(run.summary().at("remaining_mm"), 0.0);
  ASSERT_FALSE(run.summary().at("candidates").empty());
  for (const Json& candidate : run.summary().at("candidates")) {
    const ExportedMotion motion = run.motion(candidate);
    EXPECT_TRUE(motion.finite());
    EXPECT_EQ(motion.frames(), candidate.at("file_frames").get<int>());
    expect_goals_met(motion, candidate);
    expect_ends_as_told(motion, candidate);
    expect_feet_stand(motion, candidate);
  }
}

// The column of a CSV file of shigusa's, by its header.
inline std::vector<double> csv_column(const std::string& text, const std::string& name) {
  std::vector<double> values;
  std::size_t column = 0;
  std::istringstream lines(text);
  std::string line;
  for (bool header = true; std::getline(lines, line); header = false) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (header && cell == name) column = i + 1;
      if (!header && i + 1 == column) values.push_back(std::stod(cell));
    }
  }
  SHG_CHECK(!values.empty(), "a column " + name);
  return values;
}

}  // namespace shigusa::testing_support
