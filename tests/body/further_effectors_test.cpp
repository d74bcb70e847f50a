// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "body/stance.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(FurtherEffectors, HandsComeFirstAndAreTheOnlyOnesOfTheTable) {
  const PosedBody posed = human_body();
  EXPECT_EQ(posed.body.effectors().size(), 2u);
  EXPECT_EQ(posed.body.find_effector("right_hand"), 0);
  EXPECT_EQ(posed.body.find_effector("left_hand"), 1);
  EXPECT_GT(posed.body.effector_count(), 18);
}

TEST(FurtherEffectors, JointsHaveTheWordsOfTheirFreedoms) {
  const PosedBody posed = human_body();
  // with the joint that their limb begins at: the standing foot's, of the trunk and its own leg
  const std::string foot = posed.body.dof(0).joint;
  const std::pair<std::string, std::string> roots[] = {{"right_elbow", "right_shoulder"},
                                                       {"right_wrist", "right_shoulder"},
                                                       {"right_shoulder", "right_shoulder"},
                                                       {"left_knee", "left_hip"},
                                                       {"left_hip", "left_hip"},
                                                       {"head", "neck"},
                                                       {"neck", "neck"},
                                                       {"left_clavicle", foot},
                                                       {"right_knee", foot}};
  for (const auto& [joint, root] : roots) {
    const auto index = posed.body.find_effector(joint);
    ASSERT_TRUE(index) << joint;
    const Effector& effector = posed.body.effector(*index);
    bool found = false;
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      if (posed.body.dof(d).joint != joint) continue;
      found = true;
      const Vec3d centre = placed(posed, posed.home.angles).origin[static_cast<std::size_t>(d)];
      EXPECT_LT(norm(effector_position(posed, posed.home.angles, joint.c_str()) - centre), 1e-9)
          << joint;
    }
    EXPECT_TRUE(found) << joint;
    EXPECT_TRUE(posed.body.moves(effector.limb_root, effector.link)) << joint;
    EXPECT_EQ(posed.body.dof(effector.limb_root).joint, root) << joint;
  }
}

TEST(FurtherEffectors, NodesOfTheFileAreFoundByTheirOwnNames) {
  const PosedBody posed = human_body();
  EXPECT_EQ(posed.body.find_effector("right_lower_arm"), posed.body.find_effector("right_elbow"));
  EXPECT_EQ(posed.body.find_effector("pelvis"), posed.body.find_effector("hips"));
  EXPECT_EQ(posed.body.find_effector("left_ankle"), posed.body.find_effector("left_foot"));
  EXPECT_EQ(posed.body.find_effector("nose"), std::nullopt);
  EXPECT_EQ(posed.body.find_effector(""), std::nullopt);
}

TEST(FurtherEffectors, FootThatBearsTheBodyIsNone) {
  EXPECT_FALSE(human_body().body.find_effector("right_foot"));
  EXPECT_TRUE(human_body().body.find_effector("left_foot"));
  const PosedBody other = human_body({.base = Side::left});
  EXPECT_FALSE(other.body.find_effector("left_foot"));
  EXPECT_TRUE(other.body.find_effector("right_foot"));
  EXPECT_EQ(base_foot(other)->name, "left_foot");
}

TEST(FurtherEffectors, BodyOnTheOtherFootIsTheSamePerson) {
  const PosedBody right = human_body();
  const PosedBody left = human_body({.base = Side::left});
  EXPECT_NEAR(left.body.mass(), right.body.mass(), 1e-9);
  ASSERT_EQ(left.body.nodes().size(), right.body.nodes().size());
  for (std::size_t i = 0; i < left.body.nodes().size(); ++i) {
    const BodyNode& a = left.body.nodes()[i];
    const BodyNode& b = right.body.nodes()[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_LT(norm(placed(left, left.home.angles).point(a.link, a.point) -
                   placed(right, right.home.angles).point(b.link, b.point)),
              1e-9);
  }
}

TEST(FurtherEffectors, PlacesTakeThePlacesOfNodes) {
  const PosedBody posed = human_body();
  const BodyModel moved = with_places(posed, {{"hips", {0, 0.1, 0}}});
  const int hips = posed.body.find_effector("hips").value();
  EXPECT_EQ(moved.effector(hips).point, (Vec3d{0, 0.1, 0}));
  EXPECT_EQ(moved.nodes()[0].point, posed.body.nodes()[0].point);
}

TEST(StandingOn, LeavesTheOtherFootFree) {
  const std::vector<std::string> feet{"right_foot"};
  const BodyModel one = standing_on(human_body(), feet);
  ASSERT_EQ(one.feet().size(), 1u);
  EXPECT_EQ(one.feet()[0].name, "right_foot");
  EXPECT_EQ(one.dof_count(), human_body().body.dof_count());
}

}  // namespace
}  // namespace shigusa
