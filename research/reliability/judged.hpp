// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <vector>

#include "audit.hpp"
#include "kinds.hpp"
#include "outside.hpp"
#include "table.hpp"

namespace shigusa::bench {

// One candidate under judgement: its reported values, and the contents of its files.
struct Judged {
  const CharacterSpec& character;
  const RobotTree* robot;    // of a robot
  const MujocoFile* mujoco;  // of one from MJCF, where MuJoCo reads it
  Task task;                 // on the feet that it stands on, loads apart
  bool meets_goals = false;
  Candidate candidate;
  OutsideMotion motion{};                    // by BVH, or by a robot's CSV
  Table table{};                             // the CSV
  std::vector<RobotTree::Places> links{};    // of a robot, by rows of the table
  std::vector<OutsideMotion> other_files{};  // with such nodes of goals and feet
};

// A defect introduced after the search, to verify that judges detect it.
enum class Flaw {
  none,
  goal_off,         // by 2 mm at the end
  goal_turned,      // by 0.7° at the end
  other_file_off,   // a goal by 2 mm in the second file
  foot_slid,        // by 2 mm half-way
  foot_tilted,      // by 0.2° half-way
  limit_passed,     // by 0.2°
  box_in_limb,      // about the elbow, half-way
  arm_in_head,      // reported as free
  seat_low,         // by 2 mm
  heel_told_high,   // by 2 mm
  rest_slid,        // by 2 mm after it arrived
  rest_off,         // the box smaller by 2 mm on all sides
  torque_told_low,  // all by half
  weakness_hidden,  // a joint beyond its strength is reported as possible
  tipping_hidden,   // the pressure far outside the feet, reported as possible
  order_wrong,      // candidates the wrong way round
};

// Introduces the defect, if it applies to the candidate.
void spoil(Flaw flaw, Judged& judged);

// Judges of one candidate; they use files and data, and no function of the kernel.
void judge_goals(const Judged& judged, Audit& audit);
void judge_feet(const Judged& judged, Audit& audit);
void judge_limits(const Judged& judged, Audit& audit);
void judge_boxes(const Judged& judged, Audit& audit);
void judge_flesh(const Judged& judged, Audit& audit);
void judge_seat(const Judged& judged, Audit& audit);
void judge_rests(const Judged& judged, Audit& audit);
void judge_verdict(const Judged& judged, Audit& audit);
// Heels, torques and the floor's pressure, by the masses and the table's angles.
void judge_masses(const Judged& judged, Audit& audit);

// Whether the motion is reported as free of collisions.
[[nodiscard]] bool told_as_free(const Judged& judged);

}  // namespace shigusa::bench
