// SPDX-License-Identifier: MIT
#include "body/posture_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kRounding = 1e-9;

PostureMode mode_of(const PosedBody& posed, const std::string& name) {
  const std::vector<PostureMode> modes = posture_modes(posed, posed.home);
  return *std::find_if(modes.begin(), modes.end(),
                       [&](const auto& mode) { return mode.name == name; });
}

// The body with these start angles (degrees).
PosedBody starting(PosedBody posed, const std::map<std::string, double>& angles_deg) {
  for (const auto& [dof, angle] : angles_deg) {
    posed.home.angles[static_cast<std::size_t>(posed.body.find_dof(dof).value())] = radians(angle);
  }
  return posed;
}

TEST(PostureModes, WhoStartsBentMayStraighten) {
  const struct {
    double right_knee, left_knee, hips, squat, lean;  // degrees
  } rows[] = {{0, 0, 0, 0, -20},      {20, 20, 60, 0, -20},   {21, 21, 0, -21, -20},
              {40, 40, 40, -40, -20},  // half of the knees' is the squat's
              {40, 40, 60, -40, -60}, {40, 30, 60, -30, -65}, {30, 40, 60, -30, -65}};
  for (const auto& row : rows) {
    const PosedBody posed = starting(full_body(), {{"right_knee.flexion", row.right_knee},
                                                   {"left_knee.flexion", row.left_knee},
                                                   {"right_hip.flexion", row.hips},
                                                   {"left_hip.flexion", row.hips}});
    EXPECT_NEAR(degrees(mode_of(posed, "squat").lower), row.squat, kRounding) << row.right_knee;
    EXPECT_NEAR(degrees(mode_of(posed, "lean").lower), row.lean, kRounding) << row.right_knee;
  }
  const PosedBody half = starting(half_body(), {{"right_knee.flexion", 30}});
  EXPECT_NEAR(degrees(mode_of(half, "squat").lower), -30, kRounding);
  BodyDefinition stiff = full_body().body.definition();
  for (Dof& dof : stiff.dofs) {
    if (dof.joint.ends_with("knee")) dof.name = dof.joint + ".slide";
  }
  const PosedBody bent = starting({BodyModel(stiff), full_body().home},
                                  {{"right_hip.flexion", 60}, {"left_hip.flexion", 60}});
  EXPECT_NEAR(degrees(mode_of(bent, "lean").lower), -20, kRounding);
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
