// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <shigusa/human.hpp>
#include <shigusa/request.hpp>
#include <string>
#include <string_view>

#include "formats/json_text.hpp"

namespace shigusa {

// Evaluation of draws: random, or at an end of their ranges.
enum class DrawMode {
  random,   // by the seed
  lowest,   // at the low end of each range
  highest,  // at the high end
};

// Inputs of a draw, and its evaluation.
struct DrawSource {
  std::uint64_t seed = 0;
  std::uint64_t task = 0;
  std::uint64_t person = 0;  // random stream of values under "character"
  DrawMode mode = DrawMode::random;
  std::size_t alternative = 0;  // of each choice, in the modes that are not random
};

// The partially drawn task, for draws that depend on a body: its "character", and the effector of
// the goal.
using TaskOfDraws = std::function<Result<Task>(const Json& character, const Json& goal)>;

// A kind of draw, written as a JSON object {word: argument} in place of a value.
struct DrawInfo {
  std::string_view word;
  std::string_view form;  // of its argument
  std::string_view says;
};
inline constexpr std::array kDraws{
    DrawInfo{"uniform", "[low, high]", "A number between these, each as likely."},
    DrawInfo{"integer", "[low, high]", "A whole number from low to high, each as likely."},
    DrawInfo{"choice", "[value, …]",
             "One of these values, each as likely, or by \"shares\": [3, 1, …] beside it. Values "
             "may be draws themselves."},
    DrawInfo{"percentile", "[low, high]",
             "Of stature_m: the stature of a person of the sex, by its percentile (0.1 to 99.9)."},
    DrawInfo{"bmi", "[low, high]", "Of mass_kg: the body-mass index, with the stature (kg/m²)."},
    DrawInfo{"box_m", "[[x, y, z], [x, y, z]]", "A point of the box between two corners."},
    DrawInfo{"statures", "[[x, y, z], [x, y, z]]",
             "A point of the box between two corners in statures of the body."},
    DrawInfo{"surface_m", "{\"corner\": […], \"along\": [[…], […]]}",
             "A point of a parallelogram: a corner and its two sides."},
    DrawInfo{"reach", "[[x, y, z], [x, y, z]]",
             "Of a goal's position_m: a point of the box (m) that the goal's effector can get to."},
    DrawInfo{"rotation", "\"any\"", "Of rotation_xyzw: any rotation, each as likely."},
    DrawInfo{
        "beside", "{\"goal\": 0, \"offset_m\": […]}",
        "Of a goal's position_m: that of an earlier goal, and an offset, which may be a draw."},
};

// Whether a JSON value is a draw: an object with one of their words.
[[nodiscard]] bool is_draw(const Json& value);

// Validates the draws' arguments within a template; `place`: place of the template.
[[nodiscard]] Result<void> check_draws(const Json& value, const std::string& place);

// Largest number of alternatives of its choices, 1 without any.
[[nodiscard]] std::size_t most_alternatives(const Json& value);

// The template with drawn values. Characters are drawn first, beginning with sex and stature.
[[nodiscard]] Result<Json> drawn(const Json& task, const DrawSource& source,
                                 const TaskOfDraws& task_of);

// Percentile of stature (m) for a sex: a normal distribution on either side of the median, through
// the three percentiles of stature_percentile.
[[nodiscard]] double stature_at(double percent, Sex sex);

}  // namespace shigusa
