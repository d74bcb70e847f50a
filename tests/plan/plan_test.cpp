// SPDX-License-Identifier: MIT
#include "plan/plan.hpp"

#include <gmock/gmock.h>

#include <set>
#include <shigusa/generate.hpp>

#include "plan/layer.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

const std::vector<Goal> kGoals{{"right_hand", {-0.3, 1.2, 0.35}}, {"left_hand", {0.3, 1.1, 0.4}}};

Plan layers_of(LayerReading reading) {
  return layers_to_goals(full_body(), kGoals, {.reading = reading}).value();
}

TEST(LayersToGoals, AreTheUpperOneAndEachGoalsArm) {
  const std::vector<Layer> layers = layers_of(LayerReading::shared_contractions);
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[1].name, "right_arm");
  EXPECT_EQ(layers[2].name, "left_arm");
  const std::vector<Goal> left{kGoals[1]};
  EXPECT_EQ(layers_to_goals(full_body(), left).value()[1].name, "left_arm");
  EXPECT_EQ(layers_to_goals(half_body(), left).error().code, ErrorCode::not_found);
}

// The paper's count: 14 parameters of the upper layer, and four for each arm.
TEST(PlanOfLayers, HasANameOfItsOwnForEachParameter) {
  for (const auto& [reading, word] : kEnumWords<LayerReading>) {
    const Plan plan = layers_of(reading);
    Parameters parameters = start_values(plan);
    const auto members = parameters_of(plan, parameters);
    EXPECT_EQ(members.size(), 14u + 8u) << word;
    std::set<std::string> names;
    std::set<const void*> places;
    for (const Parameter& member : members) {
      names.insert(member.spelled());
      EXPECT_EQ(member.locked != nullptr, member.info->kind == ParameterKind::weight);
      places.insert(member.values.begin(), member.values.end());
    }
    EXPECT_EQ(names.size(), members.size());
    EXPECT_EQ(places.size(), (reading == LayerReading::shared_contractions ? 12u : 10u) + 4u + 8u);
    EXPECT_TRUE(check_parameters(plan, parameters));
  }
}

TEST(CheckLayered, RefusesWhatNoNameTells) {
  const std::vector<Layer> layers = layers_of(LayerReading::contraction_a_limb);
  Parameters good = start_values(layers);
  const auto message = [&layers](const Parameters& parameters) {
    const auto checked = check_parameters(layers, parameters);
    return checked ? "" : checked.error().to_string();
  };
  Parameters bad = good;
  bad.arms.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("1 arms, for a plan of"));
  bad = good;
  bad.joints.back().weight = 2e3;
  EXPECT_EQ(message(bad), "") << "a slide's weight means nothing";
  bad = good;
  bad.arms[1][2].weight = 2e3;
  EXPECT_THAT(message(bad), HasSubstr("left_arm.left_shoulder.rotation: weight is 2000"));
  bad = good;
  bad.contractions[0] = -0.5;
  EXPECT_THAT(message(bad), HasSubstr("contraction is -0.5; allowed are 0 to 15"));
  bad = good;
  for (JointWeight& joint : bad.joints) joint.locked = false;
  EXPECT_THAT(message(bad), HasSubstr("hip.rotation: is not locked"));
  bad = good;
  bad.contractions[0] = 3.0;
  EXPECT_EQ(message(bad), "") << "each leg has its own in this reading";
  EXPECT_THAT(
      check_parameters(layers_of(LayerReading::shared_contractions), bad).error().to_string(),
      HasSubstr("legs: contractions are 3 and 0 of limbs that share one"));
}

TEST(Regenerate, TakesTheParametersOfThePreset) {
  Task task = with_preset(Task(full_body(), {.goals = kGoals}), Preset::layers);
  EXPECT_EQ(regenerate(task, uniform_parameters(task.body)).error().code,
            ErrorCode::invalid_argument);
  Parameters parameters = start_values(layers_of(LayerReading::shared_contractions));
  const GenerateResult generation = regenerate(task, parameters).value();
  ASSERT_EQ(generation.candidates.size(), 1u);
  EXPECT_EQ(generation.candidates[0].parameters, parameters);
}

}  // namespace
}  // namespace shigusa
