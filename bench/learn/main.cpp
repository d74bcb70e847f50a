// SPDX-License-Identifier: MIT
// shigusa_learn_criteria searches the mixture of criteria whose best motions obey most of what is
// measured of people, and prints it.
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <string_view>

#include "measure.hpp"
#include "mixture.hpp"
#include "search/cma_es.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_learn_criteria SHARED_FOLDER [--evaluations N] [--seed N] [--threads N]\n"
    "         [--step X] [--scales] [--only-measure] [--list] [--weights "
    "NAME=VALUE,NAME.scale=VALUE,…]\n"
    "         [--goals N]\n"
    "Weights that are given stand in place of the default's, or are what the search begins at.\n";
// The queries of the last comparison have other random numbers than those of the search.
constexpr std::uint64_t kOtherSeed = 1000;

struct Options {
  std::string shared;
  int evaluations = 320;
  std::uint64_t seed = 0;
  std::uint64_t goals = 1;
  int threads = 0;
  double step = 0.12;
  bool scales = false;
  bool only_measure = false;
  bool list = false;  // each term that is out of its band
  CriteriaSettings start = default_criteria();
};

template <class T>
bool read(std::string_view text, T& value) {
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc{} && read.ptr == end;
}

std::optional<Options> options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    const std::string_view value = i + 1 < argc ? argv[i + 1] : "";
    bool good = true;
    if (name == "--only-measure") {
      options.only_measure = true;
    } else if (name == "--list") {
      options.only_measure = options.list = true;
    } else if (name == "--scales") {
      options.scales = true;
    } else if (!name.starts_with("--")) {
      options.shared = name;
    } else {
      ++i;
      if (name == "--evaluations")
        good = read(value, options.evaluations) && options.evaluations > 0;
      else if (name == "--seed")
        good = read(value, options.seed);
      else if (name == "--goals")
        good = read(value, options.goals);
      else if (name == "--threads")
        good = read(value, options.threads) && options.threads >= 0;
      else if (name == "--step")
        good = read(value, options.step);
      else if (name == "--weights")
        good = set_weights(value, options.start).has_value();
      else
        good = false;
    }
    if (!good) return {};
  }
  return options.shared.empty() ? std::nullopt : std::optional(std::move(options));
}

// The mixture of the least training loss that a search comes upon, or the middle of its last
// points, which no chance has chosen.
CriteriaSettings learned(const std::vector<Unit>& units, const Options& options) {
  const auto train = part_of(units, false);
  const auto held = part_of(units, true);
  const MixtureSpace space(options.start, options.scales);
  const auto genes = static_cast<std::size_t>(space.genes());
  double least = 1e300;
  int scored = 0;
  SearchProblem problem;
  problem.genes = space.genes();
  problem.start = space.point(options.start);
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    std::vector<CriteriaSettings> mixtures;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      mixtures.push_back(space.mixture(points.subspan(i * genes, genes)));
    }
    const auto all = measure(train, mixtures, {options.threads, options.seed});
    for (std::size_t i = 0; i < scores.size(); ++i) {
      ++scored;
      scores[i] = all[i].loss;
      if (scores[i] >= least) continue;
      least = scores[i];
      const auto out = measure(held, {&mixtures[i], 1}, {options.threads, options.seed});
      std::cout << fmt::format("{} training {:.4f} held out {:.4f} jolting {:.2f} {}\n", scored,
                               least, out[0].loss, all[i].jolting, weights_text(mixtures[i]))
                << std::flush;
    }
  };
  const CmaEsSettings settings{
      .evaluations = options.evaluations, .step = options.step, .seed = options.seed};
  const SearchResult found = cma_es_search(problem, settings);
  std::vector<double> middle(genes);
  const std::size_t last = std::min<std::size_t>(found.final_population.size(), 16);
  for (std::size_t i = found.final_population.size() - last; i < found.final_population.size();
       ++i) {
    for (std::size_t g = 0; g < genes; ++g) {
      middle[g] += found.final_population[i].point[g] / static_cast<double>(last);
    }
  }
  const CriteriaSettings two[] = {space.mixture(found.best_seen.point), space.mixture(middle)};
  const auto again = measure(train, two, {options.threads, options.seed + kOtherSeed});
  std::cout << fmt::format("best seen {:.4f}, middle {:.4f}\n", again[0].loss, again[1].loss);
  return again[1].loss < again[0].loss ? two[1] : two[0];
}

std::string part_of_row(const RuleResult& rule) {
  if (rule.terms == 0) return fmt::format("{:>8} {:>5} {:>6}", "", "", "");
  return fmt::format("{:>8.2f} {:>4.0f}% {:>6.3f}", rule.value, 100.0 * rule.held / rule.terms,
                     rule.loss);
}

// Each figure and order that is not as people's are.
void list_terms(const std::vector<Unit>& units, const Options& options) {
  for (const Unit& unit : units) {
    const Unit* one[] = {&unit};
    const auto figures = best_figures(one, {&options.start, 1}, {options.threads, options.seed});
    for (const Term& term : terms_of(unit, figures)) {
      if (term.off <= 0.0) continue;
      const Case& at = unit.cases[term.at];
      std::cout << fmt::format(
          "{:38} {:.2f} up {:.2f} ahead, rise {:5.2f}: {} {:.2f} off by {:.1f}\n", unit.name,
          at.height, at.ahead, at.rise, rule_names()[term.rule].name, term.value, term.off);
    }
  }
}

// For each rule the mean figure, the share of motions in the band, and the loss.
void print_table(const std::vector<Unit>& units, const std::vector<CriteriaSettings>& mixtures,
                 const MeasureSettings& settings) {
  std::vector<Measured> columns;
  for (const bool held_out : {false, true}) {
    const auto part = part_of(units, held_out);
    for (Measured& m : measure(part, mixtures, settings)) columns.push_back(std::move(m));
  }
  std::cout << fmt::format("{:30} {:10} figure, held, loss: {}\n", "rule", "source",
                           mixtures.size() > 1 ? "training before, after; held out before, after"
                                               : "training; held out");
  for (std::size_t r = 0; r < rule_names().size(); ++r) {
    std::cout << fmt::format("{:30} {:10.10}", rule_names()[r].name, rule_names()[r].source);
    for (const Measured& m : columns) std::cout << " |" << part_of_row(m.rules[r]);
    std::cout << "\n";
  }
  std::cout << fmt::format("{:41}", "all");
  for (const Measured& m : columns) {
    std::cout << fmt::format(" |  jolts {:>3.0f}%  {:.4f} ", 100.0 * m.jolting, m.loss);
  }
  std::cout << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = options_of(argc, argv);
  if (!options) {
    std::cerr << kUsage;
    return 2;
  }
  std::vector<Unit> units = made_units(options->goals);
  for (Unit& unit : recorded_units(options->shared)) units.push_back(std::move(unit));
  std::size_t cases = 0;
  for (const Unit& unit : units) cases += unit.cases.size();
  std::cout << fmt::format("{} tasks in {} units, {} of them held out\n", cases, units.size(),
                           part_of(units, true).size());
  if (options->only_measure) {
    print_table(units, {options->start}, {options->threads, options->seed + kOtherSeed});
    if (options->list) list_terms(units, *options);
    return 0;
  }
  const CriteriaSettings found = learned(units, *options);
  print_table(units, {options->start, found}, {options->threads, options->seed + kOtherSeed});
  std::cout << "\n"
            << weights_code(found) << "\n"
            << weights_text(found) << "\n\n"
            << weights_json(found) << "\n";
  return 0;
}
