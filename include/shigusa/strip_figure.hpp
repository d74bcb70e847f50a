// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <shigusa/result.hpp>
#include <shigusa/skeleton.hpp>
#include <string>
#include <vector>

namespace shigusa {

/// A limb of a figure.
enum class Limb {
  left_arm,   ///< of the figure's left side
  right_arm,  ///< of its right
  left_leg,   ///< of its left
  right_leg,  ///< of its right
};

/// The most poses that a strip may have.
inline constexpr int kStripMaxPoses = 60;

/// Something beside the figure, such as a table: the convex hull of balls of one radius.
struct StripThing {
  /// Their middles. Eight without a radius are a box's corners, drawn with its edges: corner k lies
  /// on the far side of the box's first direction where k has the bit 1, and so on with 2 and 4.
  std::vector<Vec3d> corners;
  double radius = 0.0;  ///< of the balls
};

/// Marks that are drawn beside the figure itself; positions in the skeleton's world and unit.
struct StripOverlay {
  /// Drawn in every pose behind the figure, cut where they reach far beyond it; of those in front
  /// of it the edges are drawn over it once more.
  std::vector<StripThing> things;
  std::vector<Vec3d> goals;  ///< ringed crosses, in every pose
  /// (frames) a quartered disc and its plumb line; may be empty
  std::vector<Vec3d> centre_of_mass;
  std::vector<Vec3d> hand_path;  ///< (frames) a thin line up to each pose's time; may be empty
  std::string caption;           ///< UTF-8, below the strip in DejaVu Sans; may be empty
};

/// How a strip figure is drawn.
struct StripSettings {
  int poses = 7;        ///< poses drawn, equally spaced in time, first and last included
  int first_frame = 0;  ///< the part of the clip that is drawn; time labels count from here
  int last_frame = -1;  ///< -1: the clip's last

  double width_mm = 170.0;  ///< a page's; the height follows

  double azimuth_deg = 50.0;    ///< viewer's place: 0 in front, positive towards the figure's right
  double elevation_deg = 10.0;  ///< viewer above the horizon
  Vec3d up{0, 1, 0};            ///< of the skeleton's world, of any length but 0
  /// absent: as the hips of the first pose tell, else +Z (+X when up is Z)
  std::optional<Vec3d> facing;
  /// height along `up`; absent: 0, or the lowest node drawn where that is further than a tenth of
  /// the figure's size away from 0
  std::optional<double> floor;

  double metres_per_unit = 1.0;                 ///< of the skeleton's unit, for the scale bar
  std::optional<HumanoidMap> humanoid;          ///< absent: bones are found by their VRM names
  std::vector<Limb> accented{Limb::right_arm};  ///< drawn in the accent colour
};

/// Fills in the settings that a motion file does not tell: the bones, as names and shape tell them,
/// and of a whole person the axis that points up and the unit, all measured in the settings' first
/// frame. A `stature` (m) scales the figure to that height. Returns why the figure is no whole
/// person; it is then drawn as it stands, +Y up, in metres, or in centimetres where it would be
/// taller than anybody. The text is empty for a person. Fails on a stature outside 0.5 to 2.5 m.
[[nodiscard]] Result<std::string> understand_figure(const SkeletonMotion& motion,
                                                    std::optional<double> stature,
                                                    StripSettings& settings);

/// The strip figure of the paper's figures 4 to 7: a motion as poses from left to right over time
/// on one floor line, in parallel projection, as SVG: the same input gives the same bytes in every
/// build.
///
/// Limbs, trunk, head and feet get an anatomical look where the humanoid bones are known; any other
/// node is drawn as a plain bone, dark near the viewer and light away from it. A figure that stays
/// within half its size of one place is drawn about the place of its feet in each slot, so that
/// planted feet stand still from pose to pose; one that travels further is re-centred on its hips
/// in each pose. Poses never overlap: their distance is that of the widest neighbours, and the
/// scale is what fills the width. A goal too far away to be drawn in its slot becomes an arrow
/// towards it.
///
/// Fails when a setting is out of its range (the message tells it), when the motion has no frame or
/// no node, when a position is not finite, when an overlay is neither empty nor as long as the
/// clip, or when the caption is not UTF-8.
[[nodiscard]] Result<std::string> draw_strip(const SkeletonMotion& motion,
                                             const StripOverlay& overlay,
                                             const StripSettings& settings);

/// A motion, and how its strip is drawn on a page of several.
struct MotionStrip {
  SkeletonMotion motion;   ///< the figure that moves
  StripOverlay overlay;    ///< its marks and its caption, which stands below it
  StripSettings settings;  ///< its poses and its view; all strips of a page have the same width
};

/// The most strips that a page may have.
inline constexpr std::size_t kPageMaxStrips = 12;

/// Several strips under each other on one page, from top to bottom in their order: each with its
/// floor line, its times and its caption, one metre as long in each, and one legend and one scale
/// bar for all. The page of one strip is that of `draw_strip`.
///
/// Fails as `draw_strip` does, with the strip's place in front of the message ("strip 2: …",
/// counted from 1); where there is no strip or more than kPageMaxStrips; and where the settings
/// differ in `width_mm`, which is the page's.
[[nodiscard]] Result<std::string> draw_strips(const std::vector<MotionStrip>& strips);

}  // namespace shigusa
