// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

#include "mannequin_mesh.hpp"

namespace shigusa {

// A helper bone of the skin that no body has: it follows a part of a joint's rotation, so that the
// skin neither folds nor twists.
struct MannequinFollower {
  SkinBone::Kind kind = SkinBone::Kind::half;
  int joint = -1;  // node of the body
  Quatd turn{};    // rotation of the joint at rest from a hanging limb
  Quatd above{};   // rotation of the bone above from hanging
  Vec3d down{};    // unit vector along a hanging limb

  // Its rotation from the joint's, both relative to the joint's parent.
  [[nodiscard]] Quatd follow(const Quatd& joint_turn) const;

 private:
  [[nodiscard]] Quatd untwisted(const Quatd& turn, double share) const;
};

// Bending angle (rad) of a finger's bone. `closed`: -1 open, 0 relaxed, 1 in a grip.
[[nodiscard]] double finger_bend(const SkinBone& finger, double closed);

// Closure of a reaching hand at a share of the motion's time: it opens on the way and closes at the
// end.
[[nodiscard]] double hand_closed(double share);

// Rotation about a unit axis by an angle (rad).
[[nodiscard]] Quatd axis_turn(const Vec3d& axis, double angle);

}  // namespace shigusa
