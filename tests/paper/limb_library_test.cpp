// SPDX-License-Identifier: MIT
#include "paper/limb_library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plan/layer.hpp"
#include "rollout/rollout.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

PosedBody right_arm(const PosedBody& posed = half_body()) {
  return arm_body(posed.body, posed.home, find_limbs(posed.body, posed.home).value().arms[0]);
}

LimbLibrary library(LimbSearch search = LimbSearch::ladder, BatchSettings batch = {}) {
  return LimbLibrary(right_arm(), {.search = search, .batch = batch});
}

TEST(ArmBody, MovesAsTheArmOfTheWholeBody) {
  const PosedBody posed = full_body();
  const BodyLimbs limbs = find_limbs(posed.body, posed.home).value();
  Random random(8);
  for (const BodyLimb& limb : limbs.arms) {
    const PosedBody arm = arm_body(posed.body, posed.home, limb);
    std::vector<double> whole(posed.home.angles.begin(), posed.home.angles.end());
    const std::vector<double> q = random_posture(arm, random);
    for (const auto& [k, dof] :
         {std::pair{0u, limb.flexion}, {1u, limb.abduction}, {2u, limb.rotation}, {3u, limb.hinge}})
      whole[static_cast<std::size_t>(dof)] = q[k];
    const Kinematics<double> at = placed(posed, whole);
    const char* name = posed.body.effectors()[static_cast<std::size_t>(limb.effector)].name.c_str();
    const Vec3d hand =
        effector_position(posed, whole, name) - at.origin[static_cast<std::size_t>(limb.flexion)];
    const Vec3d alone = effector_position(arm, q, name);
    EXPECT_LT(norm(transpose_times(at.link_rotation(limbs.trunk), hand) - alone), 1e-12);
  }
}

TEST(ArmRollout, FollowsItsPathAndLargerWeightsMoveLess) {
  const PosedBody arm = right_arm();
  ArmRollout<double> rollout(arm);
  const Vec3d from = effector_position(arm, arm.home.angles, "right_hand");
  const EffectorPath way{.start = from, .goal = {-0.05, -0.1, 0.45}};
  std::vector<Vec3d> path;
  for (int f = 0; f <= 60; ++f) path.push_back(way.at(f / 60.0));
  double last = 1e9;
  for (const double weight : {1.0, 4.0, 15.0}) {
    ArmWeights weights;
    weights[2].weight = weight;  // rotation
    std::vector<double> angles;
    EXPECT_LT(rollout.run(path, inverse_weights(weights), angles), 1e-6);
    ASSERT_EQ(angles.size(), 61u * kArmDofs);
    const double turned = abs(angles[60 * kArmDofs + 2] - arm.home.angles[2]);
    EXPECT_LT(turned, last);
    last = turned;
  }
}

TEST(LimbLibrary, NearestCellIsTheNearestInTheGrid) {
  const LimbLibrary cells = library();
  const double longest = norm(cells.goal_of(kLimbCells - 1));
  std::set<int> seen;
  for (int cell = 0; cell < kLimbCells; ++cell) {
    EXPECT_EQ(cells.cell_of(cells.goal_of(cell)), cell);
    seen.insert(cell);
  }
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const Vec3d hand = random_direction(random) * random.uniform(0.3, longest);
    const Vec3d goal = cells.goal_of(cells.cell_of(hand));
    // half a step of each: azimuth and elevation 7.5°, radius 0.065 of the length
    EXPECT_LE(abs(norm(goal) - norm(hand)), 0.0651 * longest);
    EXPECT_GE(dot(goal, hand) / (norm(goal) * norm(hand)), std::cos(radians(10.7)));
  }
}

TEST(LimbLibrary, PathsKeepAwayFromTheShoulder) {
  const LimbLibrary cells = library();
  const double least = kLimbRadiusMin * norm(cells.goal_of(kLimbCells - 1));
  for (int cell = 0; cell < kLimbCells; ++cell) {
    const EffectorPath path = cells.path_to(cell);
    for (int f = 0; f <= 60; ++f) EXPECT_GT(norm(path.at(f / 60.0)), 0.9 * least) << cell;
  }
}

TEST(LimbLibrary, LadderFindsWhatEnumerationFinds) {
  LimbLibrary ladder = library();
  LimbLibrary all = library(LimbSearch::enumeration);
  // in front, to the other side, overhead, far, near
  for (const Vec3d& hand : {Vec3d{0.05, -0.1, 0.45}, {0.3, 0.05, 0.25}, {-0.1, 0.5, 0.2}}) {
    const int cell = ladder.cell_of(hand);
    EXPECT_LE(all.score(cell), ladder.score(cell));
    EXPECT_LE(ladder.score(cell), 1.02 * all.score(cell) + 1e-4) << cell;
  }
}

TEST(LimbLibrary, CellsAreScoredAsTheirMotionsAre) {
  LimbLibrary cells = library();
  const PosedBody arm = right_arm();
  CriteriaSettings lower;
  lower[CriterionKind::balance].weight = 0.0;
  int leads = 0;
  for (int cell = 0; cell < kLimbCells; cell += 97) {
    ReachProblem problem;
    problem.body = &arm.body;
    problem.context.start = arm.home;
    problem.goals = {{0, cells.path_to(cell)}};
    problem.duration =
        reach_duration(norm(problem.goals[0].path.goal - problem.goals[0].path.start), false);
    const ArmWeights weights = arm_weights(cells.genes(cell));
    Parameters parameters = uniform_parameters(arm);
    for (std::size_t d = 0; d < weights.size(); ++d) {
      parameters.values[d] = weights[d].weight;
      parameters.locked[d] = weights[d].locked;
    }
    const RolledOut rolled = roll_out(problem, parameters);
    if (cells.score(cell) >= worst_score(lower)) continue;
    ++leads;
    EXPECT_TRUE(rolled.outcome.met());
    EXPECT_NEAR(score_motion(arm, rolled.motion, lower).total, cells.score(cell), 1e-3) << cell;
    // better than the plain pseudo-inverse, or as good
    const RolledOut uniform = roll_out(problem, uniform_parameters(arm));
    EXPECT_LE(cells.score(cell), score_motion(arm, uniform.motion, lower).total + 1e-3);
  }
  EXPECT_GE(leads, 15);
}

TEST(LimbLibrary, DoesNotDependOnThreadsLanesOrOrder) {
  LimbLibrary one = library(LimbSearch::ladder, {SimdSet::scalar, 1});
  LimbLibrary other = library(LimbSearch::ladder, {widest_simd_set(), 2});
  for (const int cell : {500, 901, 1300}) one.build(cell);
  for (const int cell : {1300, 500, 901}) other.build(cell);
  EXPECT_EQ(one.bytes(), other.bytes());
}

TEST(LimbLibrary, TakesWhatAnotherStored) {
  LimbLibrary first = library();
  first.build(700);
  first.build(1234);
  LimbLibrary second = library();
  second.build(3);
  EXPECT_TRUE(second.take(first.bytes()));
  EXPECT_EQ(second.cells_built(), 3);
  EXPECT_EQ(second.genes(1234), first.genes(1234));
  EXPECT_EQ(second.score(1234), first.score(1234));
  EXPECT_EQ(second.cells_built(), 3);
}

TEST(LimbLibrary, LeavesDamagedOnesAlone) {
  LimbLibrary first = library();
  first.build(700);
  const std::string good = first.bytes();
  for (std::size_t cut = 0; cut < good.size(); ++cut) {
    EXPECT_FALSE(library().take(good.substr(0, cut)));
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    EXPECT_FALSE(library().take(bad)) << at;
  }
  EXPECT_FALSE(library().take(good + "x"));
  LimbLibrary untouched = library();
  EXPECT_FALSE(untouched.take("nothing of the kind"));
  EXPECT_EQ(untouched.cells_built(), 0);
}

TEST(LimbLibrary, IsOfOneBodyAndOneSearch) {
  LimbLibrary first = library();
  first.build(700);
  EXPECT_FALSE(library(LimbSearch::enumeration).take(first.bytes()));
  LimbLibrary taller(right_arm(half_body({1.8, 73.0, Sex::male})));
  EXPECT_NE(taller.hash(), first.hash());
  EXPECT_FALSE(taller.take(first.bytes()));
  EXPECT_EQ(library().hash(), first.hash());
}

}  // namespace
}  // namespace shigusa
