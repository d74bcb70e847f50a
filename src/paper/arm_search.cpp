// SPDX-License-Identifier: MIT
#include "paper/arm_search.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace shigusa {
namespace {

constexpr int kCodes = 16;

// Codes allowed for each gene.
using Choices = std::array<std::vector<std::uint8_t>, kArmDofs>;

// Whether a genome is worth scoring: only ratios of weights count, and a hand's position takes
// three dofs.
bool worth_trying(const ArmGenes& genes) {
  const auto locked = std::count(genes.begin(), genes.end(), 0);
  int divisor = 0;
  for (const std::uint8_t gene : genes) divisor = std::gcd(divisor, static_cast<int>(gene));
  return locked <= 1 && divisor == 1;
}

std::vector<ArmGenes> combinations(const Choices& choices) {
  std::vector<ArmGenes> all;
  for (const std::uint8_t a : choices[0]) {
    for (const std::uint8_t b : choices[1]) {
      for (const std::uint8_t c : choices[2]) {
        for (const std::uint8_t d : choices[3]) {
          if (worth_trying({a, b, c, d})) all.push_back({a, b, c, d});
        }
      }
    }
  }
  return all;
}

// All genomes with codes that differ by at most one.
std::vector<ArmGenes> neighbours_of(const ArmGenes& genes) {
  Choices near;
  for (std::size_t k = 0; k < genes.size(); ++k) {
    const int gene = genes[k];
    for (int code = std::max(gene - 1, 0); code <= std::min(gene + 1, kCodes - 1); ++code) {
      near[k].push_back(static_cast<std::uint8_t>(code));
    }
  }
  return combinations(near);
}

// Replaces `best` by the best of the genomes if that is better.
bool improve(FoundArm& best, std::span<const ArmGenes> genomes, const ArmEvaluation& evaluate) {
  std::vector<double> scores(genomes.size(), best.score);
  evaluate(genomes, scores);
  bool better = false;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    if (!(scores[i] < best.score)) continue;
    best = {genomes[i], scores[i]};
    better = true;
  }
  return better;
}

}  // namespace

ArmWeights arm_weights(const ArmGenes& genes) {
  ArmWeights weights;
  for (std::size_t k = 0; k < genes.size(); ++k) {
    weights[k] =
        genes[k] == 0 ? JointWeight{1.0, true} : JointWeight{static_cast<double>(genes[k]), false};
  }
  return weights;
}

std::optional<FoundArm> search_arm(LimbSearch search, double worst, const ArmEvaluation& evaluate) {
  std::vector<std::uint8_t> codes(kLimbLadder.begin(), kLimbLadder.end());
  if (search == LimbSearch::enumeration) {
    codes.resize(kCodes);
    std::iota(codes.begin(), codes.end(), std::uint8_t{0});
  }
  FoundArm best{.genes = {}, .score = worst};
  if (!improve(best, combinations({codes, codes, codes, codes}), evaluate)) return std::nullopt;
  if (search == LimbSearch::ladder) {
    while (improve(best, neighbours_of(best.genes), evaluate)) {
    }
  }
  return best;
}

}  // namespace shigusa
