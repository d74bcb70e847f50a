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

/// One motion of a data set as a row of it: what was asked, how good it is, and the parameters that
/// it is made from. Columns that it has beside these are for readers of HDF5 (docs/data.md).
struct DatasetMotion {
  std::uint64_t task = 0;               ///< number of the task, which DatasetPlan::task draws again
  double stature = 0.0;                 ///< m
  double mass = 0.0;                    ///< kg
  Sex sex = Sex::male;                  ///< of the person
  std::optional<double> seat{};         ///< m, height of the seat; none of who stands
  std::vector<Goal> goals{};            ///< of the task, in its order
  int rank = 1;                         ///< of the task's candidates, from 1
  double score = 0.0;                   ///< lower is better
  double duration = 0.0;                ///< s
  Verdict verdict = Verdict::possible;  ///< whether the body could make the motion
  /// Names of the parameters, as edits spell them, angles in radians: "right_knee.flexion.weight",
  /// "squat_rad". Motions of bodies alike have the same ones. They live as long as the call.
  std::span<const std::string> names{};
  std::vector<double> parameters{};  ///< (names) their values; NaN of a freedom that is locked
};

/// Shows all motions of a data set's folder, one shard after the other, by task and then by rank.
/// Fails where a shard is damaged or of another plan.
[[nodiscard]] Result<void> read_motions(const std::filesystem::path& folder,
                                        const std::function<void(const DatasetMotion&)>& show);

/// Parameters of a task's motions from values of these names (see DatasetMotion), which may be of
/// another task: what the task's plan has no parameter for is left out, and what has no value stays
/// as the plan begins. Fails where the task has no plan.
[[nodiscard]] Result<Parameters> named_parameters(const Task& task,
                                                  std::span<const std::string> names,
                                                  std::span<const double> values);

}  // namespace shigusa
