// SPDX-License-Identifier: MIT
// Counts the heap allocations of the whole program; counting changes nothing else.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "plan/held_input.hpp"
#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"
#include "support/problems.hpp"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// out of line: otherwise g++ takes the two for a mismatched pair
[[gnu::noinline]] void release(void* memory) { std::free(memory); }

}  // namespace

// new[] and the forms that do not throw call these
void* operator new(std::size_t size) { return counted(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLowLeft{0.25, 0.55, 0.50};

CriteriaSettings every_criterion() {
  CriteriaSettings settings;
  for (CriterionSetting& setting : settings.built_in) setting.weight = 0.1;
  return settings;
}

template <class Work>
long allocations_of(Work&& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

TEST(Allocations, AreCounted) {
  EXPECT_EQ(allocations_of([] { const std::vector<double> three(3); }), 1);
  struct alignas(64) Wide {
    float lanes[16];
  };
  EXPECT_EQ(allocations_of([] { const std::vector<Wide> three(3); }), 1);
}

TEST(Allocations, ARolloutMakesNone) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    ReachProblem problem = reach_with(posed, "right_hand", kLowLeft);
    problem.context.gaze = kLowLeft;
    const std::vector<double> inverse = inverse_weights(posed, uniform_parameters(posed));
    Rollout<double> rollout(problem);
    BuiltInCriteria<double> criteria(posed, problem.context, every_criterion());
    EXPECT_EQ(allocations_of([&] {
                rollout.run(inverse,
                            [&](const PlacedFrame<double>& frame) { criteria.add(frame); });
                (void)criteria.score();
              }),
              0);
  }
}

TEST(Allocations, AGuidedRolloutBeyondReachMakesNone) {
  const PosedBody posed = full_body();
  ReachProblem problem = reach_with(posed, "right_hand", {-3.0, 4.0, 5.0});
  problem.guide.assign(posed.home.angles.begin(), posed.home.angles.end());
  problem.corrections = 3;
  const std::vector<double> inverse = inverse_weights(posed, uniform_parameters(posed));
  Rollout<double> rollout(problem);
  EXPECT_EQ(allocations_of([&] { rollout.run(inverse, [](const PlacedFrame<double>&) {}); }), 0);
}

TEST(Allocations, ScoringMoreMotionsTakesNoMore) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const ReachProblem problem = reach_with(posed, "right_hand", kLowLeft);
    const CriteriaSettings criteria = every_criterion();
    const std::size_t dofs = posed.body.dofs().size();
    const std::vector<float> inverse(100 * dofs, 1.0F);
    std::vector<double> scores(100);
    for (const SimdSet simd : usable_simd_sets()) {
      BatchRollout batch(problem, criteria, {simd, 1});
      const auto allocations_for = [&](std::size_t motions) {
        return allocations_of([&] {
          batch.score(std::span(inverse).first(motions * dofs), std::span(scores).first(motions));
        });
      };
      EXPECT_GT(allocations_for(1), 1) << "the first makes the scratch memory";
      EXPECT_EQ(allocations_for(1), 0) << simd_name(simd);
      EXPECT_EQ(allocations_for(100), 0) << simd_name(simd);
    }
  }
}

}  // namespace
}  // namespace shigusa
