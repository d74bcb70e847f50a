// SPDX-License-Identifier: MIT
#include "work/sum_scores.hpp"

#include <algorithm>
#include <utility>

namespace shigusa {

void add_score(const Score& score, double seconds, Score& sum) {
  sum.total += seconds * score.total;
  for (const ScoreTerm& term : score.terms) {
    const auto same = [&term](const ScoreTerm& other) { return other.name == term.name; };
    auto at = std::find_if(sum.terms.begin(), sum.terms.end(), same);
    if (at == sum.terms.end()) at = sum.terms.insert(at, {term.name, term.weight, 0.0});
    at->penalty += seconds * term.penalty;
  }
}

void end_score(double seconds, Score& sum) {
  if (!(seconds > 0.0)) return;
  sum.total /= seconds;
  for (ScoreTerm& term : sum.terms) term.penalty /= seconds;
}

void add_judgement(const Judgement& judgement, double start, Judgement& all) {
  all.verdict = std::max(all.verdict, judgement.verdict);
  for (Reason reason : judgement.reasons) {
    if (reason.time) *reason.time += start;
    all.reasons.push_back(std::move(reason));
  }
  std::stable_sort(all.reasons.begin(), all.reasons.end(),
                   [](const Reason& a, const Reason& b) { return a.verdict > b.verdict; });
}

}  // namespace shigusa
