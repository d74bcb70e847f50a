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

// How draws come out.
enum class DrawMode {
  random,   // by the seed
  lowest,   // at the low end of each range
  highest,  // at the high end
};

// The numbers that a draw depends on, and how it comes out.
struct DrawSource {
  std::uint64_t seed = 0;
  std::uint64_t task = 0;
  std::uint64_t person = 0;  // that what stands under "character" is drawn by
  DrawMode mode = DrawMode::random;
  std::size_t alternative = 0;  // of each choice, in the modes that are not random
};

// The task that a drawn template has come to so far, for draws that depend on a body: its
// "character", and of a goal its effector.
using TaskOfDraws = std::function<Result<Task>(const Json& character, const Json& goal)>;

// A kind of draw: a JSON object {word: argument} in a value's place.
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

// Whether a JSON value is a draw: an object that has one of their words.
[[nodiscard]] bool is_draw(const Json& value);

// Fails on draws within a template whose arguments are wrong; `place` is the template's.
[[nodiscard]] Result<void> check_draws(const Json& value, const std::string& place);

// The most alternatives that a choice within it has, 1 without any.
[[nodiscard]] std::size_t most_alternatives(const Json& value);

// The template with a value in each draw's place. Characters are drawn before all else, and of them
// sex and stature first.
[[nodiscard]] Result<Json> drawn(const Json& task, const DrawSource& source,
                                 const TaskOfDraws& task_of);

// The stature (m) that `percent` of a hundred people of a sex do not exceed: a normal distribution
// on either side of the median, through the three percentiles that stature_percentile has.
[[nodiscard]] double stature_at(double percent, Sex sex);

}  // namespace shigusa
