// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/cost.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Weights of frames at even times in a mean over time: those of the trapezoidal rule, of sum 1.
[[nodiscard]] std::vector<double> time_weights(std::size_t frames);

// The courses of scores over frames; empty if no frame has one.
[[nodiscard]] std::optional<PostureCourse> reba_course(std::span<const FrameCost> frames);
[[nodiscard]] std::optional<PostureCourse> rula_course(std::span<const FrameCost> frames);

// The courses of the parts that the body has; `frame_time` in s.
[[nodiscard]] std::vector<ZoneCourse> zone_courses(std::span<const FrameCost> frames,
                                                   double frame_time, const Ergonomics& ergonomics);

// The course of L5/S1; empty if no frame has a moment.
[[nodiscard]] std::optional<BackCourse> back_course(std::span<const FrameCost> frames,
                                                    const Ergonomics& ergonomics);

}  // namespace shigusa
