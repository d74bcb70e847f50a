// SPDX-License-Identifier: MIT
#include "kinematics/rig_fingers.hpp"

#include <gtest/gtest.h>

#include <shigusa/math.hpp>
#include <shigusa/run.hpp>

namespace shigusa {
namespace {

TEST(HandPostures, BendMoreTowardsTheLittleFingerAndAsTheFunctionalPosition) {
  constexpr std::array kMean{45.0, 30.0, 20.0};
  for (int joint = 1; joint <= kFingerJoints; ++joint) {
    double sum = 0.0;
    double before = 0.0;
    for (const Finger finger : {Finger::index, Finger::middle, Finger::ring, Finger::little}) {
      const double bent = degrees(flexion(HandPosture::relaxed, finger, joint));
      EXPECT_GT(bent, before);
      EXPECT_LT(degrees(flexion(HandPosture::open, finger, joint)), 0.3 * bent);
      sum += before = bent;
    }
    EXPECT_NEAR(sum / 4.0, kMean[static_cast<std::size_t>(joint - 1)], 1e-9);
  }
}

// Jeannerod: widest at 60 to 70 % of the way. The third difference of a curve with a continuous
// second derivative shrinks with the step.
TEST(Openness, IsWidestLateAndSmooth) {
  EXPECT_EQ(openness(0.0), 0.0);
  EXPECT_EQ(openness(1.0), 0.0);
  double widest = 0.0;
  double at = 0.0;
  constexpr int kSteps = 2000;
  const auto second = [](double t) {
    constexpr double h = 1.0 / kSteps;
    return (openness(t + h) - 2.0 * openness(t) + openness(t - h)) / (h * h);
  };
  for (int k = 2; k < kSteps - 1; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    if (openness(t) > widest) {
      widest = openness(t);
      at = t;
    }
    // the greatest third derivative of minimum jerk is 60 / T³, T the shorter of the two
    EXPECT_LT(abs(second(t) - second(t - 1.0 / kSteps)), 1.1 * 60.0 / 0.0428 / kSteps) << t;
  }
  EXPECT_NEAR(widest, 1.0, 1e-9);
  EXPECT_GE(at, 0.6);
  EXPECT_LE(at, 0.7);
}

Quatd about(const Vec3d& axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return {axis.x * half.sin, axis.y * half.sin, axis.z * half.sin, half.cos};
}

// A hand with one finger of three joints along x, with nodes of arbitrary axes.
struct OneFinger {
  explicit OneFinger(Random& random) {
    Quatd above{0, 0, 0, 1};
    const auto any = [&] {
      const Vec3d axis =
          normalized({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) + 0.1});
      return about(axis, random.uniform(-3, 3));
    };
    for (int k = 0; k < 5; ++k) {
      const Quatd world = any();
      RigNode node;
      node.parent = k - 1;
      node.translation = transpose_times(to_matrix(above), k == 0 ? Vec3d{} : Vec3d{0.04, 0, 0});
      node.rotation = to_quat(transpose(to_matrix(above)) * to_matrix(world));
      rig.nodes.push_back(node);
      above = world;
    }
    for (int k = 1; k <= 3; ++k) {
      rig.fingers.push_back({k, Side::left, Finger::middle, k, {0, 0, -1}, 0.1 * k});
    }
    rig.at_ease = true;
  }

  // Where the last node points against the first, turned about -z (rad).
  [[nodiscard]] double bent(const FingerMover& mover, double share) const {
    Transformd at;
    Vec3d before{};
    for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
      Quatd turn = rig.nodes[i].rotation;
      if (mover.turns(i)) turn = mover.turned(i, share, turn);
      before = at.translation;
      at = at * Transformd{to_matrix(turn), rig.nodes[i].translation};
    }
    const Vec3d way = at.translation - before;
    EXPECT_NEAR(way.z, 0.0, 1e-12);
    return atan2(-way.y, way.x);
  }

  Rig rig;
};

double sum_of(HandPosture posture) {
  double sum = 0.0;
  // from where the rig has them, which is bent by 0.1, 0.2 and 0.3
  for (int k = 1; k <= 3; ++k) sum += flexion(posture, Finger::middle, k) - 0.1 * k;
  return sum;
}

TEST(FingerMover, LaysFingersInThePosturesWhateverTheirAxes) {
  Random random(3);
  for (int n = 0; n < 20; ++n) {
    const OneFinger hand(random);
    const FingerMover reaching(hand.rig, {true, {true, false}});
    EXPECT_NEAR(hand.bent(reaching, 0.0), sum_of(HandPosture::relaxed), 1e-9);
    EXPECT_NEAR(hand.bent(reaching, kWidestAt), sum_of(HandPosture::open), 1e-9);
    EXPECT_NEAR(hand.bent(reaching, 1.0), sum_of(HandPosture::relaxed), 1e-9);
    const FingerMover idle(hand.rig, {true, {false, true}});
    EXPECT_NEAR(hand.bent(idle, 0.5), sum_of(HandPosture::relaxed), 1e-9);
  }
}

TEST(FingerMover, StartsWhereAFrameHasTheFingers) {
  Random random(3);
  OneFinger hand(random);
  hand.rig.at_ease = false;
  const FingerMover reaching(hand.rig, {true, {true, false}});
  EXPECT_NEAR(hand.bent(reaching, 0.0), 0.0, 1e-9);
  EXPECT_NEAR(hand.bent(reaching, 1.0), sum_of(HandPosture::relaxed), 1e-9);
  const FingerMover idle(hand.rig, {true, {false, true}});
  EXPECT_NEAR(hand.bent(idle, 0.5), 0.0, 1e-9);
}

TEST(FingerMover, TakesThePosturesOfItsKeys) {
  Random random(3);
  OneFinger hand(random);
  HandPlay play{.fingers = true};
  play.keys[0] = {{0.2, kOpenShare, 1.0}, {0.4, kOpenShare}, {0.5, 1.5}, {0.7, 1.5}};
  for (const bool at_ease : {true, false}) {
    hand.rig.at_ease = at_ease;
    const FingerMover mover(hand.rig, play);
    const double start = at_ease ? sum_of(HandPosture::relaxed) : 0.0;
    const double open = sum_of(HandPosture::open);
    // sum_of subtracts the rig's 0.6
    const double grip = 1.5 * (sum_of(HandPosture::relaxed) + 0.6) - 0.6;
    EXPECT_NEAR(hand.bent(mover, 0.0), start, 1e-9);
    EXPECT_NEAR(hand.bent(mover, 0.2), start, 1e-9);
    EXPECT_NEAR(hand.bent(mover, 0.3), 0.5 * (start + open), 1e-9);
    EXPECT_NEAR(hand.bent(mover, 0.4), open, 1e-9);
    EXPECT_NEAR(hand.bent(mover, 0.6), grip, 1e-9);
    EXPECT_NEAR(hand.bent(mover, 1.0), grip, 1e-9);
  }
}

TEST(FingerMover, LeavesWhatCarriesTheGripAndAllWhereNothingIsAsked) {
  Random random(3);
  OneFinger hand(random);
  hand.rig.grips[0] = 3;
  const FingerMover mover(hand.rig, {true, {true, false}});
  EXPECT_FALSE(mover.turns(1));
  EXPECT_FALSE(mover.turns(2));
  EXPECT_TRUE(mover.turns(3));
  EXPECT_FALSE(FingerMover(hand.rig, {}).turns(3));
}

}  // namespace
}  // namespace shigusa
