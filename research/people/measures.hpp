// SPDX-License-Identifier: MIT
#pragma once

#include "record.hpp"

namespace shigusa::bench {

// Measures of one reach by itself.
struct Looks {
  double trunk = 0.0;       // rad, at the end: from hips to shoulders, against the vertical
  double knee = 0.0;        // rad, at the end: mean flexion of the knees
  double drop = 0.0;        // m, by how much the pelvis ends lower
  double back = 0.0;        // m, by how much it ends further back
  double path_ratio = 0.0;  // the hand's path over the distance
  double bow = 0.0;         // m, forwards: where the hand is farthest from its straight line
  double peak_speed = 0.0;  // m/s, of the hand
  double peak_time = 0.0;   // of that, as a share of the duration
};
[[nodiscard]] Looks looks_of(const Track& track);

// rad: from hips to shoulders, against the vertical; more than 0 where it leans forwards.
[[nodiscard]] double trunk_lean(const Joints& joints);
// rad: mean flexion of the knees.
[[nodiscard]] double mean_knee(const Joints& joints);
// How far in front of its straight line a joint is (m) where it is farthest from that.
[[nodiscard]] double forward_bow(const Track& track, Joint joint);

// How far two reaches are apart; moments are those of equal shares of the duration. Of angles it is
// the root mean square over time of each freedom, averaged over the freedoms.
struct Apart {
  double final_place = 0.0;   // m, mean of right shoulder, elbow, hip and knee at the end
  double nine = 0.0;          // rad, of the right side's nine freedoms of the paper's table 1
  double paper_angles = 0.0;  // rad, of the same nine with a trunk without joints
  double all = 0.0;           // rad, of all freedoms of the body
};
[[nodiscard]] Apart apart(const Recorded& reach, const Track& generated);

// Of two recorded reaches of one man, each in the world of its own feet.
[[nodiscard]] Apart apart(const Recorded& a, const Recorded& b);

// Mean over the chosen freedoms of the root mean square (rad) of their differences over time.
[[nodiscard]] double angle_difference(const Clip& recorded, const Clip& generated,
                                      const std::vector<bool>& chosen);

}  // namespace shigusa::bench
