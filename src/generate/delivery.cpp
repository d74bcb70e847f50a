// SPDX-License-Identifier: MIT
#include "delivery.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "candidate.hpp"
#include "choice.hpp"
#include "ways.hpp"

namespace shigusa {
namespace {

// Replays of what is spare, of each style that is lacking and of all together, so far apart each.
constexpr int kTries = 12;

bool is_free(const Candidate& candidate) {
  return candidate.measures.collides.depth <= kCollisionDepth;
}

Style bends(const Candidate& candidate) {
  return style_of(candidate.final_posture.stoop_squat_index);
}

struct Replayed {
  Candidate candidate;
  bool as_searched = false;  // on the way that was searched, which was in single precision
};

// Takes replays in, one by one.
class Delivery {
 public:
  Delivery(const Task& task, std::span<const ReachProblem> ways, const Searched& searched,
           Generation& generation)
      : task_(task), ways_(ways), searched_(searched), generation_(generation) {}

  void take(const Individual& individual) {
    add(replay(individual, kDistinctEnd, [](const Candidate&) { return true; }), individual.score);
  }

  // Takes it if it passes through nothing. What passes through something hinders none that ends
  // alike, as it is left out in the end. Whether it was taken.
  bool take_free(const Archived& archived, double apart) {
    std::optional<Replayed> replayed = replay({archived.point, archived.score}, apart, is_free);
    if (!replayed || !is_free(replayed->candidate)) return false;
    add(std::move(replayed), archived.score);
    return true;
  }

  // Whether one that passes through nothing ends alike.
  [[nodiscard]] bool has_like(const Archived& archived, double apart) const {
    return std::any_of(all().begin(), all().end(), [&archived, apart](const Candidate& c) {
      return is_free(c) && ends_like(c, archived, apart);
    });
  }

  // candidates that pass through nothing; the paper does not ask
  [[nodiscard]] int free() const {
    return static_cast<int>(std::count_if(
        all().begin(), all().end(), [this](const Candidate& c) { return paper() || is_free(c); }));
  }

  [[nodiscard]] bool has_free(Style style) const {
    return std::any_of(all().begin(), all().end(),
                       [style](const Candidate& c) { return is_free(c) && bends(c) == style; });
  }

 private:
  [[nodiscard]] const std::vector<Candidate>& all() const { return generation_.candidates; }
  [[nodiscard]] bool paper() const { return task_.preset == Preset::paper; }

  // None if it misses, or is a copy of one that counts.
  template <class Counts>
  std::optional<Replayed> replay(const Individual& individual, double apart, Counts&& counts) {
    const Parameters parameters = searched_.space().decode(individual.point);
    std::optional<Arrival> arrival = first_arrival(ways_, parameters, task_.generator);
    if (!arrival) {
      ++generation_.missed;
      return std::nullopt;
    }
    const Clip& clip = arrival->rolled.motion.clip;
    const auto is_copy = [&](const Candidate& better) {
      if (!counts(better)) return false;
      return paper() ? largest_distance(better.motion.clip, clip) < kDistinctPosture
                     : final_distance(better.motion.clip, clip) < apart;
    };
    if (std::any_of(all().begin(), all().end(), is_copy)) {
      ++generation_.near_copies;
      return std::nullopt;
    }
    const bool as_searched = arrival->way == &ways_.back();
    return Replayed{make_candidate(task_, *arrival->way, parameters, std::move(arrival->rolled)),
                    as_searched};
  }

  void add(std::optional<Replayed> replayed, double searched_score) {
    if (!replayed) return;
    if (replayed->as_searched) {
      const double difference = abs(replayed->candidate.score.total - searched_score);
      if (difference > kReplayTolerance) ++generation_.replay_differs;
      generation_.replay_difference = max(generation_.replay_difference, difference);
    }
    generation_.candidates.push_back(std::move(replayed->candidate));
  }

  const Task& task_;
  std::span<const ReachProblem> ways_;
  const Searched& searched_;
  Generation& generation_;
};

// Where a motion passes through nothing, those that do are left out; else those that are deeper in
// than the least.
void drop_collisions(Generation& generation) {
  std::vector<Candidate>& all = generation.candidates;
  if (all.empty()) return;
  const auto shallower = [](const Candidate& a, const Candidate& b) {
    return a.measures.collides.depth < b.measures.collides.depth;
  };
  const double least = std::min_element(all.begin(), all.end(), shallower)->measures.collides.depth;
  const double most = least <= kCollisionDepth ? kCollisionDepth : least + kCollisionDepth;
  generation.collided = static_cast<int>(
      std::erase_if(all, [most](const Candidate& c) { return c.measures.collides.depth > most; }));
}

// Of too many, what is impossible goes first, then the worst that is not the only one of its style.
void keep_most(std::size_t most, std::vector<Candidate>& all) {
  while (all.size() > most) {
    if (all.back().judgement.verdict == Verdict::impossible) {
      all.pop_back();
      continue;
    }
    const auto is_spare = [&all](const Candidate& c) {
      return std::count_if(all.begin(), all.end(),
                           [&c](const Candidate& other) { return bends(other) == bends(c); }) > 1;
    };
    const auto worst = std::find_if(all.rbegin(), all.rend(), is_spare);
    all.erase(worst == all.rend() ? all.end() - 1 : worst.base() - 1);
  }
}

}  // namespace

void deliver_candidates(const Task& task, std::span<const ReachProblem> ways,
                        const Searched& searched, const SearchResult& found,
                        Generation& generation) {
  const bool paper = task.preset == Preset::paper;
  Choice choice = paper ? Choice{.picked = ranked_population(found)}
                        : distinct_postures(searched.archive(), 4 * task.candidates);
  Delivery delivery(task, ways, searched, generation);
  for (const Individual& individual : choice.picked) {
    if (delivery.free() >= task.candidates) break;
    delivery.take(individual);
  }
  int taken = 0;  // of what is spare
  std::array<int, kStyles> tried{};
  for (const Archived& spare : choice.spare) {
    if (delivery.has_free(spare.style)) continue;
    if (tried[static_cast<std::size_t>(spare.style)]++ < kTries) {
      taken += delivery.take_free(spare, kDistinctEnd) ? 1 : 0;
    }
  }
  for (const double apart : {kDistinctEnd, kNearEnd}) {
    int others = 0;
    for (const Archived& spare : choice.spare) {
      if (delivery.free() >= task.candidates || others >= kTries) break;
      if (spare.score > choice.picked.front().score + kCandidateSpread) break;
      if (delivery.has_like(spare, apart)) continue;
      ++others;
      taken += delivery.take_free(spare, apart) ? 1 : 0;
    }
  }
  // on an earlier way than they were searched on, motions may have other scores
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(), ranks_before);
  if (!paper) drop_collisions(generation);
  choice.similar = count_similar(choice, generation.candidates, taken);
  keep_most(static_cast<std::size_t>(task.candidates), generation.candidates);
  generation.fewer = why_fewer(task, generation, choice);
}

}  // namespace shigusa
