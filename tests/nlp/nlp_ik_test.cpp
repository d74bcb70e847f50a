// SPDX-License-Identifier: MIT
#include "nlp/nlp_ik.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "criteria/joint_range.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Targets = std::vector<Constraint<double>>;
using Vector = std::vector<double>;

// An effector moves by `way` from its position in the posture.
Constraint<double> moves_by(const PosedBody& posed, const Vector& q, const Vec3d& way,
                            std::size_t effector = 0) {
  const Effector& e = posed.body.effectors()[effector];
  return {.link = e.link, .point = e.point, .place = placed(posed, q).point(e.link, e.point) + way};
}

// The second foot stays as in the start posture.
Constraint<double> planted(const PosedBody& posed) {
  const Foot& foot = posed.body.feet()[1];
  const Kinematics<double> start = placed(posed, posed.home.angles);
  return {.link = foot.link,
          .point = foot.centre,
          .place = start.point(foot.link, foot.centre),
          .exact = true,
          .turning = Turning::whole,
          .orientation = start.link_rotation(foot.link)};
}

struct Solved {
  Vector q;
  NlpIkOutcome outcome;
};

Solved solve(const PosedBody& posed, const Vector& from, Targets targets,
             const Vector& inverse_weights, const NlpIkSettings& settings = {},
             const Vector& reference = {}) {
  NlpIk ik(posed, posed.home, settings);
  ik.begin(targets, inverse_weights);
  Solved solved{Vector(from.size()), {}};
  solved.outcome = ik.solve(targets, from, reference, solved.q);
  return solved;
}

Vector start_of(const PosedBody& posed) {
  return {posed.home.angles.begin(), posed.home.angles.end()};
}

double largest_difference(const Vector& a, const Vector& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
  return largest;
}

TEST(NlpIk, OneHingeTurnsToWhereTheArcIsNearest) {
  // the point to be at lies above the arc of 2 m, in the direction of 0.1 rad
  const PosedBody posed = chain({{Axis::x, 2.0}});
  const Vec3d way = Vec3d{0, std::cos(0.1), std::sin(0.1)} * 2.5 - Vec3d{0, 2, 0};
  const Solved found = solve(posed, {0.0}, {moves_by(posed, {0.0}, way)}, {1.0},
                             {.damping = 1e-9, .lag_damping = 0.0});
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.q[0], 0.1, NlpIkSettings{}.tolerance);
}

TEST(NlpIk, GoalIsMetBeyondTheFirstOrder) {
  // a way of 0.2 m bends much, and one linear step misses it by about 0.2² / 2
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector from{0.2, 0.5};
  const Constraint<double> target = moves_by(posed, from, {0, -0.1, 0.2});
  const Solved found = solve(posed, from, {target}, {1.0, 1.0});
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_LT(norm(position_error(placed(posed, found.q), target)), NlpIkSettings{}.goal_slack);
}

// Changes count by the damping times a third of the square of the way per radian.
TEST(NlpIk, ChangesCountAlikeInBodiesOfAnySize) {
  for (const double size : {0.01, 2.0}) {
    const PosedBody posed = chain({{Axis::x, size}});
    const Constraint<double> target = moves_by(posed, {0.1}, {});
    const Targets targets{target, target};
    NlpIk ik(posed, posed.home, {.damping = 0.3});
    ik.begin(targets, Vector{1.0});
    Vector gradient(1);
    const double value = ik.objective(targets, Vector{0.0}, {}, Vector{0.1}, gradient);
    EXPECT_NEAR(value / (size * size), 0.5 * 0.3 / 3.0 * 0.1 * 0.1, 1e-12);
  }
}

TEST(NlpIk, TakesTheReferenceWhereNoGoalNeedsTheJoints) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}});
  Targets targets{moves_by(posed, {0, 0.5, 0.3}, {})};
  targets[0].link = 0;
  targets[0].point = {0, 1, 0};
  targets[0].place = {0, 1, 0};
  const Solved found = solve(posed, {0, 0.5, 0.3}, targets, {1.0, 2.0, 0.0}, {}, {0.0, 0.1, 0.1});
  EXPECT_NEAR(found.q[1], 0.6, 1e-7);
  EXPECT_EQ(found.q[2], 0.3) << "locked";
}

TEST(NlpIk, WithAllJointsLockedNothingMoves) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector from{0.1, 0.5};
  const Solved found = solve(posed, from, {moves_by(posed, from, {0, 0, 0.3})}, {0, 0});
  EXPECT_EQ(found.q, from);
}

TEST(NlpIk, AJointAtItsLimitLeavesTheWayToTheOthers) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  // the upper hinge stands at its limit; the lower one alone turns a rod of this length
  const Vector from{0.0, 2.0};
  const Vec3d tip = effector_position(posed, from, "tip");
  const SinCos<double> turn = sin_cos(0.1);
  const Vec3d turned{0, tip.y * turn.cos - tip.z * turn.sin, tip.z * turn.cos + tip.y * turn.sin};
  const Solved found = solve(posed, from, {moves_by(posed, from, turned - tip)}, {1e-2, 1.0});
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_LE(found.q[1], 2.0);
  EXPECT_NEAR(found.q[0], 0.1, 1e-3);
}

TEST(NlpIk, NoPostureTakesMoreThanItsShareOfTheRoomToALimit) {
  const PosedBody posed = chain({{Axis::x, 1.0}});
  const NlpIkSettings settings{.limit_approach = 0.2, .max_change = 1.0};
  const Solved found = solve(posed, {1.5}, {moves_by(posed, {1.5}, {0, -2, 0})}, {1.0}, settings);
  EXPECT_NEAR(found.q[0], 1.5 + 0.2 * 0.5, 1e-12);
}

TEST(NlpIk, NoAngleChangesByMoreThanTheLargestChange) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector from{0.0, 0.5};
  const Solved found = solve(posed, from, {moves_by(posed, from, {0, -2, 2})}, {1.0, 1.0});
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_LE(std::fabs(found.q[d] - from[d]), NlpIkSettings{}.max_change + 1e-12);
  }
}

TEST(NlpIk, AnUpperLimitGrowsWithItsDriver) {
  BodyDefinition definition = chain_definition({{Axis::x, 1.0}, {Axis::x, 1.0}});
  definition.dofs[0].upper = 0.5;
  definition.couplings.push_back({.dof = 0, .driver = 1, .gain = 0.4, .driver_full = 1.0});
  const PosedBody posed = at_zero(definition);
  const NlpIkSettings settings{.damping = 1e-9, .limit_approach = 1.0, .max_change = 2.0};
  // far forwards and down: both would turn much further
  for (const double driver : {0.0, 0.25, 1.0, 1.5}) {
    const Vector from{0.4, driver};
    const Solved found =
        solve(posed, from, {moves_by(posed, from, {0, -3, 1})}, {1.0, 0.0}, settings);
    EXPECT_NEAR(found.q[0], 0.5 + 0.4 * std::fmin(driver, 1.0), 1e-9) << driver;
  }
}

TEST(NlpIk, ADriverThatTurnsMakesRoomInTheSameStep) {
  BodyDefinition definition = chain_definition({{Axis::x, 1.0}, {Axis::x, 1.0}});
  definition.dofs[0].upper = 0.5;
  definition.couplings.push_back({.dof = 0, .driver = 1, .gain = 0.4, .driver_full = 1.0});
  const PosedBody posed = at_zero(definition);
  const NlpIkSettings settings{.damping = 1e-9, .limit_approach = 1.0, .max_change = 2.0};
  // down and forwards, to where both turn
  const Vector from{0.45, 0.1};
  const Solved found =
      solve(posed, from, {moves_by(posed, from, {0, -0.45, 0.5})}, {1.0, 1.0}, settings);
  const auto limit = [](double driver) { return 0.5 + 0.4 * driver; };
  ASSERT_LT(found.q[1], 1.0);
  EXPECT_GT(found.q[0], limit(from[1]) + 0.05);
  EXPECT_LE(found.q[0], limit(found.q[1]));
}

TEST(NlpIk, AStartPostureOutsideItsLimitsMayStay) {
  BodyDefinition definition = chain_definition({{Axis::x, 1.0}, {Axis::x, 1.0}});
  PosedBody posed = at_zero(definition);
  posed.home.angles = {2.3, 0.0};
  const Solved found =
      solve(posed, {2.3, 0.0}, {moves_by(posed, {2.3, 0.0}, {0, -0.1, 0})}, {1.0, 1.0});
  EXPECT_LE(found.q[0], 2.3);
  EXPECT_GT(found.q[0], 2.2);
}

// With the driver a little overstretched at the start, the line that couples both is still above
// the start posture, and holds; further overstretched it is not, and bending makes no room.
TEST(NlpIk, ACouplingHoldsUnlessTheStartPostureIsBeyondIt) {
  for (const double driver : {-0.1, -0.5}) {
    BodyDefinition definition = chain_definition({{Axis::x, 1.0}, {Axis::x, 1.0}});
    definition.dofs[0].upper = 0.5;
    definition.couplings.push_back({.dof = 0, .driver = 1, .gain = 0.4, .driver_full = 1.0});
    PosedBody posed = at_zero(definition);
    posed.home.angles = {0.45, driver};
    const NlpIkSettings settings{.damping = 1e-9, .limit_approach = 1.0, .max_change = 2.0};
    const Vector from{0.4, 0.5};
    const Solved found =
        solve(posed, from, {moves_by(posed, from, {0, -3, 1})}, {1.0, 0.0}, settings);
    EXPECT_NEAR(found.q[0], driver == -0.1 ? 0.7 : 0.5, 1e-9) << driver;
  }
}

// A posture of the full body, displacements for both hands, and weights.
struct RandomTask {
  PosedBody posed = full_body();
  Vector from = start_of(posed);
  Targets targets;
  Vector inverse_weights;

  RandomTask(std::uint64_t seed, double way) {
    Random random(seed);
    for (std::size_t e = 0; e < 2; ++e) {
      const Vec3d towards{random.uniform(-way, way), random.uniform(-way, way),
                          random.uniform(-way, way)};
      targets.push_back(moves_by(posed, from, towards, e));
    }
    targets.push_back(planted(posed));
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      inverse_weights.push_back(1.0 / (1.0 + 14.0 * random.uniform()));
    }
  }
};

RC_GTEST_PROP(NlpIkProperty, GradientIsThatOfTheObjective, (std::uint64_t seed)) {
  RandomTask task(seed, 0.3);
  Random random(seed, 1);
  Vector q = task.from;
  Vector reference(q.size());
  for (std::size_t d = 0; d < q.size(); ++d) {
    q[d] += random.uniform(-0.5, 0.5);
    reference[d] = random.uniform(-0.1, 0.1);
  }
  Constraint<double>& foot = task.targets[2];
  foot.lead = random_direction(random) * 0.1;
  foot.tilt_lead = random_direction(random) * 0.5;
  task.targets[0].lead = random_direction(random) * 0.05;
  task.targets[0].lag = 0.3;
  NlpIk ik(task.posed, task.posed.home, {.damping = 0.1});
  ik.begin(task.targets, task.inverse_weights);
  Vector gradient(q.size());
  Vector unused(q.size());
  (void)ik.objective(task.targets, task.from, reference, q, gradient);
  // central differences: h² of the third derivative and 1e-16 / h of values up to 10
  constexpr double kStep = 1e-5;
  for (std::size_t d = 0; d < q.size(); ++d) {
    Vector after = q;
    Vector before = q;
    after[d] += kStep;
    before[d] -= kStep;
    const double slope = (ik.objective(task.targets, task.from, reference, after, unused) -
                          ik.objective(task.targets, task.from, reference, before, unused)) /
                         (2.0 * kStep);
    RC_ASSERT(std::fabs(slope - gradient[d]) <= 1e-7);
  }
}

RC_GTEST_PROP(NlpIkProperty, ShortStepsAreThoseOfWeightedIk, (std::uint64_t seed)) {
  // both are first-order equal, so the difference falls with the square of the displacement
  const PosedBody posed = half_body();
  Random random(seed);
  // away from all limits
  Vector from;
  for (const Dof& dof : posed.body.dofs()) from.push_back(0.5 * (dof.lower + dof.upper));
  for (double& angle : from) angle += random.uniform(-0.2, 0.2);
  Vector inverse_weights;
  for (std::size_t d = 0; d < from.size(); ++d) {
    inverse_weights.push_back(1.0 / (1.0 + 14.0 * random.uniform()));
  }
  const Vec3d direction = random_direction(random);
  const auto difference = [&](double way) {
    const Targets targets{moves_by(posed, from, direction * way)};
    Vector reference(from.size(), way);
    const NlpIkSettings settings{.damping = 1e-6, .goal_corrections = 0, .tolerance = 1e-11};
    const Solved found = solve(posed, from, targets, inverse_weights, settings, reference);
    IkWorkspace<double> workspace(posed);
    const auto step =
        weighted_ik_step<double>(posed, placed(posed, from), {targets, inverse_weights, reference},
                                 {.damping = 1e-6}, workspace);
    Vector to = from;
    for (std::size_t d = 0; d < to.size(); ++d) to[d] += step[d];
    return largest_difference(found.q, to);
  };
  const double coarse = difference(2e-3);
  RC_ASSERT(coarse <= 1e-3);
  // a quarter, but for the damping, which counts in the start posture here and in this one there
  RC_ASSERT(difference(1e-3) <= 0.3 * coarse + 1e-8);
}

RC_GTEST_PROP(NlpIkProperty, NoPostureNearbyThatKeepsTheLimitsIsBetter, (std::uint64_t seed)) {
  const PosedBody posed = half_body();
  Random random(seed);
  Vector from;
  for (const Dof& dof : posed.body.dofs()) {
    from.push_back(dof.lower + (dof.upper - dof.lower) * random.uniform(0.0, 0.9));
  }
  Vector inverse_weights;
  for (std::size_t d = 0; d < from.size(); ++d) {
    inverse_weights.push_back(1.0 / (1.0 + 14.0 * random.uniform()));
  }
  const Vec3d direction = random_direction(random);
  const Targets targets{moves_by(posed, from, direction * random.uniform(0.0, 0.1))};
  const NlpIkSettings settings{.limit_approach = 1.0,
                               .max_change = 10.0,
                               .lead_limit = 0.0,
                               .tolerance = 1e-9,
                               .iterations = 2000};
  const Solved found = solve(posed, from, targets, inverse_weights, settings);
  RC_ASSERT(found.outcome.converged);
  NlpIk ik(posed, posed.home, settings);
  ik.begin(targets, inverse_weights);
  Vector gradient(from.size());
  const double least = ik.objective(targets, from, {}, found.q, gradient);
  for (int k = 0; k < 300; ++k) {
    Vector other = found.q;
    const double reach = std::pow(10.0, random.uniform(-6.0, -2.0));
    for (double& angle : other) {
      if (random.chance(0.5)) angle += random.uniform(-reach, reach);
    }
    bool inside = true;
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const double angle = other[static_cast<std::size_t>(d)];
      inside = inside && angle >= posed.body.dof(d).lower && angle <= upper_limit(posed, d, other);
    }
    // 1e-9 rad off the minimum, at slopes of less than 1 m²/rad
    if (inside) RC_ASSERT(ik.objective(targets, from, {}, other, gradient) >= least - 1e-10);
  }
}

RC_GTEST_PROP(NlpIkProperty, APlantedFootStandsHoweverTheHandsPull, (std::uint64_t seed)) {
  const RandomTask task(seed, 1.5);
  const Solved found = solve(task.posed, task.from, task.targets, task.inverse_weights);
  const Kinematics<double> now = placed(task.posed, found.q);
  const Constraint<double> foot = planted(task.posed);
  RC_ASSERT(norm(position_error(now, foot)) <= 1e-4);
  RC_ASSERT(kContactLength * tilt(now, foot) <= 1.01e-4);
}

TEST(NlpIk, NothingMovesRatherThanAFootByMoreThanFiveSlacks) {
  const PosedBody posed = chain({{Axis::x, 1.0}});
  const Vector from{0.5};
  Constraint<double> foot = moves_by(posed, from, {});
  foot.exact = true;
  foot.turning = Turning::whole;
  foot.orientation = placed(posed, from).link_rotation(foot.link);
  const auto pulled = [&](double slack) {
    return solve(posed, from, {moves_by(posed, from, {0, -0.1, 0.2}), foot}, {1.0},
                 {.contact_slack = slack, .contact_corrections = 0, .goal_corrections = 0});
  };
  const Kinematics<double> now = placed(posed, pulled(1.0).q);
  const double off = max(norm(position_error(now, foot)), kContactLength * tilt(now, foot));
  ASSERT_GT(off, 1e-3);
  EXPECT_NE(pulled(off / 4.9).q, from);
  EXPECT_TRUE(pulled(off / 4.9).outcome.converged);
  EXPECT_EQ(pulled(off / 5.1).q, from);
  EXPECT_FALSE(pulled(off / 5.1).outcome.converged);
}

RC_GTEST_PROP(NlpIkProperty, LockedJointsDoNotMoveAtAll, (std::uint64_t seed)) {
  RandomTask task(seed, 0.2);
  for (double& inverse : task.inverse_weights) {
    if (*rc::gen::inRange(0, 3) == 0) inverse = 0.0;
  }
  const Solved found = solve(task.posed, task.from, task.targets, task.inverse_weights);
  for (std::size_t d = 0; d < found.q.size(); ++d) {
    RC_ASSERT(std::isfinite(found.q[d]));
    if (task.inverse_weights[d] == 0.0) RC_ASSERT(found.q[d] == task.from[d]);
  }
}

TEST(NlpIk, RefusesWhatIsOutsideItsRanges) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const auto refuses = [&](auto change) {
    NlpIkSettings settings;
    change(settings);
    EXPECT_THROW(solve(posed, {0, 0}, {}, {1, 1}, settings), PreconditionError);
  };
  refuses([](auto& s) { s.damping = 0.0; });
  refuses([](auto& s) { s.damping = 2.0; });
  refuses([](auto& s) { s.lag_damping = -1.0; });
  refuses([](auto& s) { s.lag_scale = 0.0; });
  refuses([](auto& s) { s.limit_approach = 0.0; });
  refuses([](auto& s) { s.limit_approach = 1.1; });
  refuses([](auto& s) { s.max_change = 0.0; });
  refuses([](auto& s) { s.contact_stiffness = 0.5; });
  refuses([](auto& s) { s.contact_slack = 0.0; });
  refuses([](auto& s) { s.contact_corrections = -1; });
  refuses([](auto& s) { s.lead_limit = -1.0; });
  refuses([](auto& s) { s.goal_slack = 0.0; });
  refuses([](auto& s) { s.goal_corrections = -1; });
  refuses([](auto& s) { s.max_step = 0.0; });
  refuses([](auto& s) { s.tolerance = 0.0; });
  refuses([](auto& s) { s.iterations = 0; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(solve(posed, {0, 0}, {}, {1, 1}));
  EXPECT_THROW(solve(posed, {0, 0}, {}, {1}), PreconditionError);
  EXPECT_THROW(solve(posed, {0, 0}, {}, {1, -1}), PreconditionError);
  EXPECT_THROW(solve(posed, {0, 0}, {}, {1, nan}), PreconditionError);
  BodyDefinition lowered = chain_definition({{Axis::x, 1.0}, {Axis::x, 1.0}});
  lowered.couplings.push_back({.dof = 0, .driver = 1, .gain = -0.1, .driver_full = 1.0});
  EXPECT_THROW((NlpIk{at_zero(lowered), at_zero(lowered).home}), PreconditionError);
}

}  // namespace
}  // namespace shigusa
