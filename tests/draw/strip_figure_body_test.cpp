// SPDX-License-Identifier: MIT
#include "draw/strip_figure_body.hpp"

#include <gtest/gtest.h>

namespace shigusa::strip {
namespace {

constexpr double kSize = 0.5;

// The neck and head of a chain of these nodes, each 0.1 above the one before, with an arm on the
// first, which identifies them as a person's.
std::array<Part, 2> neck_and_head(const std::vector<std::string>& names) {
  SkeletonMotion motion;
  const auto add = [&](const std::string& name, int parent, const Vec3d& offset) {
    motion.skeleton.nodes.push_back({name, parent, offset, false});
    motion.clip.local.push_back({offset, {}});
  };
  const int count = static_cast<int>(names.size());
  for (int i = 0; i < count; ++i) add(names[static_cast<std::size_t>(i)], i - 1, {0, 0.1, 0});
  add("left_upper_arm", 0, {0.1, 0, 0});
  add("left_lower_arm", count, {0.2, 0, 0});
  add("left_hand", count + 1, {0.2, 0, 0});
  motion.clip.frames = 1;
  const FigureBody body(motion.skeleton, {}, {{0, 1, 0}, {0, 0, 1}});
  const auto parts = body.parts(world_transforms(motion.skeleton, motion.clip, 0), kSize);
  const std::size_t neck = parts.size() - 5;  // before the arm's three
  return {parts.at(neck), parts.at(neck + 1)};
}

TEST(FigureBody, NecksBeginAtTheNeckOrWhatCarriesTheHead) {
  const struct {
    std::vector<std::string> names;
    double height;
  } rows[] = {{{"neck", "neck_twist", "head"}, 0.1},
              {{"hips", "neck", "neck_twist", "head"}, 0.2},
              {{"hips", "chest_top", "head"}, 0.2},
              {{"head"}, 0.1}};
  for (const auto& [names, height] : rows) {
    const auto [neck, skull] = neck_and_head(names);
    EXPECT_NEAR(neck.balls[0].centre.y, height, 1e-12) << names.front();
    EXPECT_NEAR(neck.setback, 0.2 * kSize, 0.1 * kSize);
    // the neck ends within the skull, and the jaw is in front of that
    const std::vector<Ball>& head = skull.balls;
    EXPECT_LT(norm(neck.balls[1].centre - head[0].centre), head[0].radius);
    EXPECT_GT(head[1].centre.z, head[0].centre.z);
    EXPECT_LT(head[1].centre.y, head[0].centre.y);
  }
}

// Length of a hand drawn from a wrist at the height 0.06 down to a finger tip at -0.04.
double hand_length(const std::optional<double>& floor) {
  StripSettings settings;
  settings.floor = floor;
  SkeletonMotion motion;
  const auto add = [&](const std::string& name, int parent, const Vec3d& offset) {
    motion.skeleton.nodes.push_back({name, parent, offset, false});
    motion.clip.local.push_back({offset, {}});
  };
  add("hips", -1, {0, 0.46, 0});
  add("left_upper_arm", 0, {0.1, 0, 0});
  add("left_lower_arm", 1, {0, -0.2, 0});
  add("left_hand", 2, {0, -0.2, 0});
  add("left_tip", 3, {0, -0.1, 0});
  motion.clip.frames = 1;
  const FigureBody body(motion.skeleton, settings, {{0, 1, 0}, {0, 0, 1}});
  const auto parts = body.parts(world_transforms(motion.skeleton, motion.clip, 0), kSize);
  const std::vector<Ball>& hand = parts.back().balls;
  return norm(hand.at(1).centre - hand.at(0).centre);
}

TEST(FigureBody, FingersCurlOnTheFloor) {
  EXPECT_NEAR(hand_length(std::nullopt), 0.1, 1e-12);
  EXPECT_NEAR(hand_length(-0.1), 0.1, 1e-12);
  EXPECT_NEAR(hand_length(0.0), 0.06, 1e-12);
  EXPECT_NEAR(hand_length(0.05), 0.05, 1e-12);  // a fist
}

}  // namespace
}  // namespace shigusa::strip
