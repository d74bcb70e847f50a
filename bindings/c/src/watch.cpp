// SPDX-License-Identifier: MIT
#include "watch.hpp"

namespace shigusa::door {

Progress Watched::progress() {
  Progress progress;
  progress.cancel = &stop_;
  if (watch_ == nullptr || watch_->report == nullptr) return progress;
  progress.report = [this](const ProgressReport& report) { tell(report); };
  return progress;
}

void Watched::tell(const ProgressReport& report) noexcept {
  if (failed_) return;
  try {
    const HostArithmetic host(arithmetic_->host());
    const auto answer =
        watch_->report(watch_->user, report.fraction, report.evaluations, report.best_score);
    if (answer != 0) stop_ = true;
  } catch (...) {
    failed_ = true;
    thrown_ = std::current_exception();
    stop_ = true;
  }
}

}  // namespace shigusa::door
