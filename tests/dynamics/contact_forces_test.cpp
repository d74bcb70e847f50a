// SPDX-License-Identifier: MIT
#include "dynamics/contact_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Vector = std::vector<double>;

// The wrench of a force at a point, with a moment of its own.
Wrench<double> force_at(const Vec3d& point, const Vec3d& force, const Vec3d& own = {}) {
  return {force, cross(point, force) + own};
}

TEST(CentreOfPressure, IsWhereAForceOnTheFloorActs) {
  const Wrench<double> w = force_at({0.3, 0.05, -0.2}, {40, 700, -25}, {0, 6, 0});
  const Vec3d cop = centre_of_pressure(w, 0.05);
  EXPECT_LT(norm(cop - Vec3d{0.3, 0.05, -0.2}), 1e-15);
}

TEST(CentreOfPressure, LeavesNoHorizontalMoment) {
  const Wrench<double> w{{40, 700, -25}, {30, -12, 55}};
  const Vec3d left = w.moment - cross(centre_of_pressure(w, 0.1), w.force);
  EXPECT_NEAR(left.x, 0.0, 1e-13);
  EXPECT_NEAR(left.z, 0.0, 1e-13);
}

TEST(CentreOfPressure, IsFiniteInFreeFall) {
  const Vec3d cop = centre_of_pressure(Wrench<double>{{0, 0, 0}, {1, 1, 1}}, 0.0);
  EXPECT_TRUE(is_finite(cop.x) && is_finite(cop.z));
}

// The full body in its start posture with a given ground wrench.
class TwoFeet : public testing::Test {
 protected:
  const PosedBody posed = full_body();
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  const Foot& first = posed.body.feet()[0];
  const Foot& second = posed.body.feet()[1];
  const Vec3d a = kinematics.point(first.link, first.centre);
  const Vec3d b = kinematics.point(second.link, second.centre);
  const Vec3d force{30, 720, -45};

  Wrench<double> second_part(const Wrench<double>& ground) {
    Vector tau(posed.body.dofs().size());
    return share_ground_wrench<double>(posed, kinematics, {}, ground, tau);
  }
};

TEST_F(TwoFeet, CarryByTheLeverRule) {
  for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const Wrench<double> part = second_part(force_at(a + (b - a) * share, force));
    EXPECT_LT(norm(part.force - force * share), 1e-12 * norm(force)) << share;
  }
}

TEST_F(TwoFeet, BeyondAFootThatFootCarriesAll) {
  EXPECT_LT(norm(second_part(force_at(a + (b - a) * 1.5, force)).force - force), 1e-12);
  EXPECT_LT(norm(second_part(force_at(a - (b - a) * 0.5, force)).force), 1e-12);
}

TEST_F(TwoFeet, PressEquallyFarFromTheirCentres) {
  // a centre of pressure 8 cm ahead of the line between the feet is 8 cm ahead in either foot
  const Vec3d line = normalized(b - a);
  const Vec3d ahead = cross(line, Vec3d{0, 1, 0}) * 0.08;
  const Wrench<double> ground = force_at(a + (b - a) * 0.3 + ahead, force, {0, 5, 0});
  const Wrench<double> part = second_part(ground);
  const Wrench<double> rest{ground.force - part.force, ground.moment - part.moment};
  EXPECT_LT(norm(centre_of_pressure(part, b.y) - (b + ahead)), 1e-14);
  EXPECT_LT(norm(centre_of_pressure(rest, a.y) - (a + ahead)), 1e-14);
}

TEST_F(TwoFeet, PartsOfBothAreTheWholeWrench) {
  const Wrench<double> ground = force_at({0.1, 0.0, 0.12}, force, {0, 8, 0});
  const Vec3d cop = centre_of_pressure(ground, a.y);
  const double share = 0.4;
  const Vec3d on_line = a + (b - a) * share;
  const Wrench<double> to_second = shared_wrench(ground, cop, on_line, b, share);
  const Wrench<double> to_first = shared_wrench(ground, cop, on_line, a, 1.0 - share);
  EXPECT_LT(norm(to_first.force + to_second.force - ground.force), 1e-12);
  EXPECT_LT(norm(to_first.moment + to_second.moment - ground.moment), 1e-12);
}

TEST_F(TwoFeet, SecondPartReachesTheJointsThroughItsJacobian) {
  Random random(41);
  const Vector before = random_vector(posed, -100, 100, random);
  Vector after = before;
  const Wrench<double> part = share_ground_wrench<double>(
      posed, kinematics, {}, force_at({0.05, 0.0, 0.1}, force, {0, 8, 0}), after);
  const Vec3d at = kinematics.point(second.link, second.centre);
  const Vec3d moment = part.moment - cross(at, part.force);
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    const auto k = static_cast<std::size_t>(d);
    const double power =
        dot(position_column(kinematics, d, at), part.force) + dot(kinematics.axis[k], moment);
    EXPECT_NEAR(before[k] - after[k], posed.body.moves(d, second.link) ? power : 0.0, 1e-11);
  }
}

TEST_F(TwoFeet, SymmetricStanceLoadsBothLegsAlike) {
  // standing still in a symmetric posture, the joints of both legs carry the same
  DynamicsWorkspace<double> work(posed);
  const Vector still(posed.body.dofs().size(), 0.0);
  Vector tau(still.size());
  const Wrench<double> ground =
      inverse_dynamics<double>(posed, kinematics, {still, still}, work, tau);
  share_ground_wrench<double>(posed, kinematics, {}, ground, tau);
  for (const char* joint : {"hip.flexion", "hip.abduction", "knee.flexion", "ankle.flexion"}) {
    const auto left = static_cast<std::size_t>(*posed.body.find_dof(std::string("left_") + joint));
    const auto right =
        static_cast<std::size_t>(*posed.body.find_dof(std::string("right_") + joint));
    EXPECT_NEAR(tau[left], tau[right], 1e-9) << joint;
  }
}

}  // namespace
}  // namespace shigusa
