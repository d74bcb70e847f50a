// SPDX-License-Identifier: MIT
#pragma once

#include "robot_joints.hpp"

namespace shigusa {

// Names a robot's joints as a person's freedoms, by the axes that they turn about: fills part,
// freedom, sign and usual. Borrows both.
class JointNamer {
 public:
  JointNamer(const Robot& robot, const PlacedRobot& placed) : robot_(robot), placed_(placed) {}

  void name_spine(std::vector<PersonJoint>& joints) const;
  void name_neck(std::vector<PersonJoint>& joints) const;
  // `side`: 0 left, 1 right; `begins` must be known.
  void name_leg(PersonLimb& leg, std::size_t side) const;
  // `upper_arm`, `forearm`: m, world, the ways along them.
  void name_arm(PersonLimb& arm, std::size_t side, const Vec3d& upper_arm,
                const Vec3d& forearm) const;

 private:
  struct Part;

  // Gives the part's joints the freedoms that their axes are nearest to, the clearest first.
  void name_part(std::vector<PersonJoint>& joints, const Part& part) const;
  // An elbow that has one axis across the arm bends about it, however the arm lies; which way, its
  // limits tell.
  void bend_by_hinge(PersonLimb& arm) const;
  // Spine and neck: up to three joints of different freedoms are one part.
  void name_trunk(std::vector<PersonJoint>& joints, bool neck) const;

  const Robot& robot_;
  const PlacedRobot& placed_;
};

}  // namespace shigusa
