// SPDX-License-Identifier: MIT
#include <shigusa/draw.hpp>

#include "character/character_rig.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "page.hpp"

namespace shigusa::bench {
namespace {

constexpr int kPoses = 5;

MotionStrip recorded_strip(const Recorded& reach) {
  const Rig& rig = reach.person.rig->rig;
  MotionStrip strip{reach.motion, {}, {}};
  strip.overlay.caption = "recorded";
  strip.settings.poses = kPoses;
  strip.settings.first_frame = reach.segment.first;
  strip.settings.last_frame = reach.segment.last;
  strip.settings.metres_per_unit = rig.placement.unit;
  strip.settings.up = rig.placement.up;
  strip.settings.facing = rig.placement.ahead;
  strip.settings.humanoid = rig.bones;
  return strip;
}

MotionStrip made_strip(const Recorded& reach, const Track& track) {
  MotionStrip strip{skeleton_motion(reach.posed, track.angles), {}, {}};
  strip.overlay.goals = {reach.track.joints.back()[right_grip]};
  for (const Joints& joints : track.joints) {
    strip.overlay.hand_path.push_back(joints[right_grip]);
  }
  strip.settings.poses = kPoses;
  return strip;
}

// The recorded motion and the generated ones for its reach, below each other.
Result<std::string> reach_page(const Compared& c) {
  std::vector<MotionStrip> strips{recorded_strip(c.reach)};
  const auto add = [&](const char* caption, const Track& track) {
    strips.push_back(made_strip(c.reach, track));
    strips.back().overlay.caption = caption;
  };
  for (const Chosen& each : c.chosen) {
    if (each.way.starts_with("best-scored")) add("best-scored", each.track);
    if (each.way.starts_with("nearest")) add("nearest", each.track);
  }
  if (!c.fitted.back().clip.angles.empty()) {
    add("fitted", track_of(c.reach, c.fitted.back().clip));
  }
  return draw_strips(strips);
}

}  // namespace

Result<std::string> side_strip(const Recorded& reach, const Track& track) {
  MotionStrip strip = made_strip(reach, track);
  strip.settings.azimuth_deg = 90.0;
  strip.settings.elevation_deg = 0.0;
  return draw_strips({strip});
}

Result<std::vector<NamedPicture>> people_pictures(const std::vector<Compared>& compared) {
  std::vector<NamedPicture> pictures;
  for (const Compared& c : compared) {
    SHG_TRY_ASSIGN(std::string svg, reach_page(c));
    pictures.push_back({c.reach.segment.name, std::move(svg)});
  }
  return pictures;
}

}  // namespace shigusa::bench
