// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <limits>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <thread>

namespace shigusa {

// Progress of work in parts, each of which reports as if it were the whole: shares and motions are
// summed, and the lowest score is kept. Parts may run in parallel; reports are passed on from the
// thread that constructed the object.
class JointProgress {
 public:
  explicit JointProgress(const Progress& whole) : whole_(whole) {}
  JointProgress(const JointProgress&) = delete;
  JointProgress& operator=(const JointProgress&) = delete;

  // Progress of a part with this share of the whole (0..1); the shares of unforeseen parts may
  // raise the sum above 1. Not to be called while parts run; this object and `whole` outlive the
  // part.
  [[nodiscard]] Progress part(double share) {
    Progress own = whole_;
    if (!whole_.report) return own;
    Slot& slot = slots_.emplace_back();
    own.report = [this, &slot, share](const ProgressReport& report) {
      // a part that is worked on once more begins anew
      slot.fraction = max(slot.fraction.load(), share * report.fraction);
      slot.evaluations = std::max(slot.evaluations.load(), report.evaluations);
      if (std::this_thread::get_id() == caller_) pass_on(report);
    };
    return own;
  }

 private:
  struct Slot {
    std::atomic<double> fraction{0.0};
    std::atomic<int> evaluations{0};
  };

  void pass_on(ProgressReport report) {
    if (report.evaluations > 0) best_ = min(best_, report.best_score);
    report.fraction = 0.0;
    report.evaluations = 0;
    for (const Slot& slot : slots_) {
      report.fraction += slot.fraction;
      report.evaluations += slot.evaluations;
    }
    report.fraction = min(report.fraction, 1.0);
    report.best_score = best_;
    whole_.report(report);
  }

  const Progress& whole_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::deque<Slot> slots_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace shigusa
