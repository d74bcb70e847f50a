// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(ForwardKinematics, HingesTurnAboutTheirAxes) {
  // a positive turn about x leads from y to z, about z from y to -x, and about y it leaves y alone
  const double angle = 0.3;
  const std::vector<double> q{angle};
  const Vec3d about_x = effector_position(chain({{Axis::x, 2.0}}), q, "tip");
  EXPECT_LT(norm(about_x - Vec3d{0, 2 * std::cos(angle), 2 * std::sin(angle)}), 1e-15);
  const Vec3d about_y = effector_position(chain({{Axis::y, 2.0}}), q, "tip");
  EXPECT_LT(norm(about_y - Vec3d{0, 2, 0}), 1e-15);
  const Vec3d about_z = effector_position(chain({{Axis::z, 2.0}}), q, "tip");
  EXPECT_LT(norm(about_z - Vec3d{-2 * std::sin(angle), 2 * std::cos(angle), 0}), 1e-15);
}

TEST(ForwardKinematics, NegativeSignTurnsTheOtherWay) {
  BodyDefinition definition = chain_definition({{Axis::x, 2.0}});
  definition.dofs[0].sign = -1.0;
  const std::vector<double> q{0.3};
  const Vec3d tip = effector_position(at_zero(definition), q, "tip");
  EXPECT_LT(norm(tip - Vec3d{0, 2 * std::cos(0.3), -2 * std::sin(0.3)}), 1e-15);
}

TEST(ForwardKinematics, AnglesOfParallelHingesAddUp) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 0.5}});
  const std::vector<double> q{0.4, 0.7};
  const Vec3d expected{0, std::cos(0.4) + 0.5 * std::cos(1.1), std::sin(0.4) + 0.5 * std::sin(1.1)};
  EXPECT_LT(norm(effector_position(posed, q, "tip") - expected), 1e-15);
}

TEST(ForwardKinematics, FreedomsAtOneCentreTurnAboutItInTheirOrder) {
  BodyDefinition definition = chain_definition({{Axis::y, 1.0}, {Axis::x, 1.0}, {Axis::z, 1.0}});
  definition.dofs[1].offset = definition.dofs[2].offset = {};
  definition.dofs[1].sign = -1.0;
  const std::vector<double> q{0.4, -0.9, 1.3};
  const Mat3d turned = rotation(Axis::y, 0.4) * rotation(Axis::x, 0.9) * rotation(Axis::z, 1.3);
  const Kinematics<double> kinematics = placed(at_zero(definition), q);
  EXPECT_LT(distance(kinematics.rotation[2], turned), 1e-15);
  EXPECT_EQ(kinematics.origin[2], Vec3d{});
  EXPECT_LT(norm(kinematics.axis[1] + rotation(Axis::y, 0.4).cx), 1e-15);
}

TEST(ForwardKinematics, BasePlacesTheWholeBody) {
  BodyDefinition definition = chain_definition({{Axis::x, 1.0}});
  definition.base = {rotation(Axis::y, kPi / 2), {1, 2, 3}};
  const std::vector<double> q{kPi / 2};
  // the rod lies along the base's z, which is the world's x
  EXPECT_LT(norm(effector_position(at_zero(definition), q, "tip") - Vec3d{2, 2, 3}), 1e-15);
}

TEST(ForwardKinematics, PointsOfTheBaseLinkDoNotMove) {
  const PosedBody posed = full_body();
  const Foot& foot = posed.body.feet()[0];
  ASSERT_EQ(foot.link, kBaseLink);
  Random random(1);
  const Vec3d before = placed(posed, posed.home.angles).point(foot.link, foot.centre);
  EXPECT_EQ(placed(posed, random_posture(posed, random)).point(foot.link, foot.centre), before);
}

TEST(ForwardKinematics, JacobianColumnsAreDerivatives) {
  const PosedBody posed = full_body();
  constexpr double kStep = 1e-5;  // central differences: an error of step² for lengths of 1 m
  Random random(2);
  std::vector<double> q = random_posture(posed, random);
  const Kinematics<double> kinematics = placed(posed, q);
  for (const Effector& effector : posed.body.effectors()) {
    const Vec3d at = kinematics.point(effector.link, effector.point);
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double angle = q[k];
      q[k] = angle + kStep;
      const Vec3d after = placed(posed, q).point(effector.link, effector.point);
      q[k] = angle - kStep;
      const Vec3d before = placed(posed, q).point(effector.link, effector.point);
      q[k] = angle;
      const Vec3d column =
          posed.body.moves(d, effector.link) ? position_column(kinematics, d, at) : Vec3d{};
      EXPECT_LT(norm(column - (after - before) * (0.5 / kStep)), 1e-9) << posed.body.dof(d).name;
    }
  }
}

}  // namespace
}  // namespace shigusa
