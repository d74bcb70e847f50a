// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_build.hpp>
#include <shigusa/body_model.hpp>
#include <shigusa/landmarks.hpp>
#include <shigusa/message.hpp>
#include <string>
#include <vector>

namespace shigusa {

/// How much of the body moves (table 1 of the paper).
enum class BodyExtent {
  half,  ///< 9 dof: right ankle 1, knee 1, hip 3, shoulder 3, elbow 1; left limbs are mass
  full,  ///< 18 dof: both sides; both feet stay planted
  /// 45 dof, with the pelvis' six 51: spine, neck, clavicles, forearms, wrists and ankles' second
  /// freedom as well, as far as the landmarks tell of them
  human,
};
/// The words of BodyExtent.
template <>
inline constexpr std::array kEnumWords<BodyExtent>{
    EnumWord{BodyExtent::half, "half"},
    EnumWord{BodyExtent::full, "full"},
    EnumWord{BodyExtent::human, "human"},
};

/// How build_human makes a body.
struct HumanSettings {
  std::string name = "body";             ///< of the body
  BodyExtent extent = BodyExtent::full;  ///< how much of it moves
  double stature = 1.741;                ///< m
  double mass = 73.0;                    ///< kg
  Sex sex = Sex::male;                   ///< of the tables of masses and strengths
  Side base = Side::right;               ///< the foot that bears the body where both stand
  /// both feet stand, however high the one is above the other
  bool on_both = false;
  bool sits = false;  ///< on both thighs, see build_human; not of half extent
  /// Heels may lift: the body stands on its forefeet, and each foot turns about its toes' joint. Of
  /// extent human, standing.
  bool heels = false;
};

/// A lifted foot: its sole is more than this above the other's (m).
inline constexpr double kLiftedFoot = 0.05;

/// The body whose start posture has exactly these landmarks: their distances become the segment
/// lengths, masses come from the anthropometric tables by `mass` and `sex`. The trunk is rigid in
/// the shape of the start posture. The base is the foot of
/// settings.base, or the one that stands where the other does not (not of half extent). Where the
/// start posture lies outside a joint limit, that limit is widened to hold it, with a doubt. Half
/// extent: the left leg's mass moves as the right leg's translation, the left arm's with the trunk,
/// and leg strengths count for both legs (paper, section 3.1; each number in docs/paper_map.md).
/// A person who sits has the right thigh as the base, and the left one stands in a foot's place:
/// the pelvis tips over them and turns no further. The legs below are one piece with their thighs,
/// and where their soles are on the floor these are a part of what bears the body.
[[nodiscard]] BodyModel build_human(const Landmarks& landmarks, const HumanSettings& settings,
                                    std::vector<Message> doubts = {});

/// Each foot of the standing full body is turned out by this: 14° between the feet (McIlroy and
/// Maki, Clinical Biomechanics 12 (1997) 66-70). The half body's foot points straight ahead.
inline constexpr double kStandingToeOut = radians(7.0);

/// Makes the body of 9 freedoms, standing at ease (standing_landmarks).
[[nodiscard]] BodyModel half_body(const BodyBuild& stature = {});
/// Makes the body of 18 freedoms, standing at ease.
[[nodiscard]] BodyModel full_body(const BodyBuild& stature = {});
/// Makes the body of 45 freedoms, standing at ease.
[[nodiscard]] BodyModel human_body(const BodyBuild& stature = {});

}  // namespace shigusa
