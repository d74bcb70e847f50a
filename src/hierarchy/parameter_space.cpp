// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/hierarchy/parameter_space.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/genetic_operators.hpp>

namespace shigusa {
namespace {

// the freedoms that move a target: the others do nothing in weighted IK
std::vector<bool> useful_dofs(const ReachProblem& problem) {
  std::vector<bool> useful(problem.body->dofs().size());
  for (const IkTarget<double>& target : ik_targets(problem)) {
    for (const int d : problem.body->chain(target.link)) useful[static_cast<std::size_t>(d)] = true;
  }
  return useful;
}

// "hip.flexion" of "left_hip.flexion"; arms keep their side
std::string shared_name(const std::string& name) {
  for (const char* side : {"left_", "right_"}) {
    const std::string prefix = side;
    if (name.rfind(prefix, 0) != 0) continue;
    const std::string rest = name.substr(prefix.size());
    const std::string joint = rest.substr(0, rest.find('.'));
    if (joint == "hip" || joint == "knee" || joint == "ankle") return rest;
  }
  return name;
}

}  // namespace

ParameterSpace::ParameterSpace(const ReachProblem& problem, GeneCode code)
    : body_(problem.body), code_(code) {
  add_weights(problem);
  if (code_ == GeneCode::natural) add_posture(problem);
}

void ParameterSpace::add_weights(const ReachProblem& problem) {
  const std::vector<bool> useful = useful_dofs(problem);
  for (std::size_t d = 0; d < body_->dofs().size(); ++d) {
    const std::string& name = body_->dofs()[d].name;
    if (code_ != GeneCode::natural) {
      genes_.push_back(
          {.name = name, .dofs = {d}, .lower = -kLogWeightRange, .upper = kLogWeightRange});
      continue;
    }
    if (!useful[d]) continue;
    const auto same = [&](const Gene& gene) { return gene.name == shared_name(name); };
    if (const auto gene = std::find_if(genes_.begin(), genes_.end(), same); gene != genes_.end()) {
      gene->dofs.push_back(d);
    } else {
      genes_.push_back({.name = shared_name(name),
                        .dofs = {d},
                        .lower = -kLogWeightRange,
                        .upper = kLogWeightRange});
    }
  }
}

void ParameterSpace::add_posture(const ReachProblem& problem) {
  const std::vector<bool> useful = useful_dofs(problem);
  modes_ = posture_modes(*body_);
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    bool moves = false;
    for (std::size_t d = 0; d < useful.size(); ++d) {
      moves = moves || (useful[d] && modes_[m].direction[d] != 0.0);
    }
    if (!moves) continue;
    genes_.push_back({.kind = Kind::posture,
                      .name = modes_[m].name,
                      .mode = m,
                      .lower = modes_[m].lower,
                      .upper = modes_[m].upper});
  }
  genes_.push_back({.kind = Kind::delay, .name = "delay", .upper = kDelayMax});
  genes_.push_back(
      {.kind = Kind::bow, .name = "bow", .lower = -kBowSearched / 2.0, .upper = kBowSearched});
  genes_.push_back({.kind = Kind::skew, .name = "skew", .lower = -1.0, .upper = 1.0});
}

std::vector<std::string> ParameterSpace::names() const {
  std::vector<std::string> names;
  for (const Gene& gene : genes_) names.push_back(gene.name);
  return names;
}

std::vector<double> ParameterSpace::start() const {
  std::vector<double> point;
  for (const Gene& gene : genes_) point.push_back(gene.of(0.0));
  return point;
}

int ParameterSpace::find(std::string_view name) const {
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    if (genes_[g].name == name) return static_cast<int>(g);
  }
  return -1;
}

double ParameterSpace::coordinate(int gene, double value) const {
  return clamp(genes_[static_cast<std::size_t>(gene)].of(value), 0.0, 1.0);
}

Parameters ParameterSpace::decode(std::span<const double> point) const {
  if (code_ == GeneCode::paper) {
    return decode_paper_genes(genome_of_point(point, kPaperBitsPerGene));
  }
  Parameters parameters = uniform_parameters(*body_);
  if (code_ == GeneCode::natural) parameters.posture.modes.resize(modes_.size());
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    const Gene& gene = genes_[g];
    const double value = gene.at(point[g]);
    switch (gene.kind) {
      case Kind::weight:
        for (const std::size_t d : gene.dofs) {
          parameters.joints[d].weight = exponential(value);
        }
        break;
      case Kind::posture:
        parameters.posture.modes[gene.mode] = value;
        break;
      case Kind::delay:
        parameters.posture.delay = value;
        break;
      case Kind::bow:
        parameters.posture.bow = value;
        break;
      case Kind::skew:
        parameters.posture.skew = value;
        break;
    }
  }
  return parameters;
}

MotionInputs ParameterSpace::rows(std::span<const double> points) {
  if (code_ == GeneCode::paper) {
    weights_ = inverse_weights_of_genes(genome_of_point(points, kPaperBitsPerGene));
    return weights_;
  }
  const std::size_t motions = points.size() / genes_.size();
  const std::size_t dofs = body_->dofs().size();
  weights_.assign(motions * dofs, 1.0F);
  const bool natural = code_ == GeneCode::natural;
  postures_.assign(natural ? motions * dofs : 0, 0.0F);
  timing_.assign(natural ? motions * 3 : 0, 0.0F);
  for (std::size_t i = 0; i < motions; ++i) {
    const std::span<const double> point = points.subspan(i * genes_.size(), genes_.size());
    for (std::size_t g = 0; g < genes_.size(); ++g) {
      const Gene& gene = genes_[g];
      const double value = gene.at(point[g]);
      if (gene.kind == Kind::weight) {
        const auto inverse = static_cast<float>(exponential(-value));
        for (const std::size_t d : gene.dofs) weights_[i * dofs + d] = inverse;
      } else if (gene.kind == Kind::posture) {
        const std::vector<double>& direction = modes_[gene.mode].direction;
        for (std::size_t d = 0; d < dofs; ++d) {
          postures_[i * dofs + d] += static_cast<float>(value * direction[d]);
        }
      } else {
        const std::size_t k = gene.kind == Kind::delay ? 0 : gene.kind == Kind::bow ? 1 : 2;
        timing_[i * 3 + k] = static_cast<float>(value);
      }
    }
  }
  return {weights_, postures_, timing_};
}

}  // namespace shigusa
