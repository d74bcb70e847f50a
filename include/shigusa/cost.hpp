// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/ergonomics.hpp>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

/// Angles (rad) of the trunk, or of the head against the trunk; 0 in the body's neutral posture.
struct TrunkAngles {
  double flexion = 0.0;  ///< ahead above 0, in the sagittal plane
  double lateral = 0.0;  ///< out of the sagittal plane, to the left above 0
  double twist = 0.0;    ///< about the long axis, to the left above 0
};

/// Angles of an arm; empty where the body lacks the joints.
struct ArmAngles {
  /// rad, of the upper arm against the trunk in its sagittal plane, ahead above 0, at most 270°. An
  /// arm within 15° of the side has less and less of it, as the plane says nothing of it there.
  double flexion = 0.0;
  double abduction = 0.0;  ///< rad, of the upper arm out of that plane, away from the body above 0
  double elevation = 0.0;  ///< rad, of the upper arm from the vertical, hanging is 0
  double raised = 0.0;     ///< m, of the shoulder above neutral, along the chest
  double elbow = 0.0;      ///< rad, from straight
  double across = 0.0;   ///< m, of the wrist from the middle of the trunk, to its own side above 0
  double outside = 0.0;  ///< m, of the wrist outside its shoulder
  std::optional<double> wrist{};      ///< rad, flexion of the hand against the forearm
  std::optional<double> deviation{};  ///< rad, of the hand sideways
  std::optional<double> forearm{};    ///< share of the forearm's range of rotation, 0..1
};

/// Angles of a placed body as REBA, RULA and EN 1005-4 need them; empty where the body lacks the
/// joints. Neutral is the body's home or, where the trunk leans there by more than 20°, all angles
/// at 0.
struct PostureAngles {
  std::optional<TrunkAngles>
      trunk{};                        ///< line from the middle of the hips to C7, from the vertical
  std::optional<TrunkAngles> neck{};  ///< head against that line
  std::optional<double> head{};       ///< rad, inclination of the head from the vertical
  std::array<std::optional<ArmAngles>, 2> arms{};  ///< left, right
  std::array<std::optional<double>, 2> knees{};    ///< rad, left, right: from straight
  /// Share of the weight on the left foot, by the centre of mass; 1 or 0 if the other foot is off
  /// the floor; empty for a body without feet.
  std::optional<double> on_left{};
  bool sits = false;  ///< sits on both thighs
};

/// Measures the angles of a body at joint angles (dofs, rad).
[[nodiscard]] PostureAngles posture_angles(const BodyModel& body, const State& home,
                                           std::span<const double> angles);

}  // namespace shigusa
