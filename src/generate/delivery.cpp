// SPDX-License-Identifier: MIT
#include "delivery.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <shigusa/run.hpp>
#include <utility>

#include "candidate.hpp"
#include "core/index.hpp"
#include "distinct.hpp"

namespace shigusa {
namespace {

// Most replays of spare motions for each distance, per missing style and in all, and for each
// motion that the task asks for; chosen, as more of them find little.
constexpr int kTries = 12;
constexpr int kTriesOfOne = 3;
// Those of spare motions that score worse, where few candidates are feasible.
constexpr int kWorseTries = 24;
constexpr int kWorseTriesOfOne = 6;

// Steps of the delivery, by preset.
struct Policy {
  bool by_look = false;      // copies are judged by how they end, not by all frames
  bool asks_free = false;    // colliding motions do not count
  bool asks_smooth = false;  // jolting motions do not count
  bool styles = false;
  bool as_people = false;  // no strange final postures beside a first candidate with a normal one
  int tries = 0;           // spare motions
};

Policy policy_of(const Task& task) {
  if (!traits_of(task.preset).natural) return {};
  if (traits_of(task.preset).layers) {
    return {.by_look = true, .tries = task.candidates};
  }
  return {.by_look = true,
          .asks_free = true,
          .asks_smooth = minds_jolts(task),
          .styles = true,
          .as_people = true,
          .tries = std::min(kTries, kTriesOfOne * task.candidates)};
}

Style end_style(const Candidate& candidate) {
  return style_of(candidate.final_posture.stoop_squat_index);
}

// The motion of a point, played in advance.
struct Ahead {
  Expanded expanded{};
  std::optional<Arrival> arrival{};
  std::optional<Candidate> candidate{};
};

// A replayed motion on its way to a candidate.
struct Replayed {
  Candidate candidate;
  bool as_searched = false;
};

class Delivery {
 public:
  Delivery(const Task& task, Planner& planner, std::size_t approach, const Selection& selection,
           GenerateResult& generation)
      : task_(task),
        policy_(policy_of(task)),
        planner_(planner),
        approach_(approach),
        selection_(selection),
        generation_(generation),
        meter_(task.body, task.home, 0) {}

  void take_picked() {
    std::vector<Ahead> ahead = play_ahead();
    for (std::size_t i = 0; i < selection_.picked.size(); ++i) {
      const Individual& individual = selection_.picked[i];
      if (is_enough()) return;
      Ahead played =
          i < ahead.size() ? std::move(ahead[i]) : play(planner_.expand(individual.point));
      std::optional<Replayed> replayed = replayed_of(std::move(played), false);
      if (replayed) add(std::move(*replayed), individual.score);
    }
  }

  void take_styles() {
    if (!policy_.styles || task_.candidates == 1) return;
    std::array<int, kStyles> tried{};
    for (const Archived& spare : selection_.spare) {
      if (spare.score > selection_.picked.front().score + kStyleSpread) break;
      if (has_free(spare.style)) continue;
      if (tried[static_cast<std::size_t>(spare.style)]++ < policy_.tries) take_spare(spare);
    }
  }

  void take_spares() {
    if (only_hastes()) return;
    int tries = 0;
    for (const Archived& spare : selection_.spare) {
      if (is_enough() || tries >= policy_.tries) break;
      if (spare.score > selection_.picked.front().score + kCandidateSpread) break;
      if (has_like(spare)) continue;
      ++tries;
      take_spare(spare);
    }
    if (policy_.as_people) take_worse();
  }

  // Adds feasible motions with worse scores where fewer than kShownLeast would be shown.
  void take_worse() {
    const int most = std::min(kWorseTries, kWorseTriesOfOne * task_.candidates);
    int tries = 0;
    for (const Archived& spare : selection_.spare) {
      const auto shown =
          static_cast<int>(std::count_if(all().begin(), all().end(), [this](const Candidate& c) {
            return is_free(c) && could_be_made(c);
          }));
      if (shown >= shown_least(task_) || tries >= most) return;
      if (spare.score <= selection_.picked.front().score + kCandidateSpread) continue;
      if (has_like(spare)) continue;
      ++tries;
      take_spare(spare, true);
    }
  }

  // Whether the one motion asked for would do in a longer time, which is free.
  [[nodiscard]] bool only_hastes() const {
    if (!wants_one(task_) || all().empty()) return false;
    Candidate& one = all().front();
    if (collides(one)) return false;
    one.judgement.possible_in = possible_in(one.judgement, task_.body, one.motion, one.measures);
    return could_be_made(one) || one.judgement.possible_in;
  }

  // Number of spare motions that became candidates.
  [[nodiscard]] int taken() const { return taken_; }

 private:
  [[nodiscard]] std::vector<Candidate>& all() const { return generation_.candidates; }
  [[nodiscard]] bool is_free(const Candidate& candidate) const {
    if (policy_.asks_smooth && candidate.measures.sudden.jolts()) return false;
    return !policy_.asks_free || !collides(candidate);
  }
  [[nodiscard]] bool has_free(Style style) const {
    return std::any_of(all().begin(), all().end(), [&](const Candidate& candidate) {
      return is_free(candidate) && end_style(candidate) == style;
    });
  }
  // The looks of the candidates.
  [[nodiscard]] const std::vector<Look>& looks() {
    while (looks_.size() < all().size()) {
      looks_.push_back(meter_.look(all()[looks_.size()].motion.clip));
    }
    return looks_;
  }
  [[nodiscard]] bool has_like(const Archived& archived) {
    return looks_like(archived.look, true, kLookSlack);
  }
  [[nodiscard]] bool is_enough() const {
    return std::count_if(all().begin(), all().end(), [this](const Candidate& candidate) {
             return is_free(candidate);
           }) >= task_.candidates;
  }

  // Whether a look is that of a candidate, or with `of_free` of a free candidate.
  [[nodiscard]] bool looks_like(const Look& look, bool of_free, double slack) {
    const std::vector<Look>& known = looks();
    for (std::size_t k = 0; k < known.size(); ++k) {
      if (of_free && !is_free(all()[k])) continue;
      if (look_alike(known[k], look, slack)) return true;
    }
    return false;
  }
  // Whether a motion copies a candidate, or with `of_free` a free candidate.
  [[nodiscard]] bool is_copy(const Clip& clip, bool of_free) {
    if (policy_.by_look) return looks_like(meter_.look(clip), of_free, 1.0);
    return std::any_of(all().begin(), all().end(), [&](const Candidate& better) {
      return largest_distance(better.motion.clip, clip) < kDistinctPosture;
    });
  }

  [[nodiscard]] Ahead play(Expanded expanded) const {
    Ahead played{.expanded = std::move(expanded)};
    played.arrival = planner_.arrival(played.expanded.values, approach_);
    return played;
  }

  // Plays the first picked points in parallel: as many as the task asks for.
  [[nodiscard]] std::vector<Ahead> play_ahead() {
    const int threads = thread_count(task_.batch.threads);
    if (threads == 1) return {};
    std::vector<Ahead> ahead(std::min(selection_.picked.size(), index(task_.candidates)));
    for (std::size_t i = 0; i < ahead.size(); ++i) {
      ahead[i].expanded = planner_.expand(selection_.picked[i].point);
    }
    parallel_for(static_cast<int>(ahead.size()), threads, [&](int i, int) {
      Ahead& played = ahead[index(i)];
      played = play(std::move(played.expanded));
      // user criteria are called from one thread
      if (!played.arrival || !task_.criteria.user.empty()) return;
      played.candidate = planner_.candidate(played.expanded, *played.arrival);
    });
    return ahead;
  }

  // The motion as a candidate; none if it misses its goals or is a copy.
  std::optional<Replayed> replayed_of(Ahead played, bool of_free) {
    if (!played.arrival) {
      ++generation_.log.missed;
      return std::nullopt;
    }
    if (is_copy(played.arrival->rolled.motion.clip, of_free)) {
      ++generation_.log.near_copies;
      return std::nullopt;
    }
    const bool as_searched = played.arrival->as_searched;
    if (!played.candidate) {
      played.candidate = planner_.candidate(played.expanded, std::move(*played.arrival));
    }
    return Replayed{std::move(*played.candidate), as_searched};
  }

  // Adds a spare motion that does not copy a free candidate: colliding candidates are dropped at
  // the end.
  void take_spare(const Archived& spare, bool possible_ones = false) {
    std::optional<Replayed> replayed = replayed_of(play(planner_.expand(spare.point)), true);
    if (!replayed || !is_free(replayed->candidate)) return;
    if (possible_ones && !could_be_made(replayed->candidate)) return;
    const std::size_t before = all().size();
    add(std::move(*replayed), spare.score);
    if (all().size() > before) ++taken_;
  }

  [[nodiscard]] bool is_odd(const Candidate& candidate) const {
    return policy_.as_people && !all().empty() && is_strange(candidate.final_posture) &&
           !is_strange(all().front().final_posture);
  }

  void add(Replayed replayed, double searched_score) {
    if (is_odd(replayed.candidate)) {
      ++generation_.log.strange;
      return;
    }
    if (replayed.as_searched) {
      // a smoothed motion may score better, never worse
      const double difference = replayed.candidate.score.total - searched_score;
      if (difference > kReplayTolerance) ++generation_.log.replay_differs;
      generation_.log.replay_difference = max(generation_.log.replay_difference, difference);
    }
    all().push_back(std::move(replayed.candidate));
  }

  const Task& task_;
  Policy policy_;
  Planner& planner_;
  std::size_t approach_;
  const Selection& selection_;
  GenerateResult& generation_;
  PostureMeter meter_;
  std::vector<Look> looks_;
  int taken_ = 0;
};

// Drops colliding candidates where some are free, apart from those needed to show `shown`;
// otherwise drops those deeper than the least penetration.
void drop_collisions(int shown, GenerateResult& generation) {
  std::vector<Candidate>& all = generation.candidates;
  if (all.empty()) return;
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& c : all) least = min(least, c.measures.collides.depth);
  const bool some_free = least <= kCollisionDepth;
  const double most = some_free ? kCollisionDepth : least + kCollisionDepth;
  int kept = 0;  // from the best down
  generation.log.collided = static_cast<int>(std::erase_if(all, [&](const Candidate& c) {
    if (c.measures.collides.depth <= most || (some_free && could_be_made(c) && kept < shown)) {
      ++kept;
      return false;
    }
    return true;
  }));
}

// Drops candidates that exceed joint limits, if some candidate does not.
void keep_within_limits(GenerateResult& generation) {
  const auto passes = [](const Candidate& c) { return !c.measures.over_limit.empty(); };
  std::vector<Candidate>& all = generation.candidates;
  if (std::all_of(all.begin(), all.end(), passes)) return;
  generation.log.over_limit = static_cast<int>(std::erase_if(all, passes));
}

// Drops the worst candidates with the words of a better one, apart from those needed to show
// `shown`. Returns their number.
int drop_same_words(int shown, std::vector<Candidate>& all) {
  int dropped = 0;
  for (std::size_t k = all.size(); k-- > 1 && static_cast<int>(all.size()) > shown;) {
    const std::vector<PostureWord> words = words_for(all[k].final_posture);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::none_of(all.begin(), end, [&words](const Candidate& better) {
          return words_for(better.final_posture) == words;
        })) {
      continue;
    }
    all.erase(end);
    ++dropped;
  }
  return dropped;
}

// Drops candidates beyond `most`: impossible ones first, then the worst that shares its style.
void keep_most(std::size_t most, std::vector<Candidate>& all) {
  while (all.size() > most) {
    if (!could_be_made(all.back())) {
      all.pop_back();
      continue;
    }
    const auto is_spare = [&all](const Candidate& c) {
      return std::count_if(all.begin(), all.end(), [&c](const Candidate& other) {
               return end_style(other) == end_style(c);
             }) > 1;
    };
    const auto worst = std::find_if(all.rbegin(), all.rend(), is_spare);
    all.erase(worst == all.rend() ? all.end() - 1 : worst.base() - 1);
  }
}

}  // namespace

bool minds_jolts(const Task& task) {
  const PresetTraits& traits = traits_of(task.preset);
  return traits.natural && !traits.layers && task.criteria[CriterionKind::jolts].weight > 0.0;
}

void drop_jolts(GenerateResult& generation) {
  std::vector<Candidate>& all = generation.candidates;
  const auto jolts = [](const Candidate& c) { return c.measures.sudden.jolts(); };
  const bool some = std::any_of(all.begin(), all.end(),
                                [&](const Candidate& c) { return !jolts(c) && could_be_made(c); });
  if (some) generation.log.jolting += static_cast<int>(std::erase_if(all, jolts));
}

void deliver_candidates(const Task& task, Planner& planner, std::size_t approach, Found found,
                        GenerateResult& generation) {
  generation.log.missed = generation.log.over_limit = generation.log.replay_differs = 0;
  generation.log.strange = generation.log.jolting = 0;
  generation.log.replay_difference = 0.0;
  Selection& selection = found.selection;
  Delivery delivery(task, planner, approach, selection, generation);
  delivery.take_picked();
  delivery.take_styles();
  delivery.take_spares();
  // scores may differ on an earlier approach than the one searched
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(), ranks_of(task));
  int same = 0;
  if (traits_of(task.preset).natural) {
    traits_of(task.preset).layers ? keep_within_limits(generation)
                                  : drop_collisions(shown_least(task), generation);
    if (minds_jolts(task)) drop_jolts(generation);
    // who asks for more than usual wants all that look different
    if (!traits_of(task.preset).layers && task.candidates <= traits_of(task.preset).candidates) {
      same = drop_same_words(shown_least(task), generation.candidates);
    }
  }
  PostureMeter meter(task.body, task.home, 0);
  std::vector<Look> looks;
  for (const Candidate& c : generation.candidates) looks.push_back(meter.look(c.motion.clip));
  selection.similar = same + count_similar(selection, looks, delivery.taken());
  keep_most(static_cast<std::size_t>(task.candidates), generation.candidates);
  generation.fewer = why_fewer(task, generation, selection);
}

}  // namespace shigusa
