// SPDX-License-Identifier: MIT
#include "kinematics/weighted_ik.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Targets = std::vector<Constraint<double>>;
using Vector = std::vector<double>;

// Goals are to be met exactly and no step is cut short.
constexpr IkSettings kExact{
    .damping = 0.0, .lag_damping = 0.0, .contact_damping = 0.0, .max_step = 1e3};

Vector ik_step(const PosedBody& posed, const Vector& q, const Targets& targets,
               const Vector& inverse_weights, const Vector& reference = {},
               const IkSettings& settings = kExact) {
  IkWorkspace<double> workspace(posed);
  std::fill(workspace.columns.begin(), workspace.columns.end(), Vec3d{7, 7, 7});  // of other steps
  const auto dq = weighted_ik_step<double>(
      posed, placed(posed, q), {targets, inverse_weights, reference}, settings, workspace);
  return {dq.begin(), dq.end()};
}

// The tip of a chain moves by `way`.
Targets tip_moves_by(const PosedBody& posed, const Vector& q, const Vec3d& way) {
  const Effector& tip = posed.body.effectors()[0];
  return {{.link = tip.link,
           .point = tip.point,
           .place = placed(posed, q).point(tip.link, tip.point) + way}};
}

TEST(WeightedIk, OneHingeGoesTheArcLength) {
  const PosedBody posed = chain({{Axis::x, 2.0}});
  // upright, the tip moves along z by 2 m per radian
  const Vector dq = ik_step(posed, {0.0}, tip_moves_by(posed, {0.0}, {0, 0, 0.1}), {1.0});
  EXPECT_NEAR(dq[0], 0.05, 1e-15);
}

TEST(WeightedIk, HingesShareAWayByTheirInverseWeights) {
  // both hinges move the tip of the bent rod alike, but for their distance to it
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const double w0 = 2.0;
  const double w1 = 3.0;
  const Vector dq =
      ik_step(posed, {0, 0}, tip_moves_by(posed, {0, 0}, {0, 0, 0.1}), {1 / w0, 1 / w1});
  // min w0 a² + w1 b²  s.t.  2 a + b = 0.1
  const double multiplier = 0.1 / (4 / w0 + 1 / w1);
  EXPECT_NEAR(dq[0], 2 / w0 * multiplier, 1e-15);
  EXPECT_NEAR(dq[1], 1 / w1 * multiplier, 1e-15);
}

// Weights determine how joints share a motion, whatever their unit: a factor of a power of two
// changes not even the rounding.
TEST(WeightedIk, AllWeightsTimesAPowerOfTwoMoveJointsAlike) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Targets targets = tip_moves_by(posed, {0, 0.5}, {0, 0.05, 0.1});
  const Vector step = ik_step(posed, {0, 0.5}, targets, {0.5, 2.0}, {}, IkSettings{});
  ASSERT_NE(step[0], 0.0);
  for (const int power : {-60, -20, 20, 60}) {
    const Vector weights{std::ldexp(0.5, power), std::ldexp(2.0, power)};
    EXPECT_EQ(ik_step(posed, {0, 0.5}, targets, weights, {}, IkSettings{}), step) << power;
  }
}

TEST(WeightedIk, GoalNoJointLeadsToStandsStill) {
  // straight up, no hinge lengthens the rod
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector dq = ik_step(posed, {0, 0}, tip_moves_by(posed, {0, 0}, {0, 0.1, 0}), {1.0, 1.0});
  EXPECT_EQ(dq, (Vector{0.0, 0.0}));
}

TEST(WeightedIk, WithAllJointsLockedNothingMoves) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector dq = ik_step(posed, {0, 0.5}, tip_moves_by(posed, {0, 0.5}, {0, 0.1, 0.1}), {0, 0},
                            {0.3, 0.3}, IkSettings{});
  EXPECT_EQ(dq, (Vector{0.0, 0.0}));
}

TEST(WeightedIk, WithoutTargetsItTakesTheReference) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector dq = ik_step(posed, {0, 0.5}, {}, {1.0, 0.0}, {0.3, 0.4});
  EXPECT_EQ(dq, (Vector{0.3, 0.0}));
}

TEST(WeightedIk, LongStepIsScaledDownAsAWhole) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Targets targets = tip_moves_by(posed, {0, 0.5}, {0, 0, 5.0});
  IkSettings cut = kExact;
  cut.max_step = 0.25;
  const Vector whole = ik_step(posed, {0, 0.5}, targets, {1.0, 1.0});
  const Vector part = ik_step(posed, {0, 0.5}, targets, {1.0, 1.0}, {}, cut);
  const double largest = std::fmax(std::fabs(whole[0]), std::fabs(whole[1]));
  ASSERT_GT(largest, cut.max_step);
  EXPECT_NEAR(part[0], whole[0] * (cut.max_step / largest), 1e-15);
  EXPECT_NEAR(part[1], whole[1] * (cut.max_step / largest), 1e-15);
}

TEST(WeightedIk, ShortStepIsNotScaled) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  const Targets targets = tip_moves_by(posed, {0, 0.5}, {0, 0, 0.1});
  IkSettings cut = kExact;
  cut.max_step = 0.25;
  EXPECT_EQ(ik_step(posed, {0, 0.5}, targets, {1.0, 1.0}, {}, cut),
            ik_step(posed, {0, 0.5}, targets, {1.0, 1.0}));
}

TEST(WeightedIk, GoalThatLagsIsDampedByTheSquareOfItsLag) {
  // one hinge, J = (0, 0, 2): Δq = J e / (J² + share · J² / 3), J² / 3 being the mean diagonal
  const PosedBody posed = chain({{Axis::x, 2.0}});
  Targets targets = tip_moves_by(posed, {0.0}, {0, 0, 0.1});
  targets[0].lag = 0.3;
  const IkSettings settings{
      .damping = 0.5, .lag_damping = 2.0, .lag_scale = 0.1, .contact_damping = 0.0, .max_step = 1};
  const double share = 0.5 + 2.0 * 9.0;
  const Vector dq = ik_step(posed, {0.0}, targets, {1.0}, {}, settings);
  EXPECT_NEAR(dq[0], 0.05 / (1.0 + share / 3.0), 1e-15);
}

TEST(WeightedIk, ContactIsDampedByItsMeanDiagonal) {
  const PosedBody posed = chain({{Axis::x, 2.0}});
  Targets targets = tip_moves_by(posed, {0.0}, {0, 0, 0.1});
  targets[0].exact = true;
  IkSettings settings = kExact;
  settings.contact_damping = 0.3;
  const Vector dq = ik_step(posed, {0.0}, targets, {1.0}, {}, settings);
  // of three rows one moves, by 2 m per radian
  EXPECT_NEAR(dq[0], 0.1 * 2.0 / (4.0 + 0.3 * 4.0 / 3.0), 1e-15);
}

TEST(WeightedIk, PlaceOnALinkMovesWithIt) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}});
  Targets targets = tip_moves_by(posed, {0, 0}, {});
  targets[0].carrier = 0;
  targets[0].exact = true;
  // the first hinge is a goal's, and moves tip and place alike
  targets.push_back({.link = 0, .point = {0, 1, 0}, .place = {0, 1, 0.2}});
  for (int order = 0; order < 2; ++order, std::swap(targets[0], targets[1])) {
    const Vector dq = ik_step(posed, {0, 0}, targets, {1.0, 1.0});
    EXPECT_NEAR(dq[0], 0.2, 1e-15);
    EXPECT_NEAR(dq[1], 0.0, 1e-15);
  }
}

TEST(WeightedIk, ConstraintThatIsNotActiveLeavesTheOthersAlone) {
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::y, 1.0}});
  const Vector q{0.3, 0.5, 0.2};
  Targets targets = tip_moves_by(posed, q, {0.01, 0.02, 0.1});
  const Vector alone = ik_step(posed, q, targets, {1, 2, 3});
  for (const Turning turning : {Turning::free, Turning::whole, Turning::axis}) {
    for (const int carrier : {kWorldCarrier, 0}) {
      const Constraint<double> off{.link = 1,
                                   .point = {0, 1, 0},
                                   .carrier = carrier,
                                   .place = {5, 5, 5},
                                   .exact = true,
                                   .turning = turning,
                                   .axis = {0, 1, 0},
                                   .direction = {1, 0, 0},
                                   .active = 0.0};
      EXPECT_EQ(ik_step(posed, q, {off, targets[0]}, {1, 2, 3}), alone);
      EXPECT_EQ(ik_step(posed, q, {targets[0], off}, {1, 2, 3}), alone);
    }
  }
}

TEST(WeightedIk, ContactIsHeldAgainstAGoalThatPullsAway) {
  // the tip is planted, and the goal of the middle exceeds the single dof left: it gives way
  const PosedBody posed = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}});
  const Vector q{0.3, 0.5, 0.6, 0.4};
  Targets targets = tip_moves_by(posed, q, {0, 0, 0});
  const Kinematics<double> kinematics = placed(posed, q);
  targets[0].exact = true;
  targets[0].turning = Turning::whole;
  targets[0].orientation = kinematics.link_rotation(3);
  targets.insert(targets.begin(), {.link = 1, .point = {0, 1, 0}, .place = {0, 3, 3}, .lag = 0.1});
  const Vector dq = ik_step(posed, q, targets, {1, 1, 1, 1}, {}, IkSettings{});
  double largest = 0.0;
  Vec3d slide{};
  double tilt = 0.0;
  const Vec3d at = kinematics.point(3, {0, 1, 0});
  for (int d = 0; d < 4; ++d) {
    const double step = dq[static_cast<std::size_t>(d)];
    largest = std::fmax(largest, std::fabs(step));
    slide += position_column(kinematics, d, at) * step;
    tilt += step;
  }
  EXPECT_GT(largest, 0.01);
  // contacts give way too, by 1e-9 of the system's diagonal times the force that pulls them away
  EXPECT_LT(norm(slide), 1e-6 * largest);
  EXPECT_LT(std::fabs(tilt), 1e-6 / kContactLength * largest);
}

TEST(WeightedIk, TiltedContactIsTurnedBack) {
  const PosedBody posed = chain({{Axis::x, 1.0},
                                 {Axis::y, 1.0},
                                 {Axis::x, 1.0},
                                 {Axis::z, 1.0},
                                 {Axis::x, 1.0},
                                 {Axis::y, 1.0},
                                 {Axis::z, 1.0}});
  const Vector upright{0.3, 0.1, -0.8, 0.2, 0.5, -0.3, 0.1};
  Targets targets = tip_moves_by(posed, upright, {});
  targets[0].exact = true;
  targets[0].turning = Turning::whole;
  targets[0].orientation = placed(posed, upright).link_rotation(6);
  Vector q = upright;
  for (std::size_t d = 0; d < q.size(); ++d) q[d] += d % 2 == 0 ? 0.02 : -0.03;
  for (int k = 0; k < 5; ++k) {
    const Vector dq = ik_step(posed, q, targets, Vector(7, 1.0));
    for (std::size_t d = 0; d < q.size(); ++d) q[d] += dq[d];
  }
  EXPECT_LT(distance(placed(posed, q).link_rotation(6), targets[0].orientation), 1e-12);
  EXPECT_LT(norm(effector_position(posed, q, "tip") - targets[0].place), 1e-12);
}

TEST(WeightedIk, MoreRowsThanFitAreRefused) {
  const PosedBody posed = chain({{Axis::x, 1.0}});
  const Targets nine(9, Constraint<double>{.point = {0, 1, 0}});
  EXPECT_THROW(ik_step(posed, {0.0}, nine, {1.0}), PreconditionError);
  const Targets eight(8, Constraint<double>{.point = {0, 1, 0}, .place = {0, 1, 0}});
  EXPECT_NO_THROW(ik_step(posed, {0.0}, eight, {1.0}));
}

// A random step of the full body: both hands to nearby goals, the second foot held.
struct RandomStep {
  PosedBody posed = full_body();
  Vector q;
  Targets targets;
  Vector inverse_weights;

  explicit RandomStep(std::uint64_t seed) {
    Random random(seed);
    q.assign(posed.home.angles.begin(), posed.home.angles.end());
    for (double& angle : q) angle += random.uniform(-0.5, 0.5);
    const Kinematics<double> kinematics = placed(posed, q);
    const auto here = [&](int link, const Vec3d& point) {
      const Vec3d away{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                       random.uniform(-0.1, 0.1)};
      return Constraint<double>{
          .link = link, .point = point, .place = kinematics.point(link, point) + away};
    };
    for (const Effector& e : posed.body.effectors()) targets.push_back(here(e.link, e.point));
    const Foot& foot = posed.body.feet()[1];
    Constraint<double> contact = here(foot.link, foot.centre);
    contact.place = kinematics.point(foot.link, foot.centre);
    contact.exact = true;
    contact.turning = Turning::whole;
    contact.orientation = kinematics.link_rotation(foot.link);
    targets.push_back(contact);
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      inverse_weights.push_back(1.0 / (1.0 + 14.0 * random.uniform()));
    }
  }

  [[nodiscard]] Vector taken(const IkSettings& settings = kExact) const {
    return ik_step(posed, q, targets, inverse_weights, {}, settings);
  }
};

TEST(WeightedIk, HandStaysOnALinkOfAnotherBranch) {
  RandomStep step(7);
  const PosedBody& posed = step.posed;
  const Kinematics<double> kinematics = placed(posed, step.q);
  const int thigh = posed.body.dof(posed.body.find_dof("left_knee.flexion").value()).parent;
  Constraint<double>& hand = step.targets[1];
  const Vec3d at = kinematics.point(hand.link, hand.point);
  hand.carrier = thigh;
  hand.place = transpose_times(kinematics.link_rotation(thigh), at - kinematics.link_origin(thigh));
  hand.exact = true;
  const int link = hand.link;
  for (int order = 0; order < 3; ++order) {
    const Vector dq = step.taken();
    Vec3d moved{};
    Vec3d carried{};
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const Vec3d way = position_column(kinematics, d, at) * dq[static_cast<std::size_t>(d)];
      if (posed.body.moves(d, link)) moved += way;
      if (posed.body.moves(d, thigh)) carried += way;
    }
    EXPECT_GT(norm(carried), 0.01);
    EXPECT_LT(norm(moved - carried), 1e-12);
    std::rotate(step.targets.begin(), step.targets.begin() + 1, step.targets.end());
  }
}

double largest_difference(const Vector& a, const Vector& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
  return largest;
}

// Holds exactly for the minimiser of Σ w Δq² among the Δq of one fixed set: from Σ w a² ≤ Σ w b²
// and Σ w' b² ≤ Σ w' a² follows (w'_k - w_k) (b_k² - a_k²) ≤ 0.
RC_GTEST_PROP(WeightedIkProperty, LargerWeightNeverMovesAJointMore, (std::uint64_t seed)) {
  RandomStep step(seed);
  const auto k = static_cast<std::size_t>(*rc::gen::inRange(0, step.posed.body.dof_count()));
  const double factor = 1.0 + 0.01 * *rc::gen::inRange(1, 100000);
  const double light = std::fabs(step.taken()[k]);
  step.inverse_weights[k] /= factor;
  const double heavy = std::fabs(step.taken()[k]);
  RC_ASSERT(heavy <= light + 1e-10);  // rounding of steps of up to 1 rad
}

RC_GTEST_PROP(WeightedIkProperty, ScalingAllWeightsChangesNothing, (std::uint64_t seed)) {
  RandomStep step(seed);
  const double factor = std::pow(10.0, *rc::gen::inRange(-60, 61) / 10.0);
  const Vector before = step.taken(IkSettings{});
  for (double& inverse : step.inverse_weights) inverse *= factor;
  RC_ASSERT(largest_difference(before, step.taken(IkSettings{})) <= 1e-9);
}

RC_GTEST_PROP(WeightedIkProperty, LockedJointsDoNotMoveAtAll, (std::uint64_t seed)) {
  RandomStep step(seed);
  const auto locked =
      *rc::gen::container<std::vector<bool>>(step.q.size(), rc::gen::arbitrary<bool>());
  for (std::size_t d = 0; d < step.q.size(); ++d) {
    if (locked[d]) step.inverse_weights[d] = 0.0;
  }
  const Vector dq = step.taken(IkSettings{});
  for (std::size_t d = 0; d < step.q.size(); ++d) {
    RC_ASSERT(std::isfinite(dq[d]));
    if (locked[d]) RC_ASSERT(dq[d] == 0.0);
  }
}

RC_GTEST_PROP(WeightedIkProperty, NoAngleChangesByMoreThanTheLargestStep, (std::uint64_t seed)) {
  RandomStep step(seed);
  const double reach = *rc::gen::inRange(0, 1000) / 10.0;
  for (std::size_t g = 0; g < 2; ++g) step.targets[g].place.y += reach;
  const IkSettings settings;
  for (const double dq : step.taken(settings)) {
    RC_ASSERT(std::fabs(dq) <= settings.max_step * (1.0 + 1e-15));
  }
}

}  // namespace
}  // namespace shigusa
