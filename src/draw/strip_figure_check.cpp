// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/text.hpp"
#include "strip_figure_layout.hpp"

namespace shigusa::strip {
namespace {

// Limits that keep a figure's file below some tens of megabytes.
constexpr std::size_t kMaxPieces = 65'536;
constexpr std::size_t kMaxGoals = 64;
constexpr std::size_t kMaxThings = 80 + kThingsMax;
constexpr std::size_t kMaxCorners = 64;
constexpr std::size_t kMaxCaption = 2000;

tl::unexpected<Error> invalid(std::string place, std::string message) {
  return fail(ErrorCode::invalid_argument, std::move(message), std::move(place));
}

Result<void> check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return invalid(name, fmt::format("{} given; {:g} to {:g} allowed", value, low, high));
}

int poses_of(const StripSettings& settings) {
  return settings.frames.empty() ? settings.poses : static_cast<int>(settings.frames.size());
}

Result<void> check_settings(const StripSettings& settings, std::size_t nodes) {
  const struct {
    const char* name;
    double value, low, high;
  } ranges[] = {{"poses", static_cast<double>(poses_of(settings)), 1, kStripMaxPoses},
                {"width_mm", settings.width_mm, 100, 2000},
                {"azimuth_deg", settings.azimuth_deg, -360, 360},
                {"elevation_deg", settings.elevation_deg, -30, 80},
                {"metres_per_unit", settings.metres_per_unit, 1e-6, 1e6},
                {"length of up", norm(settings.up), 1e-6, 1e6},
                {"length of facing", settings.facing ? norm(*settings.facing) : 1.0, 1e-6, 1e6},
                {"floor", settings.floor.value_or(0.0), -kFarthest, kFarthest}};
  for (const auto& range : ranges) {
    SHG_TRY(check_range(range.name, range.value, range.low, range.high));
  }
  if (!settings.humanoid) return {};
  for (const int node : settings.humanoid->node) {
    if (node < -1 || node >= static_cast<int>(nodes)) {
      return invalid("humanoid map", fmt::format("names node {} of a skeleton of {}", node, nodes));
    }
  }
  return {};
}

Result<void> check_skeleton(const Skeleton& skeleton, int poses) {
  const std::size_t count = skeleton.nodes.size();
  if (count == 0) return invalid("skeleton", "has no node to draw");
  if (count * static_cast<std::size_t>(poses) > kMaxPieces) {
    return invalid("skeleton", fmt::format("{} nodes in {} poses; together at most {} allowed",
                                           count, poses, kMaxPieces));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const SkeletonNode& node = skeleton.nodes[i];
    if (node.parent < -1 || node.parent >= static_cast<int>(i)) {
      return invalid(fmt::format("node {} '{}'", i, node.name),
                     fmt::format("has parent {}; -1 or an earlier node allowed", node.parent));
    }
    if (!(norm(node.offset) <= kFarthest)) {
      return invalid(fmt::format("node {} '{}'", i, node.name),
                     fmt::format("has an offset that is not finite, or beyond {:g}", kFarthest));
    }
  }
  return {};
}

Result<void> check_clip(const SkeletonClip& clip, std::size_t nodes,
                        const StripSettings& settings) {
  if (clip.frames < 1) return invalid("motion", "has no frame to draw");
  if (clip.local.size() != static_cast<std::size_t>(clip.frames) * nodes) {
    return invalid("motion", fmt::format("{} transforms for {} frames of {} nodes",
                                         clip.local.size(), clip.frames, nodes));
  }
  int before = -1;
  for (const int frame : settings.frames) {
    if (frame <= before || frame >= clip.frames) {
      return invalid("frames", fmt::format("{} after {}; the clip has 0 to {}, and they ascend",
                                           frame, before, clip.frames - 1));
    }
    before = frame;
  }
  const int last = settings.last_frame < 0 ? clip.frames - 1 : settings.last_frame;
  if (last >= clip.frames || settings.first_frame < 0 || settings.first_frame > last) {
    return invalid("frames", fmt::format("{} to {} given; the clip has 0 to {}",
                                         settings.first_frame, last, clip.frames - 1));
  }
  return check_range("frame time", clip.frame_time, 0.0, 1e6);
}

Result<void> check_poses(const std::vector<Transformd>& poses, int frames,
                         const std::string& place) {
  if (!poses.empty() && poses.size() != static_cast<std::size_t>(frames)) {
    return invalid(place, fmt::format("{} poses given; 0 or {} allowed", poses.size(), frames));
  }
  for (const Transformd& pose : poses) {
    if (usable(pose)) continue;
    return invalid(place, fmt::format("a pose is not finite, or beyond {:g}", kFarthest));
  }
  return {};
}

Result<void> check_things(const std::vector<StripThing>& things, int frames) {
  if (things.size() > kMaxThings) {
    return invalid("things", fmt::format("{} given; up to {} allowed", things.size(), kMaxThings));
  }
  for (std::size_t i = 0; i < things.size(); ++i) {
    const std::string place = fmt::format("thing {}", i);
    const std::size_t count = things[i].corners.size();
    if (count == 0 || count > kMaxCorners) {
      return invalid(place, fmt::format("{} corners given; 1 to {} allowed", count, kMaxCorners));
    }
    SHG_TRY(check_range("radius of a thing", things[i].radius, 0.0, kFarthest));
    for (const Vec3d& corner : things[i].corners) {
      if (norm(corner) <= kFarthest) continue;
      return invalid(place, fmt::format("a corner is not finite, or beyond {:g}", kFarthest));
    }
    SHG_TRY(check_poses(things[i].poses, frames, place));
  }
  return {};
}

Result<void> check_text(const char* name, std::string_view text) {
  if (text.size() > kMaxCaption) {
    return invalid(name, fmt::format("{} bytes given; up to {} allowed", text.size(), kMaxCaption));
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0) return invalid(name, fmt::format("byte {} is not UTF-8 text", i));
    i += length;
  }
  return {};
}

Result<void> check_actions(const std::vector<StripAction>& actions) {
  if (actions.size() > kActionsMax) {
    return invalid("actions",
                   fmt::format("{} given; up to {} allowed", actions.size(), kActionsMax));
  }
  for (const StripAction& action : actions) {
    SHG_TRY(check_text("name of an action", action.name));
    SHG_TRY(check_range("goals of an action", static_cast<double>(action.goals.size()), 0.0,
                        static_cast<double>(kMaxGoals)));
    SHG_TRY(check_range("begin of an action", action.first, 0.0, action.last));
    for (const Vec3d& goal : action.goals) {
      if (norm(goal) <= kFarthest) continue;
      return invalid("goals of an action",
                     fmt::format("a position is not finite, or beyond {:g}", kFarthest));
    }
  }
  return {};
}

Result<void> check_overlay(const StripOverlay& overlay, int frames) {
  SHG_TRY(check_things(overlay.things, frames));
  SHG_TRY(check_actions(overlay.actions));
  const struct {
    const char* name;
    const std::vector<Vec3d>& points;
    std::size_t most;
    bool per_frame;
  } lists[] = {{"goals", overlay.goals, kMaxGoals, false},
               {"centre of mass", overlay.centre_of_mass, static_cast<std::size_t>(frames), true},
               {"hand path", overlay.hand_path, static_cast<std::size_t>(frames), true}};
  for (const auto& list : lists) {
    const std::size_t count = list.points.size();
    if (count > list.most || (list.per_frame && count > 0 && count < list.most)) {
      return invalid(list.name, fmt::format("{} positions given; {} {} allowed", count,
                                            list.per_frame ? "0 or" : "up to", list.most));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(norm(list.points[i]) <= kFarthest)) {
        return invalid(list.name,
                       fmt::format("position {} is not finite, or beyond {:g}", i, kFarthest));
      }
    }
  }
  return check_text("caption", overlay.caption);
}

}  // namespace

bool usable(const Transformd& x) {
  const Mat3d& r = x.rotation;
  return norm(x.translation) <= kFarthest && norm(r.cx) + norm(r.cy) + norm(r.cz) <= kFarthest;
}

Result<void> check_strip(const SkeletonMotion& motion, const StripOverlay& overlay,
                         const StripSettings& settings) {
  const std::size_t nodes = motion.skeleton.nodes.size();
  SHG_TRY(check_settings(settings, nodes));
  SHG_TRY(check_skeleton(motion.skeleton, poses_of(settings)));
  SHG_TRY(check_clip(motion.clip, nodes, settings));
  return check_overlay(overlay, motion.clip.frames);
}

}  // namespace shigusa::strip
