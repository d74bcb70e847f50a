// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/ergonomics.hpp>
#include <tuple>

#include "core/field.hpp"

namespace shigusa {

// Bounds of recurrences (1/min), ages (years) and the back muscles' lever (m).
inline constexpr double kRecursMost = 1000.0;
inline constexpr double kAgeMost = 120.0;
inline constexpr double kLeverLeast = 0.02;
inline constexpr double kLeverMost = 0.10;

// The fields of thresholds.
template <>
inline constexpr FieldTable kFields<PostureThresholds>{
    "posture_thresholds",
    "Thresholds that REBA and RULA leave open; a border belongs to the better band.",
    std::tuple{
        Field{"upright_rad",
              &PostureThresholds::upright,
              "Trunk that counts as upright; 5°.",
              {.high = kPi}},
        Field{"straight_wrist_rad",
              &PostureThresholds::straight_wrist,
              "Wrist that counts as neutral in RULA; 5°.",
              {.high = kPi}},
        Field{"neck_extends_rad",
              &PostureThresholds::neck_extends,
              "Neck beyond which it is extended; 5°.",
              {.high = kPi}},
        Field{"trunk_aside_rad",
              &PostureThresholds::trunk_aside,
              "Trunk bent sideways or twisted beyond this; 10°.",
              {.high = kPi}},
        Field{"neck_aside_rad",
              &PostureThresholds::neck_aside,
              "Neck bent sideways or twisted beyond this; 15°.",
              {.high = kPi}},
        Field{"arm_abducted_rad",
              &PostureThresholds::arm_abducted,
              "Upper arm abducted beyond this; 30°.",
              {.high = kPi}},
        Field{"shoulder_raised_m",
              &PostureThresholds::shoulder_raised,
              "Shoulder raised by more than this; 0.025.",
              {.high = 1.0}},
        Field{"wrist_deviates_rad",
              &PostureThresholds::wrist_deviates,
              "Hand bent sideways beyond this; 10°.",
              {.high = kPi}},
        Field{"forearm_end",
              &PostureThresholds::forearm_end,
              "Share of the forearm's range at either end that is its end; 0.25.",
              {.high = 0.5}},
        Field{"one_foot",
              &PostureThresholds::one_foot,
              "Share of the weight above which one foot bears it; 0.75.",
              {.low = 0.5, .high = 1.0}},
        Field{"gravity_helps_rad",
              &PostureThresholds::gravity_helps,
              "Upper arm that hangs so near to the vertical is helped by gravity in REBA; 20°.",
              {.high = kPi}},
        Field{"hand_across_m",
              &PostureThresholds::hand_across,
              "Wrist beyond the middle of the trunk that works across it in RULA; 0.",
              {.high = 1.0}},
        Field{"hand_out_m",
              &PostureThresholds::hand_out,
              "Wrist outside its shoulder that works out to the side in RULA; 0.1.",
              {.high = 1.0}},
    }};

// The fields of what a motion does not tell.
template <>
inline constexpr FieldTable kFields<Ergonomics>{
    "ergonomics", "What a motion does not tell, for what it costs the body.",
    std::tuple{
        Field{"coupling", &Ergonomics::coupling,
              "Grip on the load: good, when not given, fair, poor or, in REBA, unacceptable."},
        Field{"held", &Ergonomics::held,
              "true: a part of the body is held for more than a minute."},
        Field{"repeated", &Ergonomics::repeated,
              "true: small-range actions recur more than 4 times a minute."},
        Field{"rapid", &Ergonomics::rapid,
              "true: rapid large changes of posture, or an unstable base."},
        Field{"shock", &Ergonomics::shock, "true: forces build up rapidly."},
        Field{
            "lifts_per_min",
            &Ergonomics::lifts_per_min,
            "Recurrence of each lift of the motion, lifts a minute; 0.2, the least of the lifting "
            "equation, when not given.",
            {.high = kRecursMost}},
        Field{"lifting_time", &Ergonomics::lifting_time,
              "Duration of lifting in a shift with its rests: short, up to 1 h, when not given, "
              "moderate, up to 2 h, or long, up to 8 h."},
        Field{"placed_with_care", &Ergonomics::placed_with_care,
              "Whether lifts end with control, so that both ends count; true when not given."},
        Field{"moves_per_min",
              &Ergonomics::moves_per_min,
              "Recurrence of the motion a minute, for EN 1005-4; when not given, postures that are "
              "held for 4 s alone are judged.",
              {.high = kRecursMost}},
        Field{"age_years",
              &Ergonomics::age,
              "For the limit of compression at L5/S1 by age and sex; none when not given.",
              {.high = kAgeMost}},
        Field{"sex", &Ergonomics::sex, "For that limit; the character's when not given."},
        Field{"back_lever_m",
              &Ergonomics::back_lever,
              "Of the back's muscles about L5/S1; 0.05 when not given, texts have up to 0.07.",
              {.low = kLeverLeast, .high = kLeverMost}},
        Field{"rula_edition", &Ergonomics::rula_edition,
              "Of RULA's table A: present, when not given, or older."},
        Field{"thresholds", &Ergonomics::thresholds, "Where REBA and RULA name none."},
    }};

}  // namespace shigusa
