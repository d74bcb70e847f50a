// SPDX-License-Identifier: MIT
// Correction of joint limits in another unit than the format's.
#include <algorithm>
#include <set>
#include <utility>

#include "core/say.hpp"
#include "robot/robot.hpp"

namespace shigusa {
namespace {

constexpr double kWide = 2.0 * kTwoPi;       // rad: no joint of a limb turns twice round
constexpr double kNarrow = radians(kTwoPi);  // rad: radians that were taken for degrees
constexpr double kMostDegrees = 360.0;       // larger values mean no limit
constexpr double kPerRadian = 180.0 / kPi;
constexpr std::size_t kFewest = 4;  // distinct limits needed to infer a unit

void set_limits(Robot::Joint& joint, double lower, double upper) {
  joint.limited = upper - lower < kTwoPi;
  joint.lower = joint.limited ? lower : -kPi;
  joint.upper = joint.limited ? upper : kPi;
}

}  // namespace

void mend_limits(Robot& robot) {
  std::size_t told = 0;
  std::size_t wide = 0;
  std::size_t narrow = 0;
  std::set<std::pair<double, double>> different;  // identical limits of all joints mean no limits
  bool degrees = true;
  for (const Robot::Joint& joint : robot.joints) {
    if (!joint.ends || !joint.turns) continue;
    const auto& [lower, upper] = *joint.ends;
    const double most = max(abs(lower), abs(upper));
    // such values mean no limit
    if (most >= 1000.0) continue;
    ++told;
    different.emplace(lower, upper);
    degrees = degrees && most <= kMostDegrees;
    if (upper - lower > kWide) ++wide;
    if (upper - lower <= kNarrow) ++narrow;
  }
  if (different.size() < kFewest) return;
  double unit = 1.0;
  if (2 * wide > told && degrees) unit = 1.0 / kPerRadian;
  if (2 * narrow > told) unit = kPerRadian;
  if (unit == 1.0) return;
  for (Robot::Joint& joint : robot.joints) {
    if (!joint.ends) continue;
    set_limits(joint, (*joint.ends)[0] * unit, (*joint.ends)[1] * unit);
  }
  robot.doubts.push_back(unit < 1.0 ? say("limits_in_degrees", wide)
                                    : say("limits_in_radians", narrow));
}

}  // namespace shigusa
