// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace shigusa {

// When a motion changes its posture, and by what line its effectors go. S is double, or a pack
// whose lanes are motions of their own.
template <class S>
struct Timing {
  S delay{};  // share of the duration after which the posture begins to change
  S bow{};    // share of the path's length, see ReachGoal::bow
  S skew{};   // of the bow towards the start (> 0) or the end, see path_bow
  S sway{};   // share of the path's length sideways, see ReachGoal::sway

  friend bool operator==(const Timing&, const Timing&) = default;
};

// One of these numbers.
struct TimingNumber {
  std::string_view name;      // "bow"
  double low;                 // the least that is allowed
  double high;                // the most that is allowed
  double searched_low;        // the least that searches try
  double searched_high;       // the most that searches try
  bool searched;              // by the usual searches; the others leave it at 0
  std::string_view sentence;  // what it does
};

inline constexpr double kDelayMax = 0.5;  // share of the duration
// Of the path's length, what a path may leave its line by: by its bow forwards or (< 0) backwards,
// by its sway outwards or inwards. People's reaches leave it by a tenth to a fifth.
inline constexpr double kBowMax = 0.3;
// By so much of it searches let a path leave its line.
inline constexpr double kBowSearched = 0.2;

// All of them; whatever reads, writes, searches or shows a timing goes by this table.
inline constexpr std::array kTimingNumbers{
    TimingNumber{"delay", 0.0, kDelayMax, 0.0, kDelayMax, false,
                 "The posture begins to change after this share of the duration."},
    TimingNumber{"bow", -kBowMax, kBowMax, -kBowSearched / 2.0, kBowSearched, true,
                 "The paths leave their line forwards by this share of their length."},
    TimingNumber{"skew", -1.0, 1.0, -1.0, 1.0, false,
                 "The bow lies nearer to the start (above 0) or to the end."},
    TimingNumber{
        "sway", -kBowMax, kBowMax, -kBowSearched, kBowSearched, true,
        "The paths leave their line sideways by this share of their length, outwards above 0."},
};
// Number of them.
inline constexpr std::size_t kTimings = kTimingNumbers.size();
// Where they are, in the table's order.
template <class S>
inline constexpr std::array<S Timing<S>::*, kTimings> kTimingMembers{
    &Timing<S>::delay, &Timing<S>::bow, &Timing<S>::skew, &Timing<S>::sway};

}  // namespace shigusa
