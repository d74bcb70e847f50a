// SPDX-License-Identifier: MIT
// A motion delivered as collision-free passes through neither head nor shank by another geometry
// than the kernel's.
#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "plan/plan.hpp"
#include "support/flesh.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// m: capsules tolerate kCollisionDepth, and their shape differs from the flesh's
constexpr double kThrough = 0.010;
// Builds that check every step take fifteen times as long per goal.
#ifdef NDEBUG
constexpr int kGoals = 30;
#else
constexpr int kGoals = 3;
#endif

constexpr int kPlainGoals = 30;

// Places where forearms passed through head and shanks: about the head, at the shins, between the
// feet and behind the back. In parts of the stature.
Vec3d awkward_goal(int index, Random& random) {
  const auto near = [&](const Vec3d& at, const Vec3d& by) {
    return Vec3d{at.x + random.uniform(-by.x, by.x), at.y + random.uniform(-by.y, by.y),
                 at.z + random.uniform(-by.z, by.z)};
  };
  switch (index % 5) {
    case 0:
      return near({0.0, 0.93, 0.0}, {0.15, 0.08, 0.15});  // head
    case 1:
      return near({0.0, 0.15, 0.02}, {0.15, 0.10, 0.12});  // shins
    case 2:
      return near({0.0, 0.03, 0.02}, {0.03, 0.02, 0.15});  // between the feet
    case 3:
      return near({0.05, 0.60, -0.15}, {0.15, 0.15, 0.05});  // behind the back
    default:
      return near({0.20, 0.15, -0.05}, {0.10, 0.10, 0.10});  // beside the other shin
  }
}

struct Found {
  int free = 0;       // motions delivered as passing through nothing
  double head = 0.0;  // m, the deepest of these
  double shank = 0.0;
};

Found free_motions(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  Random random(77);
  Found found;
  for (int k = 0; k < kGoals; ++k) {
    Task task(posed);
    task.goals = {{"right_hand", awkward_goal(k, random) * body.stature()}};
    task.seed = random.next();
    task.evaluations = 400;
    const GenerateResult generation = generate(task).value();
    for (const Candidate& candidate : generation.candidates) {
      if (candidate.measures.collides.depth > kCollisionDepth) continue;
      ++found.free;
      const ClipPlaces places(body, candidate.motion.clip);
      const auto depths = Flesh(places, body.stature()).deepest();
      found.head = std::fmax(found.head, depths.head);
      found.shank = std::fmax(found.shank, depths.shank);
    }
  }
  return found;
}

class FreeMotions : public testing::TestWithParam<const char*> {
 protected:
  PosedBody body() { return std::string(GetParam()) == "human" ? human_body() : full_body(); }
};

TEST_P(FreeMotions, PassThroughNeitherHeadNorShank) {
  const Found found = free_motions(body());
  EXPECT_GE(found.free, 2 * kGoals / 3);
  EXPECT_LE(found.head, kThrough);
  EXPECT_LE(found.shank, kThrough);
}

// The other geometry detects the collisions that the capsules prevent: straight to a goal, without
// a search that would begin at motions known to be free.
TEST_P(FreeMotions, WouldWithoutTheirCapsules) {
  BodyDefinition bare = body().body.definition();
  std::erase_if(bare.capsules, [](const Capsule& capsule) {
    return capsule.name == "head" || capsule.name == "jaw" || capsule.name.ends_with("shank");
  });
  const PosedBody posed{BodyModel(bare), body().home};
  const BodyModel& body = posed.body;
  Random random(77);
  double deepest = 0.0;
  for (int k = 0; k < kPlainGoals; ++k) {
    const Task task(posed, {.goals = {{"right_hand", awkward_goal(k, random) * body.stature()}}});
    const Parameters plain = uniform_parameters(body);
    const GenerateResult played = regenerate(task, plain).value();
    const ClipPlaces places(body, played.candidates[0].motion.clip);
    const auto depths = Flesh(places, body.stature()).deepest();
    deepest = std::fmax(deepest, std::fmax(depths.head, depths.shank));
  }
  EXPECT_GT(deepest, 2.5 * kThrough);
}

INSTANTIATE_TEST_SUITE_P(Of, FreeMotions, testing::Values("full_body", "human"));

}  // namespace
}  // namespace shigusa
