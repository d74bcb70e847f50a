// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/score.hpp>

namespace shigusa {

// A recorded motion on its body, smoothed, with the frames around those that are scored.
struct SmoothClip {
  ClipFit fit{};  // before smoothing
  Clip clip{};
  int first = 0;  // frames of `clip` that are scored
  int last = 0;   // included
  std::vector<Message> doubts{};
};
[[nodiscard]] Result<SmoothClip> smooth_clip(const RecordedMotion& recorded,
                                             const ScoreSettings& settings);

// Scores the frames of a clip on a body, which may hold loads, from the start of a context. Fit,
// final posture and doubts stay empty.
[[nodiscard]] ClipScore score_frames(const BodyModel& body, CriteriaContext context,
                                     const SmoothClip& smooth, const CriteriaSettings& criteria);

}  // namespace shigusa
