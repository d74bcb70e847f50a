// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <shigusa/criteria.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <string_view>
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

/// Results in words, as tables and pages tell them to a person.
namespace shigusa {

/// "right hand" of "right_hand", "right ankle (inversion)" of "right_ankle.inversion".
[[nodiscard]] std::string part_words(std::string_view name);

/// A distance in the unit that it is best read in: "8 mm", "12 cm", "1.25 m". `metres` ≥ 0.
[[nodiscard]] std::string length_words(double metres);

/// A duration that is enough, in tenths of a second, rounded up: "1.3 s" of 1.21 s.
[[nodiscard]] std::string enough_words(double seconds);

/// A place as the body at its start sees it: "0.25 m left, 0.55 m up, 0.5 m ahead" of (0.25, 0.55,
/// 0.5) m. Coordinates of 0 are left out, and the floor is named.
[[nodiscard]] std::string place_words(const Vec3d& place);

/// "right hand to 0.25 m left, 0.55 m up, 0.5 m ahead, holding 5 kg".
[[nodiscard]] std::string goal_words(const Goal& goal);

/// All that is asked of effectors and feet: "right hand to 0.2 m up; standing on the left foot".
[[nodiscard]] std::string asked_words(const Request& request);

/// The goals as a title: "Right hand low in front on the left", "Both hands overhead". Heights are
/// told beside the `stature` (m).
[[nodiscard]] std::string goals_title(std::span<const Goal> goals, double stature);

/// The thing that a criterion counts, "quick starts and stops" of "joint_acceleration"; of a
/// criterion of the user's own its name.
[[nodiscard]] std::string criterion_words(std::string_view name);

/// A verdict as a sentence: "Strains: some of this build could.", "Impossible so fast: 2.1 s would
/// do."
[[nodiscard]] std::string verdict_sentence(const Judgement& judgement);

/// A reason as a sentence with the parts' plain names: "The right ankle (flexion) needs 715 N·m at
/// 0.11 s, 7.9 times its strength of 90."
[[nodiscard]] std::string reason_sentence(const Reason& reason);

/// The most candidates that a page shows, of all its results together.
inline constexpr std::size_t kPageMostCandidates = 2000;
/// The most poses of a motion that a page holds; between them it draws on a straight way.
inline constexpr int kPagePoses = 61;

/// A result that a page shows. Borrows task and motions.
struct ShownResult {
  const Task& task;                  ///< that the motions were found for
  const GenerateResult& generation;  ///< the motions, as generate or replay_all gives them
  std::string title{};               ///< UTF-8; empty: the goals in words (goals_title)
};

/// HTML that shows results on one page, complete in itself: a section for each, with the sentence
/// of what was asked and its candidates as moving figures, each with its verdict and its score in
/// words, and the numbers to unfold. The page asks for no other file, works from a disk, follows
/// the reader's choice of light or dark and of less motion, and is operable by keyboard. It is
/// drawn by a small script from the figure's points in whole millimetres. Texts from files and
/// titles stand in it escaped; what is not UTF-8 is replaced. Same results, same bytes. Fails where
/// there are more candidates than kPageMostCandidates.
[[nodiscard]] Result<std::string> motion_page(std::span<const ShownResult> results,
                                              std::string_view heading = {});

/// The strip figure of the first candidate of each result under each other as SVG, with the titles
/// as captions. Fails as draw_strips does.
[[nodiscard]] Result<std::string> result_strips(std::span<const ShownResult> results);

}  // namespace shigusa
