// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "generate/posture_meter.hpp"
#include "goal_search.hpp"
#include "report.hpp"
#include "rollout/rollout.hpp"
#include "search/cma_es.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr double kSquatBelow = 40.0;
constexpr double kStoopAbove = 80.0;

struct Delivered {
  bool reached = false;
  std::vector<double> index;  // of each candidate within the limits
  int over_limit = 0;
  double best = 0.0;    // score of the best candidate
  double squat = -1.0;  // score of the best candidate that is one, or -1
  double stoop = -1.0;
};

Delivered deliver(const PosedBody& posed, const Vec3d& goal, const CriteriaSettings& criteria,
                  std::uint64_t seed) {
  Task task = goal_task(posed, goal, Preset::flat, criteria);
  task.seed = seed;
  const GenerateResult generation = generate(task).value();
  Delivered delivered;
  delivered.reached = generation.meets_goals();
  delivered.best = generation.candidates.front().score.total;
  for (const Candidate& candidate : generation.candidates) {
    if (!candidate.measures.over_limit.empty()) {
      ++delivered.over_limit;
      continue;
    }
    const double index = candidate.final_posture.stoop_squat_index.value_or(100.0);
    delivered.index.push_back(index);
    // lowest score first
    double& best = index < kSquatBelow ? delivered.squat : delivered.stoop;
    if ((index < kSquatBelow || index > kStoopAbove) && best < 0.0) best = candidate.score.total;
  }
  return delivered;
}

// Score of a squat: that of the best motion with an index below kSquatBelow from searches biased to
// squats; the worst score if there is none.
double asked_for_squat(const Plan& plan, const PosedBody& posed, const Vec3d& goal,
                       const CriteriaSettings& criteria) {
  GoalSearch searched(posed, goal, {.criteria = criteria});
  const double worst = worst_score(searched.criteria());
  double best = worst;
  PostureMeter meter(posed, posed.home, posed.body.find_effector("right_hand").value());
  SearchProblem problem = searched.problem();
  const auto genes = static_cast<std::size_t>(problem.genes);
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const RolledOut rolled =
          roll_out(searched.reach(), searched.space().decode(points.subspan(i * genes, genes)));
      scores[i] = 2.0 * worst;
      if (!rolled.outcome.met(searched.reach().tolerance)) continue;
      scores[i] = score_motion(posed, rolled.motion, searched.criteria()).total;
      const Clip& clip = rolled.motion.clip;
      const double index = meter.index(clip.frame(clip.frames - 1)).value_or(100.0);
      if (index < kSquatBelow) {
        best = min(best, scores[i]);
      } else {
        scores[i] += worst * (index - kSquatBelow) / (100.0 - kSquatBelow);
      }
    }
  };
  for (int seed = 1; seed <= plan.slow_seeds; ++seed) {
    (void)cma_es_search(
        problem, {.evaluations = kFlatEvaluations, .seed = static_cast<std::uint64_t>(seed)});
  }
  return best;
}

// Table row of a body and a mixture.
std::vector<std::string> line_of(const Plan& plan, const Subject& subject,
                                 const CriteriaPreset& criteria, const Vec3d& goal) {
  std::vector<Delivered> all(static_cast<std::size_t>(plan.seeds));
  parallel_for(plan.seeds, 0, [&](int s, int) {
    all[static_cast<std::size_t>(s)] =
        deliver(subject.posed, goal, criteria.settings(), static_cast<std::uint64_t>(s) + 1);
  });
  int squats = 0, stoops = 0, both = 0, over = 0;
  std::vector<double> counts, lowest, highest, squat_scores, stoop_scores, best_scores;
  for (const Delivered& one : all) {
    const bool squat = one.reached && one.squat >= 0.0;
    const bool stoop = one.reached && one.stoop >= 0.0;
    squats += squat ? 1 : 0;
    stoops += stoop ? 1 : 0;
    both += squat && stoop ? 1 : 0;
    over += one.over_limit;
    best_scores.push_back(one.best);
    counts.push_back(static_cast<double>(one.index.size()));
    if (squat) squat_scores.push_back(one.squat);
    if (stoop) stoop_scores.push_back(one.stoop);
    if (one.index.empty()) continue;
    lowest.push_back(quantile(one.index, 0.0));
    highest.push_back(quantile(one.index, 1.0));
  }
  const auto middle = [](const std::vector<double>& values, int digits) {
    return values.empty() ? std::string("–") : fmt::format("{:.{}f}", median(values), digits);
  };
  return {std::string(criteria.name),
          subject.posed.body.name(),
          percent(squats, plan.seeds),
          percent(stoops, plan.seeds),
          percent(both, plan.seeds),
          middle(counts, 0),
          std::to_string(over),
          middle(lowest, 0),
          middle(highest, 0),
          middle(squat_scores, 3),
          middle(stoop_scores, 3),
          middle(best_scores, 3),
          fmt::format("{:.3f}", asked_for_squat(plan, subject.posed, goal, criteria.settings()))};
}

}  // namespace

std::string stoop_and_squat(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"criteria", "body", "seeds with a squat", "with a stoop", "with both", "candidates",
               "over a limit", "lowest index", "highest index", "best squat's score",
               "best stoop's score", "best score", "a squat that is asked for"});
  const Vec3d goal = named_places()[1].position;
  // the paper's and the default; the others are for Pareto fronts
  for (const CriteriaPreset& criteria : criteria_presets().first(2)) {
    for (const Subject& subject : subjects) {
      table.add(line_of(plan, subject, criteria, goal));
    }
  }
  return fmt::format(
             "`generate()` with the preset flat and its {} motions for the goal at the feet, {} "
             "seeds. The stoop–squat index is 100 · (1 - drop of the hips / drop of the "
             "shoulders) from the first frame to the last, each the middle of what joint centres "
             "the body has: a squat below {:g}, a stoop above {:g}. Wanted: both among the "
             "candidates, within all limits. Columns without a share are medians over the "
             "seeds. The last is the best that {} searches of as many motions find which are "
             "told to look for an index below {:g}: whether there is a squat to be "
             "delivered.\n\n",
             kFlatEvaluations, plan.seeds, kSquatBelow, kStoopAbove, plan.slow_seeds, kSquatBelow) +
         table.text();
}

}  // namespace shigusa::bench
