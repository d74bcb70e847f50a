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

PostureMode mode_of(const BodyModel& body, const std::string& name) {
  const std::vector<PostureMode> modes = posture_modes(body, start_state(body));
  return *std::find_if(modes.begin(), modes.end(),
                       [&](const auto& mode) { return mode.name == name; });
}

// The body with these start angles (degrees).
BodyModel starting(BodyDefinition body, const std::map<std::string, double>& angles_deg) {
  const BodyModel before(body);
  for (const auto& [dof, angle] : angles_deg) {
    body.start[static_cast<std::size_t>(before.find_dof(dof).value())] = radians(angle);
  }
  return BodyModel(body);
}

TEST(PostureModes, WhoStartsBentMayStraighten) {
  const struct {
    double right_knee, left_knee, hips, squat, lean;  // degrees
  } rows[] = {{0, 0, 0, 0, -20},      {20, 20, 60, 0, -20},   {21, 21, 0, -21, -20},
              {40, 40, 40, -40, -20},  // half of the knees' is the squat's
              {40, 40, 60, -40, -60}, {40, 30, 60, -30, -65}, {30, 40, 60, -30, -65}};
  for (const auto& row : rows) {
    const BodyModel body =
        starting(full_body().definition(), {{"right_knee.flexion", row.right_knee},
                                            {"left_knee.flexion", row.left_knee},
                                            {"right_hip.flexion", row.hips},
                                            {"left_hip.flexion", row.hips}});
    EXPECT_NEAR(degrees(mode_of(body, "squat").lower), row.squat, kRounding) << row.right_knee;
    EXPECT_NEAR(degrees(mode_of(body, "lean").lower), row.lean, kRounding) << row.right_knee;
  }
  const BodyModel half = starting(half_body().definition(), {{"right_knee.flexion", 30}});
  EXPECT_NEAR(degrees(mode_of(half, "squat").lower), -30, kRounding);
  BodyDefinition stiff = full_body().definition();
  for (Dof& dof : stiff.dofs) {
    if (dof.joint.ends_with("knee")) dof.name = dof.joint + ".slide";
  }
  const BodyModel bent = starting(stiff, {{"right_hip.flexion", 60}, {"left_hip.flexion", 60}});
  EXPECT_NEAR(degrees(mode_of(bent, "lean").lower), -20, kRounding);
}

// Positions of nodes after that change (rad) of a mode.
class Moved {
 public:
  Moved(const BodyModel& body, const std::string& mode, double by)
      : body_(body), kinematics_(body) {
    std::vector<double> angles(body.start().begin(), body.start().end());
    const std::vector<double> direction = mode_of(body, mode).direction;
    for (std::size_t d = 0; d < angles.size(); ++d) angles[d] += by * direction[d];
    kinematics_ = placed(body, angles);
  }
  [[nodiscard]] Vec3d at(const char* node) const {
    const BodyNode& found = *body_.find_node(node);
    return kinematics_.point(found.link, found.point);
  }
  [[nodiscard]] Vec3d way(const char* from, const char* to) const { return at(to) - at(from); }

 private:
  const BodyModel& body_;
  Kinematics<double> kinematics_;
};

TEST(PostureModes, SquatLowersTheTrunkAndLeavesItUpright) {
  const BodyModel body = half_body();
  const Moved before(body, "squat", 0.0);
  const Moved after(body, "squat", 1.0);
  EXPECT_LT(norm(after.way("hips", "head") - before.way("hips", "head")), kRounding);
  EXPECT_LT(after.at("hips").y, before.at("hips").y - 0.08);
}

TEST(PostureModes, LeanBendsAheadWithTheHipsBack) {
  const BodyModel body = full_body();
  const Moved before(body, "lean", 0.0);
  const Moved after(body, "lean", 0.5);
  EXPECT_GT(after.way("hips", "head").z, before.way("hips", "head").z + 0.1);
  EXPECT_LT(after.at("hips").z, before.at("hips").z - 0.05);
}

// The body with a waist of one joint, as in many robots.
BodyModel one_waist() {
  BodyDefinition body = human_body().definition();
  for (Dof& dof : body.dofs) {
    if (dof.name == "chest.rotation") dof.name = "torso.rotation";
  }
  return BodyModel(body);
}

double turn_between(const Vec3d& a, const Vec3d& b) { return atan2(norm(cross(a, b)), dot(a, b)); }

TEST(PostureModes, RoundBendsTheSpineByItsAngle) {
  const BodyModel bodies[] = {human_body(), one_waist()};
  for (const BodyModel& body : bodies) {
    const Vec3d before = Moved(body, "round", 0.0).way("upper_chest", "neck");
    const Vec3d after = Moved(body, "round", 0.15).way("upper_chest", "neck");
    EXPECT_NEAR(turn_between(before, after), 0.15, kRounding);
    EXPECT_GT(after.z, before.z);
  }
}

TEST(PostureModes, TwistTurnsTheShouldersToTheLeftByItsAngleOverTheFeet) {
  const BodyModel bodies[] = {full_body(), human_body(), one_waist()};
  for (const BodyModel& body : bodies) {
    const Moved before(body, "twist", 0.0);
    const Moved after(body, "twist", 0.5);
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
