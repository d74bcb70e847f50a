// SPDX-License-Identifier: MIT
#include <shigusa/math.hpp>

#include "core/index.hpp"
#include "strip_figure_painter.hpp"

namespace shigusa::strip {
namespace {

constexpr double kBetweenNames = 4.0;  // points

// The last slot whose frame is not after `frame`.
const Slot& slot_at(const Strip& strip, int frame) {
  const Slot* found = &strip.slots.front();
  for (const Slot& slot : strip.slots) {
    if (slot.frame <= frame) found = &slot;
  }
  return *found;
}

}  // namespace

std::vector<ActionLabel> action_labels(const Strip& strip, const std::vector<StripAction>& actions,
                                       double width) {
  std::vector<ActionLabel> labels;
  std::vector<double> ends;  // (rows)
  for (const StripAction& action : actions) {
    const double half = 0.5 * text_width(action.name, kText);
    const double x = clamp(slot_at(strip, action.first).x, kMargin + half, width - kMargin - half);
    std::size_t row = 0;
    while (row < ends.size() && ends[row] > x - half) ++row;
    if (row == ends.size()) ends.emplace_back();
    ends[row] = x + half + kBetweenNames;
    labels.push_back({action.name, x, static_cast<int>(row)});
  }
  return labels;
}

}  // namespace shigusa::strip
