// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/layers/layered_parameters.hpp>

namespace shigusa {
namespace {

constexpr std::array kLimbDofs{&BodyLimb::flexion, &BodyLimb::abduction, &BodyLimb::rotation,
                               &BodyLimb::hinge};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// what a contraction's gene is called, less what it is
std::string short_name(const LayerGene& gene) {
  return gene.kind == LayerGeneKind::contraction ? gene.name.substr(0, gene.name.rfind('.'))
                                                 : gene.name;
}

bool has_gene(const Layer& layer, std::size_t dof) {
  return std::any_of(layer.genes.begin(), layer.genes.end(), [dof](const LayerGene& gene) {
    return gene.kind == LayerGeneKind::weight &&
           std::count(gene.applies_to.begin(), gene.applies_to.end(), static_cast<int>(dof)) > 0;
  });
}

// Numbers of the layers below.
struct Counts {
  std::size_t arms = 0;
  std::size_t swivels = 0;
  std::vector<double> finals{};  // rad, at the start
};

Counts counts_of(std::span<const Layer> layers) {
  Counts counts;
  for (const Layer& layer : layers.subspan(1)) {
    if (searches(layer, LayerGeneKind::weight)) ++counts.arms;
    if (searches(layer, LayerGeneKind::swivel)) ++counts.swivels;
    for (const LayerGene& gene : layer.genes) {
      if (gene.kind != LayerGeneKind::final_angle) continue;
      counts.finals.push_back(layer.body.dofs[index(gene.applies_to[0])].start);
    }
  }
  return counts;
}

// weights of 1, no contraction, and the start's angles, where the counts are not the layers'
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
  const Counts counts = counts_of(layers);
  if (parameters.arms.size() != counts.arms) parameters.arms.assign(counts.arms, {});
  if (parameters.swivels.size() != counts.swivels) parameters.swivels.assign(counts.swivels, 0.0);
  if (parameters.finals.size() != counts.finals.size()) parameters.finals = counts.finals;
}

Result<void> check_counts(std::span<const Layer> layers, const LayeredParameters& parameters) {
  const ReducedBody& body = layers[0].body;
  const LayerParameters& upper = parameters.upper;
  const Counts counts = counts_of(layers);
  if (upper.joints.size() != body.dofs.size() || upper.contractions.size() != body.limbs.size() ||
      parameters.arms.size() != counts.arms) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} freedoms, {} limbs and {} arms, for layers of {}, {} and {}",
                            upper.joints.size(), upper.contractions.size(), parameters.arms.size(),
                            body.dofs.size(), body.limbs.size(), counts.arms));
  }
  if (parameters.swivels.size() == counts.swivels &&
      parameters.finals.size() == counts.finals.size()) {
    return {};
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} swivels and {} final angles, for layers of {} and {}",
                          parameters.swivels.size(), parameters.finals.size(), counts.swivels,
                          counts.finals.size()));
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
  if (member.angle != nullptr) {
    if (*member.angle >= member.low && *member.angle <= member.high) return {};
    return fail(ErrorCode::invalid_argument,
                fmt::format("angle is {} rad; allowed are {:.4g} to {:.4g}", *member.angle,
                            member.low, member.high),
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

// Whether a layer's freedom is one of a limb.
bool is_of(const BodyModel& body, const BodyLimb& limb, const std::string& dof) {
  return std::any_of(kLimbDofs.begin(), kLimbDofs.end(),
                     [&](int BodyLimb::*member) { return body.dof(limb.*member).name == dof; });
}

// The layers that have limbs which no goal moves, with the genes of those limbs alone.
void add_idle_layers(const BodyModel& body, std::span<const Layer> all, std::span<const Goal> goals,
                     std::vector<Layer>& layers) {
  for (Layer layer : all.subspan(1)) {
    const auto has = [&](const LayerGene& gene) {
      const std::string& dof = layer.body.dofs[index(gene.applies_to[0])].name;
      return std::any_of(all[0].hands_down.begin(), all[0].hands_down.end(),
                         [&](const HandedLimb& handed) {
                           const BodyLimb& limb = all[0].body.limbs[index(handed.limb)].joints;
                           return handed.idle == layer.name && is_of(body, limb, dof) &&
                                  std::none_of(goals.begin(), goals.end(), [&](const Goal& goal) {
                                    return body.find_effector(goal.effector) == limb.effector;
                                  });
                         });
    };
    const bool idle = std::any_of(all[0].hands_down.begin(), all[0].hands_down.end(),
                                  [&](const HandedLimb& limb) { return limb.idle == layer.name; });
    if (!idle) continue;
    std::erase_if(layer.genes, [&has](const LayerGene& gene) { return !has(gene); });
    layers.push_back(std::move(layer));
  }
}

}  // namespace

Result<std::vector<Layer>> layers_to_goals(const BodyModel& body, std::span<const Goal> goals,
                                           const LayerChoice& choice,
                                           const CriteriaSettings& criteria) {
  const Result<std::vector<Layer>> all = make_layers(body, choice, criteria);
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
    const bool turns = goal.rotation || goal.axis;
    const bool turnable = choice.stack == LayerStack::human && arm->has_wrist();
    if ((turns && !turnable) || goal.tolerance != Vec3d{}) {
      return fail(ErrorCode::unsupported,
                  "layers bring hands to positions, and those of a whole human by the preset human "
                  "to rotations and axes too; the preset flat takes rotations, axes and boxes",
                  "goal of " + goal.effector);
    }
    // the arms' layers follow the upper one in the order of the arms
    layers.push_back((*all)[1 + index(static_cast<int>(arm - limbs.arms.begin()))]);
  }
  add_idle_layers(body, *all, goals, layers);
  return layers;
}

std::vector<LayeredMember> layered_members(std::span<const Layer> layers,
                                           LayeredParameters& parameters) {
  bring_to_size(layers, parameters);
  std::vector<LayeredMember> members;
  for (const LayerGene& gene : layers[0].genes) {
    LayeredMember member{.layer = {}, .name = short_name(gene), .kind = gene.kind};
    for (const int to : gene.applies_to) {
      if (gene.kind == LayerGeneKind::weight) {
        member.joint = &parameters.upper.joints[index(to)];
      } else {
        member.contraction.push_back(&parameters.upper.contractions[index(to)]);
      }
    }
    members.push_back(std::move(member));
  }
  auto arm = parameters.arms.begin();
  auto swivel = parameters.swivels.begin();
  auto final_angle = parameters.finals.begin();
  for (const Layer& layer : layers.subspan(1)) {
    for (const LayerGene& gene : layer.genes) {
      LayeredMember member{.layer = layer.name,
                           .name = gene.name,
                           .kind = gene.kind,
                           .low = gene.low,
                           .high = gene.high};
      switch (gene.kind) {
        case LayerGeneKind::weight:
          member.joint = &(*arm)[index(gene.applies_to[0])];
          break;
        case LayerGeneKind::swivel:
          member.angle = &*swivel++;
          break;
        case LayerGeneKind::final_angle:
          member.angle = &*final_angle++;
          break;
        case LayerGeneKind::contraction:
          break;
      }
      members.push_back(std::move(member));
    }
    if (searches(layer, LayerGeneKind::weight)) ++arm;
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
