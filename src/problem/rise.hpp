// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

namespace shigusa {

// Trunk's lean and mean flexion of the knees (rad) up to which a person counts as standing; legs
// almost as long as straight ones do too, whatever their knees.
inline constexpr double kStandsLean = radians(20.0);
inline constexpr double kStandsKnees = radians(20.0);
// Least duration (s) of a motion that begins bent: recorded rises from a squat or a stoop take 1.1
// s with a standard deviation of 0.18 s (docs/people.md).
inline constexpr double kRiseTime = 1.1;

// The change (dofs, rad) from a bent state to standing upright on the feet as they are placed: legs
// almost straight, the pelvis level over the ankles and facing as the feet do, the back without
// twist and side bend. Postures of motions are relative to that. Empty for a person who stands, who
// sits, and for bodies without legs, and where the feet do not permit it.
[[nodiscard]] std::vector<double> rise_of(const BodyModel& body, const CriteriaContext& context);

}  // namespace shigusa
