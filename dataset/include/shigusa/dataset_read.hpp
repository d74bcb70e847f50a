// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/human.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

/// One motion of a data set: its request, its quality, and the parameters that it is made from.
/// Further columns are accessible with HDF5 readers (docs/data.md).
struct DatasetMotion {
  std::uint64_t task = 0;               ///< number of the task, for DatasetPlan::task
  double stature = 0.0;                 ///< m
  double mass = 0.0;                    ///< kg
  Sex sex = Sex::male;                  ///< sex of the person
  std::optional<double> seat{};         ///< m, height of the seat; empty for a standing person
  std::vector<Goal> goals{};            ///< goals of the task, in order
  int rank = 1;                         ///< rank among the task's candidates, from 1
  double score = 0.0;                   ///< lower is better
  double duration = 0.0;                ///< s
  Verdict verdict = Verdict::possible;  ///< whether the body could make the motion
  /// Names of the parameters in the notation of edits, angles in radians:
  /// "right_knee.flexion.weight", "squat_rad". Motions of similar bodies have the same names. Valid
  /// during the call.
  std::span<const std::string> names{};
  std::vector<double> parameters{};  ///< (names) their values; NaN for a locked one
};

/// Visits all motions of a data set's folder, ordered by shard, task and rank. Fails if a shard is
/// damaged or of another plan.
[[nodiscard]] Result<void> read_motions(const std::filesystem::path& folder,
                                        const std::function<void(const DatasetMotion&)>& show);

/// Parameters for a task's motions from named values (see DatasetMotion), possibly of another task:
/// names unknown to the task's plan are ignored, and missing values keep the plan's initial ones.
/// Fails if the task has no plan.
[[nodiscard]] Result<Parameters> named_parameters(const Task& task,
                                                  std::span<const std::string> names,
                                                  std::span<const double> values);

}  // namespace shigusa
