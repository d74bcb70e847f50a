// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/math.hpp>
#include <shigusa/score.hpp>
#include <string>
#include <utility>

#include "cost/posture_parts.hpp"
#include "export_file.hpp"
#include "formats/csv.hpp"
#include "robot/root_joints.hpp"
#include "sampled.hpp"

namespace shigusa {
namespace {

constexpr std::array kPoseNames{"root.x [m]", "root.y [m]", "root.z [m]", "root.qx",
                                "root.qy",    "root.qz",    "root.qw"};

// (frames) values of the joints between the world and the root; empty if the root is free, or if
// those joints cannot reach its placements.
std::vector<RootValues> carried(const RobotFrame& robot, const std::vector<Transformd>& root) {
  std::vector<RootValues> values;
  if (robot.carriers.empty()) return values;
  RootValues before{};
  for (const Transformd& place : root) {
    const std::optional<RootValues> now = root_values(robot, place, before);
    if (!now) return {};
    values.push_back(before = *now);
  }
  return values;
}

void add_pose(const std::vector<Transformd>& places, std::vector<CsvColumn>& columns) {
  std::array<CsvColumn, kPoseNames.size()> pose;
  for (std::size_t k = 0; k < pose.size(); ++k) pose[k].name = kPoseNames[k];
  Quatd before;
  for (const Transformd& place : places) {
    const Vec3d& at = place.translation;
    const Quatd q = before = nearer(to_quat(place.rotation), before);
    const double values[] = {at.x, at.y, at.z, q.x, q.y, q.z, q.w};
    for (std::size_t k = 0; k < pose.size(); ++k) pose[k].values.push_back(values[k]);
  }
  for (CsvColumn& column : pose) columns.push_back(std::move(column));
}

// Adds the columns that drive a robot through a motion, in the terms of its file: the root link's
// position "root.x [m]" … and quaternion "root.qx" … in the robot's world, then "JOINT [rad]" (or
// "JOINT [m]" for sliding joints) for all joints that move, in the file's order, then "JOINT torque
// [N m]" for those that take part. If six joints attach the root to a world link, they drive it,
// and root.* is the placement of the world link.
void add_robot_columns(const PosedBody& posed, const Motion& motion,
                       std::vector<CsvColumn>& columns) {
  const Clip& clip = motion.clip;
  const RobotFrame& robot = *posed.robot;
  std::vector<Transformd> root = root_places(posed.body, robot, clip);
  const std::vector<RootValues> ways = carried(robot, root);
  if (!ways.empty()) root.assign(root.size(), robot.world);
  add_pose(root, columns);
  const auto frames = static_cast<std::size_t>(clip.frames);
  const std::size_t first = columns.size();
  for (const RobotJoint& joint : robot.joints) {
    columns.push_back({joint.name + (joint.slides ? " [m]" : " [rad]"),
                       joint.dof < 0 ? std::vector<double>(frames, joint.angle)
                                     : of_joint(joint, clip.angles, clip.dofs)});
  }
  for (std::size_t f = 0; f < ways.size(); ++f) {
    for (std::size_t k = 0; k < robot.carriers.size(); ++k) {
      columns[first + robot.carriers[k].joint].values[f] += ways[f][k];
    }
  }
  for (const RobotJoint& joint : robot.joints) {
    if (joint.dof < 0) continue;
    columns.push_back({joint.name + " torque [N m]", of_joint(joint, motion.torques, clip.dofs)});
  }
}

void add_body_columns(const PosedBody& posed, const Motion& motion,
                      std::vector<CsvColumn>& columns) {
  const auto dofs = static_cast<std::size_t>(motion.clip.dofs);
  const auto add = [&](std::size_t d, const char* unit, const std::vector<double>& values) {
    CsvColumn column{fmt::format("{} {}", posed.body.dofs()[d].name, unit), {}};
    for (std::size_t i = d; i < values.size(); i += dofs) column.values.push_back(values[i]);
    columns.push_back(std::move(column));
  };
  for (std::size_t d = 0; d < dofs; ++d) add(d, "[rad]", motion.clip.angles);
  for (std::size_t d = 0; d < dofs; ++d) add(d, "torque [N m]", motion.torques);
}

void add_point_columns(const std::string& name, const std::vector<Vec3d>& points,
                       std::vector<CsvColumn>& columns) {
  for (int k = 0; k < 3; ++k) {
    CsvColumn column{fmt::format("{}.{} [m]", name, "xyz"[k]), {}};
    for (const Vec3d& point : points) column.values.push_back(point[k]);
    columns.push_back(std::move(column));
  }
}

// "thing.NAME.x [m]" to z, then "thing.NAME.qx" to qw: pose in the world.
void add_thing_columns(const ThingMotion& thing, std::vector<CsvColumn>& columns) {
  const std::string name = "thing." + thing.thing.name;
  std::vector<Vec3d> points;
  std::array<CsvColumn, 4> turn;
  for (std::size_t k = 0; k < turn.size(); ++k) turn[k].name = name + ".q" + "xyzw"[k];
  for (const Transformd& pose : thing.poses) {
    points.push_back(pose.translation);
    const Quatd q = to_quat(pose.rotation);
    turn[0].values.push_back(q.x);
    turn[1].values.push_back(q.y);
    turn[2].values.push_back(q.z);
    turn[3].values.push_back(q.w);
  }
  add_point_columns(name, points, columns);
  columns.insert(columns.end(), turn.begin(), turn.end());
}

// Scores of each side, sub-scores of the worse one, and loads at L5/S1.
void add_cost_columns(const MotionCost& cost, std::vector<CsvColumn>& columns) {
  const auto add = [&](std::string name, const auto& value) {
    CsvColumn column{std::move(name), {}};
    for (const FrameCost& frame : cost.frames) column.values.push_back(value(frame));
    columns.push_back(std::move(column));
  };
  const auto add_scores = [&](const std::string& name, auto scores, const auto& parts) {
    const auto worse = [scores](const FrameCost& frame, const auto& of) {
      int worst = 0;
      for (const auto& side : frame.*scores) worst = side ? std::max(worst, of(*side)) : worst;
      return static_cast<double>(worst);
    };
    for (std::size_t k = 0; k < 2; ++k) {
      add(name + (k == 0 ? ".left" : ".right"), [scores, k](const FrameCost& frame) {
        const auto& own = (frame.*scores)[k];
        return own ? static_cast<double>(own->score) : 0.0;
      });
    }
    for (const auto& part : parts) {
      add(name + "." + std::string(part.word), [&](const FrameCost& frame) {
        return worse(frame, [&part](const auto& score) { return score.parts.*part.part; });
      });
    }
  };
  if (cost.reba) add_scores("reba", &FrameCost::reba, kRebaParts);
  if (cost.rula) add_scores("rula", &FrameCost::rula, kRulaParts);
  if (!cost.back) return;
  add("l5s1.moment [N m]", [](const FrameCost& frame) { return frame.back_moment.value_or(0.0); });
  if (!cost.back->forces) return;
  add("l5s1.compression [N]",
      [](const FrameCost& frame) { return frame.back ? frame.back->compression : 0.0; });
  add("l5s1.shear [N]",
      [](const FrameCost& frame) { return frame.back ? frame.back->shear : 0.0; });
}

// The cost in the frames of another clip: what is found in a frame holds until the next.
MotionCost in_frames_of(const Clip& clip, const Clip& own, MotionCost cost) {
  const std::vector<FrameCost> frames = std::exchange(cost.frames, {});
  for (int f = 0; f < clip.frames && !frames.empty(); ++f) {
    constexpr double kSlack = 1e-9;  // frames, of a time that is a frame's own
    const double at = f * clip.frame_time / max(own.frame_time, kSlack) + kSlack;
    cost.frames.push_back(frames[std::min(static_cast<std::size_t>(at), frames.size() - 1)]);
  }
  return cost;
}

Result<std::string> motion_csv(const WriteRequest& request) {
  const Task& task = request.task;
  Candidate at_rate;
  // controllers of robots have a rate; a person's numbers stay those of the motion's own frames
  const std::optional<double> rate = task.robot ? request.settings.rate : std::nullopt;
  if (rate) {
    SHG_TRY_ASSIGN(at_rate, sampled(request.character, task, request.candidate, *rate));
  }
  const Candidate& candidate = rate ? at_rate : request.candidate;
  const Motion& motion = candidate.motion;
  const bool robot = task.robot.has_value();
  std::vector<CsvColumn> columns{{"time [s]", {}}};
  for (int f = 0; f < motion.clip.frames; ++f) {
    columns[0].values.push_back(f * motion.clip.frame_time);
  }
  (robot ? add_robot_columns : add_body_columns)(task, motion, columns);
  const auto add_points = [&](const std::string& name, std::vector<Vec3d> points) {
    if (robot) std::transform(points.begin(), points.end(), points.begin(), in_robot_world);
    add_point_columns(name, points, columns);
  };
  add_points("centre_of_mass", motion.centre_of_mass);
  for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
    add_points(candidate.goals[g].asked.effector, motion.effectors[g]);
  }
  for (const ThingMotion& thing : candidate.things) add_thing_columns(thing, columns);
  if (task.cost) {
    Result<MotionCost> cost = request.cost != nullptr
                                  ? Result<MotionCost>(*request.cost)
                                  : candidate_cost(task, request.candidate, task.ergonomics);
    if (!cost) return tl::unexpected(cost.error());
    add_cost_columns(
        rate ? in_frames_of(motion.clip, request.candidate.motion.clip, std::move(*cost)) : *cost,
        columns);
  }
  return format_csv(columns);
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::csv>(const WriteRequest& request) {
  return unread(motion_csv(request));
}

}  // namespace shigusa
