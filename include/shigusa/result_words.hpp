// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/request.hpp>
#include <shigusa/vec3.hpp>
#include <shigusa/verdict.hpp>
#include <span>
#include <string>
#include <string_view>

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

}  // namespace shigusa
