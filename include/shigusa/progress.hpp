// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

namespace shigusa {

/// How far a long piece of work has come.
struct ProgressReport {
  std::string_view stage;   ///< "search", "export"; valid during the call only
  double fraction = 0.0;    ///< 0..1 of this stage, at most; the work may converge earlier
  int evaluations = 0;      ///< motions scored so far
  double best_score = 0.0;  ///< lowest score so far; meaningless while evaluations is 0
};

/// How a caller watches and stops long work. All members may be left empty. `report` is called on
/// the thread that called the work; what it throws is passed on to that caller. Setting `cancel` to
/// true, from any thread or from a signal handler, ends the work at its next step with the best so
/// far; so does the `deadline` once it has passed. The result at a deadline depends on the
/// machine's speed.
struct Progress {
  std::function<void(const ProgressReport&)> report{};  ///< called at each step
  /// ends the work once it is true
  const std::atomic<bool>* cancel = nullptr;
  std::optional<std::chrono::steady_clock::time_point> deadline{};  ///< ends it once it has passed

  /// Whether the work is to end now.
  [[nodiscard]] bool cancelled() const {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return true;
    return deadline && std::chrono::steady_clock::now() >= *deadline;
  }
};

}  // namespace shigusa
