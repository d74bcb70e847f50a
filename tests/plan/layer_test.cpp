// SPDX-License-Identifier: MIT
#include "plan/layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "paper/layered_player.hpp"
#include "support/bodies.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

Layer upper_layer(const PosedBody& posed,
                  LayerReading reading = LayerReading::shared_contractions) {
  return paper_layers(posed.body, posed.home, {}, reading).value()[0];
}

int count(const Layer& layer, ParameterKind kind) {
  return static_cast<int>(
      std::count_if(layer.parameters.begin(), layer.parameters.end(),
                    [&](const ParameterInfo& gene) { return gene.kind == kind; }));
}

// Rule R2: the paper's 14 parameters, in both readings.
TEST(PaperLayers, HaveFourteenParametersForTheWholeBody) {
  const Layer shared = upper_layer(full_body());
  EXPECT_EQ(count(shared, ParameterKind::weight), 12);
  EXPECT_EQ(count(shared, ParameterKind::contraction), 2);
  const Layer each = upper_layer(full_body(), LayerReading::contraction_a_limb);
  EXPECT_EQ(count(each, ParameterKind::weight), 10);
  EXPECT_EQ(count(each, ParameterKind::contraction), 4);
}

TEST(PaperLayers, HaveEightParametersForTheRightHalf) {
  EXPECT_EQ(upper_layer(half_body()).parameters.size(), 8u);
  EXPECT_EQ(upper_layer(half_body(), LayerReading::contraction_a_limb).parameters.size(), 7u);
}

TEST(PaperLayers, HaveFourParametersForAnArm) {
  const auto layers = paper_layers(full_body().body, full_body().home).value();
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[1].name, "right_arm");
  EXPECT_EQ(layers[2].name, "left_arm");
  for (const std::size_t arm : {1u, 2u}) {
    EXPECT_EQ(layers[arm].parameters.size(), 4u);
    EXPECT_EQ(layers[arm].criteria[CriterionKind::balance].weight, 0.0);
  }
}

TEST(PaperLayers, HandDownEveryLimbToALayerThatThereIs) {
  const auto layers = paper_layers(full_body().body, full_body().home).value();
  EXPECT_EQ(layers[0].delegates.size(), layers[0].body.limbs.size());
  for (const Delegate& handed : layers[0].delegates) {
    const bool known = std::any_of(layers.begin() + 1, layers.end(),
                                   [&](const Layer& layer) { return layer.name == handed.layer; });
    EXPECT_EQ(known, handed.by == DelegateMethod::limb_library);
  }
}

TEST(PaperLayers, RefuseABodyThatIsNoPerson) {
  const auto layers = paper_layers(chain({{}, {}}).body, chain({{}, {}}).home);
  ASSERT_FALSE(layers);
  EXPECT_EQ(layers.error().code, ErrorCode::unsupported);
}

std::vector<PosedBody> people() {
  Landmarks lifted = standing_landmarks(1.7, 0.1);
  lift_leg(lifted.right_leg, 1.0);
  return {half_body(),
          full_body(),
          build_human(asymmetric_person(), {"asymmetric", BodyExtent::full, 1.6, 60.0}),
          build_human(asymmetric_person(), {"half_asymmetric", BodyExtent::half, 1.6, 60.0}),
          build_human(lifted, {"right_leg_up", BodyExtent::full, 1.7, 70.0}),
          human_body(),
          human_body({.base = Side::left}),
          build_human(asymmetric_person(), {"whole_asymmetric", BodyExtent::human, 1.6, 60.0}),
          build_human(lifted, {"whole_leg_up", BodyExtent::human, 1.7, 70.0})};
}

TEST(ReducedBody, StartsWithHandsFeetAndTrunkWhereTheBodyHasThem) {
  for (const PosedBody& posed : people()) {
    const ReducedBody reduced = upper_layer(posed).body;
    const ReducedPlacement<double> at = start_placement(reduced);
    const Kinematics<double> whole = placed(posed, posed.home.angles);
    const BodyLimbs limbs = find_limbs(posed.body, posed.home).value();
    const auto trunk = static_cast<std::size_t>(reduced.trunk);
    EXPECT_LT(rotation_chord(at.rotation[trunk], whole.link_rotation(limbs.trunk)), 1e-12);
    EXPECT_LT(norm(at.origin[trunk] - whole.link_origin(limbs.trunk)), 1e-12);
    for (const ReducedLimb& limb : reduced.limbs) {
      const auto slide = static_cast<std::size_t>(limb.slide);
      if (limb.joints.kind == LimbKind::arm) {
        const Effector& hand =
            posed.body.effectors()[static_cast<std::size_t>(limb.joints.effector)];
        EXPECT_LT(norm(at.origin[slide] - whole.point(hand.link, hand.point)), 1e-12);
      } else if (!limb.joints.carries) {
        const Vec3d& ankle = whole.origin[static_cast<std::size_t>(limb.joints.ankle)];
        EXPECT_LT(norm(at.origin[slide] - ankle), 1e-12) << posed.body.name();
        const bool inverts = limb.joints.inversion >= 0;
        const Mat3d& foot =
            whole.link_rotation(inverts ? limb.joints.inversion : limb.joints.ankle);
        EXPECT_LT(rotation_chord(at.rotation[slide + (inverts ? 2 : 1)], foot), 1e-12);
      }
    }
  }
}

TEST(DecodeLayerGenes, LocksAtZeroAndSharesContractions) {
  const Layer layer = upper_layer(full_body());
  std::vector<std::uint16_t> genes(layer.parameters.size(), 7);
  genes[0] = 0;
  genes[12] = 15;  // legs
  genes[13] = 5;   // arms
  const LayeredValues parameters = decode_layer_genes(layer, genes);
  EXPECT_TRUE(
      parameters.joints[static_cast<std::size_t>(layer.parameters[0].applies_to[0])].locked);
  EXPECT_EQ(parameters.joints[static_cast<std::size_t>(layer.parameters[1].applies_to[0])].weight,
            7.0);
  EXPECT_EQ(parameters.contractions, (std::vector<double>{15.0, 15.0, 5.0, 5.0}));
}

TEST(DecodeLayerGenes, WithoutAGeneAHipDoesNotRotate) {
  const Layer layer = upper_layer(full_body(), LayerReading::contraction_a_limb);
  const LayeredValues parameters =
      decode_layer_genes(layer, std::vector<std::uint16_t>(layer.parameters.size(), 1));
  for (std::size_t d = 0; d < layer.body.dofs.size(); ++d) {
    const ReducedDof& dof = layer.body.dofs[d];
    if (dof.kind == ReducedDof::Kind::slide) continue;
    EXPECT_EQ(parameters.joints[d].locked, dof.name.ends_with("hip.rotation")) << dof.name;
  }
}

TEST(DecodeLayerPoint, IsEvenInLogarithmsAndInContraction) {
  const Layer layer = upper_layer(half_body());
  const std::vector<double> point{0.0, 0.5, 1.0, 0.75, 0.5, 0.5, 0.25, 1.0};
  const LayeredValues parameters = decode_layer_point(layer, point);
  const auto weight = [&](std::size_t gene) {
    return parameters.joints[static_cast<std::size_t>(layer.parameters[gene].applies_to[0])].weight;
  };
  EXPECT_NEAR(weight(1), 1.0, 1e-12);
  EXPECT_NEAR(weight(0) * weight(2), 1.0, 1e-12);
  EXPECT_NEAR(weight(3) * weight(3), weight(2), 1e-9 * weight(2));
  EXPECT_GT(weight(2), 200.0);
  EXPECT_EQ(parameters.contractions, (std::vector<double>{0.25 * 15.0, 15.0}));
}

// A motion of the upper layer.
ReducedClip<double> moved_by(const Layer& layer, const ReachProblem& problem,
                             const LayeredValues& parameters) {
  const ReducedProblem reduced(layer.body, problem);
  ReducedClip<double> clip;
  ReducedRollout<double>(reduced).run({upper_weights(parameters), parameters.contractions}, clip);
  return clip;
}

// A motion of the upper layer with random genes.
ReducedClip<double> moved(const Layer& layer, const ReachProblem& problem, Random& random) {
  std::vector<std::uint16_t> genes;
  for (const ParameterInfo& gene : layer.parameters) {
    const bool weight = gene.kind == ParameterKind::weight;
    genes.push_back(static_cast<std::uint16_t>(weight ? 1 + random.below(15) : random.below(8)));
  }
  return moved_by(layer, problem, decode_layer_genes(layer, genes));
}

constexpr Vec3d kFrontLow{-0.15, 0.5, 0.5};

TEST(ReducedRollout, KeepsHandAndFeetWithAnyWeights) {
  Random random(4);
  for (const PosedBody& posed : people()) {
    const Layer layer = upper_layer(posed);
    const ReachProblem problem = reach_with(posed, "right_hand", kFrontLow);
    int kept = 0;
    for (int i = 0; i < 50; ++i) {
      const ReducedClip<double> clip = moved(layer, problem, random);
      if (clip.path_error < 1e-4 && clip.foot_error < 1e-4) ++kept;
    }
    EXPECT_GE(kept, 48) << posed.body.name();
  }
}

TEST(ReducedRollout, LimbsHaveTheLengthsOfTheirContractions) {
  const PosedBody posed = half_body();
  const Layer layer = upper_layer(posed);
  const ReachProblem problem = reach_with(posed, "right_hand", kFrontLow);
  const std::vector<std::uint16_t> genes{3, 2, 5, 1, 4, 2, 6, 3};
  const ReducedClip<double> clip = moved_by(layer, problem, decode_layer_genes(layer, genes));
  EXPECT_LT(clip.path_error, 1e-4);
  for (const auto& [i, code] : {std::pair{0u, 6}, {1u, 3}}) {
    const ReducedLimb& limb = layer.body.limbs[i];
    const auto slide = static_cast<std::size_t>(limb.slide);
    const double start = layer.body.dofs[slide].start;
    const double last = limb.longest - (limb.longest - limb.shortest) * code / 15.0;
    for (int f = 0; f <= problem.steps; ++f) {
      const double share = minimum_jerk(static_cast<double>(f) / problem.steps);
      EXPECT_NEAR(clip.frame(f)[slide], start + (last - start) * share, 1e-12);
    }
  }
}

TEST(ReducedRollout, TwoLegsEndNearTheirContraction) {
  const PosedBody posed = full_body();
  const Layer layer = upper_layer(posed);
  const ReachProblem problem = reach_with(posed, "right_hand", {0.0, 0.45, 0.45});
  std::vector<std::uint16_t> genes(layer.parameters.size(), 1);
  genes[12] = 5;
  genes[13] = 0;
  const ReducedClip<double> clip = moved_by(layer, problem, decode_layer_genes(layer, genes));
  EXPECT_LT(clip.path_error, 1e-4);
  for (const std::size_t leg : {0u, 1u}) {
    const ReducedLimb& limb = layer.body.limbs[leg];
    const double last = limb.longest - (limb.longest - limb.shortest) / 3.0;
    EXPECT_NEAR(clip.frame(problem.steps)[static_cast<std::size_t>(limb.slide)], last, 0.02);
  }
}

TEST(ReducedRollout, LargerWeightMovesAJointLess) {
  const PosedBody posed = half_body();
  const Layer layer = upper_layer(posed);
  const ReachProblem problem = reach_with(posed, "right_hand", kFrontLow);
  for (std::size_t g = 0; g < 4; ++g) {
    std::vector<std::uint16_t> genes{1, 1, 1, 1, 1, 1, 4, 4};
    const auto dof = static_cast<std::size_t>(layer.parameters[g].applies_to[0]);
    const auto travel = [&](std::uint16_t weight) {
      genes[g] = weight;
      const ReducedClip<double> clip = moved_by(layer, problem, decode_layer_genes(layer, genes));
      EXPECT_LT(clip.path_error, kReachTolerance);
      double sum = 0.0;
      for (int f = 1; f <= problem.steps; ++f) {
        sum += abs(clip.frame(f)[dof] - clip.frame(f - 1)[dof]);
      }
      return sum;
    };
    const double light = travel(1);
    const double heavy = travel(15);
    EXPECT_LT(heavy, light) << layer.parameters[g].name;
    EXPECT_EQ(travel(0), 0.0);
  }
}

}  // namespace
}  // namespace shigusa
