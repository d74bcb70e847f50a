// SPDX-License-Identifier: MIT
// The skeletons of many tools and studios, described by files in tests/conventions: each is
// recognised without further input.
#include <gmock/gmock.h>

#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "support/convention.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using Bone = HumanoidBone;

class Conventions : public testing::TestWithParam<std::filesystem::path> {
 protected:
  const ConventionCase convention_ = read_convention(GetParam());
  const Skeleton skeleton_ = convention_.figure.skeleton();
  const std::vector<Transformd> world_ = convention_.figure.world();
};

TEST_P(Conventions, AreUnderstoodWithNothingSaid) {
  const Result<HumanoidMap> map = find_humanoid(skeleton_, world_);
  ASSERT_TRUE(map) << map.error().to_string();
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<Bone>(b);
    const std::string name(humanoid_bone_name(bone));
    const auto wanted = convention_.bones.find(name);
    const int node = (*map)[bone];
    const std::string found = node < 0 ? "-" : skeleton_.nodes[static_cast<std::size_t>(node)].name;
    // of joints that a skeleton may lack, those that the file says nothing of are free
    if (wanted == convention_.bones.end() && bone >= Bone::spine) continue;
    EXPECT_EQ(found, wanted == convention_.bones.end() ? "-" : wanted->second) << name;
  }
  for (const std::string& doubt : convention_.doubts) {
    EXPECT_THAT(map->doubts, Contains(HasSubstr(doubt)));
  }
  if (convention_.doubts.empty()) {
    EXPECT_THAT(map->doubts, IsEmpty());
  }
}

TEST_P(Conventions, AreMeasuredAndBecomeABody) {
  const Result<HumanoidMap> map = find_humanoid(skeleton_, world_);
  ASSERT_TRUE(map) << map.error().to_string();
  const Result<MeasuredPerson> person = measure_person(skeleton_, world_, *map);
  ASSERT_TRUE(person) << person.error().to_string();
  EXPECT_FALSE(person->placement.mirrored());
  EXPECT_GT(person->placement.left.x, 0.99);  // the files face +z
  const BodyModel body = build_human(
      person->landmarks, {.extent = BodyExtent::human, .stature = person->stature}, person->doubts);
  EXPECT_GT(body.dof_count(), 30);
}

// A bone map may repeat the found one without contradicting it.
TEST_P(Conventions, AreTheSameWhenTheAnswerIsAsked) {
  const Result<HumanoidMap> map = find_humanoid(skeleton_, world_);
  ASSERT_TRUE(map) << map.error().to_string();
  HumanoidMap asked;
  asked.node = map->node;
  const Result<HumanoidMap> again = find_humanoid(skeleton_, world_, {}, asked);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->node, map->node);
}

TEST_P(Conventions, AreToldInTheDocs) {
  std::ifstream in(std::filesystem::path(SHIGUSA_SOURCE_DIR) / "docs/characters.md");
  const std::string docs{std::istreambuf_iterator<char>(in), {}};
  ASSERT_FALSE(convention_.title.empty());
  EXPECT_THAT(docs, HasSubstr(convention_.title));
}

INSTANTIATE_TEST_SUITE_P(Files, Conventions, testing::ValuesIn(convention_files()),
                         [](const auto& each) { return each.param.stem().string(); });

}  // namespace
}  // namespace shigusa
