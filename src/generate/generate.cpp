// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <shigusa/generate.hpp>
#include <tuple>
#include <utility>

#include "candidate.hpp"
#include "conflict.hpp"
#include "core/say.hpp"
#include "delivery.hpp"
#include "joint_progress.hpp"
#include "pareto.hpp"
#include "planner.hpp"
#include "reflection.hpp"
#include "task/make_problem.hpp"
#include "task/mirror_request.hpp"
#include "task/plan_of.hpp"

namespace shigusa {
namespace {

// Searches on one approach, and delivers the candidates.
void search_best(const Task& task, Planner& planner, std::size_t approach, const Progress& progress,
                 GenerateResult& generation) {
  Found found = planner.search(task, approach, progress);
  add_counts(found.result, generation);
  generation.best_seen = found.best_seen;
  generation.best_seen_score = found.best_seen_score;
  deliver_candidates(task, planner, approach, std::move(found), generation);
}

// The one candidate that given values make.
Candidate only_candidate(const Planner& planner, const Parameters& values) {
  return planner.candidate({.values = values}, planner.nearest(values));
}

void finish(const Task& task, bool in_reach, GenerateResult& generation) {
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(), ranks_of(task));
  const Candidate& best = generation.candidates.front();
  const bool met = in_reach && miss_of(best) <= kReachTolerance;
  generation.status = status_of(met, generation.candidates);
  if (met) return;
  double squares = 0.0;
  for (const GoalResult& goal : best.goals) {
    squares += goal.error * goal.error;
    generation.remaining_turn = max(generation.remaining_turn, goal.turn.error.value_or(0.0));
  }
  generation.remaining_distance = sqrt(squares);
}

// Fails where the task asks for something that its preset does not know.
Result<void> check_choices(const Task& task) {
  const auto wrong = [&](const Message& what) {
    return fail(ErrorCode::invalid_argument, say("preset_cannot", word_of(task.preset), what));
  };
  if (task.pareto && task.preset != Preset::flat) return wrong(say("no_pareto"));
  if (!task.starts.empty() && task.preset != Preset::flat) return wrong(say("no_starts"));
  if (!traits_of(task.preset).layers) return {};
  if (task.generator != MotionGenerator::weighted_ik) return wrong(say("weighted_ik_only"));
  if (task.own_search) return wrong(say("no_own_search"));
  for (const Goal& goal : task.goals) {
    const auto index = task.body.find_effector(goal.effector);
    if (!index || *index < static_cast<int>(task.body.effectors().size())) continue;
    return wrong(say("hands_only"));
  }
  if (task.contacts) return wrong(say("feet_kept"));
  return {};
}

// The approaches that are searched, one after the other.
struct Approaches {
  std::size_t first = 0;
  // all of them, unless the first leads to something possible; else until something arrives
  bool all = false;
};

bool has_possible(const GenerateResult& generation) {
  return status_of(true, generation.candidates) == ReachStatus::reached;
}

// Whether the best of one approach's candidates is better than another's, possible ones first.
bool is_better(const GenerateResult& one, const GenerateResult& other) {
  if (other.candidates.empty()) return true;
  if (one.candidates.empty()) return false;
  if (has_possible(one) != has_possible(other)) return has_possible(one);
  return one.candidates.front().score.total < other.candidates.front().score.total;
}

// Adds another approach's search, and takes its candidates where they are better.
void add_approach(GenerateResult other, GenerateResult& generation) {
  other.evaluations += generation.evaluations;
  other.rejected_nan += generation.rejected_nan;
  if (is_better(other, generation)) {
    generation = std::move(other);
    return;
  }
  generation.evaluations = other.evaluations;
  generation.rejected_nan = other.rejected_nan;
  generation.end = other.end;
}

// Searches on approaches until something arrives: where the first does it, as nearly always, that
// is all.
void search_approaches(const Task& task, Planner& planner, const Approaches& approaches,
                       JointProgress& progress, GenerateResult& generation) {
  const auto search = task.pareto ? search_front : search_best;
  for (std::size_t k = approaches.first; k < planner.approaches(); ++k) {
    GenerateResult other;
    other.duration = generation.duration;
    search(task, planner, k, progress.part(1.0), other);
    add_approach(std::move(other), generation);
    if (generation.end == SearchEnd::cancelled) return;
    if (generation.candidates.empty()) continue;
    if (!approaches.all || (k == 0 && has_possible(generation))) return;
  }
}

// Where nothing arrives by the first posture at the edge of reach, this number of others is tried.
constexpr int kOtherPostures = 3;

// The paper has a person choose from this many distinct candidates (section 4.1).
constexpr int kPaperCandidates = 3;

// Whether the search of a task begins again with other random numbers: of the preset paper, of
// whose genetic algorithm one run often ends with all genomes alike, where the task does not say
// how many motions are scored; until there are kPaperCandidates candidates, or as many as the task
// asks for, or Task::most_runs are done.
bool runs_again(const Task& task, const GenerateResult& generation) {
  if (task.preset != Preset::paper || task.evaluations || task.own_search) return false;
  if (task.search.value_or(SearchMethod::paper_ga) != SearchMethod::paper_ga) return false;
  if (generation.end == SearchEnd::cancelled || generation.runs >= task.most_runs) return false;
  return static_cast<int>(generation.candidates.size()) < min(kPaperCandidates, task.candidates);
}

// Adds the candidates of another run, but for those that move as one that is there does.
void take_in(std::vector<Candidate> candidates, GenerateResult& generation) {
  std::vector<Candidate>& all = generation.candidates;
  for (Candidate& candidate : candidates) {
    const bool is_copy = std::any_of(all.begin(), all.end(), [&candidate](const Candidate& other) {
      return largest_distance(other.motion.clip, candidate.motion.clip) < kDistinctPosture;
    });
    if (is_copy) {
      ++generation.near_copies;
    } else {
      all.push_back(std::move(candidate));
    }
  }
}

// Adds another run to the result.
void add_run(const Task& task, GenerateResult run, GenerateResult& generation) {
  ++generation.runs;
  generation.evaluations += run.evaluations;
  generation.generations += run.generations;
  generation.rejected_nan += run.rejected_nan;
  generation.near_copies += run.near_copies;
  generation.missed += run.missed;
  generation.replay_differs += run.replay_differs;
  generation.replay_difference = max(generation.replay_difference, run.replay_difference);
  generation.end = run.end;
  if (run.best_seen_score < generation.best_seen_score) {
    generation.best_seen = std::move(run.best_seen);
    generation.best_seen_score = run.best_seen_score;
  }
  take_in(std::move(run.candidates), generation);
  std::vector<Candidate>& all = generation.candidates;
  std::stable_sort(all.begin(), all.end(), ranks_of(task));
  const auto most = static_cast<std::size_t>(task.candidates);
  if (all.size() > most) all.erase(all.begin() + task.candidates, all.end());
  generation.fewer = {};
  if (all.size() == most) return;
  generation.fewer = say("fewer_runs", all.size(), task.candidates, generation.runs);
}

// Searches once; `on_all`: on all approaches where the first leads to nothing possible.
Result<GenerateResult> search_task(const PreparedTask& task, const Progress& progress,
                                   bool on_all = false) {
  SHG_TRY_ASSIGN(const std::unique_ptr<Planner> made, make_planner(task));
  Planner& planner = *made;
  SHG_TRY(planner.check_search());
  GenerateResult generation;
  generation.duration = planner.duration();
  JointProgress joint(progress);
  search_approaches(task, planner, {.all = on_all}, joint, generation);
  for (int other = 1; other <= kOtherPostures && planner.in_reach(); ++other) {
    if (!generation.candidates.empty() || generation.end == SearchEnd::cancelled) break;
    if (planner.go_by_other_posture(other)) {
      search_approaches(task, planner, {.first = 1}, joint, generation);
    }
  }
  planner.go_by_other_posture(0);
  Task other = task;
  while (planner.in_reach() && runs_again(task, generation)) {
    other.genetic.stream = static_cast<std::uint64_t>(generation.runs);
    GenerateResult run;
    search_approaches(other, planner, {}, joint, run);
    add_run(task, std::move(run), generation);
  }
  if (generation.candidates.empty()) {
    generation.candidates.push_back(only_candidate(planner, start_values(planner.plan())));
  }
  finish(task, planner.in_reach(), generation);
  planner.finish(generation);
  return generation;
}

// The least duration (s) in which a candidate is possible that is not so only for its haste.
std::optional<double> possible_duration(const GenerateResult& generation) {
  std::optional<double> least;
  for (const Candidate& candidate : generation.candidates) {
    const std::optional<double>& own = candidate.judgement.possible_in;
    if (own && (!least || *own < *least)) least = own;
  }
  return least;
}

// The candidate of values, by another posture at the edge of reach where the usual one misses.
Candidate played(Planner& planner, const Parameters& values) {
  Candidate best = only_candidate(planner, values);
  bool other_postures = false;
  for (int other = 1; other <= kOtherPostures && planner.in_reach(); ++other) {
    if (miss_of(best) <= kReachTolerance) break;
    if (!planner.go_by_other_posture(other)) continue;
    other_postures = true;
    Candidate candidate = only_candidate(planner, values);
    if (miss_of(candidate) <= kReachTolerance) best = std::move(candidate);
  }
  if (other_postures) planner.go_by_other_posture(0);
  return best;
}

// The candidates as the task plays them, which has another duration.
Result<GenerateResult> played_anew(const PreparedTask& task, const GenerateResult& generation) {
  SHG_TRY_ASSIGN(const std::unique_ptr<Planner> planner, make_planner(task));
  GenerateResult again = generation;
  again.duration = *task.duration;
  for (Candidate& candidate : again.candidates) {
    candidate = played(*planner, Parameters(candidate.parameters));
  }
  std::stable_sort(again.candidates.begin(), again.candidates.end(), ranks_of(task));
  again.status = status_of(generation.meets_goals(), again.candidates);
  return again;
}

bool wants_more(const GenerateResult& generation) {
  return generation.status == ReachStatus::unsteady && generation.end != SearchEnd::cancelled;
}

// Puts another search's result in the place of one that found nothing possible, if the other did.
bool take_place(GenerateResult other, GenerateResult& found) {
  found.evaluations += other.evaluations;
  found.end = other.end;
  if (other.status != ReachStatus::reached) return false;
  other.evaluations = found.evaluations;
  found = std::move(other);
  return true;
}

// Searches in a longer duration where motions are impossible only for their haste, and the task
// gives no duration.
void try_slower(const PreparedTask& task, JointProgress& progress, GenerateResult& found) {
  const std::optional<double> duration = possible_duration(found);
  if (!wants_more(found) || task.duration || !duration) return;
  PreparedTask slower = task;
  slower.duration = duration;
  // a budget that was given is used up
  const bool spent = task.evaluations.has_value();
  const int evaluations = found.evaluations;
  Result<GenerateResult> again =
      spent ? played_anew(slower, found) : search_task(slower, progress.part(1.0));
  if (again && take_place(std::move(*again), found)) found.slowed = true;
  if (spent) found.evaluations = evaluations;
}

bool first_jolts(const GenerateResult& generation) {
  return generation.candidates.front().measures.sudden.jolts();
}

bool first_strains(const GenerateResult& generation) {
  return generation.candidates.front().judgement.verdict == Verdict::strains;
}

// Where the first choice jolts or strains, and the task gives no duration, the candidates take
// longer by these factors, until their first does not; for a strain by no more than kCalmest.
constexpr std::array kGentler{1.15, 1.3, 1.5, 1.75};
constexpr double kCalmest = 1.3;

void try_gentler(const PreparedTask& task, GenerateResult& found) {
  if (!found.meets_goals() || task.duration || found.end == SearchEnd::cancelled) return;
  PreparedTask gentler = task;
  const GenerateResult in_haste = found;
  for (const double factor : kGentler) {
    const bool jolting = first_jolts(found);
    if (!jolting && !(first_strains(found) && factor <= kCalmest)) return;
    gentler.duration = factor * in_haste.duration;
    Result<GenerateResult> again = played_anew(gentler, in_haste);
    if (!again || first_jolts(*again) || again->status != found.status) continue;
    if (!jolting && first_strains(*again)) continue;
    found = std::move(*again);
    drop_jolts(found);
    const auto left = static_cast<int>(found.candidates.size());
    if (found.fewer.empty() && left < task.candidates) {
      found.fewer = say("fewer_jolts", left, task.candidates, found.jolting);
    }
    found.gentled = true;
  }
}

// How good a choice is: a first that is possible, as many that could be made as people see, and
// how little the first scores.
std::tuple<bool, int, double> choice_of(const Task& task, const GenerateResult& generation) {
  const auto could =
      std::count_if(generation.candidates.begin(), generation.candidates.end(), could_be_made);
  const bool first = generation.candidates.front().judgement.verdict == Verdict::possible;
  return {first, std::min(static_cast<int>(could), shown_least(task)),
          -generation.candidates.front().score.total};
}

bool lacks_choice(const Task& task, const GenerateResult& generation) {
  const auto [first, could, score] = choice_of(task, generation);
  return !first || could < shown_least(task);
}

// Where nothing that was found is possible, or there is no choice, this many times as many motions
// are scored.
constexpr int kLongerSearch = 3;

void try_longer(const PreparedTask& task, JointProgress& progress, GenerateResult& found) {
  if (task.evaluations || found.end == SearchEnd::cancelled || task.pareto) return;
  const bool chooses = found.status == ReachStatus::reached && !traits_of(task.preset).layers;
  if (!wants_more(found) && !(chooses && lacks_choice(task, found))) return;
  PreparedTask longer = task;
  longer.evaluations = kLongerSearch * usual_evaluations(task);
  Result<GenerateResult> again = search_task(longer, progress.part(1.0));
  if (!again) return;
  if (!wants_more(found) && !(choice_of(task, found) < choice_of(task, *again))) {
    found.evaluations += again->evaluations;
    return;
  }
  take_place(std::move(*again), found);
}

constexpr std::uint64_t kOtherNumbers = 0x9e3779b97f4a7c15U;

// Where still nothing is possible, other random numbers search as many motions as the first search
// did: a sixth of what was spent by then.
void try_other_numbers(const PreparedTask& task, JointProgress& progress, GenerateResult& found) {
  if (task.evaluations || task.pareto || task.own_search || !wants_more(found)) return;
  PreparedTask other = task;
  other.seed = task.seed ^ kOtherNumbers;
  Result<GenerateResult> again = search_task(other, progress.part(1.0));
  if (again) take_place(std::move(*again), found);
}

// A time that is told to be enough is in tenths of a second, and at most this many are tried.
constexpr double kToldStep = 0.1;
constexpr int kToldTries = 4;

bool is_possible_in(const PreparedTask& slower, const GenerateResult& found, bool on_all,
                    JointProgress& progress) {
  // a budget that was given is used up
  const Result<GenerateResult> again = slower.evaluations
                                           ? played_anew(slower, found)
                                           : search_task(slower, progress.part(1.0), on_all);
  return again && again->status == ReachStatus::reached;
}

// Leaves of all times in which single candidates would be possible one in which the task was
// searched again and something is; none where nothing was.
void check_possible_in(const PreparedTask& task, bool on_all, JointProgress& progress,
                       GenerateResult& found) {
  const std::optional<double> least = possible_duration(found);
  if (!wants_more(found) || !least) return;
  PreparedTask slower = task;
  std::optional<double> told;
  double tenths = std::ceil(*least / kToldStep);
  for (int k = 0; k < kToldTries && !told; ++k, tenths = std::ceil(1.2 * tenths)) {
    slower.duration = kToldStep * tenths;
    if (*slower.duration > kSlowest * found.duration) break;
    if (is_possible_in(slower, found, on_all, progress)) told = slower.duration;
  }
  for (Candidate& candidate : found.candidates) {
    std::optional<double>& own = candidate.judgement.possible_in;
    if (own) own = told;
  }
}

}  // namespace

Task played_task(Task task, const GenerateResult& generation) {
  if (generation.slowed || generation.gentled) task.duration = generation.duration;
  return task;
}

Result<void> check_task(const Task& task) {
  SHG_TRY(check_choices(task));
  SHG_TRY_ASSIGN(const PreparedTask ready, prepared(task));
  return check_plan(ready);
}

Result<GenerateResult> generate(const Task& task, const Progress& progress) {
  SHG_TRY(check_choices(task));
  SHG_TRY_ASSIGN(const PreparedTask ready, prepared(task));
  JointProgress joint(progress);
  const bool natural = traits_of(ready.preset).natural;
  const bool lanes = ready.generator == MotionGenerator::weighted_ik;
  const bool on_all = natural && lanes && !traits_of(ready.preset).layers && !ready.pareto;
  SHG_TRY_ASSIGN(GenerateResult found, search_task(ready, joint.part(1.0), on_all));
  if (natural) {
    try_slower(ready, joint, found);
    try_longer(ready, joint, found);
    try_other_numbers(ready, joint, found);
    if (minds_jolts(ready)) try_gentler(ready, found);
  }
  check_possible_in(ready, on_all, joint, found);
  if (!found.meets_goals()) found.conflict = conflict_of(task);
  return found;
}

struct MotionPlayer::Made {
  Task task;
  PreparedTask ready;
  std::unique_ptr<Planner> planner;     // of `ready`
  std::optional<MotionPlayer> other{};  // of the other side, once a motion of it was asked for

  Result<Candidate> play(const Parameters& values);

 private:
  Result<std::optional<Candidate>> reflect(const Parameters& values);
};

Result<Candidate> MotionPlayer::Made::play(const Parameters& values) {
  if (values.reflected) {
    SHG_TRY_ASSIGN(std::optional<Candidate> image, reflect(values));
    if (image) return std::move(*image);
  }
  return played(*planner, values);
}

// The image of the motion that the other side's values make; none where the body has no image.
Result<std::optional<Candidate>> MotionPlayer::Made::reflect(const Parameters& values) {
  if (!other) {
    // a body that stands on the foot of the task's one side has no other: it is the image itself
    Result<MotionPlayer> made = MotionPlayer::of(mirrored_task(task));
    if (!made) return std::optional<Candidate>{};
    other = std::move(*made);
  }
  const Made& there = *other->made_;
  Parameters source = mirrored_values(planner->plan(), there.planner->plan(), values);
  SHG_TRY_ASSIGN(const GenerateResult played_there, other->play(source));
  const Candidate& of = played_there.candidates.front();
  Arrival arrival = planner->nearest(values);
  std::optional<Motion> image = reflection(*arrival.approach, of.motion);
  if (!image) return std::optional<Candidate>{};
  arrival.rolled.motion = std::move(*image);
  Candidate candidate = make_candidate(ready, *arrival.approach, values, std::move(arrival.rolled));
  candidate.arm_collision = of.arm_collision;
  return candidate;
}

Result<MotionPlayer> MotionPlayer::of(Task task) {
  SHG_TRY_ASSIGN(PreparedTask ready, prepared(task));
  auto made = std::make_unique<Made>(Made{std::move(task), std::move(ready), nullptr, {}});
  SHG_TRY_ASSIGN(made->planner, make_planner(made->ready));
  return MotionPlayer(std::move(made));
}

MotionPlayer::MotionPlayer(std::unique_ptr<Made> made) : made_(std::move(made)) {}
MotionPlayer::MotionPlayer(MotionPlayer&&) noexcept = default;
MotionPlayer& MotionPlayer::operator=(MotionPlayer&&) noexcept = default;
MotionPlayer::~MotionPlayer() = default;

const Task& MotionPlayer::task() const { return made_->task; }

Result<GenerateResult> MotionPlayer::play(const Parameters& values) {
  Planner& planner = *made_->planner;
  SHG_TRY(check_parameters(planner.plan(), values));
  GenerateResult generation;
  generation.duration = planner.duration();
  SHG_TRY_ASSIGN(Candidate candidate, made_->play(values));
  generation.candidates.push_back(std::move(candidate));
  finish(made_->ready, planner.in_reach(), generation);
  return generation;
}

Result<GenerateResult> regenerate(const Task& task, const Parameters& values) {
  SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
  return player.play(values);
}

}  // namespace shigusa
