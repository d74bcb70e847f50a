// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "strip_support.hpp"

namespace shigusa {
namespace {

using namespace strip_support;

// --- the file ---

TEST(StripFigure, SameInputGivesTheSameBytes) {
  const SkeletonMotion motion = reaching(30);
  EXPECT_EQ(svg(motion, full_overlay(motion)), svg(motion, full_overlay(motion)));
}

TEST(StripFigure, SvgHasTheWidthAskedFor) {
  StripSettings settings;
  settings.width_mm = 120.0;
  const std::string text = svg(standing(1), {}, settings);
  EXPECT_NEAR(attribute(text.substr(text.find("<svg")), "width"), 120.0 * kPointsPerMm, kSamePlace);
}

TEST(StripFigure, SvgOfSevenPosesIsSmall) {
  const SkeletonMotion motion = reaching(60);
  EXPECT_LT(svg(motion, full_overlay(motion)).size(), 40'000u);
}

TEST(StripFigure, SvgHasNoNamesThatWouldMeetThoseOfAnotherOnOnePage) {
  const SkeletonMotion motion = reaching(30);
  const std::string text = svg(motion, full_overlay(motion));
  EXPECT_EQ(text.find(" id="), std::string::npos);
  EXPECT_EQ(text.find("<style"), std::string::npos);
}

// --- the figure ---

TEST(StripFigure, PosesStandApart) {
  for (const int poses : {2, 3, 7, 20}) {
    StripSettings settings;
    settings.poses = poses;
    EXPECT_EQ(separate_figures(svg(reaching(60), {}, settings)), static_cast<std::size_t>(poses));
  }
}

TEST(StripFigure, SpreadArmsStandApartToo) {
  SkeletonMotion motion = standing(10);
  for (int frame = 0; frame < 10; ++frame) {
    local(motion, frame, "left_upper_arm").rotation = axis_rotation(Axis::z, radians(90.0));
    local(motion, frame, "right_upper_arm").rotation = axis_rotation(Axis::z, radians(-90.0));
  }
  EXPECT_EQ(separate_figures(svg(motion)), 7u);
}

TEST(StripFigure, FiguresFillTheWidth) {
  const std::vector<Path> pieces = rims(svg(reaching(60)));
  double left = 1e9;
  double right = 0.0;
  for (const Path& piece : pieces) {
    left = std::min(left, piece.left());
    right = std::max(right, piece.right());
  }
  const double width = StripSettings{}.width_mm * kPointsPerMm;
  EXPECT_LT(left, 0.02 * width);
  EXPECT_GT(right, 0.98 * width);
}

TEST(StripFigure, SinglePoseIsNotBlownUpToTheWidth) {
  StripSettings settings;
  settings.poses = 1;
  const double width = settings.width_mm * kPointsPerMm;
  EXPECT_LT(page_height(svg(standing(1), {}, settings)), 0.7 * width);
}

TEST(StripFigure, ClipShorterThanThePosesShowsEachFrameOnce) {
  EXPECT_EQ(separate_figures(svg(reaching(3))), 3u);
}

TEST(StripFigure, PartOfAClipIsDrawnAsIfItWereAll) {
  SkeletonMotion motion = reaching(21);
  StripSettings settings;
  settings.poses = 3;
  settings.first_frame = 10;
  const std::string part = svg(motion, {}, settings);
  auto& all = motion.clip.local;
  all.erase(all.begin(),
            all.begin() + static_cast<std::ptrdiff_t>(10 * motion.skeleton.nodes.size()));
  motion.clip.frames = 11;
  settings.first_frame = 0;
  EXPECT_EQ(part, svg(motion, {}, settings));
}

TEST(StripFigure, ForwardIsToTheRightOfThePage) {
  StripSettings settings;
  settings.poses = 1;
  const auto reach = [&](const SkeletonMotion& motion) {
    double right = 0.0;
    double back = 1e9;
    for (const Path& piece : filled(svg(motion, {}, settings), kAccent)) {
      right = std::max(right, piece.right());
      back = std::min(back, piece.left());
    }
    return right - back;
  };
  EXPECT_GT(reach(reaching(1)), 2.0 * reach(standing(1)));
}

TEST(StripFigure, ViewerAboveTheHorizonSeesTheNearerFootLower) {
  StripSettings settings;
  settings.poses = 1;
  const auto sole = [&](Limb leg) {
    settings.accented = {leg};
    return filled(svg(standing(1), {}, settings), kAccent).back().bottom();
  };
  EXPECT_GT(sole(Limb::right_leg), sole(Limb::left_leg));
}

TEST(StripFigure, RightArmIsPaintedOverTheLeftOne) {
  StripSettings settings;
  settings.poses = 1;
  const auto order = [&](Limb limb) {
    settings.accented = {limb};
    const std::vector<Path> all = paths(svg(standing(1), {}, settings));
    const auto found =
        std::find_if(all.begin(), all.end(), [](const Path& path) { return path.filled(kAccent); });
    return found - all.begin();
  };
  EXPECT_LT(order(Limb::left_arm), order(Limb::right_arm));
}

TEST(StripFigure, OnlyTheAccentedLimbHasTheAccentColour) {
  StripSettings settings;
  settings.poses = 1;
  EXPECT_EQ(filled(svg(standing(1), {}, settings), kAccent).size(), 3u);
  settings.accented = {};
  EXPECT_EQ(filled(svg(standing(1), {}, settings), kAccent).size(), 0u);
  settings.accented = {Limb::left_leg, Limb::right_leg};
  EXPECT_EQ(filled(svg(standing(1), {}, settings), kAccent).size(), 6u);
}

TEST(StripFigure, HumanoidMapGivesForeignNamesTheSameLook) {
  SkeletonMotion motion = reaching(20);
  const std::string expected = svg(motion);
  StripSettings settings;
  settings.humanoid.emplace();
  for (int bone = 0; bone < kHumanoidBoneCount; ++bone) {
    const auto which = static_cast<HumanoidBone>(bone);
    (*settings.humanoid)[which] = motion.skeleton.find(humanoid_bone_name(which));
  }
  for (SkeletonNode& node : motion.skeleton.nodes) node.name = "bone " + node.name;
  EXPECT_EQ(svg(motion, {}, settings), expected);
  EXPECT_NE(svg(motion), expected);
}

TEST(StripFigure, UnknownSkeletonIsDrawnBoneByBone) {
  SkeletonMotion motion = standing(1);
  for (SkeletonNode& node : motion.skeleton.nodes) node.name = "bone " + node.name;
  EXPECT_EQ(rims(svg(motion)).size(), motion.skeleton.nodes.size());
}

TEST(StripFigure, BodyWithOneArmAndOneLegIsDrawn) {
  SkeletonMotion motion = standing(1);
  for (SkeletonNode& node : motion.skeleton.nodes) {
    if (node.name.rfind("left_", 0) == 0) node.name = "no " + node.name;
  }
  EXPECT_EQ(filled(svg(motion), kAccent).size(), 3u);
}

// --- the view ---

RC_GTEST_PROP(StripFigure, PictureDoesNotDependOnWhereTheFigureFaces, ()) {
  const double angle = radians(*rc::gen::inRange(-180, 181));
  const SkeletonMotion motion = reaching(12);
  const std::string other = svg(turned(motion, axis_rotation(Axis::y, angle)));
  expect_same_picture(svg(motion), other, kSamePlace);
}

TEST(StripFigure, GivenFacingTurnsTheView) {
  StripSettings settings;
  settings.facing = Vec3d{1, 0, 0};
  EXPECT_NE(svg(reaching(12), {}, settings), svg(reaching(12)));
}

TEST(StripFigure, UpAxisZGivesTheSamePictureOfTheSameMotion) {
  const SkeletonMotion motion = reaching(12);
  StripSettings settings;
  settings.up = {0, 0, 1};
  const SkeletonMotion z_up = turned(motion, axis_rotation(Axis::x, radians(90.0)));
  expect_same_picture(svg(z_up, {}, settings), svg(motion), kSamePlace);
}

TEST(StripFigure, UnitOfTheSkeletonDoesNotChangeThePicture) {
  const SkeletonMotion motion = reaching(12);
  const SkeletonMotion scaled = in_centimetres(motion);
  StripSettings settings;
  settings.metres_per_unit = 0.01;
  expect_same_picture(svg(scaled, full_overlay(scaled), settings),
                      svg(motion, full_overlay(motion)), kSamePlace);
}

TEST(StripFigure, PlantedFeetStandInTheSamePlaceOfEachSlot) {
  SkeletonMotion motion = reaching(13);
  StripSettings settings;
  settings.accented = {Limb::right_leg};
  const std::vector<Path> leg = filled(svg(motion, {}, settings), kAccent);
  ASSERT_EQ(leg.size(), 21u);
  const double step = leg[3].left() - leg[0].left();
  for (std::size_t i = 3; i < leg.size(); ++i) {
    EXPECT_NEAR(leg[i].left() - leg[i - 3].left(), step, 2.0 * kSameArc);
  }
}

TEST(StripFigure, FigureThatTravelsIsCentredInEachSlot) {
  SkeletonMotion motion = standing(13);
  const std::string still = svg(motion);
  for (int frame = 0; frame < 13; ++frame) {
    local(motion, frame, "hips").translation += Vec3d{0.1 * frame, 0, 0.4 * frame};
  }
  expect_same_picture(svg(motion), still, kSamePlace);
}

TEST(StripFigure, FarFromHeightZeroTheFloorIsUnderTheLowestNode) {
  SkeletonMotion sunk = reaching(12);
  for (int frame = 0; frame < 12; ++frame) local(sunk, frame, "hips").translation.y -= 1.5;
  expect_same_picture(svg(sunk), svg(reaching(12)), kSamePlace);
}

TEST(StripFigure, GivenFloorIsKept) {
  SkeletonMotion raised = reaching(12);
  for (int frame = 0; frame < 12; ++frame) local(raised, frame, "hips").translation.y += 0.5;
  StripSettings settings;
  settings.floor = 0.5;
  expect_same_picture(svg(raised, {}, settings), svg(reaching(12)), kSamePlace);
  settings.floor = 0.0;
  EXPECT_NE(svg(raised, {}, settings), svg(reaching(12)));
}

TEST(StripFigure, SolesAreSeenOfFeetOnTheFloorAlone) {
  StripSettings settings;
  settings.poses = 1;
  settings.floor = 0.0;
  const auto soles = [&](double lifted) {
    SkeletonMotion motion = standing(1);
    local(motion, 0, "hips").translation.y += lifted;
    return filled(svg(motion, {}, settings), "#e4e8eb").size();
  };
  for (const double on_floor : {0.0, 0.05}) EXPECT_EQ(soles(on_floor), 1u) << on_floor;
  for (const double away : {-0.1, 0.1, 0.3}) EXPECT_EQ(soles(away), 0u) << away;
}

TEST(StripFigure, ScaleBarIsTheLongestRoundLengthWithinAnEighthOfThePage) {
  const double width = StripSettings{}.width_mm * kPointsPerMm;
  for (const double size : {0.01, 0.4, 1.0, 1.7, 2.9, 50.0}) {
    SkeletonMotion motion = standing(2);
    for (SkeletonNode& node : motion.skeleton.nodes) node.offset = node.offset * size;
    for (LocalTransform& x : motion.clip.local) x.translation = x.translation * size;
    StripOverlay overlay;
    overlay.hand_path = {{0.0, 0.4 * size, 0.0}, {0.0, 0.9 * size, 0.0}};
    StripSettings level;
    level.elevation_deg = 0.0;
    const std::string text = svg(motion, overlay, level);
    double height = 0.0;  // of the path
    double bar = 0.0;
    for (const Path& path : paths(text)) {
      if (path.look.find("#c9705f") != path.look.npos)
        height = max(height, path.bottom() - path.top());
      if (path.look.find("#2f3942") != path.look.npos) bar = path.right() - path.left();
    }
    double metres = 0.0;
    for (const Words& line : words(text)) {
      if (line.text.ends_with(" m")) metres = std::atof(line.text.c_str());
    }
    EXPECT_NEAR(bar / metres, height / (0.5 * size), 0.01 * bar / metres) << size;
    double next = 1e-3;  // the shortest round length that would not do
    for (int k = 0; next < 1.0001 * metres; ++k) next *= k % 3 == 1 ? 2.5 : 2.0;
    EXPECT_LE(bar, 0.12 * width) << size;
    EXPECT_GT(bar * next / metres, 0.12 * width) << size;
    EXPECT_LE(next, 2.501 * metres) << size;
  }
}

// --- overlays ---

TEST(StripFigure, EachOverlayIsDrawnInEachPose) {
  const SkeletonMotion motion = reaching(30);
  const StripOverlay full = full_overlay(motion);
  const std::size_t bare = paths(svg(motion)).size();
  StripOverlay goal;
  goal.goals = full.goals;
  EXPECT_GE(paths(svg(motion, goal)).size(), bare + 7 * 2);
  StripOverlay mass;
  mass.centre_of_mass = full.centre_of_mass;
  EXPECT_GE(paths(svg(motion, mass)).size(), bare + 7 * 4);
  StripOverlay path;
  path.hand_path = full.hand_path;
  EXPECT_GE(paths(svg(motion, path)).size(), bare + 7);
}

TEST(StripFigure, CaptionIsBetweenTheTimesAndTheLegend) {
  const SkeletonMotion motion = standing(1);
  StripOverlay overlay;
  overlay.goals = {{0.0, 1.0, 0.3}};
  overlay.caption = "A";
  const std::string text = svg(motion, overlay);
  EXPECT_LT(base_of(text, "0.00 s"), base_of(text, "A"));
  EXPECT_LT(base_of(text, "A"), base_of(text, "goal"));
}

TEST(StripFigure, LongCaptionStaysOnThePage) {
  StripOverlay overlay;
  overlay.caption = std::string(300, 'w') + " and " + std::string(300, ' ') + "words of its own";
  EXPECT_TRUE(within_page(svg(standing(1), overlay)));
}

TEST(StripFigure, PosesStandApartWithTheirGoals) {
  const SkeletonMotion motion = reaching(30);
  StripOverlay overlay;
  overlay.goals = {{-0.3, 1.0, 0.9}};
  EXPECT_EQ(separate_figures(svg(motion, overlay)), 14u);
}

RC_GTEST_PROP(StripFigure, GoalsAnywhereStayOnThePage, ()) {
  const auto coordinate = [] { return 0.1 * *rc::gen::inRange(-200, 200); };
  StripOverlay overlay;
  overlay.goals = {{coordinate(), coordinate(), coordinate()}};
  RC_ASSERT(within_page(svg(reaching(5), overlay)));
}

TEST(StripFigure, FarGoalLeavesTheFigureItsSize) {
  StripOverlay overlay;
  overlay.goals = {{-20.0, 1.0, 100.0}};
  EXPECT_GT(page_height(svg(reaching(5), overlay)), 0.7 * page_height(svg(reaching(5))));
}

TEST(StripFigure, PathThatLeavesTheSlotIsCut) {
  const SkeletonMotion motion = reaching(30);
  StripOverlay overlay;
  for (int frame = 0; frame < 30; ++frame) overlay.hand_path.push_back({0, 1, 0.5 * frame});
  EXPECT_TRUE(within_page(svg(motion, overlay)));
}

// --- strange motions ---

TEST(StripFigure, StrangeMotionsAreDrawnOnThePage) {
  std::vector<SkeletonMotion> motions;
  motions.push_back({{{{"", -1, {}, false}}}, {0.1, 1, {{}}}});  // one node
  motions.push_back({{{{"", -1, {}, false}, {"", -1, {}, false}}}, {0.0, 1, {{}, {}}}});
  SkeletonMotion point = reaching(4);  // all nodes in one place
  for (LocalTransform& x : point.clip.local) x.translation = {};
  motions.push_back(point);
  for (SkeletonNode& node : point.skeleton.nodes) node.offset = {};
  motions.push_back(point);
  for (const double scale : {1e-200, 1e-8, 1e8, 1e11}) {
    SkeletonMotion scaled = reaching(4);
    for (SkeletonNode& node : scaled.skeleton.nodes) node.offset = node.offset * scale;
    for (LocalTransform& x : scaled.clip.local) x.translation = x.translation * scale;
    motions.push_back(scaled);
  }
  SkeletonMotion exploded = reaching(4);  // limbs far longer than the skeleton says
  for (LocalTransform& x : exploded.clip.local) x.translation = x.translation * 1e6;
  motions.push_back(exploded);
  motions.push_back(turned(reaching(4), axis_rotation(Axis::x, radians(90.0))));  // lies
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_TRUE(within_page(svg(motions[i]))) << "motion " << i;
  }
}

RC_GTEST_PROP(StripFigure, RandomSkeletonsAreDrawnOnThePage, ()) {
  const auto number = [] { return 0.01 * *rc::gen::inRange(-300, 300); };
  SkeletonMotion motion;
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    // the names of bones, on nodes that may hang together in any way
    const auto bone = static_cast<HumanoidBone>(*rc::gen::inRange(0, kHumanoidBoneCount));
    const int parent = *rc::gen::inRange(-1, i);
    motion.skeleton.nodes.push_back({std::string(humanoid_bone_name(bone)), parent, {}, false});
    motion.skeleton.nodes.back().offset = {number(), number(), number()};
  }
  motion.clip.frames = *rc::gen::inRange(1, 10);
  for (int i = 0; i < count * motion.clip.frames; ++i) {
    motion.clip.local.push_back({{number(), number(), number()}, axis_rotation(Axis::y, number())});
  }
  RC_ASSERT(within_page(svg(motion)));
}

// --- refusals ---

std::string refusal(const SkeletonMotion& motion, const StripOverlay& overlay = {},
                    const StripSettings& settings = {}) {
  const auto figure = draw_strip(motion, overlay, settings);
  return figure ? "drawn" : figure.error().to_string();
}

TEST(StripFigure, SettingsOutOfRangeAreRefusedWithTheRange) {
  StripSettings poses;
  poses.poses = 0;
  EXPECT_EQ(refusal(standing(1), {}, poses), "poses: 0 given; 1 to 60 allowed");
  StripSettings width;
  width.width_mm = std::nan("");
  EXPECT_EQ(refusal(standing(1), {}, width), "width_mm: nan given; 100 to 2000 allowed");
  StripSettings up;
  up.up = {};
  EXPECT_EQ(refusal(standing(1), {}, up), "length of up: 0 given; 1e-06 to 1e+06 allowed");
}

TEST(StripFigure, FramesOutsideTheClipAreRefused) {
  StripSettings settings;
  for (const auto& [first, last] : {std::pair{3, 12}, {0, 5}, {-1, 2}, {2, 1}, {1, 0}}) {
    settings.first_frame = first;
    settings.last_frame = last;
    EXPECT_EQ(refusal(standing(5), {}, settings),
              fmt::format("frames: {} to {} given; the clip has 0 to 4", first, last));
  }
}

TEST(StripFigure, MorePiecesThanAFileShouldHaveAreRefused) {
  SkeletonMotion motion = standing(1);
  motion.skeleton.nodes.resize(1093, motion.skeleton.nodes.back());
  StripSettings settings;
  settings.poses = 60;
  EXPECT_EQ(refusal(motion, {}, settings),
            "skeleton: 1093 nodes in 60 poses; together at most 65536 allowed");
}

TEST(StripFigure, MapToNodesThatDoNotExistIsRefused) {
  StripSettings settings;
  settings.humanoid.emplace();
  (*settings.humanoid)[HumanoidBone::head] = 1000;
  EXPECT_EQ(refusal(standing(1), {}, settings),
            "humanoid map: names node 1000 of a skeleton of 20");
}

TEST(StripFigure, MotionWithoutFramesOrNodesIsRefused) {
  SkeletonMotion motion = standing(1);
  motion.clip.frames = 0;
  EXPECT_EQ(refusal(motion), "motion: has no frame to draw");
  EXPECT_EQ(refusal({}), "skeleton: has no node to draw");
}

TEST(StripFigure, ClipOfAnotherSizeThanItsSkeletonIsRefused) {
  SkeletonMotion motion = standing(2);
  motion.clip.local.pop_back();
  EXPECT_EQ(refusal(motion), "motion: 39 transforms for 2 frames of 20 nodes");
}

TEST(StripFigure, ParentAfterItsChildIsRefused) {
  SkeletonMotion motion = standing(1);
  motion.skeleton.nodes[1].parent = 5;
  EXPECT_EQ(refusal(motion), "node 1 'spine': has parent 5; -1 or an earlier node allowed");
}

TEST(StripFigure, PositionsThatAreNotFiniteAreRefusedWithTheirPlace) {
  SkeletonMotion motion = standing(2);
  local(motion, 1, "head").translation.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(motion).rfind("node 3 'head' in frame 1", 0), 0u);
  StripOverlay overlay;
  overlay.goals = {{0, 0, 0}, {0, std::nan(""), 0}};
  EXPECT_EQ(refusal(standing(1), overlay), "goals: position 1 is not finite, or beyond 1e+12");
}

TEST(StripFigure, RotationsThatAreNotFiniteAreRefused) {
  SkeletonMotion motion = standing(2);
  local(motion, 1, "head").rotation.w = std::nan("");
  EXPECT_EQ(refusal(motion).rfind("node 3 'head' in frame 1", 0), 0u);
}

TEST(StripFigure, OverlayOfAnotherLengthThanTheClipIsRefused) {
  StripOverlay overlay;
  overlay.hand_path.resize(3);
  EXPECT_EQ(refusal(standing(5), overlay), "hand path: 3 positions given; 0 or 5 allowed");
}

TEST(StripFigure, OverlaysUpToTheirLimitsAreDrawn) {
  StripOverlay overlay;
  overlay.things.resize(144, {std::vector<Vec3d>(64), 0.0});
  overlay.goals.resize(64);
  overlay.caption.resize(2000, 'w');
  EXPECT_EQ(refusal(standing(1), overlay), "drawn");
  StripOverlay more = overlay;
  more.things.resize(145, {{{}}, 0.0});
  EXPECT_EQ(refusal(standing(1), more), "things: 145 given; up to 144 allowed");
  more = overlay;
  more.things[3].corners.resize(65);
  EXPECT_EQ(refusal(standing(1), more), "thing 3: 65 corners given; 1 to 64 allowed");
  more = overlay;
  more.goals.resize(65);
  EXPECT_EQ(refusal(standing(1), more), "goals: 65 positions given; up to 64 allowed");
  more = overlay;
  more.caption += 'w';
  EXPECT_EQ(refusal(standing(1), more), "caption: 2001 bytes given; up to 2000 allowed");
}

TEST(StripFigure, CaptionThatIsNotUtf8IsRefused) {
  for (const std::string bad : {"\xff", "a\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80"}) {
    StripOverlay overlay;
    overlay.caption = bad;
    EXPECT_NE(refusal(standing(1), overlay).find("is not UTF-8 text"), std::string::npos);
  }
}

TEST(StripFigure, OddCaptionDoesNotSpoilTheNextFigure) {
  const std::string before = svg(standing(1));
  StripOverlay overlay;
  overlay.caption = "noncharacter \xef\xbf\xbe and bell \x07";
  (void)draw_strip(standing(1), overlay, {});
  overlay.caption = "as usual";
  EXPECT_EQ(refusal(standing(1), overlay), "drawn");
  EXPECT_EQ(svg(standing(1)), before);
}

}  // namespace
}  // namespace shigusa
