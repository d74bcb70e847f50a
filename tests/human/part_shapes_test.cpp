// SPDX-License-Identifier: MIT
// Part shapes of a person measured from a mesh.
#include "human/part_shapes.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "human/landmark_points.hpp"
#include "human/segment_mass.hpp"

namespace shigusa {
namespace {

constexpr double kRounding = 1e-12;

Landmarks meshed() {
  Landmarks person = standing_landmarks(1.7, 0.0);
  person.parts[BodyPart::left_hand] = {{0, 0, 0}, {0, -0.15, 0}, 0.02, 0.015, {0, 0, 0.03}};
  person.parts[BodyPart::pelvis] = {{0, 0, 0}, {0, 0.1, 0}, 0.12};
  person.parts[BodyPart::left_forearm] = {{0, 0, 0}, {0, -0.2, 0}, 0.04};
  return person;
}

std::vector<Capsule> capsules_of(BodyPart part, const Landmarks& person) {
  return part_capsules(part, person, human_frames(person), 1.7);
}

TEST(PartCapsules, OfAFlatPartAreTwoSideBySide) {
  const std::vector<Capsule> hand = capsules_of(BodyPart::left_hand, meshed());
  ASSERT_EQ(hand.size(), 2u);
  EXPECT_NEAR(norm(hand[0].from - hand[1].from), 0.06, kRounding);
  EXPECT_NEAR(norm((hand[0].to - hand[1].to) - (hand[0].from - hand[1].from)), 0.0, kRounding);
  for (const Capsule& line : hand) {
    EXPECT_EQ(line.radius, 0.02);
    EXPECT_EQ(line.to_radius, 0.015);
  }
  EXPECT_EQ(capsules_of(BodyPart::left_forearm, meshed()).size(), 1u);
}

TEST(PartCapsules, OfTrunksAndThighsYieldWhereAMeshToldThem) {
  EXPECT_EQ(capsules_of(BodyPart::pelvis, meshed()).front().give, kFleshGives);
  EXPECT_EQ(capsules_of(BodyPart::left_forearm, meshed()).front().give, 0.0);
  EXPECT_EQ(capsules_of(BodyPart::left_thigh, meshed()).front().give, 0.0);
}

// The part's upper half may lie within the trunk.
TEST(PartCapsules, TheLowerHalfOfAnUpperArmWithAMeshCollides) {
  Landmarks person = meshed();
  person.parts[BodyPart::left_upper_arm] = {{0, 0, 0}, {0, -0.3, 0}, 0.06, 0.04};
  const BodyModel body = build_human(person, {.extent = BodyExtent::human, .stature = 1.7});
  std::vector<Capsule> free;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.name.ends_with("upper_arm") && !capsule.grown_on) free.push_back(capsule);
  }
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].name, "left_upper_arm");
  EXPECT_NEAR(norm(free[0].to - free[0].from), 0.15, kRounding);
  EXPECT_NEAR(free[0].radius, 0.05, kRounding);
  EXPECT_NEAR(free[0].to_radius, 0.04, kRounding);
}

TEST(StatureOfLimbs, IsWithoutWhatABigHeadAdds) {
  const Landmarks usual = standing_landmarks(1.7, 0.0);
  EXPECT_EQ(stature_of_limbs(usual, 1.7), 1.7);
  Landmarks big = usual;
  big.head_top.y += 0.5;
  EXPECT_NEAR(stature_of_limbs(big, 2.2), 1.7, 0.01);
  // a head that is a little larger than usual is its own
  Landmarks larger = usual;
  larger.head_top.y += 0.05;
  EXPECT_EQ(stature_of_limbs(larger, 1.75), 1.75);
}

}  // namespace
}  // namespace shigusa
