// SPDX-License-Identifier: MIT
#include "dynamics/inverse_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/centre_of_mass.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Vector = std::vector<double>;

struct Dynamics {
  Vector tau;
  Wrench<double> ground;

  Dynamics(const PosedBody& posed, const Vector& q, const Vector& qd, const Vector& qdd)
      : tau(q.size()) {
    DynamicsWorkspace<double> work(posed);
    ground = inverse_dynamics<double>(posed, placed(posed, q), {qd, qdd}, work, tau);
  }
};

TEST(InverseDynamics, PendulumNeedsItsInertiaAndItsWeight) {
  // an upright pendulum: τ = m l² q'' - m g l sin q
  const double m = 3.0;
  const double l = 0.7;
  const PosedBody posed = chain({{Axis::x, l, m}});
  for (const double q : {-2.0, -0.4, 0.0, 0.9, 3.0}) {
    const Dynamics d(posed, {q}, {1.7}, {2.5});
    EXPECT_NEAR(d.tau[0], m * l * l * 2.5 - m * kGravity * l * std::sin(q), 1e-13);
  }
}

TEST(InverseDynamics, SpinningPendulumPullsAtTheFloor) {
  // straight up at speed ω: the floor pulls down by m l ω² against the weight m g
  const PosedBody posed = chain({{Axis::x, 0.7, 3.0}});
  const Dynamics d(posed, {0.0}, {2.0}, {0.0});
  EXPECT_NEAR(d.ground.force.y, 3.0 * (kGravity - 0.7 * 4.0), 1e-13);
  EXPECT_NEAR(norm(d.ground.moment), 0.0, 1e-13);
}

TEST(InverseDynamics, DoublePendulumFollowsTheTextbook) {
  // Lagrange's equations of two point masses with absolute angles a = q0, b = q0 + q1 from upright
  const double m1 = 2.0;
  const double m2 = 1.5;
  const double l1 = 0.5;
  const double l2 = 0.8;
  const PosedBody posed = chain({{Axis::x, l1, m1}, {Axis::x, l2, m2}});
  const Vector q{0.7, -1.1};
  const Vector qd{1.3, 0.6};
  const Vector qdd{-2.0, 4.0};
  const double a = q[0];
  const double b = q[0] + q[1];
  const double ad = qd[0];
  const double bd = qd[0] + qd[1];
  const double add = qdd[0];
  const double bdd = qdd[0] + qdd[1];
  const double on_a = (m1 + m2) * l1 * l1 * add + m2 * l1 * l2 * std::cos(a - b) * bdd +
                      m2 * l1 * l2 * std::sin(a - b) * bd * bd -
                      (m1 + m2) * kGravity * l1 * std::sin(a);
  const double on_b = m2 * l2 * l2 * bdd + m2 * l1 * l2 * std::cos(a - b) * add -
                      m2 * l1 * l2 * std::sin(a - b) * ad * ad - m2 * kGravity * l2 * std::sin(b);
  const Dynamics d(posed, q, qd, qdd);
  EXPECT_NEAR(d.tau[1], on_b, 1e-13);
  EXPECT_NEAR(d.tau[0], on_a + on_b, 1e-13);
}

TEST(InverseDynamics, StandingStillTheFloorCarriesTheWeight) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Vector q(posed.home.angles.begin(), posed.home.angles.end());
    const Vector still(q.size(), 0.0);
    const Dynamics d(posed, q, still, still);
    EXPECT_NEAR(d.ground.force.y, posed.body.mass() * kGravity, 1e-10);
    EXPECT_NEAR(d.ground.force.x, 0.0, 1e-10);
    EXPECT_NEAR(d.ground.force.z, 0.0, 1e-10);
  }
}

// A smooth random motion: q_i(t) = a sin(b t + c), with its derivatives.
struct Wave {
  Vector a;
  Vector b;
  Vector c;

  Wave(const PosedBody& posed, Random& random)
      : a(random_vector(posed, -0.8, 0.8, random)),
        b(random_vector(posed, 1.0, 4.0, random)),
        c(random_vector(posed, -3.0, 3.0, random)) {}

  [[nodiscard]] Vector derivative(int order, double t) const {
    Vector q;
    for (std::size_t i = 0; i < a.size(); ++i) {
      q.push_back(a[i] * std::pow(b[i], order) * std::sin(b[i] * t + c[i] + order * kPi / 2));
    }
    return q;
  }
};

// Momentum, angular momentum about the world's origin, and energy, each by its definition.
struct Momenta {
  Vec3d linear{};
  Vec3d angular{};
  double energy = 0.0;

  Momenta(const PosedBody& posed, const Wave& wave, double t) {
    const Kinematics<double> kinematics = placed(posed, wave.derivative(0, t));
    const Vector qd = wave.derivative(1, t);
    for (int link = kBaseLink; link < posed.body.dof_count(); ++link) {
      const MassProperties& m = posed.body.link_mass(link);
      const Vec3d com = kinematics.point(link, m.com);
      Vec3d velocity{};
      Vec3d spin{};
      for (int d = 0; d < posed.body.dof_count(); ++d) {
        if (!posed.body.moves(d, link)) continue;
        const auto k = static_cast<std::size_t>(d);
        velocity += position_column(kinematics, d, com) * qd[k];
        spin += kinematics.axis[k] * qd[k];
      }
      const Mat3d& r = kinematics.link_rotation(link);
      const Vec3d own = r * (m.inertia * transpose_times(r, spin));
      linear += velocity * m.mass;
      angular += cross(com, velocity) * m.mass + own;
      energy +=
          0.5 * m.mass * dot(velocity, velocity) + 0.5 * dot(spin, own) + m.mass * kGravity * com.y;
    }
  }
};

// Central differences of a motion: errors of step² / 6 times third derivatives, which are of the
// order of 1e5 here, and rounding of 1e-13 / step.
constexpr double kStep = 1e-5;
constexpr double kDifference = 2e-5;

TEST(InverseDynamics, FloorGivesTheRateOfMomentum) {
  const PosedBody posed = full_body();
  Random random(31);
  for (int trial = 0; trial < 20; ++trial) {
    const Wave wave(posed, random);
    const Dynamics d(posed, wave.derivative(0, 0), wave.derivative(1, 0), wave.derivative(2, 0));
    const Momenta before(posed, wave, -kStep);
    const Momenta after(posed, wave, kStep);
    const Vec3d weight{0, -posed.body.mass() * kGravity, 0};
    const Vec3d com = centre_of_mass(posed, placed(posed, wave.derivative(0, 0)));
    const Vec3d force = (after.linear - before.linear) * (0.5 / kStep);
    const Vec3d moment = (after.angular - before.angular) * (0.5 / kStep);
    EXPECT_LT(norm(d.ground.force + weight - force), kDifference);
    EXPECT_LT(norm(d.ground.moment + cross(com, weight) - moment), kDifference);
  }
}

TEST(InverseDynamics, TorquesDoTheWorkThatEnergyGains) {
  const PosedBody posed = full_body();
  Random random(32);
  for (int trial = 0; trial < 20; ++trial) {
    const Wave wave(posed, random);
    const Vector qd = wave.derivative(1, 0);
    const Dynamics d(posed, wave.derivative(0, 0), qd, wave.derivative(2, 0));
    double power = 0.0;
    for (std::size_t i = 0; i < qd.size(); ++i) power += d.tau[i] * qd[i];
    const double gain =
        (Momenta(posed, wave, kStep).energy - Momenta(posed, wave, -kStep).energy) * (0.5 / kStep);
    EXPECT_NEAR(power, gain, kDifference * 10);
  }
}

TEST(CentreOfMass, IsTheMeanOfTheMasses) {
  const PosedBody posed = chain({{Axis::x, 1.0, 1.0}, {Axis::x, 1.0, 3.0}});
  const Vec3d com = centre_of_mass(posed, placed(posed, Vector{kPi / 2, -kPi / 2}));
  // masses at (0, 0, 1) and (0, 1, 1)
  EXPECT_LT(norm(com - Vec3d{0, 0.75, 1.0}), 1e-15);
}

TEST(CentreOfMass, IsAByProductOfInverseDynamics) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    Random random(31);
    for (int trial = 0; trial < 100; ++trial) {
      const Vector q = random_posture(posed, random);
      const Kinematics<double> kinematics = placed(posed, q);
      DynamicsWorkspace<double> work(posed);
      Vector tau(q.size());
      inverse_dynamics<double>(
          posed, kinematics,
          {random_vector(posed, -5.0, 5.0, random), random_vector(posed, -50.0, 50.0, random)},
          work, tau);
      // sums of up to twenty terms of about 1 m, in another order
      EXPECT_LT(norm(centre_of_mass(posed, work) - centre_of_mass(posed, kinematics)), 1e-14);
    }
  }
}

TEST(CentreOfMass, CountsTheBase) {
  BodyDefinition definition = chain_definition({{Axis::x, 1.0, 1.0}});
  definition.base = {Mat3d{}, {0, 0, 2}};
  definition.base_mass.mass = 3.0;
  definition.base_mass.com = {0, 0, 1};
  definition.mass = 4.0;
  const PosedBody posed = at_zero(definition);
  EXPECT_LT(norm(centre_of_mass(posed, placed(posed, Vector{0.0})) - Vec3d{0, 0.25, 2.75}), 1e-15);
}

}  // namespace
}  // namespace shigusa
