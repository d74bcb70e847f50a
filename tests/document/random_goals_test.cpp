// SPDX-License-Identifier: MIT
// A thousand random goals per body at night, within and beyond its reach, judged by the exported
// BVH's own forward kinematics.
#include <gtest/gtest.h>

#include <shigusa/files.hpp>

#include "motion/minimum_jerk.hpp"
#include "problem/make_problem.hpp"
#include "support/exported.hpp"
#include "support/night.hpp"
#include "support/reach_bounds.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kMillimetre = 1e-3;
constexpr double kTenthOfADegree = radians(0.1);
// Number of goals in each of four parts, which run in parallel on several cores. Builds that check
// every step, debug and sanitizers, take fifteen times as long per goal.
#ifdef NDEBUG
const int kGoals = cases(250, 50);
#else
const int kGoals = cases(40, 20);
#endif

// (m) about half of them within a body's reach
Vec3d random_goal(Random& random) {
  return {random.uniform(-1.3, 1.1), random.uniform(-0.2, 2.4), random.uniform(-1.1, 1.3)};
}

// By geometry alone; for the full body only some goals are known to be out of reach.
void judge_status(const PosedBody& posed, const Vec3d& goal, bool reached) {
  const BodyModel& body = posed.body;
  if (body.name() == "half_body") {
    ASSERT_EQ(half_body_distance(body, goal) <= kMillimetre, reached);
  } else if (stretched_distance(posed, goal) > kMillimetre) {
    ASSERT_FALSE(reached);
  }
}

// The hand is on its path in every frame: straight paths follow their line, in the path's own time.
// A reached goal, and the path to it, is met within 1 mm.
void judge_path(const ExportedMotion& exported, const GoalResult& goal, const EffectorPath& path,
                double duration) {
  if (goal.path != PathKind::straight) return;
  const Vec3d start = exported.at(goal.node, 0);
  const Vec3d end = exported.at_end(goal.node);
  for (int f = 0; f < exported.frames(); ++f) {
    const double s = path.done(f * exported.motion().clip.frame_time / duration);
    // the path's own end lies as near to where the hand ends as the goal does
    ASSERT_LE(norm(exported.at(goal.node, f) - (start + (end - start) * s)), 2.0 * kMillimetre)
        << f;
  }
}

void judge(const Task& task, const GenerateResult& generation, const Candidate& candidate) {
  const auto bvh = export_candidate(task, candidate, FileFormat::bvh);
  const ExportedMotion exported(bvh.value(), BvhFormat{}.unit);
  ASSERT_TRUE(exported.finite());
  for (const ContactResult& foot : candidate.contacts) {
    ASSERT_LE(exported.slide(foot.node), kMillimetre) << foot.node;
    ASSERT_LE(exported.tilt(foot.node), 1.02 * kTenthOfADegree) << foot.node;  // rounded in files
  }
  ASSERT_TRUE(task.preset == Preset::paper || candidate.measures.over_limit.empty());
  const bool reached = generation.meets_goals();
  ASSERT_TRUE(!reached || candidate.path_error <= kMillimetre) << candidate.path_error;
  const ReachProblem problem = make_problem(task).value();
  double miss = 0.0;
  for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
    const GoalResult& goal = candidate.goals[g];
    const EffectorPath& path = problem.goals[g].path;
    if (reached) judge_path(exported, goal, path, candidate.motion.clip.duration());
    miss = std::fmax(miss, norm(exported.at_end(goal.node) - goal.asked.position));
  }
  ASSERT_EQ(miss <= kMillimetre, reached) << miss << " m";
}

// Generates and judges; the search is reduced to its first population, since final positions do not
// depend on scores.
ReachStatus generate_and_judge(TaskFile& file) {
  Task task = make_task(file, {}).value();
  if (file.preset == Preset::paper) task.genetic.max_generations = 0;
  task.most_runs = 1;
  task.candidates = 2;
  const GenerateResult generation = generate(task).value();
  EXPECT_FALSE(generation.candidates.empty());
  for (const Candidate& candidate : generation.candidates) judge(task, generation, candidate);
  if (task.goals.size() == 1 && task.preset == Preset::paper) {
    const bool reached = generation.meets_goals();
    judge_status(task, task.goals[0].position, reached);
  }
  return generation.status;
}

struct Part {
  const char* body;
  std::uint64_t index;
  bool both_hands = false;
  bool heels = false;  // may lift: by the preset flat
};

class RandomGoals : public testing::TestWithParam<Part> {};

TEST_P(RandomGoals, AreMetOrMissedAsTheStatusTells) {
  Random random(2024, GetParam().index);
  int reached = 0;
  for (int k = 0; k < kGoals; ++k) {
    TaskFile file;
    file.preset = GetParam().heels ? Preset::flat : Preset::paper;
    file.criteria = traits_of(file.preset).criteria();
    file.character.source = GetParam().body;
    file.character.heels = GetParam().heels;
    if (GetParam().heels) file.evaluations = 100;
    file.goals = {{"right_hand", random_goal(random)}};
    if (GetParam().both_hands) file.goals.push_back({"left_hand", random_goal(random)});
    file.seed = random.next();
    SCOPED_TRACE(format_task(file));
    reached += generate_and_judge(file) != ReachStatus::unreachable ? 1 : 0;
    ASSERT_FALSE(HasFailure());
  }
  // otherwise the goals show nothing of one side
  EXPECT_GT(reached, kGoals / 20);
  EXPECT_LT(reached, kGoals);
}

INSTANTIATE_TEST_SUITE_P(HalfBody, RandomGoals,
                         testing::Values(Part{"half_body", 0}, Part{"half_body", 1},
                                         Part{"half_body", 2}, Part{"half_body", 3}));
INSTANTIATE_TEST_SUITE_P(FullBody, RandomGoals,
                         testing::Values(Part{"full_body", 0}, Part{"full_body", 1},
                                         Part{"full_body", 2}, Part{"full_body", 3},
                                         Part{"full_body", 4, true}));
INSTANTIATE_TEST_SUITE_P(Heels, RandomGoals,
                         testing::Values(Part{"human", 5, false, true},
                                         Part{"human", 6, false, true}));

}  // namespace
}  // namespace shigusa
