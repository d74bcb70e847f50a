// SPDX-License-Identifier: MIT
#include "generate/parameter_space.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/check.hpp"
#include "plan/held_input.hpp"
#include "search/genetic.hpp"
#include "search/genetic_operators.hpp"

namespace shigusa {
namespace {

// Lower bound of the logarithm of a weight for a dof that yields last (Dof::give).
constexpr double kLastLogWeight = -1.0;

// Share of the body's weight carried by a resting hand in the plain motion.
constexpr double kSupportStart = 0.05;

// Whether each dof moves a constraint's point or place: the others have no effect in weighted IK.
std::vector<bool> useful_dofs(const ReachProblem& problem) {
  std::vector<bool> useful(problem.body->dofs().size());
  const auto use = [&](int link) {
    for (const int d : problem.body->chain(link)) useful[static_cast<std::size_t>(d)] = true;
  };
  for (const Constraint<double>& constraint : constraints(problem)) {
    use(constraint.link);
    if (constraint.carrier != kWorldCarrier) use(constraint.carrier);
  }
  return useful;
}

// The shared name: "hip.flexion" for "left_hip.flexion", "spine.flexion" for all joints of the
// spine; arms keep their side.
std::string shared_name(const Dof& dof) {
  const JointPlace& part = dof.part;
  if (part.joint_kind == JointKind::chest || part.joint_kind == JointKind::upper_chest) {
    return std::string(word_of(JointKind::spine)) + "." + part.freedom;
  }
  return part.limb == LimbKind::leg ? part.joint + "." + part.freedom : dof.name;
}

// Repeats the values for each motion.
void repeat(std::span<const float> values, std::size_t motions, std::vector<float>& rows) {
  rows.clear();
  for (std::size_t i = 0; i < motions; ++i) rows.insert(rows.end(), values.begin(), values.end());
}

// Index of the dof, posture mode, timing or support of a parameter.
std::size_t number_of(const ParameterInfo& info) {
  return static_cast<std::size_t>(info.applies_to[0]);
}

}  // namespace

ParameterSpace::ParameterSpace(const ReachProblem& problem, const ParameterList& list,
                               GeneCode code, const std::optional<FixedParameters>& fixed)
    : body_(problem.body),
      list_(&list),
      code_(code),
      named_(code == GeneCode::natural || code == GeneCode::every),
      base_(list.start()),
      set_(fixed ? fixed->set : std::vector<bool>(list.size())),
      modes_(posture_modes(*body_)),
      supports_(problem.supports.size()) {
  base_.posed = named_;
  const std::vector<bool> useful = useful_dofs(problem);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool weight = list.all[i].kind == ParameterKind::weight;
    if (set_[i]) {
      base_.values[i] = fixed->values.values[i];
      base_.locked[i] = fixed->values.locked[i];
      base_.posed = base_.posed || !weight;
    }
    // a genome of the paper has a gene for each dof
    if (!set_[i] || (code_ == GeneCode::paper && weight)) add(i, useful);
  }
  start_rows();
}

// Sets the cells of each gene, and the other elements from the fixed parameters.
void ParameterSpace::start_rows() {
  const HeldInput held(*body_, base_, supports_);
  const MotionInput<double> input = held.input();
  base_rows_[kWeights].assign(input.inverse_weights.begin(), input.inverse_weights.end());
  if (base_.posed) {
    base_rows_[kPosture].assign(input.posture.begin(), input.posture.end());
    for (const auto member : kTimingMembers<double>) {
      base_rows_[kTiming].push_back(static_cast<float>(input.timing.*member));
    }
    base_rows_[kSupports].assign(input.supports.begin(), input.supports.end());
  }
  for (Gene& gene : genes_) {
    for (const std::size_t p : gene.parameters) add_cells(list_->all[p], gene.cells);
    if (gene.kind != ParameterKind::weight) continue;  // other rows accumulate from 0
    for (const Cell& cell : gene.cells) base_rows_[cell.row][cell.column] = 0.0F;
  }
}

void ParameterSpace::add_cells(const ParameterInfo& info, std::vector<Cell>& cells) const {
  const std::size_t number = number_of(info);
  if (info.kind == ParameterKind::mode) {
    const std::vector<double>& direction = modes_[number].direction;
    for (std::size_t d = 0; d < direction.size(); ++d) {
      if (direction[d] != 0.0) cells.push_back({kPosture, d, direction[d]});
    }
    return;
  }
  const Row row = info.kind == ParameterKind::weight   ? kWeights
                  : info.kind == ParameterKind::timing ? kTiming
                                                       : kSupports;
  cells.push_back({row, number, 1.0});
}

void ParameterSpace::add(std::size_t parameter, const std::vector<bool>& useful) {
  const ParameterInfo& info = list_->all[parameter];
  Gene gene{.kind = info.kind,
            .name = info.name,
            .parameters = {parameter},
            .lower = info.shown_low,
            .upper = info.shown_high};
  if (info.kind == ParameterKind::weight) return add_weight(parameter, useful, std::move(gene));
  if (info.kind == ParameterKind::support) gene.start = kSupportStart;
  if (info.of_posture() && !named_) return;
  if (info.kind == ParameterKind::mode) {
    const std::vector<double>& direction = modes_[number_of(info)].direction;
    bool moves = false;
    for (std::size_t d = 0; d < useful.size(); ++d) {
      moves = moves || (useful[d] && direction[d] != 0.0);
    }
    if (!moves) return;
  }
  if (info.kind == ParameterKind::timing) {
    const TimingNumber& number = kTimingNumbers[number_of(info)];
    if (!number.searched && code_ != GeneCode::every) return;
    gene.lower = number.searched_low;
    gene.upper = number.searched_high;
  }
  genes_.push_back(std::move(gene));
}

void ParameterSpace::add_weight(std::size_t parameter, const std::vector<bool>& useful, Gene gene) {
  const std::size_t d = number_of(list_->all[parameter]);
  if (set_[parameter]) gene.parameters.clear();
  gene.lower = -kLogWeightRange;
  gene.upper = kLogWeightRange;
  if (named_) {
    if (!useful[d]) return;
    gene.name = shared_name(body_->dofs()[d]);
    const auto same = [&gene](const Gene& other) { return other.name == gene.name; };
    if (const auto own = std::find_if(genes_.begin(), genes_.end(), same); own != genes_.end()) {
      own->parameters.push_back(parameter);
      return;
    }
    // a dof that yields last must not be among the lightest
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

std::vector<int> ParameterSpace::weights_of(JointKind joint, FreedomKind freedom) const {
  std::vector<int> genes;
  for (const int d : body_->dofs_of(joint, freedom)) {
    const Dof& dof = body_->dof(d);
    const int gene = find(named_ ? shared_name(dof) : dof.name);
    if (gene >= 0 && std::find(genes.begin(), genes.end(), gene) == genes.end()) {
      genes.push_back(gene);
    }
  }
  return genes;
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

// The paper's genes of a point; empty for other codes.
Genome ParameterSpace::genome_of(std::span<const double> point) const {
  return code_ == GeneCode::paper ? genome_of_point(point, kPaperBitsPerGene) : Genome{};
}

Parameters ParameterSpace::decode(std::span<const double> point) const {
  Parameters values = base_;
  const Genome genome = genome_of(point);
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    const bool weight = genes_[g].kind == ParameterKind::weight;
    const double value = genes_[g].at(point[g]);
    for (const std::size_t p : genes_[g].parameters) {
      if (weight && !genome.empty()) values.locked[p] = genome[g] == 0;
      values.values[p] = !weight          ? value
                         : genome.empty() ? exponential(value)
                                          : std::max<double>(genome[g], 1.0);
    }
  }
  return values;
}

std::vector<double> ParameterSpace::encode(const Parameters& values) const {
  SHG_CHECK(code_ != GeneCode::paper, "the paper's codes are not of all weights");
  std::vector<double> point;
  for (const Gene& gene : genes_) point.push_back(clamp(gene.of(value_of(gene, values)), 0.0, 1.0));
  return point;
}

double ParameterSpace::value_of(const Gene& gene, const Parameters& values) const {
  if (gene.kind != ParameterKind::weight) return values.values[gene.parameters[0]];
  double sum = 0.0;
  for (const std::size_t p : gene.parameters) {
    sum += values.locked[p] ? kLogWeightRange : natural_log(values.values[p]);
  }
  return sum / static_cast<double>(gene.parameters.size());
}

MotionInputs ParameterSpace::rows(std::span<const double> points) {
  const std::size_t motions = points.size() / genes_.size();
  for (std::size_t k = 0; k < kRows; ++k) repeat(base_rows_[k], motions, rows_[k]);
  for (std::size_t i = 0; i < motions; ++i) {
    add_to_rows(i, points.subspan(i * genes_.size(), genes_.size()));
  }
  MotionInputs inputs{rows_[kWeights], rows_[kPosture], rows_[kTiming]};
  inputs.supports = rows_[kSupports];
  return inputs;
}

void ParameterSpace::add_to_rows(std::size_t motion, std::span<const double> point) {
  const std::vector<float> genome = inverse_weights_of_genes(genome_of(point));
  for (std::size_t g = 0; g < genes_.size(); ++g) {
    const bool weight = genes_[g].kind == ParameterKind::weight;
    double value = genes_[g].at(point[g]);
    if (weight) value = genome.empty() ? exponential(-value) : genome[g];
    for (const Cell& cell : genes_[g].cells) {
      rows_[cell.row][motion * base_rows_[cell.row].size() + cell.column] +=
          static_cast<float>(value * cell.factor);
    }
  }
}

}  // namespace shigusa
