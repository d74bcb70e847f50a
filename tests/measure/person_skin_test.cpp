// SPDX-License-Identifier: MIT
// A person measured from a mesh: a figure with flesh drawn around its joints.
#include <gmock/gmock.h>

#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "body/skin.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/stick_figure.hpp"

namespace shigusa {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kStature = 1.7;
constexpr double kRounding = 1e-9;

using Mesh = std::vector<SkinVertex>;

// A shoe around a foot: its sole at `sole`, from `back` behind the ankle to `front` ahead of it.
struct Shoe {
  double sole = 0.0;
  double front = 0.2;
  double back = 0.06;
  double half = 0.05;
};

void add_shoe(const StickFigure& figure, const std::string& foot, const Shoe& shoe, Mesh& mesh) {
  const int node = figure.find(foot);
  const Vec3d ankle = figure.points[static_cast<std::size_t>(node)].at;
  for (const double y : {shoe.sole, 0.5 * (shoe.sole + ankle.y), ankle.y}) {
    for (int i = 0; i <= 4; ++i) {
      const double z = ankle.z - shoe.back + (shoe.front + shoe.back) * 0.25 * i;
      for (const double x : {-shoe.half, shoe.half}) mesh.push_back({{ankle.x + x, y, z}, node});
    }
  }
}

// Rings of vertices every 2 cm around a limb, whose thickness `radius` gives by the share of the
// way.
template <class Radius>
void add_limb(const StickFigure& figure, const std::string& from, const std::string& to,
              Radius&& radius, Mesh& mesh) {
  const int node = figure.find(from);
  const Vec3d a = figure.points[static_cast<std::size_t>(node)].at;
  const Vec3d way = figure.points[static_cast<std::size_t>(figure.find(to))].at - a;
  const Vec3d across = normalized(cross(way, {0, 0, 1}));
  const Vec3d other = normalized(cross(way, across));
  constexpr int kRound = 16;
  const int rings = static_cast<int>(norm(way) / 0.02);
  for (int i = 0; i <= rings; ++i) {
    const double share = static_cast<double>(i) / rings;
    for (int k = 0; k < kRound; ++k) {
      const SinCos<double> turn = sin_cos(2.0 * kPi * k / kRound);
      const Vec3d out = across * turn.cos + other * turn.sin;
      mesh.push_back({a + way * share + out * radius(share), node});
    }
  }
}

void add_limb(const StickFigure& figure, const std::string& from, const std::string& to,
              double radius, Mesh& mesh) {
  add_limb(
      figure, from, to, [radius](double) { return radius; }, mesh);
}

// An ellipsoid of vertices, evenly about its centre, with one at its top.
void add_ball(int node, const Vec3d& middle, const Vec3d& half, Mesh& mesh) {
  constexpr int kCount = 400;
  for (int i = 0; i <= kCount; ++i) {
    const double y = 1.0 - 2.0 * i / kCount;
    const double out = sqrt(max(1.0 - y * y, 0.0));
    const SinCos<double> turn = sin_cos(2.399963 * i);  // the golden angle
    mesh.push_back(
        {middle + Vec3d{turn.cos * out * half.x, y * half.y, turn.sin * out * half.z}, node});
  }
}

MeasuredPerson measured(const StickFigure& figure, const Mesh& mesh,
                        std::optional<double> stature = std::nullopt) {
  const Skeleton skeleton = figure.skeleton();
  const auto world = figure.world();
  const auto map = find_humanoid(skeleton, world, {}, {}, mesh);
  EXPECT_TRUE(map) << map.error().to_string();
  const auto person = measure_person(skeleton, world, *map, {.stature = stature, .skin = mesh});
  EXPECT_TRUE(person) << person.error().to_string();
  return *person;
}

Mesh shoes(const StickFigure& figure, const Shoe& shoe) {
  Mesh mesh;
  for (const char* foot : {"LeftFoot", "RightFoot"}) add_shoe(figure, foot, shoe, mesh);
  return mesh;
}

TEST(PersonSkin, TheFloorComesFromTheMesh) {
  const StickFigure figure = standing_figure();
  // soles 4 cm below where 0.039 of the stature lays them
  const MeasuredPerson person = measured(figure, shoes(figure, {.sole = -0.04}));
  EXPECT_NEAR(person.placement.origin.y, -0.04, kRounding);
  for (const Side side : {Side::left, Side::right}) {
    const Landmarks::Leg& leg = person.landmarks.leg(side);
    ASSERT_TRUE(leg.sole);
    EXPECT_NEAR((*leg.sole)[0].y, 0.0, kRounding);
    EXPECT_NEAR(leg.ankle.y, 0.039 * kStature + 0.04, 1e-6);
  }
}

TEST(PersonSkin, TheFilesOwnFloorStaysWhereSolesAreNearIt) {
  const StickFigure figure = standing_figure();
  const MeasuredPerson near = measured(figure, shoes(figure, {.sole = 0.002}));
  EXPECT_NEAR(near.placement.origin.y, 0.0, kRounding);
  EXPECT_NEAR((*near.landmarks.left_leg.sole)[0].y, 0.002, kRounding);
  const MeasuredPerson above = measured(figure, shoes(figure, {.sole = 0.01}));
  EXPECT_NEAR(above.placement.origin.y, 0.01, kRounding);
}

TEST(PersonSkin, ASoleThatIsHigherIsTold) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_shoe(figure, "LeftFoot", {.sole = 0.012}, mesh);
  add_shoe(figure, "RightFoot", {.sole = 0.0}, mesh);
  EXPECT_THAT(measured(figure, mesh).doubts, Contains("the left sole is 12 mm above the floor"));
  EXPECT_THAT(measured(figure, shoes(figure, {})).doubts, Not(Contains(HasSubstr("sole is"))));
}

TEST(PersonSkin, TheSupportPolygonIsTheShoes) {
  const StickFigure figure = standing_figure();
  const Shoe shoe{.sole = 0.0, .front = 0.24, .back = 0.08, .half = 0.06};
  const MeasuredPerson person = measured(figure, shoes(figure, shoe));
  const SoleOutline& sole = *person.landmarks.left_leg.sole;
  const Vec3d ankle = person.landmarks.left_leg.ankle;
  const Vec3d expected[] = {{shoe.half, 0, shoe.front},
                            {shoe.half, 0, -shoe.back},
                            {-shoe.half, 0, -shoe.back},
                            {-shoe.half, 0, shoe.front}};
  for (std::size_t i = 0; i < sole.size(); ++i) {
    EXPECT_NEAR(sole[i].x - ankle.x, expected[i].x, kRounding) << i;
    EXPECT_NEAR(sole[i].z - ankle.z, expected[i].z, kRounding) << i;
  }
  EXPECT_NEAR(person.landmarks.left_leg.toe.z - ankle.z, shoe.front, kRounding);
  const BodyModel body = build_human(person.landmarks, {.stature = person.stature});
  for (const Foot& foot : body.feet()) {
    double least = 1e9;
    double most = -1e9;
    for (const Vec3d& corner : foot.outline) {
      least = std::min(least, corner.z);
      most = std::max(most, corner.z);
    }
    EXPECT_NEAR(most - least, shoe.front + shoe.back, kRounding) << foot.name;
  }
}

TEST(PersonSkin, WhatIsFurtherFromTheFootThanTheLegIsLongIsNoSole) {
  const StickFigure figure = standing_figure();
  Mesh mesh = shoes(figure, {});
  const MeasuredPerson before = measured(figure, mesh);
  mesh.push_back({{-1e4, 0.0, 0.0}, figure.find("RightFoot")});
  const MeasuredPerson after = measured(figure, mesh);
  for (std::size_t i = 0; i < before.landmarks.right_leg.sole->size(); ++i) {
    EXPECT_EQ((*after.landmarks.right_leg.sole)[i], (*before.landmarks.right_leg.sole)[i]);
  }
}

TEST(PersonSkin, PegsBearTheBodyOnFeet) {
  using F = StatureFractions;
  const StickFigure figure = standing_figure();
  const Shoe peg{.sole = 0.0, .front = 0.03, .back = 0.03, .half = 0.02};
  const MeasuredPerson person = measured(figure, shoes(figure, peg));
  const Landmarks::Leg& leg = person.landmarks.left_leg;
  const SoleOutline& sole = *leg.sole;
  EXPECT_NEAR(sole[0].z - sole[1].z, F::kFootLength * person.stature, 1e-6);
  EXPECT_NEAR(sole[0].x - sole[3].x, F::kFootBreadth * person.stature, 1e-6);
  EXPECT_NEAR(leg.ankle.z - sole[1].z, kHeelShare * F::kFootLength * person.stature, 1e-6);
  EXPECT_NEAR(sole[0].y, 0.0, 1e-6);
}

// Nobody stands on a sole without width, so no person's file may state one.
TEST(PersonSkin, SheetsBearTheBodyOnFeet) {
  using F = StatureFractions;
  const StickFigure figure = standing_figure();
  for (const Shoe& sheet : {Shoe{.sole = 0.0, .front = 0.2, .back = 0.06, .half = 0.0},
                            Shoe{.sole = 0.01, .front = 0.16, .back = 0.09, .half = 0.002}}) {
    const MeasuredPerson person = measured(figure, shoes(figure, sheet));
    for (const Landmarks::Leg* leg : {&person.landmarks.left_leg, &person.landmarks.right_leg}) {
      const SoleOutline& sole = *leg->sole;
      EXPECT_NEAR(sole[0].z - sole[1].z, sheet.front + sheet.back, 1e-6);
      EXPECT_NEAR(sole[0].x - sole[3].x, F::kFootBreadth * person.stature, 1e-6);
      EXPECT_NEAR(sole[0].x + sole[3].x, 2.0 * leg->ankle.x, 1e-6) << "under the ankle";
    }
  }
}

TEST(PersonSkin, AFootWithoutMeshEndsWithItsShanks) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  for (const char* shank : {"LeftLeg", "RightLeg"}) {
    add_limb(figure, shank, shank == std::string("LeftLeg") ? "LeftFoot" : "RightFoot", 0.05, mesh);
  }
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(person.placement.origin.y, 0.039 * kStature, 1e-6);
}

// Bones without names and feet without toes: only the mesh shows the facing.
TEST(PersonSkin, FeetPointWhereTheirMeshLies) {
  StickFigure figure = standing_figure();
  for (const char* toes : {"LeftToeBase", "RightToeBase"}) figure = figure.without(toes);
  const Mesh mesh = shoes(figure, {});
  const StickFigure nameless = figure.nameless();
  for (const bool back : {false, true}) {
    const Mat3d turn = back ? Mat3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}} : Mat3d{};
    Mesh turned = mesh;
    for (SkinVertex& vertex : turned) vertex.position = turn * vertex.position;
    const MeasuredPerson person = measured(nameless.transformed(turn), turned);
    EXPECT_NEAR(person.placement.ahead.z, back ? -1.0 : 1.0, 1e-6);
    EXPECT_THAT(person.doubts, Not(Contains(HasSubstr("nothing follows joint 'LeftFoot'"))));
    EXPECT_NEAR(norm(person.landmarks.left_leg.toe - person.landmarks.left_leg.ankle),
                norm(Vec3d{0, 0.039 * kStature, 0.2}), 1e-6);
  }
}

StickFigure without_head_tip() {
  StickFigure figure = standing_figure();
  figure.points.erase(figure.points.begin() + figure.find("Head") + 1);
  for (StickFigure::Point& point : figure.points) {
    if (point.parent > figure.find("Head")) --point.parent;
  }
  return figure;
}

// A head as high as the rest of the body, as in games.
TEST(PersonSkin, ABigHeadTellsTheStature) {
  const StickFigure figure =
      without_head_tip().transformed({{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}});
  Mesh mesh = shoes(figure, {});
  const Vec3d head = figure.points[static_cast<std::size_t>(figure.find("Head"))].at;
  const double half = 0.5 * head.y;
  add_ball(figure.find("Head"), head + Vec3d{0, half, 0}, {half, half, half}, mesh);
  const MeasuredPerson person = measured(figure, mesh);
  // the bones' lengths up to the head's joint are its height, as the figure is upright
  EXPECT_NEAR(person.stature, 2.0 * head.y, 0.01);
  EXPECT_NEAR(person.landmarks.head_top.y, 2.0 * head.y, 0.01);
  EXPECT_THAT(person.doubts, Not(Contains(HasSubstr("the head has no tip"))));
}

TEST(PersonSkin, EarsHairAndHatsAreNoHead) {
  const StickFigure plain = without_head_tip();
  StickFigure figure = plain;
  const Vec3d head = figure.points[static_cast<std::size_t>(figure.find("Head"))].at;
  figure.add("Hair", "Head", head + Vec3d{0, 0.1, 0});
  Mesh mesh = shoes(figure, {});
  add_ball(figure.find("Head"), head + Vec3d{0, 0.08, 0}, {0.08, 0.08, 0.1}, mesh);
  const double bald = measured(figure, mesh).stature;
  for (const double side : {-1.0, 1.0}) {  // ears of a bunny
    for (int i = 0; i < 20; ++i) {
      mesh.push_back({head + Vec3d{side * 0.06, 0.1 + 0.015 * i, 0}, figure.find("Head")});
    }
  }
  for (int i = 0; i < 40; ++i) {  // a crest, a hat
    mesh.push_back({head + Vec3d{0, 0.16 + 0.01 * i, 0}, figure.find("Hair")});
    mesh.push_back({head + Vec3d{0, 0.16 + 0.01 * i, 0}, figure.find("Head"), true});
  }
  EXPECT_NEAR(measured(figure, mesh).stature, bald, kRounding);
  EXPECT_NEAR(bald, head.y + 0.16, 0.01);
}

TEST(PersonSkin, WithoutAMeshNothingChanges) {
  const StickFigure figure = standing_figure();
  const MeasuredPerson person = measured(figure, {});
  EXPECT_FALSE(person.landmarks.left_leg.sole);
  for (const auto& shape : person.landmarks.parts.shape) EXPECT_FALSE(shape);
}

double radius_of(const MeasuredPerson& person, BodyPart part) {
  EXPECT_TRUE(person.landmarks.parts[part]) << body_part_name(part);
  return person.landmarks.parts[part] ? person.landmarks.parts[part]->radius : 0.0;
}

TEST(FittedParts, ARoundLimbHasItsRadius) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(figure, "LeftForeArm", "LeftHand", 0.047, mesh);
  add_limb(figure, "LeftUpLeg", "LeftLeg", 0.07, mesh);
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(radius_of(person, BodyPart::left_forearm), 0.047, kRounding);
  EXPECT_NEAR(radius_of(person, BodyPart::left_thigh), 0.07, kRounding);
  // a limb without vertices is as the other side's
  EXPECT_NEAR(radius_of(person, BodyPart::right_thigh), 0.07, kRounding);
  EXPECT_FALSE(person.landmarks.parts[BodyPart::right_shank]);
}

TEST(FittedParts, ACalfBehindItsBoneIsRoundAboutItsOwnMiddle) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(figure, "LeftLeg", "LeftFoot", 0.05, mesh);
  for (SkinVertex& vertex : mesh) vertex.position.z -= 0.015;
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(radius_of(person, BodyPart::left_shank), 0.05, 0.002);
  EXPECT_NEAR(person.landmarks.parts[BodyPart::left_shank]->from.z, -0.015, 0.003);
}

TEST(FittedParts, ATaperingLimbHasTheRadiiOfItsEnds) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(
      figure, "LeftForeArm", "LeftHand", [](double s) { return 0.06 - 0.03 * s; }, mesh);
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(radius_of(person, BodyPart::left_forearm), 0.057, 0.003);
  EXPECT_NEAR(person.landmarks.parts[BodyPart::left_forearm]->to_radius, 0.033, 0.005);
}

// Vertices that stick out to one side are no flesh: a hanging sleeve, a sword in the hand, a skirt.
TEST(FittedParts, SleevesSwordsAndSkirtsMakeNoBarrel) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(figure, "LeftForeArm", "LeftHand", 0.04, mesh);
  add_limb(figure, "LeftUpLeg", "LeftLeg", 0.07, mesh);
  const auto near = mesh.size();
  for (std::size_t i = 0; i < near; ++i) {
    const Vec3d at = mesh[i].position;
    const bool arm = mesh[i].node == figure.find("LeftForeArm");
    if (arm && at.y < 0.818 * kStature - 0.03) {
      for (int k = 1; k < 10; ++k) {  // a wide sleeve below the arm
        mesh.push_back({at - Vec3d{0, 0.03 * k, 0}, mesh[i].node});
      }
    }
    if (!arm) {  // a skirt: a cone around both legs
      const Vec3d out = normalized(Vec3d{at.x, 0, at.z}, {1, 0, 0});
      mesh.push_back({Vec3d{0, at.y, 0} + out * 0.35, mesh[i].node});
    }
  }
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(radius_of(person, BodyPart::left_forearm), 0.04, 0.005);
  // there are 0.085 m from a leg to the middle between both
  EXPECT_LE(radius_of(person, BodyPart::left_thigh), 0.085 + kRounding);
}

TEST(FittedParts, MirroredSidesAreMirrored) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(
      figure, "LeftArm", "LeftForeArm", [](double s) { return 0.05 - 0.01 * s; }, mesh);
  for (SkinVertex& vertex : mesh) vertex.position.z += 0.01;
  const auto half = mesh.size();
  for (std::size_t i = 0; i < half; ++i) {
    Vec3d at = mesh[i].position;
    at.x = -at.x;
    mesh.push_back({at, figure.find("RightArm")});
  }
  const MeasuredPerson person = measured(figure, mesh);
  const PartShape left = person.landmarks.parts[BodyPart::left_upper_arm].value();
  const PartShape right = person.landmarks.parts[BodyPart::right_upper_arm].value();
  EXPECT_NEAR(left.radius, right.radius, kRounding);
  EXPECT_NEAR(left.from.x, -right.from.x, kRounding);
  EXPECT_NEAR(left.from.z, right.from.z, kRounding);
}

// Some vertices that stick out, of a watch or a spike.
TEST(FittedParts, AFewOutliersMakeALimbNoThicker) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  const auto forearm = [](double s) { return 0.05 - 0.02 * s; };
  add_limb(figure, "LeftForeArm", "LeftHand", forearm, mesh);
  const PartShape plain = measured(figure, mesh).landmarks.parts[BodyPart::left_forearm].value();
  const auto count = mesh.size();
  const Vec3d elbow = figure.points[static_cast<std::size_t>(figure.find("LeftForeArm"))].at;
  for (std::size_t i = 0; i < count; i += 19) {
    const Vec3d out = mesh[i].position - elbow;
    mesh.push_back({elbow + Vec3d{out.x, 3.0 * out.y, 3.0 * out.z}, mesh[i].node});
  }
  const PartShape spiked = measured(figure, mesh).landmarks.parts[BodyPart::left_forearm].value();
  EXPECT_NEAR(spiked.radius, plain.radius, 0.003);
  EXPECT_NEAR(spiked.to_radius, plain.to_radius, 0.003);
}

// The shape of a left hand whose mesh is a flat tube of these sizes (m).
PartShape fitted_hand(double length, double breadth, double thickness) {
  const StickFigure figure = standing_figure();
  const int hand = figure.find("LeftHand");
  const Vec3d wrist = figure.points[static_cast<std::size_t>(hand)].at;
  Mesh mesh;
  for (int i = 0; i <= 30; ++i) {
    for (int k = 0; k < 32; ++k) {
      const SinCos<double> turn = sin_cos(2.0 * kPi * k / 32);
      mesh.push_back(
          {wrist + Vec3d{length * i / 30, 0.5 * thickness * turn.sin, 0.5 * breadth * turn.cos},
           hand});
    }
  }
  return measured(figure, mesh).landmarks.parts[BodyPart::left_hand].value();
}

TEST(FittedParts, AHandIsAsFlatAndAsLongAsItsMesh) {
  const double length = StatureFractions::kHand * kStature;
  const PartShape flat = fitted_hand(length, 0.09, 0.03);
  EXPECT_NEAR(flat.radius, 0.015, 0.006);
  EXPECT_NEAR(norm(flat.aside) + flat.radius, 0.045, 0.006);
  EXPECT_NEAR(norm(flat.to) + flat.to_radius, length, 0.015);
  EXPECT_EQ(fitted_hand(length, 0.05, 0.05).aside, Vec3d{});
  const PartShape fist = fitted_hand(0.5 * length, 0.07, 0.07);
  EXPECT_NEAR(norm(fist.to) + fist.to_radius, 0.5 * length, 0.015);
}

TEST(FittedParts, AnArmouredArmHasItsOwnThickness) {
  const StickFigure figure = standing_figure();
  Mesh mesh;
  add_limb(figure, "LeftForeArm", "LeftHand", 0.04, mesh);
  Mesh armour;
  add_limb(figure, "RightForeArm", "RightHand", 0.08, armour);
  for (std::size_t i = 0; i < armour.size(); i += 5) mesh.push_back(armour[i]);
  const MeasuredPerson person = measured(figure, mesh);
  EXPECT_NEAR(radius_of(person, BodyPart::right_forearm), 0.08, 0.005);
  EXPECT_NEAR(radius_of(person, BodyPart::left_forearm), 0.04, 0.005);
}

// The head's ellipsoid lies within skull and jaw, as far as a capsule can follow it.
TEST(FittedParts, SkullAndJawCoverTheHead) {
  const StickFigure figure = without_head_tip();
  Mesh mesh = shoes(figure, {});
  const Vec3d head = figure.points[static_cast<std::size_t>(figure.find("Head"))].at;
  add_ball(figure.find("Head"), head + Vec3d{0, 0.05, 0.01}, {0.076, 0.115, 0.098}, mesh);
  const MeasuredPerson person = measured(figure, mesh);
  const PartShape skull = person.landmarks.parts[BodyPart::head].value();
  const PartShape jaw = person.landmarks.parts[BodyPart::jaw].value();
  EXPECT_NEAR(skull.radius, 0.076, 0.006);
  EXPECT_NEAR(jaw.to.y - jaw.radius, 0.05 - 0.115, 0.02);
  EXPECT_NEAR(skull.to.z + skull.radius, 0.01 + 0.098, 0.01);
}

// Arrows of axes at all bones, for example.
TEST(FittedParts, AMeshWithAHeadBesideItsBoneShowsNoBody) {
  const StickFigure figure = without_head_tip();
  const Vec3d head = figure.points[static_cast<std::size_t>(figure.find("Head"))].at;
  for (const double aside : {0.01, 0.05}) {
    Mesh mesh = shoes(figure, {});
    add_limb(figure, "LeftForeArm", "LeftHand", 0.04, mesh);
    add_ball(figure.find("Head"), head + Vec3d{aside, 0.05, 0.01}, {0.076, 0.115, 0.098}, mesh);
    const PartShapes& parts = measured(figure, mesh).landmarks.parts;
    EXPECT_EQ(parts[BodyPart::head].has_value(), aside < 0.02);
    EXPECT_EQ(parts[BodyPart::left_forearm].has_value(), aside < 0.02);
  }
}

}  // namespace
}  // namespace shigusa
