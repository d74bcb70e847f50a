// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "dynamics/contact_forces.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A human with heels, bent by that angle about the right toes, standing still.
struct Standing {
  const PosedBody posed = human_body({.heels = true});
  std::vector<double> angles{posed.home.angles.begin(), posed.home.angles.end()};
  std::vector<double> tau;
  std::vector<double> whole;  // torques of the joints if the base bore everything
  Kinematics<double> kinematics{posed};
  Wrench<double> ground;

  explicit Standing(double toes) : tau(angles.size()), whole(tau) {
    angles[static_cast<std::size_t>(posed.body.feet()[0].heel->toes)] = toes;
    forward_kinematics<double>(posed, angles, kinematics);
    DynamicsWorkspace<double> work(posed);
    const std::vector<double> still(angles.size());
    ground = inverse_dynamics<double>(posed, kinematics, {still, still}, work, whole);
    tau = whole;
    bear_on_feet<double>(posed, kinematics, angles, ground, tau);
  }
  [[nodiscard]] double torque(const char* name) const {
    return tau[static_cast<std::size_t>(posed.body.find_dof(name).value())];
  }
};

TEST(Heels, ThatAreDownLeaveTheToesNothingToDo) {
  const Standing flat(0.0);
  EXPECT_EQ(flat.torque("right_toes.flexion"), 0.0);
  EXPECT_EQ(flat.torque("left_toes.flexion"), 0.0);
  // and the other joints need the torques of feet without toes
  const PosedBody posed = human_body();
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  DynamicsWorkspace<double> work(posed);
  const std::vector<double> still(posed.body.dofs().size());
  std::vector<double> tau(still);
  const Wrench<double> ground =
      inverse_dynamics<double>(posed, kinematics, {still, still}, work, tau);
  bear_on_feet<double>(posed, kinematics, posed.home.angles, ground, tau);
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    EXPECT_NEAR(flat.torque(posed.body.dof(d).name.c_str()), tau[static_cast<std::size_t>(d)], 1e-9)
        << posed.body.dof(d).name;
  }
}

// The moment of the floor's force on the first forefoot, about the hinge, equals the toes' torque.
TEST(Heels, ThatAreLiftedLoadTheToesByTheFloorsMoment) {
  const Standing tiptoe(radians(25.0));
  const Foot& first = tiptoe.posed.body.feet()[0];
  std::vector<double> tau = tiptoe.whole;
  const Wrench<double> part = share_ground_wrench<double>(tiptoe.posed.body, tiptoe.kinematics,
                                                          tiptoe.angles, tiptoe.ground, tau);
  const Wrench<double> own{tiptoe.ground.force - part.force, tiptoe.ground.moment - part.moment};
  const auto toes = static_cast<std::size_t>(first.heel->toes);
  const Vec3d hinge = tiptoe.kinematics.origin[toes];
  const Vec3d about = own.moment - cross(hinge, own.force);
  // the forefoot's own weight rests on the floor
  const MassProperties& mass = tiptoe.posed.body.link_mass(kBaseLink);
  const Vec3d weight = cross(tiptoe.kinematics.point(kBaseLink, mass.com) - hinge,
                             Vec3d{0, -mass.mass * kGravity, 0});
  EXPECT_NEAR(tiptoe.torque("right_toes.flexion"),
              dot(tiptoe.kinematics.axis[toes], about + weight), 1e-9);
}

TEST(Heels, MoveTheMiddleOfWhatBearsToTheForefoot) {
  const Standing flat(0.0);
  const Standing half(0.5 * kHeelLifts);
  const Standing tiptoe(radians(25.0));
  const auto centre = [](const Standing& s) {
    return bearing_centre<double>(s.posed.body.feet()[0], s.kinematics, s.angles);
  };
  const Foot& foot = flat.posed.body.feet()[0];
  EXPECT_LT(norm(centre(flat) - flat.kinematics.point(kBaseLink, foot.centre)), 1e-15);
  EXPECT_LT(norm(centre(tiptoe) - flat.kinematics.point(kBaseLink, foot.heel->forefoot_centre)),
            1e-15);
  EXPECT_LT(norm(centre(half) - (centre(flat) + centre(tiptoe)) * 0.5), 1e-12);
}

}  // namespace
}  // namespace shigusa
