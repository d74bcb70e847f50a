// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "human/human_frames.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/stick_figure.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;
using F = StatureFractions;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Result<MeasuredPerson> measure(const StickFigure& figure, const MeasureSettings& settings = {}) {
  const auto map = find_humanoid(figure.skeleton(), figure.world());
  EXPECT_TRUE(map) << map.error().to_string();
  if (!map) return tl::unexpected<Error>(map.error());
  return measure_person(figure.skeleton(), figure.world(), *map, settings);
}

MeasuredPerson measured(const StickFigure& figure, const MeasureSettings& settings = {}) {
  const auto person = measure(figure, settings);
  EXPECT_TRUE(person) << person.error().to_string();
  return person ? *person : MeasuredPerson{};
}

std::vector<Vec3d> points(const Landmarks& l) {
  std::vector<Vec3d> all;
  for (const Side side : {Side::left, Side::right}) {
    const auto& leg = l.leg(side);
    const auto& arm = l.arm(side);
    for (const Vec3d& p : {leg.hip, leg.knee, leg.ankle, leg.toe, arm.shoulder, arm.elbow,
                           arm.wrist, arm.fingertip}) {
      all.push_back(p);
    }
  }
  all.push_back(l.neck);
  all.push_back(l.head_top);
  return all;
}

double distance(const Landmarks& a, const Landmarks& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < points(a).size(); ++i) {
    worst = std::max(worst, norm(points(a)[i] - points(b)[i]));
  }
  return worst;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
  EXPECT_LT(norm(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

Mat3d scale(double s) { return {{s, 0, 0}, {0, s, 0}, {0, 0, s}}; }

TEST(MeasurePerson, StandingFigureIsMeasuredAsItWasDrawn) {
  const StickFigure figure = standing_figure();
  const MeasuredPerson person = measured(figure);
  EXPECT_NEAR(person.stature, 1.7, 1e-12);
  EXPECT_EQ(person.placement.unit, 1.0);
  EXPECT_THAT(person.doubts, IsEmpty());
  const Landmarks& l = person.landmarks;
  const auto at = [&](const char* name) {
    return figure.points[static_cast<std::size_t>(figure.find(name))].at;
  };
  expect_near(l.left_leg.hip, at("LeftUpLeg"));
  expect_near(l.left_leg.knee, at("LeftLeg"));
  expect_near(l.right_leg.ankle, at("RightFoot"));
  expect_near(l.right_leg.toe, {-0.085, 0.01, 0.19});
  expect_near(l.left_arm.shoulder, at("LeftArm"));
  expect_near(l.left_arm.elbow, at("LeftForeArm"));
  expect_near(l.right_arm.wrist, at("RightHand"));
  expect_near(l.right_arm.fingertip, at("RightHand") - Vec3d{F::kHand * 1.7, 0, 0});
  expect_near(l.neck, at("Neck"));
  expect_near(l.head_top, {0, 1.7, 0});
}

RC_GTEST_PROP(MeasurePerson, AxesPlaceAndUnitOfTheFileDoNotMatter, ()) {
  const double unit = *rc::gen::element(1.0, 0.1, 0.01, 0.001, 0.0254, 0.0254 / 0.45);
  const double heading = *rc::gen::inRange(-180, 180);
  const Axis tilt = *rc::gen::element(Axis::x, Axis::z);
  const double tilt_angle = 90.0 * *rc::gen::inRange(0, 4);
  const Mat3d turn = rotation(tilt, radians(tilt_angle)) * rotation(Axis::y, radians(heading));
  StickFigure figure = standing_figure().transformed(turn * scale(1.0 / unit));
  const Vec3d place{*rc::gen::inRange(-500, 500) * 1.0, *rc::gen::inRange(-500, 500) * 1.0, 7.0};
  figure.move("Hips", place);
  const MeasuredPerson person = measured(figure);
  RC_ASSERT(std::abs(person.placement.unit - unit) < 1e-12);
  RC_ASSERT(distance(person.landmarks, measured(standing_figure()).landmarks) < 1e-9);
}

TEST(MeasurePerson, FacingIsTheMeanOfHipsAndShoulders) {
  StickFigure figure = standing_figure();
  // the trunk above the hips is turned by 30°
  for (auto& point : figure.points) {
    if (point.at.y > 1.2) point.at = rotation(Axis::y, radians(30)) * point.at;
  }
  const Landmarks l = measured(figure).landmarks;
  const Vec3d hips = l.left_leg.hip - l.right_leg.hip;
  const Vec3d shoulders = l.left_arm.shoulder - l.right_arm.shoulder;
  EXPECT_NEAR(degrees(atan2(-hips.z, hips.x)), -15.0, 1e-9);
  EXPECT_NEAR(degrees(atan2(-shoulders.z, shoulders.x)), 15.0, 1e-9);
}

TEST(MeasurePerson, GivenStatureScalesAndNoUnitIsGuessed) {
  const MeasuredPerson person = measured(standing_figure().transformed(scale(23.0)), {1.19});
  EXPECT_EQ(person.stature, 1.19);
  EXPECT_NEAR(person.placement.unit, 1.19 / (23.0 * 1.7), 1e-12);
  EXPECT_NEAR(person.landmarks.head_top.y, 1.19, 1e-12);
  EXPECT_THAT(person.doubts, IsEmpty());
}

TEST(MeasurePerson, GivenStatureMustBeAPersons) {
  for (const double stature : {0.0, 0.4, 2.6, -1.7, std::nan("")}) {
    const auto person = measure(standing_figure(), {stature});
    ASSERT_FALSE(person);
    EXPECT_THAT(person.error().message, HasSubstr("0.5 to 2.5 m are allowed"));
  }
}

TEST(MeasurePerson, TwoPlausibleUnitsAreADoubt) {
  // 21.6 units: 2.16 m in decimetres, 1.22 m in the CMU's unit
  const MeasuredPerson person = measured(standing_figure().transformed(scale(21.6 / 1.7)));
  EXPECT_NEAR(person.placement.unit, 0.1, 1e-12);
  EXPECT_THAT(person.doubts, Contains(HasSubstr("CMU database's unit, 1.22 m")));
}

// 17 units would be 0.96 m in the CMU's unit, and 33 would be 0.84 m in inches.
TEST(MeasurePerson, UnitsThatMakeDwarfsAreNoDoubtBesideOneOfUsualPeople) {
  for (const double size : {17.0, 33.0}) {
    const auto doubts = measured(standing_figure().transformed(scale(size / 1.7))).doubts;
    EXPECT_THAT(doubts, ElementsAre(HasSubstr("with --stature it is another")));
  }
}

TEST(MeasurePerson, RareUnitsAreToldAndUsualOnesAreNot) {
  const auto doubts_at = [](double height) {
    return measured(standing_figure().transformed(scale(height / 1.7))).doubts;
  };
  EXPECT_THAT(doubts_at(18.0),
              ElementsAre(HasSubstr("taken as decimetres, for a stature of 1.80 m")));
  EXPECT_THAT(doubts_at(66.0), ElementsAre(HasSubstr("taken as inches, for a stature of 1.68 m")));
  for (const double usual : {1.7, 165.0, 1750.0}) EXPECT_THAT(doubts_at(usual), IsEmpty());
}

TEST(MeasurePerson, DecimetresAreAUnit) {
  EXPECT_NEAR(measured(standing_figure().transformed(scale(10.0))).stature, 1.7, 1e-9);
}

// 12 units are 1.2 m in decimetres, too short for an adult, and 0.7 m in the CMU's unit.
TEST(MeasurePerson, BuildOfAChildSpeaksForARareUnit) {
  StickFigure child = standing_figure();
  const double hip = child["Hips"].at.y;
  for (auto& point : child.points) {
    if (point.at.y > hip) point.at.y += 0.3;
  }
  const double tall = measured(child).stature;
  EXPECT_NEAR(measured(child.transformed(scale(12.0 / tall))).stature, 1.2, 1e-9);
  EXPECT_EQ(measured(standing_figure().transformed(scale(12.0 / 1.7))).stature, 1.7);
}

TEST(MeasurePerson, UnusualStatureIsADoubt) {
  const MeasuredPerson person = measured(standing_figure().transformed(scale(100.0 / 1.7)));
  EXPECT_EQ(person.placement.unit, 0.01);
  EXPECT_THAT(person.doubts, Contains(HasSubstr("a stature of 1.00 m is unusual")));
}

// A giant of 3.2 m, a toy, and sizes between the units.
TEST(MeasurePerson, FigureOfNoUnitIsTakenAsAPersonOfUsualStature) {
  for (const double size : {0.3, 3.2, 4.5, 7.5, 400.0, 1e6}) {
    const MeasuredPerson person = measured(standing_figure().transformed(scale(size / 1.7)));
    EXPECT_EQ(person.stature, 1.7) << size;
    EXPECT_NEAR(person.placement.unit * size, 1.7, 1e-9) << size;
    EXPECT_NEAR(person.landmarks.head_top.y, 1.7, 1e-9) << size;
    EXPECT_THAT(person.doubts, Contains(AllOf(HasSubstr("a stature of 1.70 m is guessed"),
                                              HasSubstr(fmt::format("{:g} units tall", size)),
                                              HasSubstr("--stature"))));
  }
}

TEST(MeasurePerson, StatureIsTheSameInAStoop) {
  StickFigure figure = standing_figure();
  // the trunk leans by 80° about the hips, with the arms on it
  const Vec3d hips = figure["Hips"].at;
  for (std::size_t i = 1; i < figure.points.size(); ++i) {
    Vec3d& p = figure.points[i].at;
    const bool trunk = i < 5 || i >= 15;
    if (trunk) p = hips + rotation(Axis::x, radians(80)) * (p - hips);
  }
  const auto upright = standing_figure();
  const auto map = find_humanoid(upright.skeleton(), upright.world());
  const auto person = measure_person(upright.skeleton(), figure.world(), *map);
  ASSERT_TRUE(person) << person.error().to_string();
  EXPECT_NEAR(person->stature, 1.7, 1e-12);
  expect_near(person->landmarks.left_leg.knee, {0.085, 0.285 * 1.7, 0});
  EXPECT_LT(person->landmarks.head_top.y, 1.1);
  EXPECT_GT(person->landmarks.head_top.z, 0.7);
}

TEST(MeasurePerson, HipsBelowTheHipJointsAddNothingToTheStature) {
  StickFigure figure = standing_figure();
  figure["Hips"].at.y -= 0.1;  // as in VRM and game characters
  EXPECT_NEAR(measured(figure).stature, measured(standing_figure()).stature, 1e-12);
}

TEST(MeasurePerson, PersonWhoSitsOnTheFloorIsNotTilted) {
  StickFigure figure = standing_figure();
  const Vec3d hips = figure["Hips"].at;
  for (std::size_t i = 5; i < 15; ++i) {
    Vec3d& p = figure.points[i].at;
    p = hips + rotation(Axis::x, radians(-90)) * (p - hips);
  }
  const auto upright = standing_figure();
  const auto map = find_humanoid(upright.skeleton(), upright.world());
  const auto person = measure_person(upright.skeleton(), figure.world(), *map);
  ASSERT_TRUE(person) << person.error().to_string();
  EXPECT_GT(person->landmarks.head_top.y, 0.8);
  EXPECT_GT(person->landmarks.left_leg.ankle.z, person->landmarks.left_leg.hip.z + 0.8);
}

TEST(MeasurePerson, TurnedRootIsFollowedWithADoubt) {
  const StickFigure upright = standing_figure();
  const StickFigure turned = upright.transformed(rotation(Axis::x, kPi / 2));
  const auto map = find_humanoid(upright.skeleton(), turned.world());
  const auto person = measure_person(upright.skeleton(), turned.world(), *map);
  ASSERT_TRUE(person);
  EXPECT_LT(distance(person->landmarks, measured(upright).landmarks), 1e-12);
  EXPECT_THAT(person->doubts, Contains(HasSubstr("up is +z in this posture, but +y at rest")));
}

TEST(MeasurePerson, MirroredFileIsMirroredBack) {
  const MeasuredPerson person =
      measured(standing_figure().transformed({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}));
  EXPECT_LT(distance(person.landmarks, measured(standing_figure()).landmarks), 1e-12);
  EXPECT_THAT(person.doubts, Contains(HasSubstr("the person was mirrored")));
}

// A spine whose bones go back and forth, like MakeHuman's from its root to its neck.
TEST(MeasurePerson, ATrunkIsAsLongAsItStandsHoweverItsBonesWind) {
  StickFigure figure = standing_figure();
  figure["Hips"].at.z = 0.1;
  figure["Spine"].at.z = -0.1;
  EXPECT_NEAR(measured(figure).stature, 1.7, 1e-9);
  // and in a stoop
  StickFigure bent = figure;
  const Vec3d hip = figure["LeftUpLeg"].at;
  for (StickFigure::Point& point : bent.points) {
    const Vec3d off = point.at - hip;
    if (off.y > 0.01) {
      point.at = hip + Vec3d{off.x, 0.8 * off.y - 0.6 * off.z, 0.6 * off.y + 0.8 * off.z};
    }
  }
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = bent.world();
  const auto stooped =
      measure_person(skeleton, world, find_humanoid(skeleton, world).value()).value();
  EXPECT_NEAR(stooped.stature, 1.7, 0.05);
}

TEST(MeasurePerson, FacingThatCannotBeToldIsAnError) {
  // up along the line from right to left
  StickFigure figure = standing_figure();
  for (const char* side : {"Left", "Right"}) {
    for (const char* bone : {"UpLeg", "Leg", "Foot", "ToeBase", "Shoulder", "Arm"}) {
      figure[std::string(side) + bone].at.x = 0.0;
    }
  }
  const auto person = measure(figure);
  ASSERT_FALSE(person);
  EXPECT_THAT(person.error().message, HasSubstr("the facing cannot be determined"));
}

TEST(MeasurePerson, FloorIsUnderTheLowerFootAndTheOriginBetweenTheAnkles) {
  StickFigure figure = standing_figure();
  figure.move("LeftLeg", {0, 0.2, 0.3});
  const MeasuredPerson person = measured(figure, {1.7});
  const Landmarks& l = person.landmarks;
  EXPECT_NEAR(l.right_leg.ankle.y, F::kAnkleHeight * 1.7, 1e-12);
  EXPECT_NEAR(l.left_leg.ankle.x + l.right_leg.ankle.x, 0.0, 1e-12);
  EXPECT_NEAR(l.left_leg.ankle.z + l.right_leg.ankle.z, 0.0, 1e-12);
  EXPECT_THAT(person.doubts, Contains(HasSubstr("the left foot is 0.20 m above the floor")));
}

TEST(MeasurePerson, FloorIsAtTheToesOfAPersonOnTiptoe) {
  StickFigure figure = standing_figure();
  figure.move("LeftToeBase", {0, -0.05, 0});
  EXPECT_NEAR(measured(figure).landmarks.left_leg.toe.y, 0.0, 1e-12);
}

TEST(MeasurePerson, MissingTipsAreOfAverageProportions) {
  StickFigure figure = standing_figure();
  figure = figure.without("LeftToeBase");
  StickFigure cut;
  for (const auto& point : figure.points) {
    const std::string parent =
        point.parent < 0 ? "" : figure.points[static_cast<std::size_t>(point.parent)].name;
    if (point.name.empty() && (parent == "Head" || parent == "LeftHand")) continue;
    cut.points.push_back({point.name, cut.find(parent), point.at});
  }
  const MeasuredPerson person = measured(cut);
  EXPECT_NEAR(person.stature, 1.7, 1e-12);
  const Landmarks& l = person.landmarks;
  expect_near(l.head_top, {0, 1.7, 0});
  expect_near(l.left_arm.fingertip, l.left_arm.wrist + Vec3d{F::kHand * 1.7, 0, 0});
  expect_near(l.left_leg.toe, {0.085, 0, (1 - kHeelShare) * F::kFootLength * 1.7});
  EXPECT_THAT(person.doubts, Contains(HasSubstr("the head has no tip")));
  EXPECT_THAT(person.doubts, Contains(HasSubstr("nothing follows joint 'LeftHand'")));
  EXPECT_THAT(person.doubts, Contains(HasSubstr("nothing follows joint 'LeftFoot'")));
}

TEST(MeasurePerson, MissingToeOfABentLegStandsAcrossTheShank) {
  StickFigure figure = standing_figure().without("LeftToeBase");
  // the shank is lifted backwards to the horizontal
  figure["LeftFoot"].at = figure["LeftLeg"].at - Vec3d{0, 0, F::kShank * 1.7};
  const Landmarks::Leg leg = measured(figure).landmarks.left_leg;
  EXPECT_NEAR(dot(leg.toe - leg.ankle, leg.knee - leg.ankle) / (F::kShank * 1.7),
              -F::kAnkleHeight * 1.7, 1e-12);
  EXPECT_LT(leg.toe.y, leg.ankle.y);
}

TEST(MeasurePerson, MissingNeckIsBetweenTheShoulders) {
  const MeasuredPerson person = measured(standing_figure().without("Neck"));
  expect_near(person.landmarks.neck, {0, F::kShoulderHeight * 1.7, 0}, 0.06);
  EXPECT_NEAR(person.landmarks.neck.y, person.landmarks.left_arm.shoulder.y, 1e-12);
}

TEST(MeasurePerson, FingertipIsTheFarthestButTheThumb) {
  StickFigure figure = standing_figure();
  const Vec3d wrist = figure["LeftHand"].at;
  figure.add("LeftHandThumb1", "LeftHand", wrist + Vec3d{0.1, 0, 0.3});
  figure.add("LeftHandMiddle1", "LeftHand", wrist + Vec3d{0.1, 0, 0});
  figure.add("LeftHandMiddle2", "LeftHandMiddle1", wrist + Vec3d{0.2, 0, 0});
  expect_near(measured(figure).landmarks.left_arm.fingertip,
              measured(standing_figure()).landmarks.left_arm.wrist + Vec3d{0.2, 0, 0});
}

TEST(MeasurePerson, GripIsTheNodeNearestToTheThirdKnuckle) {
  StickFigure figure = standing_figure();
  const Vec3d wrist = figure["LeftHand"].at;
  figure.add("LeftHandThumb1", "LeftHand", wrist + Vec3d{0.09, 0, 0.01});
  figure.add("LeftHandMiddle1", "LeftHand", wrist + Vec3d{0.1, 0, 0});
  figure.add("LeftHandMiddle2", "LeftHandMiddle1", wrist + Vec3d{0.2, 0, 0});
  const MeasuredPerson person = measured(figure);
  EXPECT_EQ(person.grip_nodes[0], figure.find("LeftHandMiddle1"));
  expect_near(*person.landmarks.left_arm.grip, person.landmarks.left_arm.wrist + Vec3d{0.1, 0, 0});
  // a hand without fingers
  EXPECT_EQ(person.grip_nodes[1], figure.find("RightHand"));
  EXPECT_EQ(*person.landmarks.right_arm.grip, person.landmarks.right_arm.wrist);
}

TEST(GripOf, WithoutANodeIsAShareOfTheHand) {
  const Landmarks::Arm arm = standing_landmarks(1.7, 0.0).left_arm;
  expect_near(grip_of(arm), arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction);
}

TEST(Placement, TakesTheFilesPointsToTheLandmarks) {
  const Mat3d turn = rotation(Axis::x, radians(90)) * rotation(Axis::y, radians(30));
  for (const double mirror : {1.0, -1.0}) {
    StickFigure figure = standing_figure().transformed(turn * scale(100.0));
    for (auto& point : figure.points) point.at = Vec3d{mirror * point.at.x, point.at.y, point.at.z};
    const MeasuredPerson person = measured(figure);
    EXPECT_EQ(person.placement.mirrored(), mirror < 0.0);
    expect_near(person.placement.to_world(figure["LeftLeg"].at), person.landmarks.left_leg.knee);
    expect_near(person.placement.to_world(figure["RightHand"].at),
                person.landmarks.right_arm.wrist);
  }
}

TEST(MeasurePerson, SegmentsWithoutLengthAreErrors) {
  for (const auto& [upper, lower, segment] :
       {std::tuple("RightUpLeg", "RightLeg", "right thigh"),
        std::tuple("LeftArm", "LeftForeArm", "left upper arm"),
        std::tuple("RightForeArm", "RightHand", "right forearm")}) {
    StickFigure figure = standing_figure();
    figure[lower].at = figure[upper].at;
    const auto person = measure(figure);
    ASSERT_FALSE(person);
    EXPECT_EQ(person.error().message, std::string("the ") + segment + " has no length: joint '" +
                                          upper + "' and joint '" + lower + "' stand at one point");
  }
}

TEST(MeasurePerson, UnequalSidesAreADoubt) {
  StickFigure figure = standing_figure();
  figure["LeftLeg"].at.y += 0.1;
  const MeasuredPerson person = measured(figure);
  EXPECT_THAT(person.doubts, Contains(HasSubstr("the left thigh is 0.317 m long, the right")));
}

// The shoulders of game characters often lie behind their hips.
StickFigure leaning_back(double lean_deg) {
  StickFigure figure = standing_figure();
  const double hip = figure["Hips"].at.y;
  const SinCos<double> lean = sin_cos(radians(lean_deg));
  for (StickFigure::Point& point : figure.points) {
    if (point.at.y > hip) point.at.z -= lean.sin / lean.cos * (point.at.y - hip);
  }
  return figure;
}

double lean_of_frame(const Landmarks& person) {
  const Vec3d up = human_frames(person).trunk.cy;
  return degrees(std::atan2(-up.z, up.y));
}

const MeasureSettings kAtRest{.stature = {}, .skin = {}, .at_rest = true};

TEST(MeasurePerson, ATrunkAtRestIsUprightWhereverItsJointsLie) {
  const Landmarks person = measured(leaning_back(8.0), kAtRest).landmarks;
  EXPECT_NEAR(degrees(person.trunk_lean), 8.0, 1e-9);
  EXPECT_NEAR(lean_of_frame(person), 0.0, 1e-9);
  const Landmarks stooping = measured(leaning_back(-19.0), kAtRest).landmarks;
  EXPECT_NEAR(lean_of_frame(stooping), 0.0, 1e-9);
}

TEST(MeasurePerson, ATrunkThatLeansFarOrInAMotionLeans) {
  EXPECT_NEAR(lean_of_frame(measured(leaning_back(25.0), kAtRest).landmarks), 25.0, 1e-9);
  EXPECT_NEAR(lean_of_frame(measured(leaning_back(8.0)).landmarks), 8.0, 1e-9);
}

struct RealPerson {
  const char* path;
  double unit;
  double stature;  // m, by adding the file's OFFSETs by hand
};

class RealPersons : public ::testing::TestWithParam<RealPerson> {
 protected:
  void SetUp() override {
    const fs::path path = fs::path(SHIGUSA_SHARED_DIR) / GetParam().path;
    if (!fs::exists(path)) GTEST_SKIP() << "no " << path;
    auto motion = read_bvh(path);
    ASSERT_TRUE(motion) << motion.error().to_string();
    motion_ = std::move(*motion);
  }
  [[nodiscard]] MeasuredPerson at(int frame) const {
    const auto world = world_transforms(motion_.skeleton, motion_.clip, frame);
    const auto map = find_humanoid(motion_.skeleton, world);
    EXPECT_TRUE(map) << map.error().to_string();
    const auto person = measure_person(motion_.skeleton, world, *map);
    EXPECT_TRUE(person) << person.error().to_string();
    return person ? *person : MeasuredPerson{};
  }
  SkeletonMotion motion_;
};

TEST_P(RealPersons, HaveOneStatureAndUnitInAllFrames) {
  for (int frame = 0; frame < motion_.clip.frames; frame += 7) {
    const MeasuredPerson person = at(frame);
    EXPECT_NEAR(person.placement.unit, GetParam().unit, 1e-9) << frame;
    EXPECT_NEAR(person.stature, GetParam().stature, 0.002) << frame;
  }
}

TEST_P(RealPersons, StandOnTheFloorBetweenTheirFeetLeftToTheLeft) {
  for (int frame = 0; frame < motion_.clip.frames; frame += 7) {
    const MeasuredPerson person = at(frame);
    const Landmarks& l = person.landmarks;
    double lowest = 1.0;
    for (const Side side : {Side::left, Side::right}) {
      lowest = std::min(lowest, l.leg(side).toe.y);
      lowest = std::min(lowest, l.leg(side).ankle.y - F::kAnkleHeight * person.stature);
    }
    EXPECT_NEAR(lowest, 0.0, 1e-12);
    EXPECT_NEAR(l.left_leg.ankle.x + l.right_leg.ankle.x, 0.0, 1e-12);
    EXPECT_NEAR(l.left_leg.ankle.z + l.right_leg.ankle.z, 0.0, 1e-12);
    EXPECT_GT(l.left_leg.hip.x, l.right_leg.hip.x);
    EXPECT_GT(l.left_arm.shoulder.x, l.right_arm.shoulder.x);
    // they bend, run and sit on the ground, but none lies, and their feet go ahead
    EXPECT_GT(l.neck.y, l.left_leg.ankle.y);
    EXPECT_GT(l.neck.y, l.right_leg.ankle.y);
    EXPECT_GT(l.left_leg.toe.z + l.right_leg.toe.z, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shared, RealPersons,
    ::testing::Values(RealPerson{"characters/assimp__Boxing_Toes.bvh", 0.01, 1.735},
                      RealPerson{"characters/blender-cli-rendering__102_01.bvh", 0.0254 / 0.45,
                                 1.435},
                      RealPerson{"characters/fairmotion__pfnn_hierarchy.bvh", 1.0, 1.555},
                      RealPerson{"characters/pybvh__bvh_test1.bvh", 0.0254, 1.663},
                      RealPerson{"characters/pybvh__standard_skeleton.bvh", 0.0254, 1.544},
                      RealPerson{"reach/cmu_02_06_60hz.bvh", 0.01, 1.627}),
    [](const auto& test) {
      std::string name = fs::path(test.param.path).stem().string();
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace shigusa
