// SPDX-License-Identifier: MIT
#include "body/posture_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kRounding = 1e-9;

PostureMode mode_of(const PosedBody& posed, const std::string& name) {
  const std::vector<PostureMode> modes = posture_modes(posed);
  return *std::find_if(modes.begin(), modes.end(),
                       [&](const auto& mode) { return mode.name == name; });
}

// Positions of nodes after that change (rad) of a mode.
class Moved {
 public:
  Moved(const PosedBody& posed, const std::string& mode, double by)
      : body_(posed), kinematics_(posed) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    const std::vector<double> direction = mode_of(posed, mode).direction;
    for (std::size_t d = 0; d < angles.size(); ++d) angles[d] += by * direction[d];
    kinematics_ = placed(posed, angles);
  }
  [[nodiscard]] Vec3d at(const char* node) const {
    const BodyNode& found = *body_.body.find_node(node);
    return kinematics_.point(found.link, found.point);
  }
  [[nodiscard]] Vec3d way(const char* from, const char* to) const { return at(to) - at(from); }

 private:
  const PosedBody& body_;
  Kinematics<double> kinematics_;
};

TEST(PostureModes, SquatLowersTheTrunkAndLeavesItUpright) {
  const PosedBody posed = half_body();
  const Moved before(posed, "squat", 0.0);
  const Moved after(posed, "squat", 1.0);
  EXPECT_LT(norm(after.way("hips", "head") - before.way("hips", "head")), kRounding);
  EXPECT_LT(after.at("hips").y, before.at("hips").y - 0.08);
}

TEST(PostureModes, LeanBendsAheadWithTheHipsBack) {
  const PosedBody posed = full_body();
  const Moved before(posed, "lean", 0.0);
  const Moved after(posed, "lean", 0.5);
  EXPECT_GT(after.way("hips", "head").z, before.way("hips", "head").z + 0.1);
  EXPECT_LT(after.at("hips").z, before.at("hips").z - 0.05);
}

// The body with a waist of one joint, as in many robots.
PosedBody one_waist() {
  BodyDefinition body = human_body().body.definition();
  for (Dof& dof : body.dofs) {
    if (dof.name == "chest.rotation") dof.name = "torso.rotation";
  }
  return {BodyModel(body), human_body().home};
}

double turn_between(const Vec3d& a, const Vec3d& b) { return atan2(norm(cross(a, b)), dot(a, b)); }

TEST(PostureModes, RoundBendsTheSpineByItsAngle) {
  const PosedBody bodies[] = {human_body(), one_waist()};
  for (const PosedBody& posed : bodies) {
    const Vec3d before = Moved(posed, "round", 0.0).way("upper_chest", "neck");
    const Vec3d after = Moved(posed, "round", 0.15).way("upper_chest", "neck");
    EXPECT_NEAR(turn_between(before, after), 0.15, kRounding);
    EXPECT_GT(after.z, before.z);
  }
}

TEST(PostureModes, TwistTurnsTheShouldersToTheLeftByItsAngleOverTheFeet) {
  const PosedBody bodies[] = {full_body(), human_body(), one_waist()};
  for (const PosedBody& posed : bodies) {
    const Moved before(posed, "twist", 0.0);
    const Moved after(posed, "twist", 0.5);
    const Vec3d shoulders = after.way("right_upper_arm", "left_upper_arm");
    EXPECT_NEAR(turn_between(before.way("right_upper_arm", "left_upper_arm"), shoulders), 0.5,
                0.01);
    EXPECT_LT(shoulders.z, -0.1);
    EXPECT_LT(norm(after.way("left_foot", "left_toes") - before.way("left_foot", "left_toes")),
              0.01);
  }
}

}  // namespace
}  // namespace shigusa
