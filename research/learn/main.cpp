// SPDX-License-Identifier: MIT
// shigusa_learn_criteria searches the mixture of criteria whose best motions agree best with
// measurements of people, and prints it.
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <string_view>

#include "learner.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_learn_criteria SHARED_FOLDER [--evaluations N] [--seed N] [--threads N]\n"
    "         [--step X] [--scales] [--only-measure] [--list] [--weights "
    "NAME=VALUE,NAME.scale=VALUE,…]\n"
    "         [--goals N] [--motions N]\n"
    "Weights that are given stand in place of the default's, or are what the search begins at.\n";
struct Options {
  std::string shared;
  std::uint64_t goals = 1;
  LearnSettings learn{};
  bool only_measure = false;
  bool list = false;  // each term that is out of its band
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
    MeasureSettings& measure = options.learn.measure;
    const std::string_view value = i + 1 < argc ? argv[i + 1] : "";
    bool good = true;
    if (name == "--only-measure") {
      options.only_measure = true;
    } else if (name == "--list") {
      options.only_measure = options.list = true;
    } else if (name == "--scales") {
      options.learn.scales = true;
    } else if (!name.starts_with("--")) {
      options.shared = name;
    } else {
      ++i;
      if (name == "--evaluations")
        good = read(value, options.learn.evaluations) && options.learn.evaluations > 0;
      else if (name == "--seed")
        good = read(value, measure.seed);
      else if (name == "--goals")
        good = read(value, options.goals);
      else if (name == "--threads")
        good = read(value, measure.threads) && measure.threads >= 0;
      else if (name == "--motions")
        good = read(value, measure.motions.emplace()) && *measure.motions >= kPaperPopulation;
      else if (name == "--step")
        good = read(value, options.learn.step);
      else if (name == "--weights")
        good = set_weights(value, options.learn.start).has_value();
      else
        good = false;
    }
    if (!good) return {};
  }
  return options.shared.empty() ? std::nullopt : std::optional(std::move(options));
}

std::string part_of_row(const RuleResult& rule) {
  if (rule.terms == 0) return fmt::format("{:>8} {:>5} {:>6}", "", "", "");
  return fmt::format("{:>8.2f} {:>4.0f}% {:>6.3f}", rule.value, 100.0 * rule.held / rule.terms,
                     rule.loss);
}

// Prints each figure and order that differs from people's.
void list_terms(const std::vector<Unit>& units, const Options& options) {
  for (const Unit& unit : units) {
    const Unit* one[] = {&unit};
    const auto figures = best_figures(one, {&options.learn.start, 1}, options.learn.measure);
    for (const Term& term : terms_of(unit, figures)) {
      if (term.off <= 0.0) continue;
      const Case& at = unit.cases[term.at];
      std::cout << fmt::format(
          "{:38} {:.2f} up {:.2f} ahead, rise {:5.2f}: {} {:.2f} off by {:.1f}\n", unit.name,
          at.height, at.ahead, at.rise, rule_names()[term.rule].name, term.value, term.off);
    }
  }
}

// Prints for each rule the mean figure, the share of motions in the band, and the loss.
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
    print_table(units, {options->learn.start}, other_seed(options->learn.measure));
    if (options->list) list_terms(units, *options);
    return 0;
  }
  const CriteriaSettings found = learned(units, options->learn);
  print_table(units, {options->learn.start, found}, other_seed(options->learn.measure));
  std::cout << "\n"
            << weights_code(found) << "\n"
            << weights_text(found) << "\n\n"
            << weights_json(found) << "\n";
  return 0;
}
