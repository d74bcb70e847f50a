// SPDX-License-Identifier: MIT
// Facing of bodies whose feet alone would give a wrong direction.
#include "rig/facing.hpp"

#include <gmock/gmock.h>

#include <shigusa/error.hpp>
#include <shigusa/human.hpp>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/stick_figure.hpp"

namespace shigusa {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Bone = HumanoidBone;

const std::array kSides{std::pair("Left", 1.0), std::pair("Right", -1.0)};

// A figure without toes, with a node behind each ankle.
StickFigure with_heels(const std::string& name, const std::string& parent = "Foot") {
  StickFigure figure = standing_figure().without("LeftToeBase").without("RightToeBase");
  for (const auto& [side, x] : kSides) {
    figure.add(side + name, side + parent, {0.085 * x, 0.02, -0.07});
  }
  return figure;
}

void add_eyes(StickFigure& figure, double ahead) {
  for (const auto& [side, x] : kSides) {
    figure.add(side + std::string("Eye"), "Head", {0.03 * x, 1.6, ahead});
  }
}

struct Read {
  HumanoidMap map;
  MeasuredPerson person;
};

Read read(const StickFigure& figure, std::span<const SkinVertex> skin = {}) {
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = figure.world();
  HumanoidMap map = find_humanoid(skeleton, world, {}, {}, skin).value();
  MeasuredPerson person =
      measure_person(skeleton, world, map, {.stature = {}, .skin = skin}).value();
  return {std::move(map), std::move(person)};
}

TEST(Facing, AHeelIsNoTipOfAFoot) {
  for (const char* heel : {"Heel", "FootBack", "_Heel_02"}) {
    const Read found = read(with_heels(heel));
    EXPECT_FALSE(found.person.placement.mirrored()) << heel;
    EXPECT_GT(found.person.landmarks.left_leg.toe.z, 0.1) << heel;
    EXPECT_LT(found.map[Bone::left_toes], 0) << heel;
    EXPECT_THAT(found.map.doubts, Not(Contains(HasSubstr("backwards")))) << heel;
    EXPECT_THAT(found.person.doubts, Contains(HasSubstr("only a heel follows joint 'LeftFoot'")));
  }
}

TEST(Facing, AHeelBesideTheFootIsNotTheFoot) {
  StickFigure figure = standing_figure();
  for (const auto& [side, x] : kSides) {
    figure.add(side + std::string("FootBack"), side + std::string("Leg"), {0.085 * x, 0.07, 0});
    figure.add(side + std::string("Back"), side + std::string("FootBack"), {0.085 * x, 0, -0.3});
  }
  const Read found = read(figure);
  EXPECT_EQ(found.map[Bone::left_foot], figure.find("LeftFoot"));
  EXPECT_FALSE(found.person.placement.mirrored());
  EXPECT_THAT(found.map.doubts, IsEmpty());
}

TEST(Facing, AHeelThatBearsTheToesIsTheFoot) {
  StickFigure figure = standing_figure();
  for (const char* side : {"Left", "Right"}) {
    figure[side + std::string("Foot")].name = side + std::string("Heel");
  }
  const Read found = read(figure);
  EXPECT_EQ(found.map[Bone::left_foot], figure.find("LeftHeel"));
  EXPECT_EQ(found.map[Bone::left_toes], figure.find("LeftToeBase"));
  EXPECT_THAT(found.map.doubts, IsEmpty());
}

TEST(Facing, WhatLiesBehindAFootsMeshIsAHeelWhateverItIsCalled) {
  const StickFigure figure = with_heels("_Bone");
  std::vector<SkinVertex> skin;
  for (const auto& [side, x] : kSides) {
    const int foot = figure.find(side + std::string("Foot"));
    for (int i = 0; i < 20; ++i) {
      skin.push_back({{0.085 * x + 0.03 * (i % 2), 0.0, -0.06 + 0.013 * i}, foot});
    }
  }
  EXPECT_TRUE(read(figure).person.placement.mirrored());
  const Read found = read(figure, skin);
  EXPECT_FALSE(found.person.placement.mirrored());
  EXPECT_GT(found.person.landmarks.left_leg.toe.z, 0.15);
}

TEST(Facing, FeetAloneMirrorNobodyWhoseFaceLiesAhead) {
  StickFigure figure = with_heels("_Bone");
  add_eyes(figure, 0.1);
  const Read found = read(figure);
  EXPECT_FALSE(found.person.placement.mirrored());
  EXPECT_GT(found.person.landmarks.left_leg.toe.z, 0.1);
}

TEST(Facing, FeetAndFaceThatBothLieBehindAreAMirroredFiles) {
  StickFigure figure = standing_figure();
  add_eyes(figure, 0.1);
  const Read found = read(figure.transformed({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}));
  EXPECT_TRUE(found.person.placement.mirrored());
  EXPECT_THAT(found.map.doubts, Contains(HasSubstr("feet point backwards")));
}

// Mirroring is recognised without toes as with toes.
TEST(Facing, AFaceAndKneesTellWhereFeetDoNot) {
  StickFigure figure = standing_figure().without("LeftToeBase").without("RightToeBase");
  add_eyes(figure, 0.1);
  for (const char* side : {"Left", "Right"}) figure[side + std::string("Leg")].at.z = 0.03;
  EXPECT_FALSE(read(figure).person.placement.mirrored());
  EXPECT_TRUE(
      read(figure.transformed({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}})).person.placement.mirrored());
}

// The foot is a control on the root, and the bone of its heel ends the shank: Quaternius' mechs.
TEST(Facing, AFootBesideTheHeelThatEndsTheShankIsTheFoot) {
  StickFigure figure = standing_figure().without("LeftFoot").without("RightFoot");
  for (const auto& [side, x] : kSides) {
    const std::string s = side;
    figure.add("FootBack." + s, s + "Leg", {0.085 * x, 0.07, 0});
    figure.add("FootBack." + s + "_end", "FootBack." + s, {0.085 * x, 0.05, -0.3});
    figure.add("Foot." + s, "Hips", {0.085 * x, 0.07, 0});
    figure.add("Foot." + s + "_end", "Foot." + s, {0.085 * x, 0.02, 0.18});
  }
  const Read found = read(figure);
  EXPECT_EQ(found.map[Bone::left_foot], figure.find("Foot.Left"));
  EXPECT_FALSE(found.person.placement.mirrored());
  EXPECT_GT(found.person.landmarks.left_leg.toe.z, 0.1);
}

// A mirrored file stays mirrored in every posture, also with thumbs turned back.
TEST(Facing, AFileIsMirroredInAllItsPosturesOrInNone) {
  StickFigure figure = standing_figure().transformed({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  for (const auto& [side, x] : kSides) {
    figure.add(side + std::string("Thumb"), side + std::string("Hand"), {0.75 * x, 1.39, -0.05});
  }
  const Read found = read(figure);
  ASSERT_TRUE(found.person.placement.mirrored());
  StickFigure turned = figure;
  for (const char* side : {"Left", "Right"}) turned[side + std::string("Thumb")].at.z = 0.05;
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = turned.world();
  EXPECT_TRUE(measure_person(skeleton, world, found.map).value().placement.mirrored());
}

TEST(Facing, ATailAndElbowsSpeakAgainstHeels) {
  StickFigure figure = with_heels("_Bone");
  figure.add("Tail", "Hips", {0, 0.9, -0.2});
  EXPECT_FALSE(read(figure).person.placement.mirrored());
}

}  // namespace
}  // namespace shigusa
