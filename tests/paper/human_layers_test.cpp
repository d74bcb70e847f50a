// SPDX-License-Identifier: MIT
// The three layers of the preset human as data.
#include <gmock/gmock.h>

#include <algorithm>

#include "paper/layered_values.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Layer> to_goals(const PosedBody& posed, const std::vector<std::string>& hands) {
  std::vector<Goal> goals;
  for (const std::string& hand : hands) goals.push_back({hand, {}});
  return layers_to_goals(posed.body, posed.home, goals, {.stack = LayerStack::human}).value();
}

std::vector<std::string> names(const std::vector<Layer>& layers) {
  std::vector<std::string> all;
  for (const Layer& layer : layers) all.push_back(layer.name);
  return all;
}

std::vector<std::string> genes(const Layer& layer) {
  std::vector<std::string> all;
  for (const ParameterInfo& gene : layer.parameters) all.push_back(gene.name);
  return all;
}

TEST(HumanLayers, AreTrunkThenSwivelsThenTheRest) {
  const auto layers = human_layers(full_body().body, full_body().home).value();
  EXPECT_THAT(names(layers),
              ElementsAre("trunk_and_limb_lengths", "right_arm", "left_arm", "rest"));
  EXPECT_EQ(layers[0].parameters.size(), 14u);
  EXPECT_THAT(genes(layers[1]), ElementsAre("right_arm"));
  EXPECT_THAT(genes(layers[2]), ElementsAre("left_arm"));
  EXPECT_EQ(layers[3].parameters.size(), 6u);
  EXPECT_THAT(names(human_layers(half_body().body, half_body().home).value()),
              ElementsAre("trunk_and_limb_lengths", "right_arm", "rest"));
}

TEST(HumanLayers, HandEveryLimbToALayerThatThereIs) {
  const auto layers = human_layers(full_body().body, full_body().home).value();
  const auto known = [&layers](const std::string& name) {
    return std::any_of(layers.begin() + 1, layers.end(),
                       [&name](const Layer& layer) { return layer.name == name; });
  };
  ASSERT_EQ(layers[0].delegates.size(), layers[0].body.limbs.size());
  for (const Delegate& handed : layers[0].delegates) {
    const bool arm = handed.by == DelegateMethod::swivel;
    EXPECT_NE(arm, handed.by == DelegateMethod::closed_form);
    EXPECT_EQ(known(handed.layer), arm);
    EXPECT_EQ(known(handed.idle), arm);
  }
}

TEST(HumanLayers, RefuseABodyThatIsNoPerson) {
  EXPECT_EQ(human_layers(chain({{}, {}}).body, chain({{}, {}}).home).error().code,
            ErrorCode::unsupported);
}

TEST(HumanLayersToGoals, LeaveToTheRestWhatNoGoalMoves) {
  const auto right = to_goals(full_body(), {"right_hand"});
  EXPECT_THAT(names(right), ElementsAre("trunk_and_limb_lengths", "right_arm", "rest"));
  EXPECT_THAT(genes(right[2]), ElementsAre("left_shoulder.flexion", "left_shoulder.abduction",
                                           "left_elbow.flexion"));
  const auto left = to_goals(full_body(), {"left_hand"});
  EXPECT_EQ(left[1].name, "left_arm");
  EXPECT_EQ(genes(left[2])[2], "right_elbow.flexion");
  EXPECT_TRUE(to_goals(full_body(), {"left_hand", "right_hand"})[3].parameters.empty());
  // half a body has no limb that is free
  EXPECT_TRUE(to_goals(half_body(), {"right_hand"})[2].parameters.empty());
}

TEST(HumanLayersToGoals, RangesHoldTheStartAndJointLimits) {
  for (const PosedBody& posed :
       {full_body(), build_human(asymmetric_person(), {"crooked", BodyExtent::full, 1.6, 60.0})}) {
    const auto layers = to_goals(posed, {"right_hand"});
    ASSERT_EQ(layers[2].parameters.size(), 3u);
    for (const ParameterInfo& gene : layers[2].parameters) {
      const int dof = posed.body.find_dof(gene.name).value();
      const double start = posed.home.angles[static_cast<std::size_t>(dof)];
      EXPECT_LT(gene.low, gene.high);
      EXPECT_LE(gene.low, start);
      EXPECT_GE(gene.high, start);
      EXPECT_GE(gene.low, min(posed.body.dof(dof).lower, start));
      EXPECT_LE(gene.high, max(posed.body.dof(dof).upper, start));
    }
  }
}

TEST(HumanMembers, AreWeightsContractionsSwivelsAndFinalAngles) {
  const PosedBody posed = full_body();
  const auto layers = to_goals(posed, {"right_hand"});
  const LayeredValues parameters = start_values(layers);
  EXPECT_EQ(parameter_list(layers).size(), 14u + 1u + 3u);
  EXPECT_TRUE(parameters.arms.empty());
  EXPECT_THAT(parameters.swivels, ElementsAre(0.0));
  ASSERT_EQ(parameters.finals.size(), 3u);
  const auto elbow = static_cast<std::size_t>(posed.body.find_dof("left_elbow.flexion").value());
  EXPECT_EQ(parameters.finals[2], posed.home.angles[elbow]);
  EXPECT_TRUE(parameter_list(layers).check(parameters_of(layers, parameters)));
}

TEST(HumanMembers, OutOfRangeAreRefusedByName) {
  const auto layers = to_goals(full_body(), {"right_hand"});
  const LayeredValues good = start_values(layers);
  const auto message = [&layers](const LayeredValues& values) {
    const auto checked = parameter_list(layers).check(parameters_of(layers, values));
    return checked ? "" : checked.error().to_string();
  };
  LayeredValues bad = good;
  bad.swivels[0] = 2.0;
  EXPECT_THAT(message(bad), HasSubstr("right_arm: swivel is 2; allowed are -1.047"));
  bad = good;
  bad.finals[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message(bad), HasSubstr("left_elbow.flexion: final is nan"));
}

}  // namespace
}  // namespace shigusa
