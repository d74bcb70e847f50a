// SPDX-License-Identifier: MIT
#include "robot/robot_size.hpp"

#include "core/say.hpp"

namespace shigusa {
namespace {

// Usual range of heights (m) of humanoid robots.
bool is_usual(double stature) { return stature >= 0.5 && stature <= 2.1; }

}  // namespace

std::optional<Message> doubt_of_size(double stature) {
  if (stature >= kRobotLeastStature && stature <= kRobotMostStature) return std::nullopt;
  const Metres tall{stature};
  if (is_usual(stature * 0.001)) return say("robot_in_unit", tall, say("unit_millimetres"));
  if (is_usual(stature * 0.01)) return say("robot_in_unit", tall, say("unit_centimetres"));
  if (is_usual(stature * 0.0254)) return say("robot_in_unit", tall, say("unit_inches"));
  for (const double times : {10.0, 100.0, 1000.0}) {
    if (is_usual(stature * times)) return say("robot_too_small", tall, times);
  }
  return say("robot_odd_size", tall);
}

}  // namespace shigusa
