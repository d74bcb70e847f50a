// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <shigusa/hierarchy/archive.hpp>
#include <shigusa/hierarchy/generator.hpp>
#include <shigusa/hierarchy/parameter_space.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <utility>

#include "candidate.hpp"
#include "layered_generator.hpp"
#include "ways.hpp"

namespace shigusa {
namespace {

SearchMethod search_of(const Task& task) {
  return task.search.value_or(preset_search(task.preset));
}

// The paper's own searches go over its codes; the others over a wider range.
GeneCode gene_code(const Task& task) {
  if (task.preset != Preset::paper) return GeneCode::natural;
  switch (search_of(task)) {
    case SearchMethod::paper_ga:
    case SearchMethod::annealing:
    case SearchMethod::random:
      return GeneCode::paper;
    default:
      return GeneCode::logarithmic;
  }
}

// The score in double of what was searched in single precision.
double replayed_score(const ReachProblem& problem, const Task& task, const Parameters& parameters) {
  const RolledOut rolled = roll_out(problem, parameters);
  return rolled.outcome.met(problem.tolerance)
             ? score_motion(*problem.body, rolled.motion, task_criteria(task)).total
             : worst_score(task.criteria);
}

// Most of the budget goes to all parameters together; the rest to stoops and squats apart, since
// people do both and no criterion decides between them. Each part is a search of its own whose
// budget never shrinks as the whole grows, so more budget never gives a worse best.
constexpr double kFreeShare = 0.6;
constexpr double kStyleShare = 0.2;
// A part is at least a population of the genetic searches; a budget too small for three of them is
// spent on all parameters together, up to that many.
constexpr int kLeastStyleBudget = kPaperPopulation;
constexpr int kLeastFreeBudget = 3 * kPaperPopulation;
constexpr double kStiffKnee = 1.0;  // logarithm of the least weight of a knee that goes by the dial
constexpr std::pair<double, double> kStyleRanges[] = {{0.0, radians(30.0)},
                                                      {radians(115.0), radians(138.0)}};  // rad

// The squat that a person has fixed, as the knees' flexion at the end. Weights and the other modes
// leave more or less of it, so the search is told how much.
class SquatDial {
 public:
  static std::optional<SquatDial> of(const Task& task) {
    if (!task.fixed) return std::nullopt;
    PostureParameters posture = task.fixed->values.posture;
    const std::vector<PostureMember> members = posture_members(task.body, posture);
    for (std::size_t m = 0; m < members.size(); ++m) {
      if (members[m].name != "squat" || !task.fixed->posture[m]) continue;
      SquatDial dial;
      for (const char* knee : {"left_knee.flexion", "right_knee.flexion"}) {
        const std::optional<int> dof = task.body.find_dof(knee);
        if (!dof) continue;
        dial.knees_.push_back(static_cast<std::size_t>(*dof));
        dial.wanted_ += *members[m].value + task.body.start()[dial.knees_.back()];
      }
      if (!dial.knees_.empty()) return dial;
    }
    return std::nullopt;
  }

  // How far (rad) the mean of the knees' angles is off.
  [[nodiscard]] double off(std::span<const float> angles) const {
    double sum = -wanted_;
    for (const std::size_t knee : knees_) sum += static_cast<double>(angles[knee]);
    return abs(sum) / static_cast<double>(knees_.size());
  }

 private:
  std::vector<std::size_t> knees_;
  double wanted_ = 0.0;  // rad, of all knees together
};

// How near (rad) the dial's motions come to it, what the search aims at, and what a radian off
// costs there; no criterion is 1 for more than that.
constexpr double kDialSlack = radians(8.0);
constexpr double kDialAim = radians(4.0);
constexpr double kDialPull = 1.0;

// What is searched on one way to the goal, and what the search came upon.
class Searched {
 public:
  Searched(const ReachProblem& problem, const Task& task)
      : problem_(problem),
        task_(task),
        criteria_(task_criteria(task)),
        space_(problem, gene_code(task), task.fixed),
        batch_(problem, criteria_, task.batch),
        archive_(*problem.body),
        dial_(SquatDial::of(task)) {}

  SearchResult run(const Progress& progress) {
    const int budget = task_.evaluations.value_or(kFlatEvaluations);
    if (task_.preset == Preset::paper) return run_in({}, budget, progress);
    const int squat = space_.find("squat");
    if (squat < 0) return run_in(stiff_knees(), budget, progress);
    const int free =
        std::max(static_cast<int>(kFreeShare * budget), std::min(budget, kLeastFreeBudget));
    SearchResult all = run_in({}, free, progress);
    const int style = static_cast<int>(kStyleShare * budget);
    if (style < kLeastStyleBudget) return all;
    for (const auto& [low, high] : kStyleRanges) {
      if (all.end == SearchEnd::cancelled) break;
      Niche niche = stiff_knees();
      niche.push_back({squat, space_.coordinate(squat, low), space_.coordinate(squat, high)});
      add(run_in(niche, style, progress), all);
    }
    return all;
  }

  [[nodiscard]] const ParameterSpace& space() const { return space_; }
  [[nodiscard]] const Archive& archive() const { return archive_; }

 private:
  // one coordinate within bounds
  struct Bound {
    int gene = 0;
    double low = 0.0;
    double high = 1.0;
  };
  // a part of the space
  using Niche = std::vector<Bound>;

  // Where the knees' flexion is given they go by it: light ones would bend as the hand has it.
  [[nodiscard]] Niche stiff_knees() const {
    Niche niche;
    for (const char* name : {"knee.flexion", "left_knee.flexion", "right_knee.flexion"}) {
      const int gene = space_.find(name);
      if (gene >= 0) niche.push_back({gene, space_.coordinate(gene, kStiffKnee), 1.0});
    }
    return niche;
  }

  static void take_in(const Niche& niche, std::span<double> points, std::size_t genes) {
    for (const Bound& bound : niche) {
      for (auto k = static_cast<std::size_t>(bound.gene); k < points.size(); k += genes) {
        points[k] = bound.low + points[k] * (bound.high - bound.low);
      }
    }
  }

  SearchResult run_in(const Niche& niche, int budget, const Progress& progress) {
    SearchProblem searched;
    searched.genes = space_.genes();
    searched.start = space_.start();
    for (const Bound& bound : niche) searched.start[static_cast<std::size_t>(bound.gene)] = 0.5;
    const auto genes = static_cast<std::size_t>(searched.genes);
    searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
      moved_.assign(points.begin(), points.end());
      take_in(niche, moved_, genes);
      evaluate(moved_, scores);
    };
    SearchResult found = search_with(searched, budget, progress);
    take_in(niche, found.best_seen.point, genes);
    for (Individual& individual : found.final_population) {
      take_in(niche, individual.point, genes);
    }
    return found;
  }

  SearchResult search_with(const SearchProblem& searched, int budget, const Progress& progress) {
    const SearchMethod method = search_of(task_);
    if (method != SearchMethod::paper_ga && method != SearchMethod::log_ga) {
      return search(method, searched, budget, task_.genetic.seed, progress);
    }
    const bool once = !task_.evaluations && task_.preset == Preset::paper;
    return once ? genetic_search(searched, task_.genetic, progress)
                : restarted_genetic_search(searched, task_.genetic, budget, progress);
  }

  static void add(SearchResult part, SearchResult& all) {
    all.evaluations += part.evaluations;
    all.rejected_nan += part.rejected_nan;
    all.generations += part.generations;
    all.end = part.end;
    if (part.best_seen.score < all.best_seen.score) all.best_seen = std::move(part.best_seen);
  }

  void evaluate(std::span<const double> points, std::span<double> scores) {
    const bool kept = task_.preset != Preset::paper;
    if (!task_.criteria.user.empty()) return evaluate_one_by_one(points, scores);
    const std::size_t dofs = problem_.body->dofs().size();
    angles_.resize(kept ? scores.size() * dofs : 0);
    batch_.score(space_.rows(points), scores, angles_);
    if (!kept) return;
    if (!dial_) return archive_.add(points, scores, angles_, worst_score(criteria_));
    kept_scores_.assign(scores.begin(), scores.end());
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const double off = dial_->off({angles_.data() + i * dofs, dofs});
      if (off > kDialSlack) kept_scores_[i] = worst_score(criteria_);
      scores[i] += kDialPull * max(0.0, off - kDialAim);
    }
    archive_.add(points, kept_scores_, angles_, worst_score(criteria_));
  }

  // criteria of the user's own want whole motions: one after the other
  void evaluate_one_by_one(std::span<const double> points, std::span<double> scores) {
    const auto genes = static_cast<std::size_t>(space_.genes());
    std::vector<float> end;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const std::span<const double> point = points.subspan(i * genes, genes);
      const RolledOut rolled = roll_out(problem_, space_.decode(point));
      scores[i] = rolled.outcome.met(problem_.tolerance)
                      ? score_motion(*problem_.body, rolled.motion, criteria_).total
                      : worst_score(criteria_);
      const Clip& clip = rolled.motion.clip;
      const std::span<const double> last = clip.frame(clip.frames - 1);
      end.clear();
      for (const double angle : last) end.push_back(static_cast<float>(angle));
      archive_.add(point, scores.subspan(i, 1), end, worst_score(criteria_));
    }
  }

  const ReachProblem& problem_;
  const Task& task_;
  CriteriaSettings criteria_;
  ParameterSpace space_;
  BatchRollout batch_;
  Archive archive_;
  std::optional<SquatDial> dial_;
  std::vector<float> angles_;
  std::vector<double> moved_;
  std::vector<double> kept_scores_;
};

// What is worth a replay, best first, and what was not.
struct Choice {
  std::vector<Individual> picked;
  int similar = 0;  // end as a better one does
  int worse = 0;    // score more than kCandidateSpread worse than the best
};

// Of all that the search came upon, the best and others that end differently and are not much
// worse: first the best of each style, then what is left, best first.
Choice distinct_postures(const Archive& archive, int most) {
  const std::vector<Archived> ranked = archive.ranked();
  std::vector<const Archived*> picked;
  Choice choice;
  const auto near = [](const Archived& a, const Archived& b) {
    return posture_distance(a.posture, b.posture) < kDistinctEnd + kEndSlack;
  };
  for (const bool new_style_only : {true, false}) {
    choice.similar = choice.worse = 0;
    for (const Archived& archived : ranked) {
      if (static_cast<int>(picked.size()) >= most) break;
      const double spread = new_style_only ? kStyleSpread : kCandidateSpread;
      if (archived.score > ranked.front().score + spread) {
        ++choice.worse;
      } else if (std::any_of(picked.begin(), picked.end(),
                             [&](const Archived* better) { return near(*better, archived); })) {
        ++choice.similar;
      } else if (!new_style_only ||
                 std::none_of(picked.begin(), picked.end(), [&](const Archived* better) {
                   return better->style == archived.style;
                 })) {
        picked.push_back(&archived);
      }
    }
  }
  choice.similar -= static_cast<int>(picked.size());  // each is near itself
  for (const Archived* archived : picked) {
    choice.picked.push_back({archived->point, archived->score});
  }
  return choice;
}

// Why there are fewer candidates than asked for.
std::string why_fewer(const Task& task, const Generation& generation, const Choice& choice) {
  if (static_cast<int>(generation.candidates.size()) >= task.candidates) return {};
  const bool paper = task.preset == Preset::paper;
  std::vector<std::string> reasons;
  const auto add = [&](int count, std::string_view what) {
    if (count > 0) reasons.push_back(fmt::format("{} {}", count, what));
  };
  add(choice.similar + generation.near_copies,
      paper ? "move as a better one does" : "end within 10° of a better one");
  add(choice.worse, fmt::format("score over {} worse than the best", kCandidateSpread));
  add(generation.missed, "miss the goal, leave the path or move a foot when replayed");
  return fmt::format(
      "{} of {} candidates: of the others that were kept, {}", generation.candidates.size(),
      task.candidates,
      reasons.empty() ? "there are none" : fmt::format("{}", fmt::join(reasons, "; ")));
}

// Replays what was found and keeps what arrives and differs, best first.
void collect_candidates(const Task& task, std::span<const ReachProblem> ways,
                        const Searched& searched, const SearchResult& found,
                        Generation& generation) {
  const bool paper = task.preset == Preset::paper;
  const Choice choice = paper ? Choice{.picked = ranked_population(found)}
                              : distinct_postures(searched.archive(), 4 * task.candidates);
  for (const Individual& individual : choice.picked) {
    if (static_cast<int>(generation.candidates.size()) >= task.candidates) break;
    const Parameters parameters = searched.space().decode(individual.point);
    std::optional<Arrival> arrival = first_arrival(ways, parameters);
    if (!arrival) {
      ++generation.missed;
      continue;
    }
    const Clip& clip = arrival->rolled.motion.clip;
    const auto is_copy = [&](const Candidate& better) {
      return paper ? largest_distance(better.motion.clip, clip) < kDistinctPosture
                   : final_distance(better.motion.clip, clip) < kDistinctEnd;
    };
    if (std::any_of(generation.candidates.begin(), generation.candidates.end(), is_copy)) {
      ++generation.near_copies;
      continue;
    }
    generation.candidates.push_back(
        make_candidate(task, *arrival->way, parameters, std::move(arrival->rolled)));
    if (arrival->way != &ways.back()) continue;
    // it was searched on this way, in single precision
    const double difference = abs(generation.candidates.back().score.total - individual.score);
    if (difference > kReplayTolerance) ++generation.replay_differs;
    generation.replay_difference = max(generation.replay_difference, difference);
  }
  // on an earlier way than they were searched on, motions may have other scores
  std::stable_sort(
      generation.candidates.begin(), generation.candidates.end(),
      [](const Candidate& a, const Candidate& b) { return ranking(a.score) < ranking(b.score); });
  generation.fewer = why_fewer(task, generation, choice);
}

// The parameters' motion on the first way that brings them to the goal; where none does, the one
// that comes nearest, but rather one that is farther off than one whose foot slides.
Candidate only_candidate(const Task& task, std::span<const ReachProblem> ways,
                         const Parameters& parameters) {
  if (std::optional<Arrival> arrival = first_arrival(ways, parameters)) {
    return make_candidate(task, *arrival->way, parameters, std::move(arrival->rolled));
  }
  std::optional<Candidate> best;
  bool best_stands = false;
  for (const ReachProblem& way : ways) {
    RolledOut rolled = roll_out(way, parameters);
    const bool stands = rolled.outcome.stands();
    Candidate candidate = make_candidate(task, way, parameters, std::move(rolled));
    const bool nearer = best && miss_of(candidate) < miss_of(*best);
    if (!best || (stands == best_stands ? nearer : stands)) {
      best = std::move(candidate);
      best_stands = stands;
    }
  }
  return std::move(*best);
}

void finish(const ClosestReach& reach, Generation& generation) {
  const double miss = miss_of(generation.candidates.front());
  const bool met = reach.reached() && miss <= kReachTolerance;
  generation.status = met ? ReachStatus::reached : ReachStatus::unreachable;
  generation.remaining_distance = met ? 0.0 : miss;
}

Result<void> check_posture(const BodyModel& body, PostureParameters posture) {
  if (posture.modes.empty()) return {};
  const std::size_t given = posture.modes.size();
  const std::vector<PostureMember> members = posture_members(body, posture);
  if (given != posture.modes.size()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} posture values for a body of {} posture modes", given,
                            posture.modes.size()));
  }
  for (const PostureMember& member : members) {
    if (*member.value >= member.low && *member.value <= member.high) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("value is {}; allowed are {:g} to {:g}", *member.value, member.low,
                            member.high),
                member.name);
  }
  return {};
}

Result<void> check_parameters(const BodyModel& body, const Parameters& parameters) {
  if (parameters.joints.size() != body.dofs().size()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} joint weights for a body of {} dof", parameters.joints.size(),
                            body.dof_count()));
  }
  if (const auto checked = check_posture(body, parameters.posture); !checked) return checked;
  for (std::size_t d = 0; d < parameters.joints.size(); ++d) {
    const double weight = parameters.joints[d].weight;
    if (weight >= kWeightMin && weight <= kWeightMax) continue;
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("weight is {}; allowed are {:g} to {:g}", weight, kWeightMin, kWeightMax),
        body.dofs()[d].name);
  }
  return {};
}

Result<void> check_fixed(const Task& task, const ReachProblem& problem) {
  if (!task.fixed) return {};
  Parameters values = task.fixed->values;
  if (const auto checked = check_parameters(task.body, values); !checked) return checked;
  const std::size_t members = posture_members(task.body, values.posture).size();
  if (task.fixed->joints.size() != values.joints.size() || task.fixed->posture.size() != members) {
    return fail(ErrorCode::invalid_argument, "fixed parameters are of another body");
  }
  if (ParameterSpace(problem, gene_code(task), task.fixed).genes() > 0) return {};
  return fail(ErrorCode::invalid_argument,
              "every parameter is fixed: there is nothing to search, an edit plays them");
}

}  // namespace

Result<Generation> generate(const Task& task, const Progress& progress) {
  if (task.preset == Preset::layers) return generate_layered(task, progress);
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_fixed(task, *problem); !checked) {
    return tl::unexpected(checked.error());
  }
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    Searched searched(ways[w], task);
    const SearchResult found = searched.run(progress);
    generation.evaluations += found.evaluations;
    generation.generations = found.generations;
    generation.rejected_nan += found.rejected_nan;
    generation.end = found.end;
    generation.best_seen = searched.space().decode(found.best_seen.point);
    generation.best_seen_score = replayed_score(ways[w], task, *generation.best_seen);
    generation.missed = generation.replay_differs = 0;
    generation.replay_difference = 0.0;
    collect_candidates(task, std::span(ways).first(w + 1), searched, found, generation);
    if (!generation.candidates.empty() || found.end == SearchEnd::cancelled) break;
  }
  if (generation.candidates.empty()) {
    generation.candidates.push_back(only_candidate(task, ways, uniform_parameters(task.body)));
  }
  finish(reach, generation);
  return generation;
}

Result<Generation> regenerate(const Task& task, const Parameters& parameters) {
  if (task.preset == Preset::layers) {
    return fail(ErrorCode::invalid_argument,
                "the preset layers goes by layered parameters, not by weights of the whole body");
  }
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_parameters(task.body, parameters); !checked) {
    return tl::unexpected(checked.error());
  }
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  generation.candidates.push_back(only_candidate(task, ways, parameters));
  finish(reach, generation);
  return generation;
}

Result<Generation> regenerate(const Task& task, const LayeredParameters& parameters) {
  return regenerate_layered(task, parameters);
}

}  // namespace shigusa
