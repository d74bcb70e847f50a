// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "motion/effector_turn.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The path to one goal, from the body's start posture; fails as make_problem does.
[[nodiscard]] Result<ReachGoal> make_reach_goal(const BodyModel& body,
                                                const Kinematics<double>& start, const Goal& goal);

// The target orientation of a goal's effector; a foot stays level if the goal gives none.
[[nodiscard]] EffectorTurn goal_turn(const BodyModel& body, const Goal& goal, int effector,
                                     const Kinematics<double>& start);

// Distance (m) of a point from a goal, or from its box.
[[nodiscard]] double goal_miss(const Goal& goal, const Vec3d& at);

// Duration (s) of a path to a goal.
[[nodiscard]] double goal_duration(const BodyModel& body, const Kinematics<double>& start,
                                   const ReachGoal& goal);

// The loads in the hands of motions to the task's goals.
[[nodiscard]] std::vector<HeldLoad> loads_in_hands(const Task& task);

// The task with the loads of its start and its goals in the body's hands, and its body on its
// contacts; unchanged without loads and freed feet.
[[nodiscard]] Result<Task> standing(Task task);

// Fails unless the start has one finite angle for each dof and loads in range, and is at rest where
// the method or the preset begins so.
[[nodiscard]] Result<void> check_start(const Task& task);

// Fails if goals and contacts take more rows than the IK has.
[[nodiscard]] Result<void> check_rows(const ReachProblem& problem);

// Gaze target: the middle of two hands' goals, or the first goal of a limb, as head and trunk do
// not look at themselves.
[[nodiscard]] std::optional<Vec3d> gaze_of(const BodyModel& body, std::span<const Goal> goals);

}  // namespace shigusa
