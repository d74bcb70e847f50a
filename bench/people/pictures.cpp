// SPDX-License-Identifier: MIT
#include <shigusa/strip_figure.hpp>

#include "character/character_rig.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "page.hpp"

namespace shigusa::bench {
namespace {

constexpr int kPoses = 6;

Result<std::string> recorded_strip(const Recorded& reach) {
  const Rig& rig = reach.person.rig->rig;
  StripSettings settings;
  settings.poses = kPoses;
  settings.first_frame = reach.segment.first;
  settings.last_frame = reach.segment.last;
  settings.metres_per_unit = rig.placement.unit;
  settings.up = rig.placement.up;
  settings.facing = rig.placement.ahead;
  settings.humanoid = rig.bones;
  return draw_strip(reach.motion, {}, settings, FigureFormat::svg);
}

}  // namespace

Result<std::string> reach_strip(const Recorded& reach, const Track& track, Seen seen) {
  StripOverlay overlay;
  overlay.goals = {reach.track.joints.back()[right_grip]};
  for (const Joints& joints : track.joints) overlay.hand_path.push_back(joints[right_grip]);
  StripSettings settings;
  settings.poses = kPoses;
  if (seen == Seen::from_the_side) {
    settings.azimuth_deg = 90.0;
    settings.elevation_deg = 0.0;
  }
  return draw_strip(skeleton_motion(reach.body, track.angles), overlay, settings,
                    FigureFormat::svg);
}

Result<std::vector<NamedPicture>> people_pictures(const std::vector<Compared>& compared) {
  std::vector<NamedPicture> pictures;
  for (const Compared& c : compared) {
    const auto add = [&](const char* what, Result<std::string> svg) -> Result<void> {
      if (!svg) return tl::unexpected(svg.error());
      pictures.push_back({c.reach.segment.name + "-" + what, std::move(*svg)});
      return {};
    };
    std::vector<std::pair<const char*, const Track*>> drawn;
    for (const Chosen& each : c.chosen) {
      if (each.way.starts_with("best-scored")) drawn.emplace_back("best-scored", &each.track);
      if (each.way.starts_with("nearest")) drawn.emplace_back("nearest", &each.track);
    }
    SHG_TRY(add("recorded", recorded_strip(c.reach)));
    for (const auto& [what, track] : drawn) {
      SHG_TRY(add(what, reach_strip(c.reach, *track)));
    }
    if (c.fitted.back().clip.angles.empty()) continue;
    const Track fitted = track_of(c.reach, c.fitted.back().clip);
    SHG_TRY(add("fitted", reach_strip(c.reach, fitted)));
  }
  return pictures;
}

}  // namespace shigusa::bench
