// SPDX-License-Identifier: MIT
#include "measure.hpp"

#include <shigusa/generate.hpp>

namespace shigusa::bench {
namespace {

constexpr double kNotReached = 3.0;
// Number of terms at which a rule has half the weight of one with many, as chance affects it more.
constexpr double kFewTerms = 6.0;

// Figures of the best motion of a case.
Figures best_of(const Case& of, const CriteriaSettings& mixture, std::uint64_t seed,
                std::optional<int> motions) {
  Task task = of.task;
  task.criteria = mixture;
  task.candidates = 1;
  task.seed = seed;
  task.evaluations = motions;
  task.batch.threads = 1;
  const auto made = generate(task);
  if (!made || made->candidates.empty()) return {.hard = kNotReached};
  const Candidate& best = made->candidates.front();
  Figures figures = figures_of(task.body, best.motion, of.side);
  figures.hard = made->meets_goals() ? static_cast<double>(best.judgement.verdict) : kNotReached;
  return figures;
}

Measured summed(std::span<const Unit* const> units, const Figures* figures) {
  Measured sum;
  sum.rules.resize(rule_names().size());
  double cases = 0.0;
  for (const Unit* unit : units) {
    const std::span<const Figures> of(figures, unit->cases.size());
    figures += unit->cases.size();
    for (const Figures& f : of) sum.jolting += f.jolt > 1.0 ? 1.0 : 0.0;
    cases += static_cast<double>(of.size());
    for (const Term& term : terms_of(*unit, of)) {
      RuleResult& rule = sum.rules[term.rule];
      rule.terms += 1;
      rule.held += term.off <= 0.0 ? 1 : 0;
      rule.value += term.value;
      rule.loss += loss_of(term);
    }
  }
  sum.jolting /= max(cases, 1.0);
  double rules = 0.0;
  for (RuleResult& rule : sum.rules) {
    if (rule.terms == 0) continue;
    rule.value /= rule.terms;
    rule.loss /= rule.terms;
    const double weight = rule.terms / (rule.terms + kFewTerms);
    sum.loss += weight * rule.loss;
    rules += weight;
  }
  sum.loss /= max(rules, 1.0);
  return sum;
}

}  // namespace

std::vector<Figures> best_figures(std::span<const Unit* const> units,
                                  std::span<const CriteriaSettings> mixtures,
                                  const MeasureSettings& settings) {
  std::vector<const Case*> cases;
  for (const Unit* unit : units) {
    for (const Case& each : unit->cases) cases.push_back(&each);
  }
  std::vector<Figures> figures(cases.size() * mixtures.size());
  parallel_for(static_cast<int>(figures.size()), settings.threads, [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    const std::size_t c = k % cases.size();
    figures[k] =
        best_of(*cases[c], mixtures[k / cases.size()], settings.seed + c, settings.motions);
  });
  return figures;
}

std::vector<Measured> measure(std::span<const Unit* const> units,
                              std::span<const CriteriaSettings> mixtures,
                              const MeasureSettings& settings) {
  const std::vector<Figures> figures = best_figures(units, mixtures, settings);
  const std::size_t cases = figures.size() / std::max<std::size_t>(mixtures.size(), 1);
  std::vector<Measured> all;
  for (std::size_t m = 0; m < mixtures.size(); ++m) {
    all.push_back(summed(units, figures.data() + m * cases));
  }
  return all;
}

std::vector<const Unit*> part_of(const std::vector<Unit>& units, bool held_out) {
  std::vector<const Unit*> part;
  for (const Unit& unit : units) {
    if (unit.held_out == held_out) part.push_back(&unit);
  }
  return part;
}

}  // namespace shigusa::bench
