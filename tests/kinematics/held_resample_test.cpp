// SPDX-License-Identifier: MIT
#include "kinematics/held_resample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "motion/effector_turn.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Three hinges that fold and unfold, at 5 frames a second.
const Clip kFolding{
    .dofs = 3,
    .frames = 5,
    .frame_time = 0.2,
    .angles = {0.1, 0.3, 0.2, 0.5, 0.9, 0.4, 0.7, 1.6, 0.9, 0.4, 1.1, 1.5, 0.2, 0.6, 1.0}};

TEST(HeldResample, TipIsOnASplineOfItsOwn) {
  const BodyModel body = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}});
  const Effector& tip = body.effectors()[0];
  const auto tip_at = [&](std::span<const double> angles) {
    return placed(body, {angles.begin(), angles.end()}).point(tip.link, tip.point);
  };
  Clip way{.dofs = 3, .frames = 5, .frame_time = 0.2, .angles = {}};
  for (int f = 0; f < way.frames; ++f) {
    const Vec3d at = tip_at(kFolding.frame(f));
    way.angles.insert(way.angles.end(), {at.x, at.y, at.z});
  }
  const Clip wanted = resampled(way, 60.0);
  const Clip free = resampled(kFolding, 60.0);
  const Clip held =
      resampled(body, kFolding, 60.0, std::vector{HeldPoint{.link = tip.link, .point = tip.point}});
  ASSERT_EQ(held.frames, wanted.frames);
  double most_free = 0.0;
  for (int f = 0; f < held.frames; ++f) {
    const std::span<const double> at = wanted.frame(f);
    const Vec3d place{at[0], at[1], at[2]};
    EXPECT_LT(norm(tip_at(held.frame(f)) - place), 1e-7) << f;  // where steps end
    most_free = std::max(most_free, norm(tip_at(free.frame(f)) - place));
  }
  EXPECT_GT(most_free, 1e-3);  // error of angles alone
}

TEST(HeldResample, FirstAndLastFramesAreTheClipsOwn) {
  const BodyModel body = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}});
  const Effector& tip = body.effectors()[0];
  const Clip held =
      resampled(body, kFolding, 60.0, std::vector{HeldPoint{.link = tip.link, .point = tip.point}});
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_EQ(held.frame(0)[d], kFolding.frame(0)[d]);
    EXPECT_EQ(held.frame(held.frames - 1)[d], kFolding.frame(4)[d]);
  }
}

// A tip on three axes, whose turn between frames is that of its own spline.
TEST(HeldResample, ATurnIsHeldWhereAsked) {
  const BodyModel body = chain({{Axis::x, 0.0}, {Axis::y, 0.0}, {Axis::z, 1.0}});
  const Effector& tip = body.effectors()[0];
  const Clip turning{
      .dofs = 3,
      .frames = 5,
      .frame_time = 0.2,
      .angles = {0.1, 0.3, 0.2, 0.5, 0.6, 0.4, 0.9, 0.9, 0.9, 0.4, 0.2, 1.5, 0.2, 0.5, 1.0}};
  const auto turn_at = [&](std::span<const double> angles) {
    return placed(body, {.angles = {angles.begin(), angles.end()}}).link_rotation(tip.link);
  };
  const Mat3d first = turn_at(turning.frame(0));
  Clip way{.dofs = 3, .frames = 5, .frame_time = 0.2, .angles = {}};
  for (int f = 0; f < way.frames; ++f) {
    const Vec3d turn = rotation_vector(turn_at(turning.frame(f)) * transpose(first));
    way.angles.insert(way.angles.end(), {turn.x, turn.y, turn.z});
  }
  const Clip wanted = resampled(way, 60.0);
  const Clip free = resampled(turning, 60.0);
  const Clip held = resampled(body, turning, 60.0,
                              std::vector{HeldPoint{.link = tip.link, .point = {}, .turns = true}});
  const auto off = [&](const Clip& clip, int f) {
    const std::span<const double> turn = wanted.frame(f);
    const Mat3d asked = rotation_by(Vec3d{turn[0], turn[1], turn[2]}) * first;
    return norm(rotation_vector(turn_at(clip.frame(f)) * transpose(asked)));
  };
  double most_free = 0.0;
  for (int f = 0; f < held.frames; ++f) {
    EXPECT_LT(off(held, f), 1e-5) << f;
    most_free = std::max(most_free, off(free, f));
  }
  EXPECT_GT(most_free, 1e-3);  // error of angles alone
}

TEST(HeldResample, NothingHeldIsTheSplineOfAngles) {
  const BodyModel body = chain({{Axis::x, 1.0}, {Axis::x, 1.0}, {Axis::x, 1.0}});
  EXPECT_EQ(resampled(body, kFolding, 60.0, {}).angles, resampled(kFolding, 60.0).angles);
}

}  // namespace
}  // namespace shigusa
