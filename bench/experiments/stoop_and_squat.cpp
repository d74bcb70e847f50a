// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/core/check.hpp>
#include <shigusa/core/parallel.hpp>
#include <shigusa/hierarchy/generator.hpp>

#include "goal_search.hpp"
#include "report.hpp"
#include "sections.hpp"
#include "stoop_squat_index.hpp"

namespace shigusa::bench {
namespace {

constexpr double kSquatBelow = 40.0;
constexpr double kStoopAbove = 80.0;

struct Delivered {
  bool reached = false;
  std::vector<double> index;  // of each candidate within the limits
  int over_limit = 0;
  double squat = -1.0;  // score of the best candidate that is one, or -1
  double stoop = -1.0;
};

Delivered deliver(const BodyModel& body, const Vec3d& goal, const CriteriaSettings& criteria,
                  std::uint64_t seed) {
  Task task = goal_task(body, goal, Preset::flat, criteria);
  task.genetic.seed = seed;
  const Generation generation = generate(task).value();
  Delivered delivered;
  delivered.reached = generation.status == ReachStatus::reached;
  for (const Candidate& candidate : generation.candidates) {
    if (!candidate.over_limit.empty()) {
      ++delivered.over_limit;
      continue;
    }
    const double index = stoop_squat_index(body, candidate.motion.clip);
    delivered.index.push_back(index);
    // lowest score first
    double& best = index < kSquatBelow ? delivered.squat : delivered.stoop;
    if ((index < kSquatBelow || index > kStoopAbove) && best < 0.0) best = candidate.score.total;
  }
  return delivered;
}

}  // namespace

double stoop_squat_index(const BodyModel& body, const Clip& clip) {
  Kinematics<double> placed(body);
  // heights (m) of the middle of a joint's two sides, or of the side that the body has
  const auto height = [&](const char* joint) {
    double sum = 0.0;
    int sides = 0;
    for (const char* side : {"right_", "left_"}) {
      const auto dof = body.find_dof(std::string(side) + joint + ".flexion");
      if (!dof) continue;
      sum += placed.origin[static_cast<std::size_t>(*dof)].y;
      ++sides;
    }
    SHG_CHECK(sides > 0, std::string("the body has no ") + joint);
    return sum / sides;
  };
  forward_kinematics<double>(body, clip.frame(0), placed);
  const double hip = height("hip");
  const double shoulder = height("shoulder");
  forward_kinematics<double>(body, clip.frame(clip.frames - 1), placed);
  return 100.0 * (1.0 - (hip - height("hip")) / (shoulder - height("shoulder")));
}

std::string stoop_and_squat(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"criteria", "body", "seeds with a squat", "with a stoop", "with both", "candidates",
               "over a limit", "lowest index", "highest index", "best squat's score",
               "best stoop's score"});
  const Vec3d goal = named_places()[1].position;
  for (const CriteriaPreset& criteria : criteria_presets()) {
    for (const Subject& subject : subjects) {
      std::vector<Delivered> all(static_cast<std::size_t>(plan.seeds));
      parallel_for(plan.seeds, 0, [&](int s, int) {
        all[static_cast<std::size_t>(s)] =
            deliver(subject.body, goal, criteria.settings(), static_cast<std::uint64_t>(s) + 1);
      });
      int squats = 0, stoops = 0, both = 0, over = 0;
      std::vector<double> counts, lowest, highest, squat_scores, stoop_scores;
      for (const Delivered& one : all) {
        const bool squat = one.reached && one.squat >= 0.0;
        const bool stoop = one.reached && one.stoop >= 0.0;
        squats += squat ? 1 : 0;
        stoops += stoop ? 1 : 0;
        both += squat && stoop ? 1 : 0;
        over += one.over_limit;
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
      table.add({std::string(criteria.name), subject.body.name(), percent(squats, plan.seeds),
                 percent(stoops, plan.seeds), percent(both, plan.seeds), middle(counts, 0),
                 std::to_string(over), middle(lowest, 0), middle(highest, 0),
                 middle(squat_scores, 3), middle(stoop_scores, 3)});
    }
  }
  return fmt::format(
             "## Stoop and squat\n\n"
             "`generate()` with the preset flat and its {} motions for the goal at the feet, {} "
             "seeds. The stoop–squat index is 100 · (1 - drop of the hips / drop of the "
             "shoulders) from the first frame to the last, each the middle of what joint centres "
             "the body has: a squat below {:g}, a stoop above {:g}. Wanted: both among the "
             "candidates, within all limits. Columns without a share are medians over the "
             "seeds.\n\n",
             kFlatEvaluations, plan.seeds, kSquatBelow, kStoopAbove) +
         table.text();
}

}  // namespace shigusa::bench
