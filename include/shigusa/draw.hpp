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

/// A limb of the figure, to be accented.
enum class Limb {
  left_arm,   ///< the figure's left arm
  right_arm,  ///< the figure's right arm
  left_leg,   ///< the figure's left leg
  right_leg,  ///< the figure's right leg
};

/// Largest number of poses in a strip.
inline constexpr int kStripMaxPoses = 60;

/// An object beside the figure, such as a table: the convex hull of spheres of one radius.
struct StripThing {
  /// Centres of the spheres. Eight centres with radius 0 are a box, drawn with its edges: bit 0 of
  /// index k selects the far side along the box's first direction, bit 1 and bit 2 those along the
  /// second and third.
  std::vector<Vec3d> corners;
  double radius = 0.0;  ///< radius of the spheres, in the skeleton's unit
  /// (frames) X_WT of a thing that moves, whose corners are along its own axes; empty: it stays.
  std::vector<Transformd> poses{};
};

/// A part of a motion with a name.
struct StripAction {
  std::string name{};          ///< UTF-8 text below the pose with which it begins
  int first = 0;               ///< frame in which it begins
  int last = 0;                ///< frame in which it ends
  std::vector<Vec3d> goals{};  ///< goals, drawn in its poses
};

/// Marks drawn beside the figure; positions are in the skeleton's world and unit.
struct StripOverlay {
  /// Objects drawn behind the figure in every pose, clipped far beyond it; edges in front of the
  /// figure are drawn over it again. Those that move are drawn before or behind its limbs.
  std::vector<StripThing> things;
  std::vector<Vec3d> goals;  ///< goals, drawn as ringed crosses in every pose
  /// (frames) centre of mass, drawn as a quartered disc with its plumb line; may be empty.
  std::vector<Vec3d> centre_of_mass;
  std::vector<Vec3d> hand_path;  ///< (frames) path of the hand, drawn up to each pose; may be empty
  std::string caption;           ///< UTF-8 text below the strip, in DejaVu Sans; may be empty
  /// Parts of the motion, in their order; the path of the hand is then drawn from the beginning of
  /// the present one.
  std::vector<StripAction> actions{};
};

/// Settings of a strip figure.
struct StripSettings {
  int poses = 7;  ///< number of poses, 1 to kStripMaxPoses, equally spaced in time from first_frame
                  ///< to last_frame
  int first_frame = 0;  ///< first frame drawn; time labels count from here
  int last_frame = -1;  ///< last frame drawn; -1: the clip's last
  /// Frames of the poses, ascending, at most kStripMaxPoses, in place of the three above; empty:
  /// those.
  std::vector<int> frames{};

  double width_mm = 170.0;  ///< width of the page; the height follows

  /// Direction of the viewer: 0 in front, positive towards the figure's right.
  double azimuth_deg = 50.0;
  double elevation_deg = 10.0;  ///< elevation of the viewer above the horizon
  Vec3d up{0, 1, 0};            ///< upward direction of the skeleton's world, non-zero
  /// Direction that the figure faces; empty: that of the hips in the first pose, else +Z (+X when
  /// up is Z).
  std::optional<Vec3d> facing;
  /// Height of the floor along `up`; empty: 0, or the lowest node drawn if that is further than a
  /// tenth of the figure's size from 0.
  std::optional<double> floor;

  double metres_per_unit = 1.0;         ///< length of the skeleton's unit, for the scale bar
  std::optional<HumanoidMap> humanoid;  ///< bones of the figure; empty: found by their VRM names
  std::vector<Limb> accented{Limb::right_arm};  ///< limbs in the accent colour
};

/// Infers the settings that a motion file does not state: the humanoid bones, from names and shape,
/// and for a complete person the up axis and the unit, measured in settings.first_frame. A
/// `stature` (m, 0.5 to 2.5) scales the figure to that height. Returns an empty text for a complete
/// person, else the reason why the figure is not one; such a figure is drawn unchanged with +Y up,
/// in metres, or in centimetres if metres would make it taller than any person. Fails on a stature
/// out of range.
[[nodiscard]] Result<std::string> understand_figure(const SkeletonMotion& motion,
                                                    std::optional<double> stature,
                                                    StripSettings& settings);

/// Draws a strip figure as in the paper's figures 4 to 7: a motion as poses from left to right over
/// time on one floor line, in parallel projection, as SVG. The same input gives the same bytes in
/// every build.
///
/// Limbs, trunk, head and feet are drawn anatomically where the humanoid bones are known; other
/// nodes are drawn as plain bones, darker near the viewer. A figure that stays within half its size
/// of one place is drawn relative to its feet, so that planted feet stand still from pose to pose;
/// one that travels further is centred on its hips in each pose. Poses never overlap: their spacing
/// is that of the widest neighbours, and the scale fills the width. A goal too far away for its
/// slot becomes an arrow towards it.
///
/// Fails when a setting is out of range (the message states the range), when the motion has no
/// frame or no node, when a position is not finite, when a non-empty overlay differs in length from
/// the clip, or when the caption is not UTF-8.
[[nodiscard]] Result<std::string> draw_strip(const SkeletonMotion& motion,
                                             const StripOverlay& overlay,
                                             const StripSettings& settings);

/// One strip of a page of several.
struct MotionStrip {
  SkeletonMotion motion;   ///< the figure that moves
  StripOverlay overlay;    ///< its marks and its caption
  StripSettings settings;  ///< its poses and view; width_mm must be equal in all strips of a page
};

/// Largest number of strips on a page.
inline constexpr std::size_t kPageMaxStrips = 12;

/// Draws several strips below each other on one page, in order: each with its floor line, times and
/// caption, at one common scale, with one legend and one scale bar. For one strip it equals
/// draw_strip.
///
/// Fails as draw_strip does, with the number of the strip, from 1, in front of the message ("strip
/// 2: …"); without a strip or with more than kPageMaxStrips; and where the settings differ in
/// `width_mm`.
[[nodiscard]] Result<std::string> draw_strips(const std::vector<MotionStrip>& strips);

}  // namespace shigusa

/// Texts that describe results in words, for tables and pages.
namespace shigusa {

/// A name in plain words: "right hand" for "right_hand", "right ankle (inversion)" for
/// "right_ankle.inversion".
[[nodiscard]] std::string part_words(std::string_view name);

/// A distance in a readable unit: "8 mm", "12 cm", "1.25 m". `metres` ≥ 0.
[[nodiscard]] std::string length_words(double metres);

/// A sufficient duration, rounded up to tenths of a second: "1.3 s" for 1.21 s.
[[nodiscard]] std::string enough_words(double seconds);

/// A position (m, world) relative to the body at its start: "0.25 m left, 0.55 m up, 0.5 m ahead"
/// for (0.25, 0.55, 0.5). Coordinates of 0 are left out, and the floor is named.
[[nodiscard]] std::string place_words(const Vec3d& place);

/// The name of a kind of actions: "grasp", "wait".
[[nodiscard]] std::string_view action_name(ActionKind kind);

/// An action in words: "grasp the box", "place the box at 0.9 m up, 0.45 m ahead", "wait for 2 s",
/// "stand", "right hand to 1.2 m up".
[[nodiscard]] std::string action_words(const Action& action);

/// A goal in words: "right hand to 0.25 m left, 0.55 m up, 0.5 m ahead, holding 5 kg".
[[nodiscard]] std::string goal_words(const Goal& goal);

/// A request's goals or actions, and its contacts, in words: "right hand to 0.2 m up; standing on
/// the left foot".
[[nodiscard]] std::string asked_words(const Request& request);

/// The actions as a title: "Grasp the box, place the box, stand".
[[nodiscard]] std::string actions_title(std::span<const Action> actions);

/// The goals as a title: "Right hand low in front on the left", "Both hands overhead". Heights are
/// judged relative to the `stature` (m).
[[nodiscard]] std::string goals_title(std::span<const Goal> goals, double stature);

/// The quantity that a built-in criterion measures, such as "quick starts and stops" for
/// "joint_acceleration"; any other name is returned unchanged.
[[nodiscard]] std::string criterion_words(std::string_view name);

/// A verdict as a sentence: "Strains: some of this build could.", "Impossible so fast: 2.1 s would
/// do."
[[nodiscard]] std::string verdict_sentence(const Judgement& judgement);

/// A reason as a sentence with plain names: "The right ankle (flexion) needs 715 N·m at 0.11 s, 7.9
/// times its strength of 90."
[[nodiscard]] std::string reason_sentence(const Reason& reason);

/// Largest number of candidates on a page, over all its results.
inline constexpr std::size_t kPageMostCandidates = 2000;
/// Largest number of poses of a motion on a page, or of each action of a piece of work; poses
/// between them are interpolated linearly.
inline constexpr int kPagePoses = 61;

/// A result on a page. It refers to the task and the motions, which must outlive it.
struct ShownResult {
  const Task& task;                  ///< task of the motions
  const GenerateResult& generation;  ///< motions from generate or replay_all
  std::string title{};               ///< UTF-8; empty: the goals in words (goals_title)
};

/// Makes one self-contained HTML page of results: a section for each, with the request in words and
/// its candidates as animated figures with verdict and score; numbers can be unfolded. The page
/// loads no other file, works from disk, respects the reader's settings for dark mode and reduced
/// motion, and is operable by keyboard. A small script draws the figures from points in whole
/// millimetres. Texts from files and titles are escaped; bytes that are not UTF-8 are replaced.
/// Same results, same bytes. Fails on more than kPageMostCandidates candidates.
[[nodiscard]] Result<std::string> motion_page(std::span<const ShownResult> results,
                                              std::string_view heading = {});

/// Draws the strip figures of the first candidate of each result on one SVG page, with the titles
/// as captions. Fails as draw_strips does.
[[nodiscard]] Result<std::string> result_strips(std::span<const ShownResult> results);

}  // namespace shigusa
