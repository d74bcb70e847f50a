// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string_view>

namespace shigusa {

/// A person's way of moving in a few numbers, none of which is a place. The default is that of most
/// people; score.hpp has learn_habit, which measures one in a recorded motion.
struct Habit {
  /// Flexion of the knees over the lean of a far leaning trunk, 0..kHabitKneesMost. People keep
  /// their own ratio at all low heights (R. Burgess-Limerick and B. Abernethy, Human Factors 39
  /// (1997) 141).
  double knees = 1.7;
  /// rad, bend of the back beside people's usual one with the pelvis tipped far,
  /// kHabitRoundLeast..kHabitRoundMost: below 0 a straight back.
  double round = 0.0;
  /// rad, angle by which the eyes look down from the head at a low goal, 0..kHabitEyesMost.
  double eyes = radians(15);
  /// Flexion of a free arm's elbow over the forward turn of its shoulder, 0..kHabitFreeArmMost.
  double free_arm = 0.6;

  /// Whether all numbers are equal.
  [[nodiscard]] bool operator==(const Habit&) const = default;
};
inline constexpr double kHabitKneesMost = 6.0;            ///< largest Habit::knees
inline constexpr double kHabitRoundLeast = radians(-30);  ///< smallest Habit::round, rad
inline constexpr double kHabitRoundMost = radians(40);    ///< largest Habit::round, rad
inline constexpr double kHabitEyesMost = radians(45);     ///< largest Habit::eyes, rad
inline constexpr double kHabitFreeArmMost = 2.0;          ///< largest Habit::free_arm

/// A habit with a name.
struct NamedHabit {
  std::string_view word;   ///< "squat"
  Habit habit;             ///< its numbers
  std::string_view about;  ///< one phrase
};
/// The habits that have a name; the first is the default.
inline constexpr std::array kHabits{
    NamedHabit{"natural", {}, "as most people"},
    NamedHabit{"half", {.knees = 1.0}, "knees bend as much as the trunk leans"},
    NamedHabit{"squat", {.knees = 3.1}, "knees bend much, the trunk stays up"},
    NamedHabit{"stoop", {.knees = 0.2}, "knees stay almost straight, the trunk leans"},
};

}  // namespace shigusa
