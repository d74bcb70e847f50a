// SPDX-License-Identifier: MIT
#include "criteria/collision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "body/load.hpp"
#include "core/index.hpp"
#include "criteria/built_in_criteria.hpp"
#include "simd/pack.hpp"
#include "support/bodies.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

std::vector<double> posture(const PosedBody& posed,
                            std::initializer_list<std::pair<const char*, double>> angles_deg) {
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  for (const auto& [name, angle] : angles_deg) {
    angles[static_cast<std::size_t>(posed.body.find_dof(name).value())] = radians(angle);
  }
  return angles;
}

CriteriaContext at_start(const PosedBody& posed) { return {.start = posed.home}; }

Clip clip_of(const PosedBody& posed, const std::vector<std::vector<double>>& frames) {
  Clip clip;
  clip.dofs = posed.body.dof_count();
  clip.frames = static_cast<int>(frames.size());
  clip.frame_time = 0.1;
  for (const auto& frame : frames) {
    clip.angles.insert(clip.angles.end(), frame.begin(), frame.end());
  }
  return clip;
}

TEST(Collision, AStandingPersonTouchesNothing) {
  for (const PosedBody& posed :
       {half_body(), full_body(), human_body(), human_body({.heels = true})}) {
    const CollisionFound found = deepest_collision(posed, clip_of(posed, {posture(posed, {})}));
    EXPECT_EQ(found.depth, 0.0) << posed.body.name();
    EXPECT_EQ(found.time, 0.0) << posed.body.name();
  }
}

// A hand at a part of another body, by any angles that bring it there.
TEST(Collision, SeesForearmsInHeadsAndShanks) {
  const PosedBody posed = full_body();
  const auto folded = posture(posed, {{"right_shoulder.flexion", 150},
                                      {"right_shoulder.abduction", -20},
                                      {"right_shoulder.rotation", -60},
                                      {"right_elbow.flexion", 120}});
  const CollisionFound head =
      deepest_collision(posed, clip_of(posed, {posture(posed, {}), folded}));
  EXPECT_TRUE(head.other == "head" || head.other == "jaw" || head.other == "neck") << head.other;
  // an arm that swings across the shins of a stooping person
  int through = 0;
  for (double swing = -40.0; swing <= 20.0; swing += 5.0) {
    for (double lift = 60.0; lift <= 130.0; lift += 5.0) {
      const auto stooped = posture(posed, {{"right_hip.flexion", 110},
                                           {"right_shoulder.flexion", lift},
                                           {"right_shoulder.abduction", swing}});
      const CollisionFound found =
          deepest_collision(posed, clip_of(posed, {posture(posed, {}), stooped}));
      through += found.other.ends_with("shank") && found.depth > 0.03 ? 1 : 0;
    }
  }
  EXPECT_GE(through, 1);
}

TEST(Collision, SeesOneLegInTheOther) {
  const PosedBody posed = human_body();
  const auto crossed = posture(posed, {{"left_hip.abduction", -20}});
  const CollisionFound found =
      deepest_collision(posed, clip_of(posed, {posture(posed, {}), crossed}));
  EXPECT_TRUE(found.limb.starts_with("left_")) << found.limb;
  EXPECT_TRUE(found.other.starts_with("right_")) << found.other;
  EXPECT_GT(found.depth, 0.03);
}

TEST(Collision, NamesWhatPassesThroughWhatAndWhen) {
  const PosedBody posed = human_body();
  // the forearm turned inwards goes through the belly
  const auto inside = posture(posed, {{"right_elbow.flexion", 90},
                                      {"right_shoulder.rotation", -70},
                                      {"right_shoulder.flexion", -25}});
  const CollisionFound found =
      deepest_collision(posed, clip_of(posed, {posture(posed, {}), inside, posture(posed, {})}));
  EXPECT_GT(found.depth, 0.03);
  EXPECT_TRUE(found.limb == "right_hand" || found.limb == "right_forearm") << found.limb;
  EXPECT_TRUE(found.other == "pelvis" || found.other == "spine" || found.other == "chest")
      << found.other;
  EXPECT_DOUBLE_EQ(found.time, 0.1);
}

// Fingers curl on the floor: a hand that points down may be as low as its knuckles.
TEST(Collision, AHandOnTheFloorEndsAtItsKnuckles) {
  const PosedBody posed = human_body();
  const Effector& hand = posed.body.effector(*posed.body.find_effector("left_hand"));  // the lower
  int stands = 0;
  int in_floor = 0;
  for (double bent = 60.0; bent < 170.0; bent += 1.0) {
    const auto low = posture(posed, {{"right_hip.flexion", bent}, {"right_knee.flexion", bent}});
    const Kinematics<double> kinematics = placed(posed, low);
    const double grip = kinematics.point(hand.link, hand.point).y;
    const CollisionFound found = deepest_collision(posed, clip_of(posed, {low}), at_start(posed));
    const bool through = found.depth > 0.0 && found.other == "floor";
    if (grip > 0.055 && grip < 0.08) {
      ++stands;
      EXPECT_FALSE(through) << grip;
    }
    if (grip > 0.0 && grip < 0.02) {
      ++in_floor;
      EXPECT_TRUE(through) << grip;
    }
  }
  EXPECT_GT(stands, 0);
  EXPECT_GT(in_floor, 0);
}

// A ball centred at the wrist: the depth is the sum of both radii.
TEST(Collision, DepthInABallIsThatOfTheirRadii) {
  const PosedBody posed = human_body();
  const auto raised = posture(posed, {{"right_shoulder.flexion", 90}});
  const Kinematics<double> kinematics = placed(posed, raised);
  for (const Capsule& capsule : posed.body.capsules()) {
    if (capsule.name != "right_forearm") continue;  // thicker than the hand
    CriteriaContext context = at_start(posed);
    context.obstacles.push_back(
        {.name = "ball", .position = kinematics.point(capsule.link, capsule.to), .radius = 0.02});
    const CollisionFound found = deepest_collision(posed, clip_of(posed, {raised}), context);
    EXPECT_EQ(found.other, "ball");
    EXPECT_NEAR(found.depth, capsule.radius + 0.02, 1e-9);
  }
}

TEST(Collision, DistanceFromABoxIsSignedAndTurnsWithIt) {
  Obstacle box{.name = "box", .position = {1, 0, 0}, .size = {2, 4, 6}};
  const auto distance = [&box](const Vec3d& at) {
    return box_distance(placed_boxes({&box, 1}).front(), at);
  };
  EXPECT_NEAR(distance({3, 0, 0}), 1.0, 1e-12);
  EXPECT_NEAR(distance({1, 1.5, 0}), -0.5, 1e-12);
  EXPECT_NEAR(distance({5, 6, 0}), 5.0, 1e-12);  // 3, 4, 5 from the edge
  box.rotation = axis_rotation(Axis::z, radians(90));
  EXPECT_NEAR(distance({3, 0, 0}), 0.0, 1e-12);
  box.radius = 0.25;
  EXPECT_NEAR(distance({4, 0, 0}), 0.75, 1e-12);
}

PlacedCapsule<double> line(const Vec3d& from, const Vec3d& to) {
  return {from, to, (from + to) * 0.5};
}

// A limb that lies across a corner between its ends and its midpoint.
TEST(Collision, NearestPointToABoxIsFoundAlongALimb) {
  Random random(7);
  const auto drawn = [&random](double most) {
    return Vec3d{random.uniform(-most, most), random.uniform(-most, most),
                 random.uniform(-most, most)};
  };
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    Obstacle box{.name = "box", .position = drawn(0.2), .size = drawn(0.2) + Vec3d{0.3, 0.3, 0.3}};
    box.rotation = axis_rotation(Axis::y, random.uniform(-3.0, 3.0));
    const PlacedBox placed = placed_boxes({&box, 1}).front();
    const PlacedCapsule<double> limb = line(drawn(0.4), drawn(0.4));
    const double length = norm(limb.to - limb.from);
    const double taper = random.uniform(-0.02, 0.02);
    double least = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      const double share = k / 1000.0;
      const Vec3d at = limb.from + (limb.to - limb.from) * share;
      least = std::min(least, box_distance(placed, at) - taper * share);
    }
    const double found = axis_distance(placed, limb, length, taper, 0.05);
    EXPECT_GE(found, least - 1e-3 * length);
    if (least > 0.05) {
      EXPECT_GT(found, 0.05);
      continue;
    }
    ++inside;
    EXPECT_LE(found, least + length / 64);
  }
  EXPECT_GT(inside, 500);
}

// A box that the right hand holds, which reaches up beside the forearm.
TEST(Collision, DepthInAHeldThingIsThatOfItsBox) {
  const PosedBody person = human_body();
  const HeldLoad load{.effector = person.body.find_effector("right_hand").value(),
                      .turn = axis_rotation(Axis::y, 0.3),
                      .name = "crate",
                      .middle = {-0.25, 0.0, 0.05},
                      .parts = {{{}, {0.4, 0.3, 0.25}, 0.01}}};
  const PosedBody posed{with_load(person, load), person.home};
  const HeldShape& crate = posed.body.definition().held.front();
  const CollisionPairs pairs = collision_pairs(posed, at_start(posed));
  for (const CollisionPairs::Pair& pair : pairs.parts) {
    const auto& capsules = posed.body.capsules();
    EXPECT_EQ(capsules[index(pair.limb)].of_thing, capsules[index(pair.other)].of_thing);
  }
  Random random(11);
  Kinematics<double> placed(posed);
  std::vector<PlacedCapsule<double>> capsules(posed.body.capsules().size());
  std::set<std::string> met;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> angles = posed.home.angles;
    for (std::size_t d = 0; d < angles.size(); ++d) {
      const Dof& dof = posed.body.dofs()[d];
      angles[d] = clamp(angles[d] + random.uniform(-1.0, 1.0), dof.lower, dof.upper);
    }
    forward_kinematics<double>(posed, angles, placed);
    const Mat3d& turn = placed.link_rotation(crate.link);
    const PlacedBox box{placed.point(crate.link, crate.middle), crate.size * 0.5, crate.radius,
                        turn * to_matrix(crate.turn)};
    visit_collisions<double>(
        posed, pairs, placed, capsules,
        [&](const CollisionPairs::Pair& pair, CollisionKind kind, double depth) {
          if (kind != CollisionKind::held) return;
          const Capsule& limb = posed.body.capsules()[index(pair.limb)];
          double expected = -1.0;
          for (int k = 0; k <= 500; ++k) {
            const Vec3d at = limb.from + (limb.to - limb.from) * (k / 500.0);
            expected = max(expected, limb.radius + taper_of(limb) * k / 500.0 - pair.allowed -
                                         box_distance(box, placed.point(limb.link, at)));
          }
          if (expected < 0.0) {
            EXPECT_LT(depth, 0.0);
            return;
          }
          EXPECT_NEAR(depth, expected, norm(limb.to - limb.from) / 64 + 1e-4);
          met.insert(limb.name);
        });
  }
  EXPECT_TRUE(met.contains("right_forearm"));  // of the arm that holds it
  EXPECT_TRUE(met.contains("left_thigh"));
  EXPECT_FALSE(met.contains("right_hand"));
}

double distance_of(const PlacedCapsule<double>& a, const PlacedCapsule<double>& b) {
  return norm(nearest_places(a, b).apart);
}

TEST(Collision, SegmentsWithoutLengthArePoints) {
  const auto origin = line({}, {});
  const auto above = line({-1, 2, 0}, {1, 2, 0});
  EXPECT_NEAR(distance_of(origin, line({3, 4, 0}, {3, 4, 0})), 5.0, 1e-9);
  EXPECT_NEAR(distance_of(origin, above), 2.0, 1e-9);
  EXPECT_NEAR(distance_of(above, line({0.5, 0, 0}, {0.5, 0, 0})), 2.0, 1e-9);
}

// Compared with the pair of nearest points, which has its own test.
TEST(Collision, DistanceOfSegmentsIsThatOfTheirNearestPoints) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    Vec3d p[4];
    for (Vec3d& v : p) {
      v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    }
    if (i % 10 == 0) p[3] = p[2] + (p[1] - p[0]) * random.uniform(-2, 2);  // parallel
    const SegmentPair pair = nearest_points(p[0], p[1], p[2], p[3]);
    EXPECT_NEAR(distance_of(line(p[0], p[1]), line(p[2], p[3])), norm(pair.on_a - pair.on_b), 1e-6)
        << i;
  }
}

TEST(Collision, TaperedCapsulesAreAsThickAsWhereTheyAreNearest) {
  const Capsule limb{
      .name = "limb", .from = {0, 0, 0}, .to = {1, 0, 0}, .radius = 0.1, .to_radius = 0.02};
  for (const double along : {0.0, 0.25, 1.0}) {
    const Capsule ball{.name = "ball",
                       .from = {along, 0.2, 0},
                       .to = {along, 0.2, 0},
                       .radius = 0.05,
                       .to_radius = 0.05};
    const double expected = 0.1 - 0.08 * along + 0.05 - 0.2;
    EXPECT_NEAR(depth_of(line(limb.from, limb.to), limb, line(ball.from, ball.to), ball), expected,
                1e-9);
    EXPECT_NEAR(capsule_depth(limb, ball), expected, 1e-9);
  }
}

// A person whose parts yield by that depth (m).
PosedBody soft_person(double give) {
  BodyDefinition body = human_body().body.definition();
  for (Capsule& capsule : body.capsules) capsule.give = give;
  return {BodyModel(body), human_body().home};
}

TEST(Collision, SoftFleshYields) {
  const PosedBody hard = soft_person(0.0);
  const PosedBody soft = soft_person(0.008);
  const Motion motion =
      motion_through(hard, {posture(hard, {}), posture(hard, {{"left_hip.abduction", -20}})});
  EXPECT_NEAR(deepest_collision(soft, motion.clip, at_start(soft)).depth,
              deepest_collision(hard, motion.clip, at_start(hard)).depth - 0.008, 1e-9);
  EXPECT_NEAR(penalty_by<Collision>(soft, motion, 1.0),
              penalty_by<Collision>(hard, motion, 1.0) - 0.75 * 0.008, 1e-9);
}

TEST(Collision, UpperArmsThatAreGrownOnTheTrunkCollideWithNothing) {
  const PosedBody posed = human_body();
  int grown = 0;
  for (const Capsule& capsule : posed.body.capsules()) grown += capsule.grown_on ? 1 : 0;
  EXPECT_EQ(grown, 2);
  for (const CapsulePair& pair : all_limb_pairs(posed)) {
    EXPECT_FALSE(posed.body.capsules()[index(pair.limb)].grown_on);
  }
}

}  // namespace
}  // namespace shigusa
