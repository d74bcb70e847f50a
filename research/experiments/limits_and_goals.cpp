// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "goal_search.hpp"
#include "independent_reach.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr int kEvaluations = 600;
constexpr int kBlock = 128;  // goals at a time, until enough motions are delivered
constexpr int kStarts = 8;
constexpr int kManyStarts = 60;  // for goals that were not reached
// Tolerance (rad) of limits for rounding.
constexpr double kRounding = 1e-9;

// Motions of one query, measured only from joint angles and forward kinematics.
struct Judged {
  Vec3d goal{};
  int motions = 0;
  int over_limit = 0;      // motions that pass a limit at some frame
  double excess = 0.0;     // rad, the most
  int feet_moved = 0;      // motions in which a planted foot slides
  bool met = false;        // reported as reached, and every motion ends there
  bool said = false;       // reported as reached
  bool reachable = false;  // by the independent method
};

// m, largest displacement of a foot's centre in any frame
double slide_of(const PosedBody& posed, const Clip& clip) {
  Kinematics<double> placed(posed);
  std::vector<Vec3d> stands;
  double most = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(posed, clip.frame(f), placed);
    for (std::size_t k = 0; k < posed.body.feet().size(); ++k) {
      const Vec3d at = placed.point(posed.body.feet()[k].link, posed.body.feet()[k].centre);
      if (f == 0) stands.push_back(at);
      most = std::max(most, norm(at - stands[k]));
    }
  }
  return most;
}

Judged judge(const PosedBody& posed, const Vec3d& goal, std::uint64_t number) {
  Task task = goal_task(posed, goal, Preset::flat, default_criteria());
  task.evaluations = kEvaluations;
  task.seed = number;
  const GenerateResult generation = generate(task).value();
  Judged judged{.goal = goal};
  judged.met = judged.said = generation.meets_goals();
  Kinematics<double> placed(posed);
  const Effector& hand =
      posed.body
          .effectors()[static_cast<std::size_t>(posed.body.find_effector("right_hand").value())];
  for (const Candidate& candidate : generation.candidates) {
    const Clip& clip = candidate.motion.clip;
    double excess = 0.0;
    for (int f = 0; f < clip.frames; ++f) excess = max(excess, excess_of(posed, clip.frame(f)));
    ++judged.motions;
    judged.over_limit += excess > kRounding ? 1 : 0;
    judged.excess = max(judged.excess, excess);
    judged.feet_moved += slide_of(posed, clip) > kReachTolerance ? 1 : 0;
    forward_kinematics<double>(posed, clip.frame(clip.frames - 1), placed);
    const double miss = norm(placed.point(hand.link, hand.point) - goal);
    judged.met = judged.met && miss <= kReachTolerance;
  }
  IndependentReach reach(posed, "right_hand");
  Random random(number, 5);
  judged.reachable = reach.posture(goal, judged.met ? kStarts : kManyStarts, random).has_value();
  return judged;
}

// until enough motions are delivered for enough goals
std::vector<Judged> judge_many(const Plan& plan, const PosedBody& posed, std::size_t goals) {
  Random places(plan.goal_seed, 4);
  std::vector<Judged> all;
  int motions = 0;
  while (motions < plan.motions || all.size() < goals) {
    const std::size_t first = all.size();
    for (int k = 0; k < std::min(kBlock, plan.motions); ++k) {
      all.push_back({.goal = random_place(places)});
    }
    parallel_for(static_cast<int>(all.size() - first), 0, [&](int i, int) {
      const std::size_t k = first + static_cast<std::size_t>(i);
      all[k] = judge(posed, all[k].goal, k);
    });
    for (std::size_t k = first; k < all.size(); ++k) motions += all[k].motions;
  }
  return all;
}

}  // namespace

std::string limits_and_goals(const Plan& plan) {
  Table table({"body", "goals", "motions delivered", "over a limit", "most, °", "foot moved",
               "reachable", "met of these", "wanted", "met, and found by none of the starts",
               "said to be met, and not"});
  std::string missed;
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) {
    const bool whole = posed.body.name() == "human";
    const auto goals = static_cast<std::size_t>(whole ? plan.human_goals : 0);
    const std::vector<Judged> all = judge_many(plan, posed, goals);
    Judged sum;
    int reachable = 0, met = 0, met_besides = 0, wrong = 0;
    for (const Judged& one : all) {
      sum.motions += one.motions;
      sum.over_limit += one.over_limit;
      sum.excess = max(sum.excess, one.excess);
      sum.feet_moved += one.feet_moved;
      reachable += one.reachable || one.met ? 1 : 0;
      met += one.met ? 1 : 0;
      met_besides += !one.reachable && one.met ? 1 : 0;
      wrong += one.said && !one.met ? 1 : 0;
      if (!one.reachable || one.met) continue;
      missed += fmt::format("- {} ({:.3f}, {:.3f}, {:.3f})\n", posed.body.name(), one.goal.x,
                            one.goal.y, one.goal.z);
    }
    table.add({posed.body.name(), std::to_string(all.size()), std::to_string(sum.motions),
               std::to_string(sum.over_limit), fmt::format("{:.4f}", degrees(sum.excess)),
               std::to_string(sum.feet_moved), std::to_string(reachable),
               percent(met, reachable, 2), whole ? "≥ 99 %" : "≥ 99.5 %",
               std::to_string(met_besides), std::to_string(wrong)});
  }
  return fmt::format(
             "`generate()` with the preset flat and {} motions a query (a third of the default: "
             "there are thousands), for goals drawn evenly from the box, in reach or not, until "
             "{} motions were delivered for each body, for human until {} goals were drawn. "
             "Limits, hands and feet are measured anew "
             "from the delivered joint angles. Reachable is what a delivered motion, so measured, "
             "meets, or the independent method finds a "
             "posture for: from {} random postures, and from {} where the query did not get "
             "there.\n\n",
             kEvaluations, plan.motions, plan.human_goals, kStarts, kManyStarts) +
         table.text() + (missed.empty() ? "" : "\nReachable, and not met:\n\n" + missed);
}

}  // namespace shigusa::bench
