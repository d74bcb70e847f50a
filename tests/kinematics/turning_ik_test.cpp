// SPDX-License-Identifier: MIT
// Targets with orientations: in one step of weighted IK, and in NLP-IK's objective.
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/human.hpp>

#include "nlp/nlp_ik.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Vector = std::vector<double>;

// The right hand keeps its position, and turns.
Constraint<double> hand_target(const PosedBody& posed, const Vector& q) {
  const Effector& hand = posed.body.effector(posed.body.find_effector("right_hand").value());
  const Kinematics<double> now = placed(posed, q);
  return {.link = hand.link, .point = hand.point, .place = now.point(hand.link, hand.point)};
}

Constraint<double> turned_by(const PosedBody& posed, const Vector& q, const Vec3d& vector) {
  Constraint<double> target = hand_target(posed, q);
  target.turning = Turning::whole;
  target.orientation = rotation_by(vector) * placed(posed, q).link_rotation(target.link);
  return target;
}

Constraint<double> pointing(const PosedBody& posed, const Vector& q, const Vec3d& vector) {
  Constraint<double> target = hand_target(posed, q);
  target.turning = Turning::axis;
  target.axis = {1, 0, 0};
  target.direction = rotation_by(vector) * placed(posed, q).link_rotation(target.link).cx;
  return target;
}

Vector step_of(const PosedBody& posed, const Vector& q, const Constraint<double>& target,
               const Vector& reference = {}) {
  const Vector weights(q.size(), 1.0);
  IkWorkspace<double> workspace(posed);
  const auto dq =
      weighted_ik_step<double>(posed, placed(posed, q), {std::span(&target, 1), weights, reference},
                               IkSettings{}, workspace);
  return {dq.begin(), dq.end()};
}

Vector bent(const PosedBody& posed) {
  Vector q(posed.home.angles.begin(), posed.home.angles.end());
  q[static_cast<std::size_t>(posed.body.find_dof("right_elbow.flexion").value())] += 1.0;
  q[static_cast<std::size_t>(posed.body.find_dof("right_shoulder.abduction").value())] += 0.3;
  return q;
}

Vector moved(const Vector& q, const Vector& dq) {
  Vector sum(q);
  for (std::size_t d = 0; d < q.size(); ++d) sum[d] += dq[d];
  return sum;
}

TEST(TurningIk, StepMakesASmallTurnToTheSecondOrder) {
  const PosedBody posed = human_body();
  const Vector q = bent(posed);
  for (const bool whole : {true, false}) {
    const Vec3d small{0.01, -0.02, 0.015};
    const Constraint<double> target =
        whole ? turned_by(posed, q, small) : pointing(posed, q, small);
    const Kinematics<double> before = placed(posed, q);
    const Kinematics<double> after = placed(posed, moved(q, step_of(posed, q, target)));
    EXPECT_GT(norm(turn_error(before, target)), 0.01);
    EXPECT_LT(norm(turn_error(after, target)), 1e-3);
    EXPECT_LT(norm(position_error(after, target)), 1e-3);
  }
}

TEST(TurningIk, StepsConvergeFromFarOff) {
  const PosedBody posed = human_body();
  // beyond 90°, where the sine of an angle shrinks again
  for (const Constraint<double>& target :
       {turned_by(posed, bent(posed), {0, 2.0, 0}), pointing(posed, bent(posed), {0, 2.4, 0})}) {
    Vector q = bent(posed);
    for (int k = 0; k < 60; ++k) q = moved(q, step_of(posed, q, target));
    EXPECT_LT(norm(turn_error(placed(posed, q), target)), 1e-6);
    EXPECT_LT(norm(position_error(placed(posed, q), target)), 1e-6);
  }
}

TEST(TurningIk, AxisThatPointsWhereItShouldLetsTheHandTurnAboutIt) {
  const PosedBody posed = human_body();
  const Vector q = bent(posed);
  Vector reference(q.size(), 0.0);
  reference[static_cast<std::size_t>(posed.body.find_dof("right_elbow.rotation").value())] = 0.02;
  reference[static_cast<std::size_t>(posed.body.find_dof("right_wrist.flexion").value())] = 0.01;
  const auto hand = static_cast<int>(posed.body.effector(0).link);
  const auto spin = [&](const Constraint<double>& target) {
    const Vector to = moved(q, step_of(posed, q, target, reference));
    const Mat3d turn =
        placed(posed, to).link_rotation(hand) * transpose(placed(posed, q).link_rotation(hand));
    return rotation_vector(turn);
  };
  const Vec3d about = placed(posed, q).link_rotation(hand).cx;
  const Vec3d free = spin(pointing(posed, q, {}));
  const Vec3d held = spin(turned_by(posed, q, {}));
  EXPECT_LT(norm(held), 1e-3);
  EXPECT_GT(std::fabs(dot(free, about)), 3e-3);
  EXPECT_LT(norm(free - about * dot(free, about)), 1e-3);
}

TEST(TurningIk, GradientOfNlpIkIsThatOfItsObjective) {
  const PosedBody posed = human_body();
  const Vector q = bent(posed);
  for (const Constraint<double>& target :
       {turned_by(posed, q, {0.5, -0.3, 0.4}), pointing(posed, q, {0.5, -0.3, 0.4})}) {
    const std::vector<Constraint<double>> targets{target};
    NlpIk ik(posed, posed.home);
    ik.begin(targets, Vector(q.size(), 1.0));
    Vector gradient(q.size());
    Vector ignored(q.size());
    (void)ik.objective(targets, q, {}, q, gradient);
    constexpr double kStep = 1e-5;
    for (std::size_t d = 0; d < q.size(); ++d) {
      Vector up(q);
      Vector down(q);
      up[d] += kStep;
      down[d] -= kStep;
      const double slope = (ik.objective(targets, q, {}, up, ignored) -
                            ik.objective(targets, q, {}, down, ignored)) /
                           (2 * kStep);
      EXPECT_NEAR(gradient[d], slope, 1e-8) << posed.body.dofs()[d].name;
    }
  }
}

}  // namespace
}  // namespace shigusa
