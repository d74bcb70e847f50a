// SPDX-License-Identifier: MIT
#include "generate/parameter_space.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/check.hpp"
#include "search/genetic.hpp"
#include "search/genetic_operators.hpp"

namespace shigusa {
namespace {

// The logarithm of the least weight that is searched for a freedom that gives way last (Dof::give).
constexpr double kLastLogWeight = -1.0;

// The share of the body's weight that a resting hand presses with in the plain motion.
constexpr double kSupportStart = 0.05;

// Whether each freedom moves a target: the others do nothing in weighted IK.
std::vector<bool> useful_dofs(const ReachProblem& problem) {
  std::vector<bool> useful(problem.body->dofs().size());
  for (const IkTarget<double>& target : ik_targets(problem)) {
    for (const int d : problem.body->chain(target.link)) useful[static_cast<std::size_t>(d)] = true;
  }
  for (const IkSupport<double>& support : ik_supports(problem)) {
    for (const int d : problem.body->chain(support.link))
      useful[static_cast<std::size_t>(d)] = true;
    if (support.carrier == kWorldCarrier) continue;
    for (const int d : problem.body->chain(support.carrier)) {
      useful[static_cast<std::size_t>(d)] = true;
    }
  }
  return useful;
}

// The task's supports, as its plan names them.
std::vector<Support> supports_of(const ReachProblem& problem) {
  std::vector<Support> supports;
  for (const HandSupport& support : problem.supports) supports.push_back({support.name, {}});
  return supports;
}

// "hip.flexion" of "left_hip.flexion", "spine.flexion" of all of its joints; arms keep their side
std::string shared_name(const Dof& dof) {
  const JointPlace& part = dof.part;
  if (part.joint == "chest" || part.joint == "upper_chest") return "spine." + part.freedom;
  return part.limb == LimbKind::leg ? part.joint + "." + part.freedom : dof.name;
}

// Repeats the values for each motion, in single precision.
void repeat(std::span<const double> values, std::size_t motions, std::vector<float>& rows) {
  rows.clear();
  for (std::size_t i = 0; i < motions; ++i) {
    for (const double value : values) rows.push_back(static_cast<float>(value));
  }
}

// Copies the weights that are set.
void keep_joints(const std::vector<bool>& set, std::span<const JointWeight> from,
                 std::vector<JointWeight>& joints) {
  for (std::size_t d = 0; d < set.size(); ++d) {
    if (set[d]) joints[d] = from[d];
  }
}

}  // namespace

ParameterSpace::ParameterSpace(const ReachProblem& problem, GeneCode code,
                               const std::optional<FixedParameters>& fixed)
    : body_(problem.body),
      code_(code),
      named_(code == GeneCode::natural || code == GeneCode::every),
      fixed_(fixed ? *fixed : no_fixed_parameters(*body_, supports_of(problem))),
      posed_(named_),
      modes_(posture_modes(*body_)) {
  const Plan plan = whole_body_plan(*body_, supports_of(problem));
  const std::vector<bool> useful = useful_dofs(problem);
  const std::vector<Parameter> all = parameters_of(plan, fixed_.values);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ParameterInfo& info = *all[i].info;
    if (info.kind == ParameterKind::weight) {
      fixed_joints_.push_back(fixed_.set[i]);
    } else {
      posed_ = posed_ || fixed_.set[i];
    }
    // a genome of the paper's has a gene for each freedom
    if (!fixed_.set[i] || (code_ == GeneCode::paper && info.kind == ParameterKind::weight)) {
      add(all[i], useful);
    }
  }
}

void ParameterSpace::add(const Parameter& parameter, const std::vector<bool>& useful) {
  const ParameterInfo& info = *parameter.info;
  Gene gene{.kind = info.kind,
            .name = info.name,
            .index = info.applies_to.empty() ? 0 : static_cast<std::size_t>(info.applies_to[0]),
            .lower = info.shown_low,
            .upper = info.shown_high};
  switch (info.kind) {
    case ParameterKind::weight:
      return add_weight(std::move(gene), useful);
    case ParameterKind::mode: {
      const std::vector<double>& direction = modes_[gene.index].direction;
      bool moves = false;
      for (std::size_t d = 0; d < useful.size(); ++d) {
        moves = moves || (useful[d] && direction[d] != 0.0);
      }
      if (!named_ || !moves) return;
      break;
    }
    case ParameterKind::timing: {
      const TimingNumber& number = kTimingNumbers[gene.index];
      if (!named_ || !(number.searched || code_ == GeneCode::every)) return;
      gene.lower = number.searched_low;
      gene.upper = number.searched_high;
      break;
    }
    case ParameterKind::support:
      gene.start = kSupportStart;
      break;
    case ParameterKind::contraction:
    case ParameterKind::swivel:
    case ParameterKind::final_angle:
      return;
  }
  genes_.push_back(std::move(gene));
}

void ParameterSpace::add_weight(Gene gene, const std::vector<bool>& useful) {
  const std::size_t d = gene.index;
  gene.dofs = {d};
  gene.lower = -kLogWeightRange;
  gene.upper = kLogWeightRange;
  if (named_) {
    if (!useful[d]) return;
    gene.name = shared_name(body_->dofs()[d]);
    const auto same = [&gene](const Gene& other) { return other.name == gene.name; };
    if (const auto own = std::find_if(genes_.begin(), genes_.end(), same); own != genes_.end()) {
      own->dofs.push_back(d);
      return;
    }
    // a freedom that gives way last is not to be among the first
    if (body_->dofs()[d].give < 1.0) gene.lower = kLastLogWeight;
  }
  genes_.push_back(std::move(gene));
}

std::vector<std::string> ParameterSpace::names() const {
  std::vector<std::string> names;
  for (const Gene& gene : genes_) names.push_back(gene.name);
  return names;
}

std::vector<double> ParameterSpace::start() const {
  std::vector<double> point;
  for (const Gene& gene : genes_) point.push_back(gene.of(gene.start));
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

// Sets the fixed weights, and the posture as it is fixed: genes come after.
void ParameterSpace::keep_fixed(Parameters& parameters) const {
  keep_joints(fixed_joints_, fixed_.values.joints, parameters.joints);
  if (posed_) parameters.posture = fixed_.values.posture;
  parameters.supports = fixed_.values.supports;
}

Parameters ParameterSpace::decode(std::span<const double> point) const {
  if (code_ == GeneCode::paper) {
    Parameters parameters = decode_paper_genes(genome_of_point(point, kPaperBitsPerGene));
    keep_fixed(parameters);
    return parameters;
  }
  Parameters parameters = uniform_parameters(*body_);
  keep_fixed(parameters);
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    const Gene& gene = genes_[g];
    const double value = gene.at(point[g]);
    switch (gene.kind) {
      case ParameterKind::weight:
        for (const std::size_t d : gene.dofs) {
          parameters.joints[d].weight = exponential(value);
        }
        break;
      case ParameterKind::mode:
        parameters.posture.modes[gene.index] = value;
        break;
      case ParameterKind::timing:
        parameters.posture.timing.*kTimingMembers<double>[gene.index] = value;
        break;
      case ParameterKind::support:
        parameters.supports[gene.index] = value;
        break;
      default:  // of other plans
        break;
    }
  }
  return parameters;
}

std::vector<double> ParameterSpace::encode(const Parameters& values) const {
  SHG_CHECK(code_ != GeneCode::paper, "the paper's codes are not of all weights");
  std::vector<double> point;
  for (const Gene& gene : genes_) point.push_back(clamp(gene.of(value_of(gene, values)), 0.0, 1.0));
  return point;
}

double ParameterSpace::value_of(const Gene& gene, const Parameters& values) const {
  switch (gene.kind) {
    case ParameterKind::weight: {
      double sum = 0.0;
      for (const std::size_t d : gene.dofs) {
        sum += values.joints[d].locked ? kLogWeightRange : natural_log(values.joints[d].weight);
      }
      return sum / static_cast<double>(gene.dofs.size());
    }
    case ParameterKind::mode: {
      const std::vector<double>& modes = values.posture.modes;
      return modes.empty() ? gene.start : modes[gene.index];
    }
    case ParameterKind::timing:
      return values.posture.timing.*kTimingMembers<double>[gene.index];
    case ParameterKind::support:
      return values.supports[gene.index];
    default:  // of other plans
      return gene.start;
  }
}

MotionInputs ParameterSpace::rows(std::span<const double> points) {
  const std::size_t motions = points.size() / genes_.size();
  const std::size_t dofs = body_->dofs().size();
  Parameters base = uniform_parameters(*body_);
  keep_fixed(base);
  const std::vector<double> inverse = inverse_weights(base);
  weights_.resize(motions * dofs);
  if (code_ == GeneCode::paper) {
    weights_ = inverse_weights_of_genes(genome_of_point(points, kPaperBitsPerGene));
  }
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const std::size_t d = k % dofs;
    if (code_ != GeneCode::paper || fixed_joints_[d]) weights_[k] = static_cast<float>(inverse[d]);
  }
  start_rows(base, motions);
  if (code_ != GeneCode::paper) {
    for (std::size_t i = 0; i < motions; ++i) {
      fill_row(i, points.subspan(i * genes_.size(), genes_.size()));
    }
  }
  if (!posed_) return weights_;
  MotionInputs inputs{weights_, postures_, timing_};
  inputs.supports = supports_;
  return inputs;
}

// postures, all as the fixed parameters have it
void ParameterSpace::start_rows(const Parameters& base, std::size_t motions) {
  if (!posed_) return;
  repeat(posture_change(*body_, base.posture), motions, postures_);
  std::vector<double> timing;
  for (const auto member : kTimingMembers<double>) timing.push_back(base.posture.timing.*member);
  repeat(timing, motions, timing_);
  repeat(base.supports, motions, supports_);
}

void ParameterSpace::fill_row(std::size_t row, std::span<const double> point) {
  const std::size_t dofs = body_->dofs().size();
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    const Gene& gene = genes_[g];
    const double value = gene.at(point[g]);
    if (gene.kind == ParameterKind::weight) {
      const auto inverse = static_cast<float>(exponential(-value));
      for (const std::size_t d : gene.dofs) weights_[row * dofs + d] = inverse;
    } else if (gene.kind == ParameterKind::mode) {
      const std::vector<double>& direction = modes_[gene.index].direction;
      for (std::size_t d = 0; d < dofs; ++d) {
        postures_[row * dofs + d] += static_cast<float>(value * direction[d]);
      }
    } else if (gene.kind == ParameterKind::support) {
      supports_[row * fixed_.values.supports.size() + gene.index] = static_cast<float>(value);
    } else {
      timing_[row * kTimings + gene.index] = static_cast<float>(value);
    }
  }
}

}  // namespace shigusa
