// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "judged.hpp"

namespace shigusa::bench {

// Generates motions, judges them by exported files and independent geometry, and counts.
class Auditor {
 public:
  explicit Auditor(int evaluations, Flaw flaw = Flaw::none)
      : evaluations_(evaluations), flaw_(flaw) {}

  void take(const Kind& kind, DrawnTask drawn);

  [[nodiscard]] const Audit& audit() const { return audit_; }

 private:
  void judge_all(const DrawnTask& drawn, const Task& task, GenerateResult generation);
  void judge_candidate(Judged judged, bool first);

  int evaluations_;
  Flaw flaw_;
  Audit audit_;
};

}  // namespace shigusa::bench
