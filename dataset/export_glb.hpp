// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <shigusa/dataset_export.hpp>
#include <string>

#include "drawn_again.hpp"

namespace shigusa {

// Motions of a data set as GLB files, one after the other. Borrows all that it is made from.
class GlbWriter {
 public:
  // Fails if no motion of the plan can leave so.
  [[nodiscard]] static Result<GlbWriter> of(const DatasetPlan& plan,
                                            const DataExportSettings& settings);

  // File of a motion. ErrorCode::unsupported: it cannot be made for the character.
  [[nodiscard]] Result<std::string> file_of(const DataMotion& motion);
  // Paragraphs about the files so far.
  [[nodiscard]] std::string about() const;
  [[nodiscard]] std::uint64_t searched() const { return searched_; }
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

 private:
  // Motions of one task, generated for a character.
  struct Made {
    std::uint64_t number = 0;
    DrawnAgain again;
    std::optional<MotionPlayer> player{};
    std::optional<GenerateResult> searched{};  // if it is not played
  };
  GlbWriter(const DatasetPlan& plan, double rate) : plan_(&plan), rate_(rate) {}
  Result<std::string> glb_of(const DataMotion& motion);
  Result<Candidate> candidate_of(const DataMotion& motion);
  Result<Candidate> searched_candidate(const DataMotion& motion);

  const DatasetPlan* plan_;
  double rate_;  // Hz
  std::optional<CharacterSpec> person_{};
  std::optional<Made> made_{};
  std::uint64_t searched_ = 0;
  std::uint64_t missed_ = 0;
};

}  // namespace shigusa
