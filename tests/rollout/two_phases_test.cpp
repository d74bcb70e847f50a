// SPDX-License-Identifier: MIT
// Motions whose weights and posture change once.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "body/posture_modes.hpp"
#include "nlp/nlp_rollout.hpp"
#include "rollout/held_input.hpp"
#include "support/lanes.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLow{-0.2, 0.5, 0.5};

// Of 60 frames, where the switch is at 0.5: the last that is the first phase's alone, and the last
// before the later has all.
constexpr int kBegins = 18;
constexpr int kEnds = 42;
static_assert(kSwitchWindow == 0.4);

ReachProblem low_reach() {
  ReachProblem problem = reach_with(full(), "right_hand", kLow);
  problem.hold_limits = true;
  problem.goals[0].bow = {0.0, 0.3, 0.0};
  problem.goals[0].sway = {-0.3, 0.0, 0.0};
  return problem;
}

std::vector<double> random_modes(Random& random) {
  std::vector<double> modes;
  for (const PostureMode& mode : posture_modes(full())) {
    modes.push_back(0.5 * random.uniform(mode.lower, mode.upper));
  }
  return modes;
}

Parameters random_posed(Random& random) {
  Parameters parameters = random_parameters(full(), random);
  parameters.posture = {random_modes(random),
                        {random.uniform(0.0, 0.4), random.uniform(-0.1, 0.2),
                         random.uniform(-1.0, 1.0), random.uniform(-0.1, 0.1)}};
  return parameters;
}

Parameters random_two_phases(Random& random) {
  Parameters parameters = random_posed(random);
  parameters.later = {random.uniform(kSwitchMin, kSwitchMax),
                      random_parameters(full(), random).joints, random_modes(random)};
  return parameters;
}

double largest_difference(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.angles.size(); ++k) {
    largest = std::fmax(largest, std::fabs(a.angles[k] - b.angles[k]));
  }
  return largest;
}

std::size_t dof(const char* name) { return static_cast<std::size_t>(*full().find_dof(name)); }

TEST(PhaseBlend, IsTheMeanOfFourthRoots) {
  const std::vector<double> first{1.0, 200.0, 0.005, 3.0};
  const std::vector<double> later{1.0, 0.004, 0.0, 5.0};
  MotionInput<double> input(first);
  input.later = {later, {}, 0.6};
  PhaseBlend<double> blend(4);
  blend.begin(input);
  for (double tau = 0.0; tau <= 1.0; tau += 0.01) {
    const double b = minimum_jerk((tau - 0.6) / kSwitchWindow + 0.5);
    EXPECT_NEAR(blend.step(input, tau), b, 1e-13);
    for (std::size_t d = 0; d < 4; ++d) {
      const double root = (1 - b) * std::pow(first[d], 0.25) + b * std::pow(later[d], 0.25);
      EXPECT_NEAR(blend.inverse_weights()[d], std::pow(root, 4.0), 1e-12 * first[d]);
    }
  }
  blend.step(input, 0.6 - 0.51 * kSwitchWindow);
  EXPECT_EQ(std::vector<double>(blend.inverse_weights().begin(), blend.inverse_weights().end()),
            first);
  blend.step(input, 0.6 + 0.51 * kSwitchWindow);
  EXPECT_EQ(std::vector<double>(blend.inverse_weights().begin(), blend.inverse_weights().end()),
            later);
}

TEST(PhaseBlend, DrawsHalfOfEachPostureAboutTheMiddle) {
  const std::vector<double> weights{1.0, 1.0, 1.0};
  const std::vector<double> lock{1.0, 1.0, 0.0};
  const std::vector<double> first{0.8, 0.2, 0.4};
  const std::vector<double> later{0.0, 0.6, 0.9};
  MotionInput<double> input(weights, first, {});
  input.later = {lock, later, 0.5};
  PhaseBlend<double> blend(3);
  blend.begin(input);
  std::vector<double> drawn(3);
  for (int f = 1; f <= 60; ++f) {
    blend.step(input, (f - 0.5) / 60);
    const double share = minimum_jerk(f / 60.0) - minimum_jerk((f - 1) / 60.0);
    for (std::size_t d = 0; d < 3; ++d) drawn[d] += share * blend.posture()[d];
  }
  // the profile and the blend are symmetric; a freedom that is locked is drawn nowhere
  EXPECT_NEAR(drawn[0], 0.4, 1e-14);
  EXPECT_NEAR(drawn[1], 0.4, 1e-14);
  EXPECT_NEAR(drawn[2], 0.2, 1e-14);
}

RC_GTEST_PROP(TwoPhases, AlikeAreTheMotionOfOne, (std::uint64_t seed)) {
  Random random(seed);
  Parameters parameters = random_posed(random);
  for (JointWeight& joint : parameters.joints) joint.locked = random.chance(0.1);
  const ReachProblem problem = low_reach();
  const RolledOut one = roll_out(problem, parameters);
  add_later_phase(parameters);
  parameters.later->switch_at = random.uniform(kSwitchMin, kSwitchMax);
  const RolledOut two = roll_out(problem, parameters);
  RC_ASSERT(one.motion.clip.angles == two.motion.clip.angles);
}

TEST(TwoPhases, AreTheFirstUntilTheChangeBegins) {
  Random random(5);
  for (int i = 0; i < 10; ++i) {
    Parameters parameters = random_two_phases(random);
    parameters.later->switch_at = 0.5;
    const ReachProblem problem = low_reach();
    const Clip two = roll_out(problem, parameters).motion.clip;
    parameters.later.reset();
    const Clip one = roll_out(problem, parameters).motion.clip;
    for (int f = 0; f <= kBegins; ++f) {
      for (std::size_t d = 0; d < full().dofs().size(); ++d) {
        EXPECT_EQ(one.frame(f)[d], two.frame(f)[d]) << f << ' ' << d;
      }
    }
    EXPECT_GT(largest_difference(one, two), radians(1.0));
  }
}

TEST(TwoPhases, LockedInOneAFreedomStandsStillThereAlone) {
  const ReachProblem problem = low_reach();
  const std::size_t elbow = dof("right_elbow.flexion");
  Parameters parameters = uniform_parameters(full());
  add_later_phase(parameters);
  parameters.later->joints[elbow].locked = true;
  const RolledOut rolled = roll_out(problem, parameters);
  const Clip& clip = rolled.motion.clip;
  EXPECT_TRUE(rolled.outcome.met());
  EXPECT_GT(abs(clip.frame(kEnds)[elbow] - clip.frame(0)[elbow]), radians(1.0));
  for (int f = kEnds; f <= 60; ++f) EXPECT_EQ(clip.frame(f)[elbow], clip.frame(kEnds)[elbow]) << f;
}

RC_GTEST_PROP(TwoPhases, HandIsOnItsPathAndFeetArePlanted, (std::uint64_t seed)) {
  Random random(seed);
  const ReachProblem problem = reach_with(full(), "right_hand", near_goal(full(), random));
  Parameters parameters = random_parameters(full(), random);
  add_later_phase(parameters);
  parameters.later->switch_at = random.uniform(kSwitchMin, kSwitchMax);
  parameters.later->joints = random_parameters(full(), random).joints;
  for (const RolledOut& rolled :
       {roll_out(problem, parameters), roll_out_nlp(problem, parameters)}) {
    // a few in a thousand weights lead astray, and the outcome says so
    RC_PRE(rolled.outcome.met());
    const MeasuredMotion measured(problem, rolled.motion.clip);
    RC_ASSERT(measured.path_error <= kReachTolerance);
    RC_ASSERT(measured.contact_slide <= kReachTolerance);
    RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
  }
}

TEST(TwoPhases, NlpIkPlaysThemAlike) {
  Random random(8);
  const ReachProblem problem = low_reach();
  Parameters parameters = random_posed(random);
  const Clip one = roll_out_nlp(problem, parameters).motion.clip;
  add_later_phase(parameters);
  const Clip alike = roll_out_nlp(problem, parameters).motion.clip;
  // both stop within NlpIkSettings::tolerance of a minimum, frame by frame
  EXPECT_LT(largest_difference(one, alike), 1e-4);
  const std::size_t elbow = dof("right_elbow.flexion");
  parameters.later->joints[elbow].locked = true;
  parameters.later->joints[dof("left_knee.flexion")].weight = 100.0;
  const RolledOut changed = roll_out_nlp(problem, parameters);
  EXPECT_TRUE(changed.outcome.met());
  const Clip& clip = changed.motion.clip;
  for (int f = 0; f <= kBegins; ++f) EXPECT_EQ(clip.frame(f)[elbow], one.frame(f)[elbow]) << f;
  for (int f = kEnds; f <= 60; ++f) EXPECT_EQ(clip.frame(f)[elbow], clip.frame(kEnds)[elbow]) << f;
}

TEST(TwoPhases, LanesScoreAsDoubleDoes) {
  const ReachProblem problem = low_reach();
  const CriteriaSettings criteria = default_criteria();
  Random random(4);
  std::vector<float> weights, changes, timing, later_weights, later_changes, switches;
  PlayedMotions played;
  const auto add = [](std::vector<float>& rows, std::span<const double> values) {
    for (const double value : values) rows.push_back(static_cast<float>(value));
  };
  for (int i = 0; i < 37; ++i) {
    const Parameters p = random_two_phases(random);
    const HeldInput held(full(), p);
    const MotionInput<double> input = held.input();
    add(weights, input.inverse_weights);
    add(changes, input.posture);
    add(timing, std::vector<double>{input.timing.delay, input.timing.bow, input.timing.skew,
                                    input.timing.sway});
    add(later_weights, input.later.inverse_weights);
    add(later_changes, input.later.posture);
    switches.push_back(static_cast<float>(input.later.switch_at));
    played.add(problem, p, criteria);
  }
  MotionInputs inputs(weights, changes, timing);
  inputs.later = {later_weights, later_changes, switches};
  expect_lanes_like(played, problem, criteria, inputs);
  BatchRollout batch(problem, criteria, {SimdSet::scalar, 1});
  std::vector<double> scores(played.scores.size());
  inputs.later.switch_at = inputs.later.switch_at.first(3);
  EXPECT_THROW(batch.score(inputs, scores), PreconditionError);
}

TEST(TwoPhases, BesideWeightsAloneAPostureIsDrawnInItsOwnPhase) {
  const ReachProblem problem = low_reach();
  Parameters parameters = uniform_parameters(full());
  add_later_phase(parameters);
  Random random(2);
  parameters.later->modes = random_modes(random);
  Parameters zeros = parameters;
  zeros.posture.modes.resize(parameters.later->modes.size());
  EXPECT_EQ(roll_out(problem, parameters).motion.clip.angles,
            roll_out(problem, zeros).motion.clip.angles);
}

}  // namespace
}  // namespace shigusa
