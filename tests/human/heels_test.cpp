// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "body/anthropometry.hpp"
#include "core/check.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

const Side kSides[] = {Side::left, Side::right};

PosedBody with_heels(Side base = Side::right) { return human_body({.base = base, .heels = true}); }

std::size_t dof(const PosedBody& posed, const char* name) {
  return static_cast<std::size_t>(posed.body.find_dof(name).value());
}

Vec3d node_at(const PosedBody& posed, std::span<const double> angles, const std::string& name) {
  for (const BodyNode& node : posed.body.nodes()) {
    if (node.name == name) return placed(posed, angles).point(node.link, node.point);
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(Heels, AddTheToesAndChangeNothingOfTheStartPosture) {
  for (const Side base : kSides) {
    const PosedBody flat = human_body({.base = base});
    const PosedBody posed = with_heels(base);
    EXPECT_EQ(posed.body.dof_count(), flat.body.dof_count() + 2);
    EXPECT_NEAR(posed.body.mass(), flat.body.mass(), 1e-12);
    const Vec3d com = centre_of_mass(posed, placed(posed, posed.home.angles));
    EXPECT_LT(norm(com - centre_of_mass(flat, placed(flat, flat.home.angles))), 1e-12);
    for (const BodyNode& node : flat.body.nodes()) {
      if (node.name.empty()) continue;
      const Vec3d there = node_at(flat, flat.home.angles, node.name);
      EXPECT_LT(norm(node_at(posed, posed.home.angles, node.name) - there), 1e-12) << node.name;
    }
    for (std::size_t f = 0; f < 2; ++f) {
      const Foot& foot = posed.body.feet()[f];
      EXPECT_EQ(foot.name, flat.body.feet()[f].name);
      EXPECT_EQ(foot.node, foot.name.substr(0, foot.name.find('_')) + "_toes");
      ASSERT_TRUE(foot.heel);
    }
  }
}

// Each part's remaining moments of inertia are those of a rigid body.
TEST(Heels, PartsOfAFootHaveTheMassOfBodies) {
  for (const BodyBuild& person : {BodyBuild{}, BodyBuild{1.48, 44.0, Sex::female}}) {
    BodyBuild lifting = person;
    lifting.heels = true;
    const PosedBody posed = human_body(lifting);
    const double foot = segment_table(person.sex).foot.mass * person.mass;
    for (const auto& [toes, rest] : {std::pair{kBaseLink, int(dof(posed, "right_toes.flexion"))},
                                     std::pair{int(dof(posed, "left_toes.flexion")),
                                               int(dof(posed, "left_ankle.inversion"))}}) {
      EXPECT_NEAR(posed.body.link_mass(toes).mass, kToesMass * foot, 1e-12);
      EXPECT_NEAR(posed.body.link_mass(rest).mass, (1.0 - kToesMass) * foot, 1e-12);
      for (const int link : {toes, rest}) {
        const Mat3d& i = posed.body.link_mass(link).inertia;
        EXPECT_GT(i.cx.x, 0.0);
        EXPECT_GT(i.cy.y, 0.0);
        EXPECT_GT(i.cz.z, 0.0);
        EXPECT_GE(i.cx.x + i.cy.y, i.cz.z);
        EXPECT_GE(i.cy.y + i.cz.z, i.cx.x);
        EXPECT_GE(i.cz.z + i.cx.x, i.cy.y);
      }
    }
  }
}

TEST(Heels, AFootTurnsAboutItsToesWhichStay) {
  for (const Side base : kSides) {
    const PosedBody posed = with_heels(base);
    const std::string side = base == Side::left ? "left_" : "right_";
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    angles[dof(posed, (side + "toes.flexion").c_str())] = radians(30.0);
    const Vec3d toes = node_at(posed, posed.home.angles, side + "toes");
    EXPECT_LT(norm(node_at(posed, angles, side + "toes") - toes), 1e-12);
    const Vec3d before = node_at(posed, posed.home.angles, side + "foot");
    const Vec3d after = node_at(posed, angles, side + "foot");
    EXPECT_NEAR(norm(after - toes), norm(before - toes), 1e-12);
    EXPECT_GT(after.y, before.y + 0.05);
    EXPECT_GT(after.z, before.z);
  }
}

// On the hanging leg too, a positive angle bends the toes up against the foot.
TEST(Heels, ToesOfTheOtherFootBendUpwards) {
  const PosedBody posed = with_heels();
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  const std::size_t toes = dof(posed, "left_toes.flexion");
  angles[toes] = radians(30.0);
  const Kinematics<double> stands = placed(posed, angles);
  const Mat3d turned = stands.link_rotation(static_cast<int>(toes));
  EXPECT_NEAR(turned.cz.y, 0.5, 1e-9);
}

TEST(Heels, ForefootIsTheSoleAheadOfTheToesJoint) {
  const PosedBody posed = with_heels();
  for (const Foot& foot : posed.body.feet()) {
    const Heel& heel = *foot.heel;
    ASSERT_EQ(heel.forefoot.size(), foot.outline.size());
    // its corners in front are the sole's, those behind are below the joint, the link's origin
    for (const std::size_t k : {std::size_t{0}, std::size_t{3}}) {
      EXPECT_LT(norm(heel.forefoot[k] - foot.outline[k]), 1e-12);
    }
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
      EXPECT_NEAR(heel.forefoot[k].z, 0.0, 1e-12);
      EXPECT_NEAR(heel.forefoot[k].y, foot.outline[k].y, 1e-12);
    }
    EXPECT_NEAR(heel.back.z, foot.outline[1].z, 1e-12);
    EXPECT_EQ(posed.body.dof(heel.toes).name,
              foot.name.substr(0, foot.name.find('_')) + "_toes.flexion");
    EXPECT_LT(posed.body.dof(heel.toes).give, 1.0);
  }
}

TEST(Heels, AreOfStandingWholeHumans) {
  const Landmarks person = standing_landmarks(1.7, 0.0);
  HumanSettings settings{.extent = BodyExtent::full, .heels = true};
  EXPECT_THROW((void)build_human(person, settings), PreconditionError);
  settings.extent = BodyExtent::human;
  settings.sits = true;
  EXPECT_THROW((void)build_human(person, settings), PreconditionError);
}

TEST(Heels, BendWhereThePersonsToesDo) {
  Landmarks person = standing_landmarks(1.7, 0.0);
  person.right_leg.toes = person.right_leg.ankle + Vec3d{0.0, -0.05, 0.11};
  const PosedBody posed =
      build_human(person, {.extent = BodyExtent::human, .stature = 1.7, .heels = true});
  EXPECT_LT(norm(node_at(posed, posed.home.angles, "right_toes") - *person.right_leg.toes), 1e-12);
  EXPECT_LT(norm(posed.body.base().translation - *person.right_leg.toes), 1e-12);
}

// Landmarks of a task file may be arbitrary.
TEST(Heels, ToesFarFromTheFootMakeABodyAllTheSame) {
  for (const Vec3d& off : {Vec3d{0, 0, -1}, Vec3d{0, 0, 2}, Vec3d{0, 50, 0}, Vec3d{-3, 0, 0.1}}) {
    Landmarks person = standing_landmarks(1.7, 0.0);
    person.right_leg.toes = person.right_leg.toe + off;
    const PosedBody posed =
        build_human(person, {.extent = BodyExtent::human, .stature = 1.7, .heels = true});
    for (int link = kBaseLink; link < posed.body.dof_count(); ++link) {
      const MassProperties& mass = posed.body.link_mass(link);
      EXPECT_GE(mass.mass, 0.0);
      EXPECT_TRUE(is_finite(mass.inertia.cx.x + mass.inertia.cy.y + mass.inertia.cz.z));
    }
  }
}

}  // namespace
}  // namespace shigusa
