// SPDX-License-Identifier: MIT
#pragma once

#include "robot_joints.hpp"

namespace shigusa {

// Assigns a robot's joints to a person's degrees of freedom by their axes: sets part, freedom, sign
// and usual. Borrows both.
class JointNamer {
 public:
  JointNamer(const Robot& robot, const PlacedRobot& placed) : robot_(robot), placed_(placed) {}

  void name_spine(std::vector<PersonJoint>& joints) const;
  void name_neck(std::vector<PersonJoint>& joints) const;
  // `side`: 0 left, 1 right; `begins` must be known.
  void name_leg(PersonLimb& leg, std::size_t side) const;
  // `upper_arm`, `forearm`: m, world, vectors along them.
  void name_arm(PersonLimb& arm, std::size_t side, const Vec3d& upper_arm,
                const Vec3d& forearm) const;

 private:
  struct Part;

  // Gives the part's joints the degrees of freedom with the nearest axes, the clearest first.
  void name_part(std::vector<PersonJoint>& joints, const Part& part) const;
  // Treats the single axis of an elbow across the arm as flexion, whatever the arm's direction; the
  // limits determine the sign.
  void bend_by_hinge(PersonLimb& arm) const;
  // Names joints of spine and neck: up to three joints with different axes form one part.
  void name_trunk(std::vector<PersonJoint>& joints, bool neck) const;

  const Robot& robot_;
  const PlacedRobot& placed_;
};

}  // namespace shigusa
