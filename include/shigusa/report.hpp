// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/cost.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

/// The greatest values of a motion's cost, each on its own scale.
struct CostPeaks {
  std::optional<int> reba{};            ///< 1..15
  std::optional<int> rula{};            ///< 1..7
  std::optional<double> compression{};  ///< N, at L5/S1
  std::optional<double> moment{};       ///< N·m, at L5/S1
  std::optional<double> lifting{};      ///< worst LI
  bool no_load = false;                 ///< a lift is not allowed with any load
  /// The greatest as a share of where its method asks for a change at once: REBA 11, RULA 7,
  /// kBackPermissible, LI 3; a lift without an allowed load counts as 2.
  [[nodiscard]] double worst() const;
  [[nodiscard]] double mean() const;  ///< mean of these shares
};
/// Takes the greatest values of a cost.
[[nodiscard]] CostPeaks cost_peaks(const MotionCost& cost);

/// A change of a task that was tried.
struct TriedChange {
  std::string change{};  ///< in words: "everything 10 cm nearer"
  CostPeaks peaks{};     ///< what the best motion costs then
  Verdict verdict{};     ///< whether it can be made
};

/// Searches a task anew after each of a few changes: everything nearer, higher or lower, half the
/// load, both hands. Returns up to three that lower its worst share, or then its mean share, most;
/// those whose goals are not met are left out. Fails as candidate_cost does, and with
/// ErrorCode::cancelled.
[[nodiscard]] Result<std::vector<TriedChange>> try_changes(const Task& task,
                                                           const Candidate& candidate,
                                                           const Ergonomics& ergonomics,
                                                           const Progress& progress = {});

/// A motion and its cost, for a report.
struct CostReport {
  const Task& task;                        ///< task of the motion
  const Candidate& candidate;              ///< the motion
  const MotionCost& cost;                  ///< what it costs
  const Ergonomics& ergonomics;            ///< what was told besides the motion
  std::span<const TriedChange> changes{};  ///< the most helpful first
  std::string title{};                     ///< UTF-8; empty: the goals in words
};

/// Makes a report as one HTML file that loads no other file and prints on two A4 pages: who does
/// what, a strip of the motion and of its worst frames, scores as bars in the methods' colours, a
/// table of the actions, plots over time, what would help, and what is not known. Texts from files
/// are escaped. Same motion, same bytes. Fails as draw_strip does.
[[nodiscard]] Result<std::string> cost_report(const CostReport& report);

}  // namespace shigusa
