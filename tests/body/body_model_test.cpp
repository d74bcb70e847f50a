// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "body/coupled_limits.hpp"
#include "core/check.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A trunk on one hinge with two arms of one hinge each.
BodyDefinition two_arms() {
  BodyDefinition body = chain_definition({{}, {}, {}});
  body.dofs[2].parent = 0;
  body.effectors = {{"left_hand", "left_hand", 1, {0, 1, 0}, 1},
                    {"right_hand", "right_hand", 2, {0, 1, 0}, 2}};
  return body;
}

TEST(BodyModel, KnowsWhichDofsMoveALink) {
  const BodyModel body(two_arms());
  EXPECT_TRUE(body.moves(0, 0));
  EXPECT_TRUE(body.moves(0, 1));
  EXPECT_TRUE(body.moves(0, 2));
  EXPECT_TRUE(body.moves(1, 1));
  EXPECT_FALSE(body.moves(1, 0));
  EXPECT_FALSE(body.moves(1, 2));
  EXPECT_FALSE(body.moves(2, 1));
}

TEST(BodyModel, UpperLimitIsThatOfTheKernel) {
  BodyDefinition definition = two_arms();
  definition.couplings = {{.dof = 1, .driver = 0, .gain = 0.4, .driver_full = 1.3},
                          {.dof = 1, .driver = 2, .gain = -0.2, .driver_full = 0.7}};
  const BodyModel body(definition);
  CoupledLimits<double> limits(body);
  for (const double angle : {-0.3, 0.0, 0.37, 0.7, 1.1, 2.0}) {
    const double angles[] = {angle, 0.1, 0.9 * angle};
    limits.update(angles);
    for (int d = 0; d < body.dof_count(); ++d) {
      const double added = limits.added()[static_cast<std::size_t>(d)];
      EXPECT_EQ(upper_limit(body, d, angles), body.dof(d).upper + added) << d << " at " << angle;
    }
  }
}

TEST(BodyModel, NothingMovesTheBase) {
  const BodyModel body(two_arms());
  for (int d = 0; d < body.dof_count(); ++d) EXPECT_FALSE(body.moves(d, kBaseLink));
}

TEST(BodyModel, ChainIsTheDofsThatMoveALinkFromTheBaseOn) {
  const BodyModel arms(two_arms());
  for (const BodyModel& body : {arms, half_body().body, full_body().body}) {
    for (int link = 0; link < body.dof_count(); ++link) {
      std::vector<int> movers;
      for (int d = 0; d < body.dof_count(); ++d) {
        if (body.moves(d, link)) movers.push_back(d);
      }
      const auto chain = body.chain(link);
      EXPECT_EQ(std::vector<int>(chain.begin(), chain.end()), movers);
      EXPECT_EQ(chain.back(), link);
    }
    EXPECT_TRUE(body.chain(kBaseLink).empty());
  }
}

TEST(BodyModel, FindsEffectorsAndDofsByName) {
  const BodyModel body(two_arms());
  EXPECT_EQ(body.find_effector("right_hand"), 1);
  EXPECT_EQ(body.find_effector("nose"), std::nullopt);
  EXPECT_EQ(body.find_dof("hinge_2.flexion"), 2);
  EXPECT_EQ(body.find_dof("hinge_2"), std::nullopt);
}

TEST(BodyModel, GivesTheMassOfEachLinkAndOfTheBase) {
  BodyDefinition definition = two_arms();
  definition.base_mass.mass = 7.0;
  definition.masses[1].mass = 2.5;
  const BodyModel body(definition);
  EXPECT_EQ(body.link_mass(kBaseLink).mass, 7.0);
  EXPECT_EQ(body.link_mass(1).mass, 2.5);
}

// Each of these invalidates a valid definition in one place.
struct Fault {
  const char* name;
  void (*commit)(BodyDefinition&);
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class BrokenDefinition : public testing::TestWithParam<Fault> {};

TEST_P(BrokenDefinition, IsRefused) {
  BodyDefinition body = two_arms();
  body.feet = {{.name = "foot", .node = "foot", .link = 1, .centre = {}, .outline = {}}};
  body.nodes = {{.name = "hips", .parent = -1, .link = 0}};
  body.feet[0].heel = Heel{.toes = 2, .ankle = 1, .forefoot = {}};
  body.capsules = {{.name = "arm", .link = 1, .radius = 0.1}};
  body.couplings = {{.dof = 0, .driver = 1, .gain = 0.1, .driver_full = 1.0}};
  ASSERT_NO_THROW(BodyModel{body});
  GetParam().commit(body);
  EXPECT_THROW(BodyModel{body}, PreconditionError);
}

using Body = BodyDefinition;
INSTANTIATE_TEST_SUITE_P(
    Faults, BrokenDefinition,
    testing::Values(
        Fault{"no_dofs", [](Body& b) { b = {}; }},
        Fault{"one_mass_too_few", [](Body& b) { b.masses.pop_back(); }},
        Fault{"own_parent", [](Body& b) { b.dofs[1].parent = 1; }},
        Fault{"later_parent", [](Body& b) { b.dofs[1].parent = 2; }},
        Fault{"parent_below_base", [](Body& b) { b.dofs[1].parent = -2; }},
        Fault{"limits_turned_round", [](Body& b) { b.dofs[1].lower = b.dofs[1].upper; }},
        Fault{"sign_of_two", [](Body& b) { b.dofs[1].sign = 2.0; }},
        Fault{"no_strength", [](Body& b) { b.dofs[1].torque_negative = 0.0; }},
        Fault{"no_strength_forwards", [](Body& b) { b.dofs[1].torque_positive = 0.0; }},
        Fault{"gives_not_at_all", [](Body& b) { b.dofs[1].give = 0.0; }},
        Fault{"gives_more_than_all", [](Body& b) { b.dofs[1].give = 1.1; }},
        Fault{"axis_turned_to_a_mirror_image",
              [](Body& b) {
                b.dofs[1].turn = Mat3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
              }},
        Fault{"axis_turned_and_stretched",
              [](Body& b) {
                b.dofs[1].turn = Mat3d{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
              }},
        Fault{"effector_on_no_link", [](Body& b) { b.effectors[0].link = 3; }},
        Fault{"effector_without_limb", [](Body& b) { b.effectors[0].limb_root = kBaseLink; }},
        Fault{"capsule_on_no_link", [](Body& b) { b.capsules[0].link = 3; }},
        Fault{"capsule_without_radius", [](Body& b) { b.capsules[0].radius = 0.0; }},
        Fault{"capsule_that_ends_in_a_point", [](Body& b) { b.capsules[0].to_radius = 0.0; }},
        Fault{"heel_without_toes", [](Body& b) { b.feet[0].heel->toes = 3; }},
        Fault{"heel_without_an_ankle", [](Body& b) { b.feet[0].heel->ankle = -1; }},
        Fault{"foot_on_no_link", [](Body& b) { b.feet[0].link = 3; }},
        Fault{"node_on_no_link", [](Body& b) { b.nodes[0].link = -2; }},
        Fault{"node_under_itself", [](Body& b) { b.nodes[0].parent = 0; }},
        Fault{"coupling_of_no_dof", [](Body& b) { b.couplings[0].dof = -1; }},
        Fault{"coupling_by_no_dof", [](Body& b) { b.couplings[0].driver = 3; }},
        Fault{"coupling_over_nothing", [](Body& b) { b.couplings[0].driver_full = 0.0; }}),
    [](const testing::TestParamInfo<Fault>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace shigusa
