// SPDX-License-Identifier: MIT
#include "cost/angles.hpp"

#include <gtest/gtest.h>

#include <shigusa/cost.hpp>
#include <shigusa/human.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/run.hpp>

#include "support/bodies.hpp"

// Angles of postures that are drawn, so that they are known by construction.
namespace shigusa {
namespace {

using enum FreedomKind;
constexpr double kExact = 1e-9;
constexpr int kDrawn = 200;

class Angles : public ::testing::Test {
 protected:
  void set(JointKind joint, FreedomKind freedom, double angle, std::optional<Side> side = {}) {
    const auto dof = person_.body.find_dof(joint, freedom, side);
    ASSERT_TRUE(dof);
    angles_[static_cast<std::size_t>(*dof)] = angle;
  }
  // Bends both legs in the plane of the standing foot, in which the trunk then leans.
  void set_legs(double ankle, double knee, double hip) {
    for (const Side side : {Side::left, Side::right}) {
      set(JointKind::ankle, inversion, 0.0, side);
      set(JointKind::hip, abduction, 0.0, side);
      set(JointKind::hip, rotation, 0.0, side);
      set(JointKind::ankle, flexion, ankle, side);
      set(JointKind::knee, flexion, knee, side);
      set(JointKind::hip, flexion, hip, side);
    }
  }
  [[nodiscard]] double home(JointKind joint, FreedomKind freedom,
                            std::optional<Side> side = {}) const {
    return person_.home
        .angles[static_cast<std::size_t>(person_.body.find_dof(joint, freedom, side).value())];
  }
  // Tilt of the pelvis at home, which faces +Z.
  [[nodiscard]] double home_tilt() const {
    const Posture at(person_.body, person_.home.angles);
    const Vec3d up = at.node_place(humanoid_bone_name(HumanoidBone::hips))->rotation.cy;
    return atan2(up.z, up.y);
  }
  [[nodiscard]] PostureAngles measured() const {
    return posture_angles(person_.body, person_.home, angles_);
  }

  PosedBody person_ = human_body();
  std::vector<double> angles_ = person_.home.angles;
  Random random_{5};
};

TEST_F(Angles, AreZeroAtHome) {
  const PostureAngles at = measured();
  EXPECT_NEAR(at.trunk->flexion, 0.0, kExact);
  EXPECT_NEAR(at.trunk->lateral, 0.0, kExact);
  EXPECT_NEAR(at.trunk->twist, 0.0, kExact);
  EXPECT_NEAR(at.neck->flexion, 0.0, kExact);
  EXPECT_NEAR(at.head.value(), 0.0, kExact);
  EXPECT_NEAR(at.arms[0]->raised, 0.0, kExact);
  EXPECT_NEAR(at.on_left.value(), 0.5, 1e-6);
  EXPECT_FALSE(at.sits);
}

// A rigid trunk on bent legs, arms and a head in any posture in the sagittal plane and out of it.
TEST_F(Angles, OfDrawnPosturesAreThoseDrawn) {
  for (int n = 0; n < kDrawn; ++n) {
    angles_ = person_.home.angles;
    const double ankle = random_.uniform(0.0, 0.5);
    const double knee = random_.uniform(0.0, 1.8);
    const double tilt = random_.uniform(-0.3, 1.8);
    set_legs(ankle, knee, tilt - ankle + knee);
    const double nod = random_.uniform(-0.3, 0.3);
    const double bow = random_.uniform(-0.3, 0.3);
    set(JointKind::neck, flexion, nod);
    set(JointKind::head, flexion, bow);
    std::array<double, 2> swung{};
    std::array<double, 2> away{};
    std::array<double, 2> bent{};
    for (const Side side : {Side::left, Side::right}) {
      const std::size_t k = side == Side::left ? 0 : 1;
      swung[k] = random_.uniform(-0.9, 2.6);
      away[k] = random_.uniform(-0.5, 1.2);
      bent[k] = random_.uniform(0.0, 2.4);
      set(JointKind::clavicle, elevation, home(JointKind::clavicle, elevation, side), side);
      set(JointKind::shoulder, flexion, swung[k], side);
      set(JointKind::shoulder, abduction, away[k], side);
      set(JointKind::elbow, flexion, bent[k], side);
      set(JointKind::wrist, flexion, 0.1 * n / kDrawn, side);
    }
    const PostureAngles at = measured();
    EXPECT_NEAR(at.trunk->flexion, tilt - home_tilt(), kExact);
    EXPECT_NEAR(at.trunk->lateral, 0.0, kExact);
    EXPECT_NEAR(at.trunk->twist, 0.0, kExact);
    const double bowed =
        nod + bow - home(JointKind::neck, flexion) - home(JointKind::head, flexion);
    EXPECT_NEAR(at.neck->flexion, bowed, kExact);
    EXPECT_NEAR(at.head.value(), at.trunk->flexion + bowed, kExact);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(at.knees[k].value(), knee, kExact);
      EXPECT_NEAR(at.arms[k]->flexion, swung[k] - home_tilt(), kExact);
      EXPECT_NEAR(at.arms[k]->abduction, away[k], kExact);
      EXPECT_NEAR(at.arms[k]->elbow, bent[k], kExact);
      EXPECT_NEAR(at.arms[k]->wrist.value() +
                      home(JointKind::wrist, flexion, k == 0 ? Side::left : Side::right),
                  0.1 * n / kDrawn, kExact);
      const double in_world = swung[k] - tilt;
      EXPECT_NEAR(at.arms[k]->elevation,
                  acos(clamp(sin_cos(away[k]).cos * sin_cos(in_world).cos, -1.0, 1.0)), 1e-7);
    }
  }
}

TEST_F(Angles, OfATurnedAndTiltedTrunkHaveTheirSigns) {
  set(JointKind::upper_chest, rotation, 0.4);
  EXPECT_NEAR(measured().trunk->twist, 0.4, radians(1.0));
  EXPECT_NEAR(measured().neck->twist, 0.0, radians(1.0));
  angles_ = person_.home.angles;
  set(JointKind::spine, lateral, 0.3);
  EXPECT_GT(measured().trunk->lateral, 0.2);
  EXPECT_LT(measured().trunk->lateral, 0.3);
  angles_ = person_.home.angles;
  set(JointKind::head, lateral, 0.3);
  EXPECT_NEAR(measured().neck->lateral, 0.3, radians(1.0));
  angles_ = person_.home.angles;
  set(JointKind::head, rotation, 0.5);
  EXPECT_NEAR(measured().neck->twist, 0.5, radians(1.0));
  angles_ = person_.home.angles;
  set(JointKind::clavicle, elevation, 0.3, Side::left);
  EXPECT_GT(measured().arms[0]->raised, 0.025);
  EXPECT_NEAR(measured().arms[1]->raised, 0.0, kExact);
}

// Any posture and its mirror image, left and right exchanged. Both feet stand alike.
TEST_F(Angles, AreMirrored) {
  for (int n = 0; n < kDrawn; ++n) {
    const double ankle = random_.uniform(0.0, 0.4);
    const double knee = random_.uniform(0.0, 1.5);
    std::vector<double> image = person_.home.angles;
    for (int d = 0; d < person_.body.dof_count(); ++d) {
      const Dof& dof = person_.body.dof(d);
      const auto k = static_cast<std::size_t>(d);
      if (dof.part.limb == LimbKind::leg) continue;
      angles_[k] = random_.uniform(dof.lower, dof.upper);
      const FreedomKind kind = dof.part.freedom_kind;
      if (!dof.part.side) {
        image[k] = kind == lateral || kind == rotation ? -angles_[k] : angles_[k];
        continue;
      }
      const Side other = *dof.part.side == Side::left ? Side::right : Side::left;
      image[static_cast<std::size_t>(
          person_.body.find_dof(dof.part.joint_kind, kind, other).value())] = angles_[k];
    }
    set_legs(ankle, knee, knee);
    const PostureAngles at = measured();
    for (int d = 0; d < person_.body.dof_count(); ++d) {
      const auto k = static_cast<std::size_t>(d);
      if (person_.body.dof(d).part.limb == LimbKind::leg) image[k] = angles_[k];
    }
    const PostureAngles mirrored = posture_angles(person_.body, person_.home, image);
    EXPECT_NEAR(at.trunk->flexion, mirrored.trunk->flexion, 1e-7);
    EXPECT_NEAR(at.trunk->lateral, -mirrored.trunk->lateral, 1e-7);
    EXPECT_NEAR(at.trunk->twist, -mirrored.trunk->twist, 1e-7);
    EXPECT_NEAR(at.neck->twist, -mirrored.neck->twist, 1e-7);
    EXPECT_NEAR(at.on_left.value(), 1.0 - mirrored.on_left.value(), 1e-6);
    EXPECT_EQ(reba_parts(at, Side::left, {}), reba_parts(mirrored, Side::right, {}));
    EXPECT_EQ(rula_parts(at, Side::right, {}), rula_parts(mirrored, Side::left, {}));
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(at.arms[k]->flexion, mirrored.arms[1 - k]->flexion, 1e-7);
      EXPECT_NEAR(at.arms[k]->abduction, mirrored.arms[1 - k]->abduction, 1e-7);
      EXPECT_NEAR(at.arms[k]->raised, mirrored.arms[1 - k]->raised, 1e-7);
      EXPECT_NEAR(at.arms[k]->forearm.value(), mirrored.arms[1 - k]->forearm.value(), 1e-9);
    }
  }
}

TEST(AnglesOfBodies, LackWhatTheBodyLacks) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const PostureAngles at = posture_angles(posed.body, posed.home, posed.home.angles);
    ASSERT_TRUE(at.trunk) << posed.body.name();
    EXPECT_NEAR(at.trunk->flexion, 0.0, 1e-9);
    EXPECT_FALSE(at.neck) << posed.body.name();
    EXPECT_TRUE(at.arms[1]);
    EXPECT_FALSE(at.arms[1]->wrist);
  }
  const PosedBody rods = testing_support::chain({{}, {}});
  const PostureAngles at = posture_angles(rods.body, rods.home, rods.home.angles);
  EXPECT_FALSE(at.trunk || at.neck || at.arms[0] || at.knees[0] || at.on_left);
}

TEST(AnglesOfBodies, NeutralIsNoBentHome) {
  PosedBody person = human_body();
  const auto upright = person.home.angles;
  for (const int hip : person.body.dofs_of(JointKind::hip, flexion)) {
    person.home.angles[static_cast<std::size_t>(hip)] += 1.0;
  }
  const PostureAngles bent = posture_angles(person.body, person.home, person.home.angles);
  EXPECT_NEAR(bent.trunk->flexion, 1.0, radians(8.0));
  EXPECT_NEAR(posture_angles(person.body, person.home, upright).trunk->flexion, 0.0, radians(8.0));
}

}  // namespace
}  // namespace shigusa
