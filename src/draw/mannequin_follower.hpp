// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

#include "mannequin_mesh.hpp"

namespace shigusa {

// A bone that no body has and that its skin wants: it turns by a part of what a joint does, so that
// skin neither folds nor wrings.
struct MannequinFollower {
  SkinBone::Kind kind = SkinBone::Kind::half;
  int joint = -1;  // the body's node
  Quatd turn{};    // of the joint, unturned, from a hanging limb
  Quatd above{};   // of the bone above from hanging
  Vec3d down{};    // unit vector: where a hanging limb points

  // Its rotation by the joint's, both in the joint's parent.
  [[nodiscard]] Quatd follow(const Quatd& joint_turn) const;

 private:
  [[nodiscard]] Quatd untwisted(const Quatd& turn, double share) const;
};

// The bend of a finger's bone (rad) in a hand that is so closed: -1 open, 0 relaxed, 1 in a grip.
[[nodiscard]] double finger_bend(const SkinBone& finger, double closed);

// How closed a hand that reaches is at a share of the motion's time: it opens on the way and closes
// at the end.
[[nodiscard]] double hand_closed(double share);

// The turn about a unit axis by an angle (rad).
[[nodiscard]] Quatd axis_turn(const Vec3d& axis, double angle);

}  // namespace shigusa
