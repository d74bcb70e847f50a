// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <shigusa/scalar.hpp>
#include <shigusa/strip_figure.hpp>
#include <string>
#include <vector>

// Fontconfig keeps its fonts for the whole run, behind pointers that the leak checker cannot read.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

namespace shigusa {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
// Control points of curves lie a little outside what is drawn.
constexpr double kCurveSlack = 1.0;
// Cairo keeps paths on a grid of 1/256 point: two roundings apart.
constexpr double kSamePlace = 2.01 / 256.0;

// A standing body of 1.7 m with the VRM names, facing +Z, for `frames` frames.
SkeletonMotion standing(int frames) {
  SkeletonMotion motion;
  auto& nodes = motion.skeleton.nodes;
  const auto add = [&](const std::string& name, const std::string& parent, Vec3d offset) {
    nodes.push_back({name, motion.skeleton.find(parent), offset, false});
  };
  nodes.push_back({"hips", -1, {0, 0.93, 0}, false});
  add("spine", "hips", {0, 0.2, 0});
  add("neck", "spine", {0, 0.32, 0});
  add("head", "neck", {0, 0.09, 0.02});
  for (const std::string side : {"left_", "right_"}) {
    const double out = side == "left_" ? 1.0 : -1.0;
    add(side + "upper_leg", "hips", {0.09 * out, -0.03, 0});
    add(side + "lower_leg", side + "upper_leg", {0, -0.42, 0});
    add(side + "foot", side + "lower_leg", {0, -0.41, 0});
    add(side + "toes", side + "foot", {0, -0.07, 0.15});
    add(side + "upper_arm", "spine", {0.18 * out, 0.28, 0});
    add(side + "lower_arm", side + "upper_arm", {0, -0.28, 0});
    add(side + "hand", side + "lower_arm", {0, -0.25, 0});
    add(side + "hand_grip", side + "hand", {0, -0.09, 0});
  }
  motion.clip.frames = frames;
  for (int frame = 0; frame < frames; ++frame) {
    for (const SkeletonNode& node : nodes) motion.clip.local.push_back({node.offset, {}});
  }
  return motion;
}

LocalTransform& local(SkeletonMotion& motion, int frame, const std::string& node) {
  const auto nodes = motion.skeleton.nodes.size();
  return motion.clip.local[static_cast<std::size_t>(frame) * nodes +
                           static_cast<std::size_t>(motion.skeleton.find(node))];
}

// The right arm rises forward, to a right angle in the last frame.
SkeletonMotion reaching(int frames) {
  SkeletonMotion motion = standing(frames);
  for (int frame = 0; frame < frames; ++frame) {
    const double share = frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1.0;
    local(motion, frame, "right_upper_arm").rotation =
        axis_rotation(Axis::x, radians(-90.0 * share));
  }
  return motion;
}

// The whole motion turned about the origin.
SkeletonMotion turned(SkeletonMotion motion, const Quatd& turn) {
  const Mat3d matrix = to_matrix(turn);
  for (int frame = 0; frame < motion.clip.frames; ++frame) {
    LocalTransform& root = local(motion, frame, "hips");
    root = {matrix * root.translation, turn * root.rotation};
  }
  return motion;
}

std::vector<Vec3d> path_of(const SkeletonMotion& motion, const std::string& node) {
  std::vector<Vec3d> path;
  const auto index = static_cast<std::size_t>(motion.skeleton.find(node));
  for (int frame = 0; frame < motion.clip.frames; ++frame) {
    const auto world = world_transforms(motion.skeleton, motion.clip, frame);
    path.push_back(world[index].translation);
  }
  return path;
}

std::string svg(const SkeletonMotion& motion, const StripOverlay& overlay = {},
                const StripSettings& settings = {}) {
  return draw_strip(motion, overlay, settings, FigureFormat::svg).value();
}

struct Path {
  std::string style;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] double left() const { return *std::min_element(x.begin(), x.end()); }
  [[nodiscard]] double right() const { return *std::max_element(x.begin(), x.end()); }
  [[nodiscard]] double top() const { return *std::min_element(y.begin(), y.end()); }
  [[nodiscard]] bool filled(const std::string& rgb) const {
    return style.find("fill:" + rgb) != std::string::npos;
  }
};

// The paths of an SVG text, in the order in which they are painted.
std::vector<Path> paths(const std::string& text) {
  std::vector<Path> result;
  for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at)) {
    const std::size_t style = text.find("style=\"", at) + 7;
    const std::size_t data = text.find(" d=\"", at) + 4;
    at = text.find("/>", data);
    Path path{text.substr(style, text.find('"', style) - style), {}, {}};
    const std::string numbers = text.substr(data, text.find('"', data) - data);
    bool is_x = true;
    for (const char* next = numbers.c_str(); *next != '\0';) {
      char* end = nullptr;
      const double value = std::strtod(next, &end);
      if (end != next) {
        (is_x ? path.x : path.y).push_back(value);
        is_x = !is_x;
      }
      next = end != next ? end : next + 1;
    }
    if (!path.x.empty()) result.push_back(path);
  }
  return result;
}

// The pieces of the figures alone: what has a white rim.
std::vector<Path> rims(const std::string& text) {
  std::vector<Path> result = paths(text);
  std::erase_if(result, [](const Path& path) {
    return path.style.find("stroke:rgb(100%,100%,100%)") == std::string::npos;
  });
  return result;
}

constexpr const char* kAccent = "rgb(63.921569%,16.862745%,9.803922%)";

std::vector<Path> filled(const std::string& text, const std::string& rgb) {
  std::vector<Path> result = paths(text);
  std::erase_if(result, [&](const Path& path) { return !path.filled(rgb); });
  return result;
}

// How many groups of pieces are left when pieces that share a column are put together.
std::size_t separate_figures(const std::string& text) {
  std::vector<Path> pieces = rims(text);
  std::sort(pieces.begin(), pieces.end(),
            [](const Path& a, const Path& b) { return a.left() < b.left(); });
  std::size_t count = 0;
  double right = -1e9;
  for (const Path& piece : pieces) {
    if (piece.left() > right) ++count;
    right = std::max(right, piece.right());
  }
  return count;
}

void expect_same_picture(const std::string& a, const std::string& b, double tolerance) {
  const std::vector<Path> first = paths(a);
  const std::vector<Path> second = paths(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].style, second[i].style);
    ASSERT_EQ(first[i].x.size(), second[i].x.size());
    for (std::size_t k = 0; k < first[i].y.size(); ++k) {
      EXPECT_NEAR(first[i].x[k], second[i].x[k], tolerance);
      EXPECT_NEAR(first[i].y[k], second[i].y[k], tolerance);
    }
  }
}

bool within_page(const std::string& text) {
  const std::size_t box = text.find("viewBox=\"0 0 ") + 13;
  char* end = nullptr;
  const double width = std::strtod(text.c_str() + box, &end);
  const double height = std::strtod(end, nullptr);
  for (const Path& path : paths(text)) {
    for (const double x : path.x) {
      if (!(x >= -kCurveSlack && x <= width + kCurveSlack)) return false;
    }
    for (const double y : path.y) {
      if (!(y >= -kCurveSlack && y <= height + kCurveSlack)) return false;
    }
  }
  return text.find("nan") == std::string::npos && text.find("inf") == std::string::npos;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

StripOverlay full_overlay(const SkeletonMotion& motion) {
  StripOverlay overlay;
  overlay.hand_path = path_of(motion, "right_hand_grip");
  overlay.centre_of_mass = path_of(motion, "hips");
  overlay.goals = {overlay.hand_path.back()};
  overlay.caption = "Reaching forward";
  return overlay;
}

// --- formats ---

TEST(StripFigure, SameInputGivesTheSameBytesInEachFormat) {
  const SkeletonMotion motion = reaching(30);
  for (const auto format : {FigureFormat::svg, FigureFormat::png, FigureFormat::pdf}) {
    const auto first = draw_strip(motion, full_overlay(motion), {}, format);
    const auto second = draw_strip(motion, full_overlay(motion), {}, format);
    EXPECT_EQ(first.value(), second.value());
  }
}

TEST(StripFigure, EachFormatHasItsSignature) {
  const SkeletonMotion motion = standing(1);
  const auto begins = [&](FigureFormat format, const std::string& signature) {
    return draw_strip(motion, {}, {}, format).value().compare(0, signature.size(), signature) == 0;
  };
  EXPECT_TRUE(begins(FigureFormat::svg, "<?xml"));
  EXPECT_TRUE(begins(FigureFormat::png, "\x89PNG\r\n\x1a\n"));
  EXPECT_TRUE(begins(FigureFormat::pdf, "%PDF-"));
}

TEST(StripFigure, SvgHasTheWidthAskedFor) {
  StripSettings settings;
  settings.width_mm = 120.0;
  const std::string text = svg(standing(1), {}, settings);
  const std::size_t at = text.find("width=\"") + 7;
  EXPECT_NEAR(std::strtod(text.c_str() + at, nullptr), 120.0 * kPointsPerMm, kSamePlace);
}

TEST(StripFigure, PngHasTheWidthAskedForInPixels) {
  StripSettings settings;
  settings.width_mm = 127.0;
  settings.png_dpi = 100.0;
  const auto png = draw_strip(standing(1), {}, settings, FigureFormat::png).value();
  EXPECT_EQ(big_endian(png, 16), 500u);
}

TEST(StripFigure, SvgHoldsNothingThatIsNumberedFromRunToRun) {
  const SkeletonMotion motion = reaching(30);
  const std::string text = svg(motion, full_overlay(motion));
  EXPECT_EQ(text.find("id=\""), std::string::npos);
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
  const std::string text = svg(standing(1), {}, settings);
  const std::size_t at = text.find("height=\"") + 8;
  const double width = settings.width_mm * kPointsPerMm;
  EXPECT_LT(std::strtod(text.c_str() + at, nullptr), 0.7 * width);
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
    const Path foot = filled(svg(standing(1), {}, settings), kAccent).back();
    return *std::max_element(foot.y.begin(), foot.y.end());
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
  SkeletonMotion scaled = motion;
  for (SkeletonNode& node : scaled.skeleton.nodes) node.offset = node.offset * 100.0;
  for (LocalTransform& x : scaled.clip.local) x.translation = x.translation * 100.0;
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
    EXPECT_NEAR(leg[i].left() - leg[i - 3].left(), step, kSamePlace);
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

// --- overlays ---

TEST(StripFigure, EachOverlayIsDrawnInEachPose) {
  const SkeletonMotion motion = reaching(30);
  const StripOverlay full = full_overlay(motion);
  const std::size_t bare = paths(svg(motion)).size();
  StripOverlay goal;
  goal.goals = full.goals;
  EXPECT_GE(paths(svg(motion, goal)).size(), bare + 7 * 4);
  StripOverlay mass;
  mass.centre_of_mass = full.centre_of_mass;
  EXPECT_GE(paths(svg(motion, mass)).size(), bare + 7 * 4);
  StripOverlay path;
  path.hand_path = full.hand_path;
  EXPECT_GE(paths(svg(motion, path)).size(), bare + 7);
}

TEST(StripFigure, CaptionIsDrawnBelowTheStrip) {
  const SkeletonMotion motion = standing(1);
  StripOverlay overlay;
  overlay.caption = "A";
  const std::vector<Path> bare = paths(svg(motion));
  const std::vector<Path> captioned = paths(svg(motion, overlay));
  ASSERT_EQ(captioned.size(), bare.size() + 1);
  for (const Path& path : bare) EXPECT_GT(captioned.back().top(), path.top());
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
  const auto height = [](const std::string& text) {
    return std::strtod(text.c_str() + text.find("height=\"") + 8, nullptr);
  };
  EXPECT_GT(height(svg(reaching(5), overlay)), 0.7 * height(svg(reaching(5))));
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
  const auto figure = draw_strip(motion, overlay, settings, FigureFormat::svg);
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
  settings.first_frame = 3;
  settings.last_frame = 12;
  EXPECT_EQ(refusal(standing(5), {}, settings), "frames: 3 to 12 given; the clip has 0 to 4");
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
  (void)draw_strip(standing(1), overlay, {}, FigureFormat::svg);
  overlay.caption = "as usual";
  EXPECT_EQ(refusal(standing(1), overlay), "drawn");
  EXPECT_EQ(svg(standing(1)), before);
}

TEST(StripFigure, PngLargerThanAnyoneCanShowIsRefused) {
  StripSettings settings;
  settings.width_mm = 2000.0;
  settings.png_dpi = 1200.0;
  EXPECT_FALSE(draw_strip(standing(1), {}, settings, FigureFormat::png));
}

}  // namespace
}  // namespace shigusa
