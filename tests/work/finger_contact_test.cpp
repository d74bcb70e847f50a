// SPDX-License-Identifier: MIT
#include "work/finger_contact.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "work/hold.hpp"

namespace shigusa {
namespace {

// The flexion of a hand's fingers about a thing whose surface is before the palm.
double flexion_of(Side side, const Thing& thing, double depth) {
  const PosedBody posed = human_body();
  const int hand = posed.body.find_effector(JointKind::hand, side).value();
  const Effector& effector = posed.body.effector(hand);
  constexpr double kBeforePalm = 0.02;
  const double out = (side == Side::left ? -1.0 : 1.0) * (kBeforePalm + 0.5 * depth);
  Grip grip{.hand = hand, .link = effector.link};
  // its upright axis is the thumb's
  grip.in_hand = {Mat3d{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, effector.point + Vec3d{out, 0, 0}};
  return flexion_about(posed.body, grip, thing);
}

TEST(FingerContact, FingersCloseMoreTheNarrowerAThingIs) {
  for (const ThingShape shape : {ThingShape::cylinder, ThingShape::sphere, ThingShape::box}) {
    double before = 0.0;
    for (const double width : {0.1, 0.08, 0.06, 0.04, 0.02}) {
      const Thing thing{.shape = shape, .size = {width, width, width}};
      const double flexion = flexion_of(Side::right, thing, width);
      EXPECT_GT(flexion, before) << word_of(shape) << " " << width;
      EXPECT_EQ(flexion_of(Side::left, thing, width), flexion);
      before = flexion;
    }
    // more than a relaxed hand, less than a fist
    EXPECT_GT(before, 1.0) << word_of(shape);
    EXPECT_LT(before, 1.5) << word_of(shape);
  }
}

TEST(FingerContact, FingersLieFlatOnALongSide) {
  const Thing box{.size = {0.3, 0.3, 0.3}};
  EXPECT_LT(flexion_of(Side::right, box, 0.3), 0.25);
  EXPECT_GT(flexion_of(Side::right, box, 0.3), 0.0);
}

TEST(FingerContact, AFistIsTheMost) {
  const Thing pin{.shape = ThingShape::cylinder, .size = {0.002, 0.1, 0.002}};
  EXPECT_LE(flexion_of(Side::right, pin, 0.2), 2.0);
  EXPECT_EQ(flexion_of(Side::right, pin, 1.0), 2.0);
}

}  // namespace
}  // namespace shigusa
