// SPDX-License-Identifier: MIT
#include "plan/plan.hpp"

#include <gmock/gmock.h>

#include <set>
#include <shigusa/generate.hpp>

#include "paper/layered_values.hpp"
#include "plan/layer.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

const std::vector<Goal> kGoals{{"right_hand", {-0.3, 1.2, 0.35}}, {"left_hand", {0.3, 1.1, 0.4}}};

Plan layers_of(LayerReading reading) {
  return layers_to_goals(full_body().body, full_body().home, kGoals, {.reading = reading}).value();
}

TEST(LayersToGoals, AreTheUpperOneAndEachGoalsArm) {
  const std::vector<Layer> layers = layers_of(LayerReading::shared_contractions);
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[1].name, "right_arm");
  EXPECT_EQ(layers[2].name, "left_arm");
  const std::vector<Goal> left{kGoals[1]};
  EXPECT_EQ(layers_to_goals(full_body().body, full_body().home, left).value()[1].name, "left_arm");
  EXPECT_EQ(layers_to_goals(half_body().body, half_body().home, left).error().code,
            ErrorCode::not_found);
}

// The paper's count: 14 parameters of the upper layer, and four for each arm.
TEST(ParameterList, HasANameOfItsOwnForEachParameterOfLayers) {
  for (const auto& [reading, word] : kEnumWords<LayerReading>) {
    const Plan plan = layers_of(reading);
    const ParameterList list = parameter_list(plan);
    EXPECT_EQ(list.size(), 14u + 8u) << word;
    const std::vector<std::string> names = list.names();
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), list.size());
    for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list.find(names[i]), i) << names[i];
    EXPECT_TRUE(list.check(list.start()));
    // conversion to the layers' form and back keeps all values
    Parameters values = list.start();
    for (std::size_t i = 0; i < list.size(); ++i) {
      values.values[i] = 1.0 + static_cast<double>(i);
      values.locked[i] = list.all[i].kind == ParameterKind::weight && i % 2 == 0;
    }
    EXPECT_EQ(parameters_of(plan, layered_values(plan, values)), values) << word;
  }
}

TEST(ParameterList, RefusesValuesOfAnotherPlanAndOutOfRange) {
  const ParameterList list = parameter_list(layers_of(LayerReading::contraction_a_limb));
  const auto message = [&list](const Parameters& parameters) {
    const auto checked = list.check(parameters);
    return checked ? "" : checked.error().to_string();
  };
  Parameters bad = list.start();
  bad.values.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("21 values, for a plan of 22"));
  bad = list.start();
  bad.locked.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("values, for a plan of 22"));
  bad = list.start();
  value_of(list, bad, "left_arm.left_shoulder.rotation.weight") = 2e3;
  EXPECT_THAT(message(bad), HasSubstr("left_arm.left_shoulder.rotation: weight is 2000"));
  bad = list.start();
  value_of(list, bad, "right_leg.contraction") = -0.5;
  EXPECT_THAT(message(bad), HasSubstr("contraction is -0.5; allowed are 0 to 15"));
  value_of(list, bad, "right_leg.contraction") = 3.0;
  EXPECT_EQ(message(bad), "");
}

TEST(Regenerate, TakesTheParametersOfThePreset) {
  Task task = with_preset(Task(full_body(), {.goals = kGoals}), Preset::layers);
  EXPECT_EQ(regenerate(task, uniform_parameters(task.body)).error().code,
            ErrorCode::invalid_argument);
  const Parameters parameters =
      parameter_list(layers_of(LayerReading::shared_contractions)).start();
  const GenerateResult generation = regenerate(task, parameters).value();
  ASSERT_EQ(generation.candidates.size(), 1u);
  EXPECT_EQ(generation.candidates[0].parameters, parameters);
}

}  // namespace
}  // namespace shigusa
