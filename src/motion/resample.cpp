// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <shigusa/motion.hpp>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

// Tolerance of rounding in a whole number of frames or steps.
constexpr double kWhole = 1e-6;

// The slope of dof d in a frame of the clip (rad per frame).
double slope(const Clip& clip, int frame, std::size_t d) {
  if (frame == clip.frames - 1 || (frame == 0 && clip.before.empty())) return 0.0;
  return 0.5 * (clip.frame(frame + 1)[d] - clip.frame_before(frame)[d]);
}

// Appends the posture between a frame and the next: at the frame for a share of 0, at the next for
// 1.
void append_between(const Clip& clip, int frame, double share, std::vector<double>& angles) {
  const double t = share;
  const double u = 1.0 - share;
  for (std::size_t d = 0; d < index(clip.dofs); ++d) {
    angles.push_back(
        u * u * ((1.0 + 2.0 * t) * clip.frame(frame)[d] + t * slope(clip, frame, d)) +
        t * t * ((1.0 + 2.0 * u) * clip.frame(frame + 1)[d] - u * slope(clip, frame + 1, d)));
  }
}

}  // namespace

State Clip::state(int index) const {
  const std::span<const double> at = frame(index);
  State state{.angles = {at.begin(), at.end()}};
  if (index == frames - 1 || (index == 0 && before.empty())) return state;
  for (std::size_t d = 0; d < at.size(); ++d) {
    state.velocities.push_back(slope(*this, index, d) / frame_time);
  }
  return state;
}

int frames_at(double duration, double rate) {
  const double steps = duration * rate - kWhole;
  const int whole = static_cast<int>(steps);
  return steps <= 0.0 ? 1 : whole + (static_cast<double>(whole) < steps ? 2 : 1);
}

Clip resampled(const Clip& clip, double rate) {
  SHG_CHECK(clip.frames >= 1, "a clip has a frame");
  SHG_CHECK(rate >= kRateMin && rate <= kRateMax, "a rate from kRateMin to kRateMax");
  Clip result{.dofs = clip.dofs,
              .frames = frames_at(clip.duration(), rate),
              .frame_time = 1.0 / rate,
              .angles = {},
              .before = {}};
  result.angles.reserve(index(result.frames) * index(clip.dofs));
  for (std::size_t d = 0; d < clip.before.size(); ++d) {
    result.before.push_back(clip.frame(0)[d] -
                            slope(clip, 0, d) * result.frame_time / clip.frame_time);
  }
  for (int k = 0; k < result.frames; ++k) {
    const double at = k / rate / clip.frame_time;
    const int frame = std::min(static_cast<int>(at + kWhole), clip.frames - 1);
    const double share = at - frame;
    if (frame == clip.frames - 1 || k == result.frames - 1 || share < kWhole) {
      const auto posture = clip.frame(k == result.frames - 1 ? clip.frames - 1 : frame);
      result.angles.insert(result.angles.end(), posture.begin(), posture.end());
    } else {
      append_between(clip, frame, share, result.angles);
    }
  }
  return result;
}

}  // namespace shigusa
