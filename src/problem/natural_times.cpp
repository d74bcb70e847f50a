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

// Pace beside that of MTM-1, whose workers are trained; chosen, as recorded people are slower.
constexpr double kPace = 1.2;
constexpr double kNearBase = 0.16 * kPace;     // s
constexpr double kNearPerMetre = 1.0 * kPace;  // s/m
constexpr double kNaturalDurationMin = 0.4;    // s
// Distances (limb lengths) of a goal from the limb's root between which the trunk begins to help.
constexpr double kTrunkFrom = 0.9;
constexpr double kTrunkTo = 1.1;
// Static constant of MTM-1's weights, 0.58 s at 47.5 lb.
constexpr double kTimePerLoad = 0.0283;  // s/kg
// Time that a goal's box saves for each bit by which its width exceeds that of a point, up to a
// share of the reach's.
constexpr double kTimePerBit = 0.1;   // s
constexpr double kPointWidth = 0.02;  // m
constexpr double kSavedMost = 1.0 / 3.0;

// Length (m) of a path.
double length_of(const EffectorPath& path) {
  if (path.detour == Vec3d{}) return norm(path.goal - path.start);
  constexpr int kParts = 20;
  double length = 0.0;
  for (int k = 0; k < kParts; ++k) {
    length += norm(path.at((k + 1.0) / kParts) - path.at(static_cast<double>(k) / kParts));
  }
  return length;
}

// Width (m) of a goal's box along the straight way to it.
double width_along(const ReachGoal& goal) {
  const Vec3d way = normalized(goal.path.goal - goal.path.start);
  double width = 1e9;
  for (int k = 0; k < 3; ++k) {
    if (abs(way[k]) > 1e-9) width = min(width, 2.0 * goal.tolerance[k] / abs(way[k]));
  }
  return width < 1e9 ? width : 0.0;
}

// Height gained on the way, as a share of its length.
double slope_of(const EffectorPath& path) {
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
  return kLevel + kUpwards * slope_of(path);
}

double natural_begin(const EffectorPath& path) { return kHandLeaves * max(-slope_of(path), 0.0); }

double natural_duration(const BodyModel& body, const Kinematics<double>& start,
                        const ReachGoal& goal, double load) {
  const Effector& effector = body.effector(goal.effector);
  const double distance = length_of(goal.path);
  const double far = norm(goal.path.goal - start.origin[index(effector.limb_root)]) /
                     max(body.limb_length(effector), 1e-6);
  const double helps = clamp((far - kTrunkFrom) / (kTrunkTo - kTrunkFrom), 0.0, 1.0);
  double duration =
      min(kDurationBase + kDurationPerMetre * distance, kNearBase + kNearPerMetre * distance);
  duration = min(duration, kDurationMax) + helps * kDurationTrunk;
  duration = duration * load_factor(load) + kTimePerLoad * max(load - kFreeLoad, 0.0);
  const double bits = natural_log(1.0 + width_along(goal) / kPointWidth) / natural_log(2.0);
  duration -= min(kTimePerBit * bits, kSavedMost * duration);
  return max(duration, kNaturalDurationMin);
}

PartWindows natural_windows(std::span<const ReachGoal> goals) {
  double rise = 0.0;
  for (const ReachGoal& goal : goals)
    rise += slope_of(goal.path) / static_cast<double>(goals.size());
  const double up = 0.5 + 0.5 * rise;
  PartWindows windows;
  for (std::size_t p = 0; p < kTimedParts; ++p) {
    windows[p] = {kDown[p].begin + (kUp[p].begin - kDown[p].begin) * up,
                  kDown[p].end + (kUp[p].end - kDown[p].end) * up};
  }
  return windows;
}

}  // namespace shigusa
