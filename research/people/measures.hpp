// SPDX-License-Identifier: MIT
#pragma once

#include "record.hpp"

namespace shigusa::bench {

// Measures of one reach by itself.
struct Looks {
  double trunk = 0.0;       // rad, at the end: from hips to shoulders, against the vertical
  double knee = 0.0;        // rad, at the end: mean flexion of the knees
  double drop = 0.0;        // m, descent of the pelvis from start to end
  double back = 0.0;        // m, backward travel of the pelvis
  double path_ratio = 0.0;  // the hand's path over the distance
  double bow = 0.0;         // m, largest forward deviation of the hand from its straight line
  double peak_speed = 0.0;  // m/s, of the hand
  double peak_time = 0.0;   // time of peak_speed, as a share of the duration
};
[[nodiscard]] Looks looks_of(const Track& track);

// rad: lean of the line from hips to shoulders against the vertical, positive forwards.
[[nodiscard]] double trunk_lean(const Joints& joints);
// rad: mean flexion of the knees.
[[nodiscard]] double mean_knee(const Joints& joints);
// Largest forward deviation (m) of a joint from its straight line.
[[nodiscard]] double forward_bow(const Track& track, Joint joint);

// Differences of two reaches at equal shares of the duration. For angles it is the root mean square
// over time of each degree of freedom, averaged over these.
struct Apart {
  double final_place = 0.0;   // m, mean of right shoulder, elbow, hip and knee at the end
  double nine = 0.0;          // rad, over the right side's nine dofs of the paper's table 1
  double paper_angles = 0.0;  // rad, of the same nine with a trunk without joints
  double all = 0.0;           // rad, over all dofs of the body
};
[[nodiscard]] Apart apart(const Recorded& reach, const Track& generated);

// Differences of two recorded reaches of one man, each relative to its own feet.
[[nodiscard]] Apart apart(const Recorded& a, const Recorded& b);

// Mean over the chosen degrees of freedom of the root mean square (rad) of their differences over
// time.
[[nodiscard]] double angle_difference(const Clip& recorded, const Clip& generated,
                                      const std::vector<bool>& chosen);

}  // namespace shigusa::bench
