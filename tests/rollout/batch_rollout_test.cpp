// SPDX-License-Identifier: MIT
#include "rollout/batch_rollout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/check.hpp"
#include "plan/held_input.hpp"
#include "rollout/rollout.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// In front of the left foot, at the height of the knee: the paper's first experiment.
constexpr Vec3d kLowLeft{0.25, 0.55, 0.50};
// A number that does not fill the last pack of any SIMD set.
constexpr std::size_t kMotions = 101;

// (motions × dofs) of random genomes of the paper's code, 0 = locked
std::vector<float> random_inverse_weights(const BodyModel& body, std::size_t motions) {
  Random random(91);
  std::vector<std::uint16_t> genes(motions * body.dofs().size());
  for (std::uint16_t& gene : genes) gene = static_cast<std::uint16_t>(random.below(16));
  return inverse_weights_of_genes(genes);
}

struct Reach {
  PosedBody posed;
  ReachProblem problem;
  CriteriaSettings criteria;
  std::vector<float> inverse_weights;  // (kMotions × dofs)

  explicit Reach(PosedBody b, CriteriaSettings c = {})
      : posed(std::move(b)),
        problem(reach_with(posed, "right_hand", kLowLeft)),
        criteria(std::move(c)),
        inverse_weights(random_inverse_weights(posed, kMotions)) {
    problem.context.gaze = kLowLeft;
  }
  Reach(const Reach&) = delete;
  Reach& operator=(const Reach&) = delete;

  // scores of the motions first … first + count - 1, in one batch
  [[nodiscard]] std::vector<double> scores(const BatchSettings& settings, std::size_t first = 0,
                                           std::size_t count = kMotions) const {
    BatchRollout batch(problem, criteria, settings);
    const std::size_t dofs = posed.body.dofs().size();
    std::vector<double> result(count, -1.0);
    batch.score(std::span(inverse_weights).subspan(first * dofs, count * dofs), result);
    return result;
  }
};

CriteriaSettings every_criterion() {
  CriteriaSettings settings;
  for (CriterionSetting& setting : settings.built_in) setting.weight = 0.1;
  return settings;
}

enum class Case { half_body, full_body, half_body_by_all_criteria, full_body_by_all_criteria };

const Reach& reach(Case which) {
  static const Reach half(half_body());
  static const Reach full(full_body());
  static const Reach half_by_all(half_body(), every_criterion());
  static const Reach full_by_all(full_body(), every_criterion());
  switch (which) {
    case Case::half_body:
      return half;
    case Case::full_body:
      return full;
    case Case::half_body_by_all_criteria:
      return half_by_all;
    case Case::full_body_by_all_criteria:
      break;
  }
  return full_by_all;
}

class BatchRolloutOf : public testing::TestWithParam<Case> {};

TEST_P(BatchRolloutOf, SimdSetAndThreadsChangeNoBit) {
  const std::vector<double> expected = reach(GetParam()).scores({SimdSet::scalar, 1});
  for (const SimdSet simd : usable_simd_sets()) {
    for (const int threads : {0, 1, 2, 3, 8}) {
      EXPECT_EQ(reach(GetParam()).scores({simd, threads}), expected)
          << simd_name(simd) << " on " << threads;
    }
  }
}

TEST_P(BatchRolloutOf, AMotionsScoreDoesNotDependOnTheBatch) {
  const std::vector<double> expected = reach(GetParam()).scores({SimdSet::scalar, 1});
  for (const SimdSet simd : usable_simd_sets()) {
    for (const std::size_t size : {1UL, 15UL, 16UL, 17UL, 100UL}) {
      for (std::size_t first = 0; first + size <= kMotions; first += std::max(size, kMotions / 5)) {
        const auto begin = expected.begin() + static_cast<std::ptrdiff_t>(first);
        const std::vector<double> part(begin, begin + static_cast<std::ptrdiff_t>(size));
        EXPECT_EQ(reach(GetParam()).scores({simd, 2}, first, size), part)
            << simd_name(simd) << ", " << size << " from " << first;
      }
    }
  }
}

TEST_P(BatchRolloutOf, ABatchUsedAgainGivesTheSameScores) {
  const Reach& r = reach(GetParam());
  const std::vector<double> expected = r.scores({SimdSet::scalar, 1});
  for (const SimdSet simd : usable_simd_sets()) {
    BatchRollout batch(r.problem, r.criteria, {simd, 2});
    for (int time = 0; time < 3; ++time) {
      std::vector<double> scores(kMotions);
      batch.score(r.inverse_weights, scores);
      EXPECT_EQ(scores, expected);
    }
  }
}

TEST_P(BatchRolloutOf, LanesThatAreNotANumberLeaveTheirNeighboursAlone) {
  const Reach& r = reach(GetParam());
  const std::vector<double> expected = r.scores({SimdSet::scalar, 1});
  std::vector<float> inverse = r.inverse_weights;
  const std::size_t dofs = r.posed.body.dofs().size();
  for (std::size_t i = 0; i < kMotions; i += 3) {
    std::fill_n(inverse.begin() + static_cast<std::ptrdiff_t>(i * dofs), dofs,
                std::numeric_limits<float>::quiet_NaN());
  }
  for (const SimdSet simd : usable_simd_sets()) {
    BatchRollout batch(r.problem, r.criteria, {simd, 1});
    std::vector<double> scores(kMotions);
    batch.score(inverse, scores);
    for (std::size_t i = 0; i < kMotions; ++i) {
      const double wanted = i % 3 == 0 ? worst_score(r.criteria) : expected[i];
      EXPECT_EQ(scores[i], wanted) << simd_name(simd) << ' ' << i;
    }
  }
}

TEST_P(BatchRolloutOf, MotionsThatMissGetTheWorstScore) {
  const Reach& r = reach(GetParam());
  ReachProblem beyond = reach_with(r.posed, "right_hand", {-3.0, 4.0, 5.0});
  CriteriaSettings criteria;
  criteria[CriterionKind::balance].weight = 0.7;
  BatchRollout batch(beyond, criteria, {});
  std::vector<double> scores(kMotions);
  batch.score(r.inverse_weights, scores);
  for (const double score : scores) EXPECT_EQ(score, worst_score(criteria));
}

TEST_P(BatchRolloutOf, LockingEverythingMisses) {
  const Reach& r = reach(GetParam());
  const std::vector<float> locked(r.posed.body.dofs().size(), 0.0F);
  BatchRollout batch(r.problem, r.criteria, {});
  std::vector<double> score(1);
  batch.score(locked, score);
  EXPECT_EQ(score[0], worst_score(r.criteria));
}

TEST_P(BatchRolloutOf, ScoresAreThoseOfDoubleToItsPrecision) {
  const Reach& r = reach(GetParam());
  const std::vector<double> scores = r.scores({});
  const std::size_t dofs = r.posed.body.dofs().size();
  int near = 0;
  for (std::size_t i = 0; i < kMotions; ++i) {
    Parameters parameters = uniform_parameters(r.posed);
    for (std::size_t d = 0; d < dofs; ++d) {
      const double inverse = static_cast<double>(r.inverse_weights[i * dofs + d]);
      parameters.values[d] = inverse > 0.0 ? 1.0 / inverse : 1.0;
      parameters.locked[d] = inverse == 0.0;
    }
    const RolledOut rolled = roll_out(r.problem, parameters);
    const double score =
        rolled.outcome.met()
            ? score_motion(r.posed, rolled.motion, r.criteria, r.problem.context).total
            : worst_score(r.criteria);
    // lanes_test.cpp has the distribution: 99 % are nearer than 1e-3
    near += std::abs(score - scores[i]) < 1e-3 ? 1 : 0;
  }
  EXPECT_GE(near, static_cast<int>(kMotions) - 3);
}

std::string case_name(const testing::TestParamInfo<Case>& which) {
  const bool all = which.param >= Case::half_body_by_all_criteria;
  return reach(which.param).posed.body.name() + (all ? "_by_all_criteria" : "");
}

INSTANTIATE_TEST_SUITE_P(Bodies, BatchRolloutOf,
                         testing::Values(Case::half_body, Case::full_body,
                                         Case::half_body_by_all_criteria,
                                         Case::full_body_by_all_criteria),
                         case_name);

TEST(BatchRollout, OfNoMotionsDoesNothing) {
  const Reach& r = reach(Case::half_body);
  BatchRollout batch(r.problem, r.criteria, {});
  batch.score(std::span<const float>{}, {});
}

TEST(BatchRollout, WantsOneWeightPerMotionAndDof) {
  const Reach& r = reach(Case::half_body);
  BatchRollout batch(r.problem, r.criteria, {});
  std::vector<double> scores(2);
  const std::vector<float> inverse(2 * r.posed.body.dofs().size() - 1, 1.0F);
  EXPECT_THROW(batch.score(inverse, scores), PreconditionError);
}

TEST(BatchRollout, RefusesASetThatTheMachineLacks) {
  const Reach& r = reach(Case::half_body);
  const auto usable = usable_simd_sets();
  // a set that no machine has is refused like one that this machine lacks
  for (const SimdSet set :
       {SimdSet::scalar, SimdSet::lanes_4, SimdSet::avx2, SimdSet::avx512, SimdSet{99}}) {
    if (std::find(usable.begin(), usable.end(), set) != usable.end()) {
      EXPECT_NO_THROW(BatchRollout(r.problem, r.criteria, {set, 1}));
    } else {
      EXPECT_THROW(BatchRollout(r.problem, r.criteria, {set, 1}), PreconditionError);
    }
  }
}

TEST(BatchRollout, RefusesThreadsOutOfRange) {
  const Reach& r = reach(Case::half_body);
  EXPECT_THROW(BatchRollout(r.problem, r.criteria, {SimdSet::scalar, -1}), PreconditionError);
}

}  // namespace
}  // namespace shigusa
