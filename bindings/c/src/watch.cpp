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
  ask([&] {
    return watch_->report(watch_->user, report.fraction, report.evaluations, report.best_score) ==
           0;
  });
}

}  // namespace shigusa::door
