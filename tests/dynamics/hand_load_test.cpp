// SPDX-License-Identifier: MIT
#include "dynamics/hand_load.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Vector = std::vector<double>;

// A stooping human whose left hand is pressed by a force at a place.
class StoopingHuman : public testing::Test {
 protected:
  StoopingHuman() : angles(posed.home.angles.begin(), posed.home.angles.end()) {
    set("spine.flexion", 0.4);
    set("chest.flexion", 0.3);
    for (const char* side : {"left_", "right_"}) {
      set(std::string(side) + "hip.flexion", 0.9);
      set(std::string(side) + "knee.flexion", 0.7);
    }
    set("left_shoulder.flexion", 0.5);
    set("left_elbow.flexion", 0.8);
    kinematics = placed(posed, angles);
  }

  void set(const std::string& dof, double angle) {
    angles[static_cast<std::size_t>(posed.body.find_dof(dof).value())] = angle;
  }
  [[nodiscard]] int link(const char* dof) const { return posed.body.find_dof(dof).value(); }

  [[nodiscard]] HandLoad<double> load_on(int carrier) const {
    const Effector& hand = posed.body.effector(posed.body.find_effector("left_hand").value());
    return {hand.link, carrier, kinematics.point(hand.link, hand.point), force};
  }

  // Adds the load to all torques, from 0; returns the floor's wrench.
  Wrench<double> bear(const HandLoad<double>& load, Vector& tau) const {
    Wrench<double> ground{{10, 700, -5}, {3, 2, 1}};
    tau.assign(posed.body.dofs().size(), 0.0);
    bear_on_hand<double>(posed, kinematics, load, ground, tau);
    return ground;
  }

  const PosedBody posed = human_body();
  Vector angles;
  Kinematics<double> kinematics{posed};
  const Vec3d force{4, 90, 30};
};

TEST_F(StoopingHuman, LeavesTheFloorsWrenchToAHandOnTheThigh) {
  Vector tau;
  const Wrench<double> ground = bear(load_on(link("left_hip.rotation")), tau);
  EXPECT_EQ(ground.force, (Vec3d{10, 700, -5}));
  EXPECT_EQ(ground.moment, (Vec3d{3, 2, 1}));
}

TEST_F(StoopingHuman, TakesTheForceOffTheFloorOnAThingOfTheWorld) {
  Vector tau;
  const HandLoad<double> load = load_on(kWorldCarrier);
  const Wrench<double> ground = bear(load, tau);
  EXPECT_EQ(ground.force, (Vec3d{10, 700, -5}) - force);
  EXPECT_EQ(ground.moment, (Vec3d{3, 2, 1}) - cross(load.at, force));
}

TEST_F(StoopingHuman, BearsTheLowBackByForceTimesLever) {
  Vector tau;
  const HandLoad<double> load = load_on(link("left_hip.rotation"));
  bear(load, tau);
  const auto back = static_cast<std::size_t>(link("spine.flexion"));
  const Vec3d moment = cross(load.at - kinematics.origin[back], force);
  const double lever = dot(kinematics.axis[back], moment);
  // the back holds a trunk that would fall forwards by a torque below 0
  EXPECT_GT(tau[back], 5.0);
  EXPECT_NEAR(tau[back], -lever, 1e-12 * norm(moment));
}

// The work of two opposite forces is the force times the change of the distance between their
// places.
TEST_F(StoopingHuman, DoesTheWorkOfBothForces) {
  constexpr double kStep = 1e-6;
  const int thigh = link("left_hip.rotation");
  const HandLoad<double> load = load_on(thigh);
  const Effector& hand = posed.body.effector(posed.body.find_effector("left_hand").value());
  const Vec3d on_thigh =
      transpose_times(kinematics.link_rotation(thigh), load.at - kinematics.link_origin(thigh));
  Vector tau;
  bear(load, tau);
  for (std::size_t d = 0; d < tau.size(); ++d) {
    Vector moved = angles;
    const auto apart = [&](double step) {
      moved[d] = angles[d] + step;
      const Kinematics<double> k = placed(posed, moved);
      return k.point(hand.link, hand.point) - k.point(thigh, on_thigh);
    };
    const Vec3d speed = (apart(kStep) - apart(-kStep)) * (0.5 / kStep);
    // central differences of sines: off by the square of the step
    EXPECT_NEAR(tau[d], -dot(force, speed), 1e-7 * norm(force)) << posed.body.dofs()[d].name;
  }
}

TEST(LeaningDirection, IsAlongTheArmWhereFrictionHoldsIt) {
  const Vec3d direction = leaning_direction<double>({0, 1, 0}, {0.1, 0.5, -0.1});
  EXPECT_LT(norm(direction - normalized(Vec3d{0.1, 0.5, -0.1})), 1e-12);
}

TEST(LeaningDirection, StaysWithinTheConeOfFriction) {
  for (const Vec3d& arm : {Vec3d{0, 0.6, 0.0}, Vec3d{0, 0.2, -0.5}, Vec3d{0.3, -0.4, 0.1}}) {
    const Vec3d normal{0, 0, 1};
    const Vec3d direction = leaning_direction(normal, arm);
    const double out = dot(direction, normal);
    EXPECT_GT(out, 0.0);
    EXPECT_LE(norm(direction - normal * out), kHandFriction * out * (1 + 1e-12));
    EXPECT_NEAR(norm(direction), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace shigusa
