// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/draw.hpp>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"

namespace shigusa {
namespace {

// Metres per unit of a figure that is no complete person: above 3 m it counts as centimetres, which
// animation tools expect of BVH and shigusa writes.
double guessed_unit(const std::vector<Transformd>& world, std::optional<double> stature) {
  constexpr double kTallest = 3.0;
  double low = world.front().translation.y;
  double high = low;
  for (const Transformd& node : world) {
    low = min(low, node.translation.y);
    high = max(high, node.translation.y);
  }
  if (stature && high > low) return *stature / (high - low);
  return high - low > kTallest ? 0.01 : 1.0;
}

}  // namespace

Result<std::string> understand_figure(const SkeletonMotion& motion, std::optional<double> stature,
                                      StripSettings& settings) {
  const int frame = std::min(settings.first_frame, motion.clip.frames - 1);
  const std::vector<Transformd> world = world_transforms(motion.skeleton, motion.clip, frame);
  const Result<HumanoidMap> map = find_humanoid(motion.skeleton, world);
  const Result<MeasuredPerson> person =
      map ? measure_person(motion.skeleton, world, *map, {.stature = stature})
          : Result<MeasuredPerson>(tl::unexpected(map.error()));
  if (map) settings.humanoid = *map;
  if (person) {
    settings.metres_per_unit = person->placement.unit;
    settings.up = person->placement.up;
    return {};
  }
  if (stature && !(*stature >= 0.5 && *stature <= 2.5)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {} m; allowed are 0.5 to 2.5 m", *stature), "stature");
  }
  settings.metres_per_unit = guessed_unit(world, stature);
  return person.error().to_string();
}

}  // namespace shigusa
