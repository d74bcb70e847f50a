// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/core/names.hpp>
#include <shigusa/hierarchy/layered_parameters.hpp>

namespace shigusa {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// what a contraction's gene is called, less what it is
std::string short_name(const LayerGene& gene) {
  return gene.kind == LayerGeneKind::weight ? gene.name : gene.name.substr(0, gene.name.rfind('.'));
}

bool has_gene(const Layer& layer, std::size_t dof) {
  return std::any_of(layer.genes.begin(), layer.genes.end(), [dof](const LayerGene& gene) {
    return gene.kind == LayerGeneKind::weight &&
           std::count(gene.applies_to.begin(), gene.applies_to.end(), static_cast<int>(dof)) > 0;
  });
}

// weights of 1, and no contraction, where the counts are not the layers'
void bring_to_size(std::span<const Layer> layers, LayeredParameters& parameters) {
  const ReducedBody& body = layers[0].body;
  std::vector<JointWeight>& joints = parameters.upper.joints;
  if (joints.size() != body.dofs.size()) {
    joints.assign(body.dofs.size(), {});
    for (std::size_t d = 0; d < joints.size(); ++d) joints[d].locked = !has_gene(layers[0], d);
  }
  if (parameters.upper.contractions.size() != body.limbs.size()) {
    parameters.upper.contractions.assign(body.limbs.size(), 0.0);
  }
  if (parameters.arms.size() != layers.size() - 1) parameters.arms.assign(layers.size() - 1, {});
}

Result<void> check_counts(std::span<const Layer> layers, const LayeredParameters& parameters) {
  const ReducedBody& body = layers[0].body;
  const LayerParameters& upper = parameters.upper;
  if (upper.joints.size() == body.dofs.size() && upper.contractions.size() == body.limbs.size() &&
      parameters.arms.size() == layers.size() - 1) {
    return {};
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} freedoms, {} limbs and {} arms, for layers of {}, {} and {}",
                          upper.joints.size(), upper.contractions.size(), parameters.arms.size(),
                          body.dofs.size(), body.limbs.size(), layers.size() - 1));
}

Result<void> check_member(const LayeredMember& member) {
  const std::string place = member.layer.empty() ? member.name : member.layer + "." + member.name;
  if (member.joint != nullptr) {
    const double weight = member.joint->weight;
    if (weight >= kWeightMin && weight <= kWeightMax) return {};
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("weight is {}; allowed are {:g} to {:g}", weight, kWeightMin, kWeightMax),
        place);
  }
  for (const double* value : member.contraction) {
    if (!(*value >= 0.0 && *value <= kLayerGeneMax)) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("contraction is {}; allowed are 0 to {}", *value, kLayerGeneMax),
                  place);
    }
    if (*value != *member.contraction.front()) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("contractions are {} and {} of limbs that share one",
                              *member.contraction.front(), *value),
                  place);
    }
  }
  return {};
}

}  // namespace

Result<std::vector<Layer>> layers_to_goals(const BodyModel& body, std::span<const Goal> goals,
                                           const LayeredSettings& settings,
                                           const CriteriaSettings& criteria) {
  Result<std::vector<Layer>> all = paper_layers(body, criteria, settings.reading);
  if (!all) return all;
  const BodyLimbs limbs = find_limbs(body).value();
  std::vector<std::string> names;
  for (const Effector& effector : body.effectors()) names.push_back(effector.name);
  std::vector<Layer> layers{(*all)[0]};
  for (const Goal& goal : goals) {
    const auto effector = body.find_effector(goal.effector);
    const auto arm = std::find_if(limbs.arms.begin(), limbs.arms.end(), [&](const BodyLimb& limb) {
      return effector && limb.effector == *effector;
    });
    if (arm == limbs.arms.end()) {
      return fail(ErrorCode::not_found, unknown_name("effector", goal.effector, names), "goal");
    }
    // the arms' layers follow the upper one in the order of the arms
    layers.push_back((*all)[1 + index(static_cast<int>(arm - limbs.arms.begin()))]);
  }
  return layers;
}

std::vector<LayeredMember> layered_members(std::span<const Layer> layers,
                                           LayeredParameters& parameters) {
  bring_to_size(layers, parameters);
  std::vector<LayeredMember> members;
  for (const LayerGene& gene : layers[0].genes) {
    LayeredMember member{.layer = {}, .name = short_name(gene)};
    for (const int to : gene.applies_to) {
      if (gene.kind == LayerGeneKind::weight) {
        member.joint = &parameters.upper.joints[index(to)];
      } else {
        member.contraction.push_back(&parameters.upper.contractions[index(to)]);
      }
    }
    members.push_back(std::move(member));
  }
  for (std::size_t g = 0; g + 1 < layers.size(); ++g) {
    for (const LayerGene& gene : layers[1 + g].genes) {
      members.push_back({.layer = layers[1 + g].name,
                         .name = gene.name,
                         .joint = &parameters.arms[g][index(gene.applies_to[0])]});
    }
  }
  return members;
}

Result<void> check_layered(std::span<const Layer> layers, const LayeredParameters& parameters) {
  if (const auto checked = check_counts(layers, parameters); !checked) return checked;
  LayeredParameters copy = parameters;
  for (const LayeredMember& member : layered_members(layers, copy)) {
    if (const auto checked = check_member(member); !checked) return checked;
  }
  const std::vector<ReducedDof>& dofs = layers[0].body.dofs;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (dofs[d].kind == ReducedDof::Kind::slide || has_gene(layers[0], d)) continue;
    if (parameters.upper.joints[d].locked) continue;
    return fail(ErrorCode::invalid_argument, "is not locked, and has no gene in these layers",
                dofs[d].name);
  }
  return {};
}

}  // namespace shigusa
