// SPDX-License-Identifier: MIT
#include "strip_figure_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <shigusa/math.hpp>

#include "core/index.hpp"
#include "strip_figure_slot.hpp"

namespace shigusa::strip {
namespace {

// Shares of the figure's size.
constexpr double kStaysWithin = 0.5;  // the root's travel up to which the figure counts as standing
constexpr double kFloorGuess = 0.1;   // a lowest node within this of height 0 stands on floor 0
// Greatest height of a figure as a share of the page's width, however few the poses.
constexpr double kMaxHeight = 0.5;
// Greatest stretch of the steps: few poses on a wide page stand together rather than at its edges.
constexpr double kMaxStretch = 1.5;
constexpr int kPathPoints = 200;

using Posture = std::vector<Transformd>;

std::vector<int> pose_frames(const SkeletonClip& clip, const StripSettings& settings) {
  if (!settings.frames.empty()) return settings.frames;
  const int first = settings.first_frame;
  const int last = settings.last_frame < 0 ? clip.frames - 1 : settings.last_frame;
  std::vector<int> frames;
  for (int i = 0; i < settings.poses; ++i) {
    const std::int64_t steps = std::max(settings.poses - 1, 1);
    const std::int64_t offset = (std::int64_t{2} * i * (last - first) + steps) / (2 * steps);
    const int frame = first + static_cast<int>(offset);
    if (frames.empty() || frames.back() != frame) frames.push_back(frame);
  }
  return frames;
}

Result<std::vector<Posture>> postures(const SkeletonMotion& motion,
                                      const std::vector<int>& frames) {
  std::vector<Posture> result;
  for (const int frame : frames) {
    result.push_back(world_transforms(motion.skeleton, motion.clip, frame));
    for (std::size_t i = 0; i < result.back().size(); ++i) {
      if (usable(result.back()[i])) continue;
      const Vec3d& p = result.back()[i].translation;
      return fail(ErrorCode::invalid_argument,
                  fmt::format("place ({}, {}, {}) or rotation is not finite, or beyond {:g}", p.x,
                              p.y, p.z, kFarthest),
                  fmt::format("node {} '{}' in frame {}", i, motion.skeleton.nodes[i].name, frame));
    }
  }
  return result;
}

Upright upright_from(const StripSettings& settings) {
  const Vec3d up = normalized(settings.up);
  const Vec3d ahead = abs(up.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  const Vec3d facing = settings.facing.value_or(ahead);
  const Vec3d sideways = normalized(ahead - up * dot(ahead, up));
  return {up, normalized(facing - up * dot(facing, up), sideways)};
}

View view_from(const StripSettings& settings, const Upright& upright, const Vec3d& leftwards) {
  const Vec3d& up = upright.up;
  Vec3d forward = upright.forward;
  if (!settings.facing) forward = normalized(cross(leftwards, up), forward);
  const Vec3d left = cross(up, forward);
  const SinCos<double> azimuth = sin_cos(radians(settings.azimuth_deg));
  const SinCos<double> elevation = sin_cos(radians(settings.elevation_deg));
  const Vec3d level = forward * azimuth.cos - left * azimuth.sin;
  View view;
  view.up = up;
  view.right = left * azimuth.cos + forward * azimuth.sin;
  view.toward = level * elevation.cos + up * elevation.sin;
  view.above = up * elevation.cos - level * elevation.sin;
  return view;
}

// Longest diagonal of a posture: the size of figures with unknown limbs.
double extent(const std::vector<Posture>& all) {
  double largest = 0.0;
  for (const Posture& posture : all) {
    Vec3d low = posture.front().translation;
    Vec3d high = low;
    for (const Transformd& node : posture) {
      for (int i = 0; i < 3; ++i) {
        low[i] = min(low[i], node.translation[i]);
        high[i] = max(high[i], node.translation[i]);
      }
    }
    largest = max(largest, norm(high - low));
  }
  return largest;
}

double find_floor(const StripSettings& settings, const std::vector<Posture>& all, const Vec3d& up,
                  double size) {
  if (settings.floor) return *settings.floor;
  double lowest = dot(all.front().front().translation, up);
  for (const Posture& posture : all) {
    for (const Transformd& node : posture) lowest = min(lowest, dot(node.translation, up));
  }
  return abs(lowest) <= kFloorGuess * size ? 0.0 : lowest;
}

// Points on the floor at which the slots are drawn.
std::vector<Vec3d> anchors(const std::vector<Posture>& all, const FigureBody& body,
                           const View& view, double size) {
  std::vector<Vec3d> places;
  Vec3d stance{};
  double travel = 0.0;
  for (const Posture& posture : all) {
    places.push_back(view.on_floor(body.place(posture)));
    travel = max(travel, norm(places.back() - places.front()));
    stance += view.on_floor(body.stance(posture)) * (1.0 / static_cast<double>(all.size()));
  }
  if (travel <= kStaysWithin * size) std::fill(places.begin(), places.end(), stance);
  return places;
}

// The action that a frame belongs to: its end does; nothing without actions.
const StripAction* action_at(const std::vector<StripAction>& actions, int frame) {
  for (const StripAction& action : actions) {
    if (frame <= action.last) return &action;
  }
  return nullptr;
}

void measure(Strip& strip) {
  const Slot& first = strip.slots.front();
  for (std::size_t i = 1; i < strip.slots.size(); ++i) {
    const double needed = strip.slots[i - 1].box.right - strip.slots[i].box.left;
    strip.step = max(strip.step, needed + kGap * strip.size);
  }
  strip.top = first.box.top;
  strip.bottom = first.box.bottom;
  for (const Slot& slot : strip.slots) {
    strip.top = max(strip.top, slot.box.top);
    strip.bottom = min(strip.bottom, slot.box.bottom);
  }
}

// Width from the left edge of the first slot to the right edge of the last one, without the steps.
double width_of_ends(const Strip& strip) {
  return strip.slots.back().box.right - strip.slots.front().box.left;
}

}  // namespace

double Strip::largest_scale(double width) const {
  const double steps = static_cast<double>(slots.size() - 1);
  const double height = max(top - bottom, size);
  return min((width - 2.0 * kMargin) / (width_of_ends(*this) + steps * step),
             kMaxHeight * width / height);
}

// Places slots at equal steps, so that the floor line is a time axis: as wide as the widest
// neighbours need, and stretched to fill the width.
void place_slots(Strip& strip, double width, double scale) {
  const double steps = static_cast<double>(strip.slots.size() - 1);
  strip.scale = scale;
  const double rest = width - 2.0 * kMargin - scale * width_of_ends(strip);
  strip.spacing = steps > 0.0 ? min(rest / steps, kMaxStretch * scale * strip.step) : 0.0;
  const double left =
      kMargin + 0.5 * (rest - steps * strip.spacing) - scale * strip.slots.front().box.left;
  for (std::size_t i = 0; i < strip.slots.size(); ++i) {
    strip.slots[i].x = left + static_cast<double>(i) * strip.spacing;
  }
}

Result<Strip> lay_out(const SkeletonMotion& motion, const StripOverlay& overlay,
                      const StripSettings& settings) {
  const std::vector<int> frames = pose_frames(motion.clip, settings);
  SHG_TRY_ASSIGN(const auto all, postures(motion, frames));

  const Upright upright = upright_from(settings);
  const FigureBody body(motion.skeleton, settings, upright);
  double size = body.stature() > 0.0 ? body.stature() : extent(all);
  if (size < 1e-9) size = 1.0;
  View view = view_from(settings, upright, body.leftwards(all.front()));
  view.floor = find_floor(settings, all, upright.up, size);
  const auto places = anchors(all, body, view, size);

  Strip strip;
  strip.size = size;
  const int path_step = std::max((frames.back() - frames.front()) / kPathPoints, 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    SlotBuilder builder(view, places[i], size);
    builder.slot.frame = frames[i];
    builder.add_parts(body.parts(all[i], size));
    builder.close_body();
    for (const Vec3d& goal : overlay.goals) builder.add_goal(goal);
    const StripAction* const action = action_at(overlay.actions, frames[i]);
    if (action != nullptr) {
      for (const Vec3d& goal : action->goals) builder.add_goal(goal);
    }
    if (!overlay.centre_of_mass.empty()) {
      builder.add_mass(overlay.centre_of_mass[index(frames[i])]);
    }
    if (!overlay.hand_path.empty()) {
      const int begin = action == nullptr ? frames.front() : action->first;
      builder.add_path(overlay.hand_path, begin, frames[i], path_step);
    }
    builder.add_moving(overlay.things);
    builder.add_things(overlay.things);
    strip.slots.push_back(std::move(builder.slot));
  }
  measure(strip);
  return strip;
}

}  // namespace shigusa::strip
