// SPDX-License-Identifier: MIT
#include "problem/natural_times.hpp"

#include "core/index.hpp"

namespace shigusa {
namespace {

// Timing on the way down and up. From standing, trunk and knees complete a tenth of their change at
// 0.22 to 0.24 of the time and the hand at 0.35 (recorded, 7 men), and the back leads the hips
// (Esola et al., Spine 21 (1996) 71). In rising the knee leads the hip, and the hip the back
// (Burgess-Limerick et al., Hum. Factors 37 (1995) 395).
constexpr PartWindows kDown{{{0.0, 0.98}, {0.0, 0.9}, {0.0, 0.88}, {0.1, 1.0}}};
constexpr PartWindows kUp{{{0.0, 0.9}, {0.1, 0.96}, {0.25, 1.0}, {0.0, 1.0}}};
// Share of the time after which a hand on its way down leaves.
constexpr double kHandLeaves = 0.2;

// Height gained on the way, as a share of its length.
double rise_of(const EffectorPath& path) {
  const Vec3d offset = path.goal - path.start;
  const double length = norm(offset);
  return length > 0.0 ? offset.y / length : 0.0;
}

}  // namespace

double natural_haste(const EffectorPath& path) {
  // recorded hands are fastest at 0.31 to 0.40 of the time on their way up and at 0.47 to 0.61 on
  // their way down (see also Papaxanthis et al., Neurosci. Lett. 253 (1998) 103)
  constexpr double kLevel = 0.07;
  constexpr double kUpwards = 0.2;
  return kLevel + kUpwards * rise_of(path);
}

double natural_begin(const EffectorPath& path) { return kHandLeaves * max(-rise_of(path), 0.0); }

PartWindows natural_windows(std::span<const ReachGoal> goals) {
  double rise = 0.0;
  for (const ReachGoal& goal : goals)
    rise += rise_of(goal.path) / static_cast<double>(goals.size());
  const double up = 0.5 + 0.5 * rise;
  PartWindows windows;
  for (std::size_t p = 0; p < kTimedParts; ++p) {
    windows[p] = {kDown[p].begin + (kUp[p].begin - kDown[p].begin) * up,
                  kDown[p].end + (kUp[p].end - kDown[p].end) * up};
  }
  return windows;
}

}  // namespace shigusa
