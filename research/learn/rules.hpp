// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases.hpp"

// Rules that people's figures obey. Sources are those of shared/people/people.md.
namespace shigusa::bench {

// Range of a figure among people.
struct Band {
  double low;
  double high;
};

// Distance of one figure, or of an order of figures, from people's.
struct Term {
  std::size_t rule;    // in rule_names()
  double value;        // the figure, or the violation of the order
  double off;          // units outside the band, ≥ 0
  std::size_t at = 0;  // the case; 0 of orders
};

// Names and sources of all rules: bands first, then orders, then recorded reaches.
struct RuleName {
  std::string name;
  std::string source;
};
[[nodiscard]] const std::vector<RuleName>& rule_names();

// All terms of a unit, from the figures of its cases' best motions.
[[nodiscard]] std::vector<Term> terms_of(const Unit& unit, std::span<const Figures> figures);

// Loss off² / (1 + off²), which saturates far from the band.
[[nodiscard]] double loss_of(const Term& term);

}  // namespace shigusa::bench
