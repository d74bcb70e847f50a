// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "criteria/built_in_criteria.hpp"
#include "criteria/replay.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A short motion of the full body that exceeds limits, leans and needs torque.
Motion wild_motion(const PosedBody& posed) {
  Random random(61);
  std::vector<std::vector<double>> frames;
  for (int f = 0; f < 5; ++f) {
    frames.push_back({posed.home.angles.begin(), posed.home.angles.end()});
    for (double& angle : frames.back()) angle += random.uniform(-0.2, 0.2);
  }
  Motion motion = motion_through(posed, frames);
  for (double& tau : motion.torques) tau = random.uniform(-30, 30);
  return motion;
}

constexpr Vec3d kGoal{0.2, 0.4, -0.3};

// All built-in criteria, each with weight 1.
CriteriaSettings every_criterion() {
  CriteriaSettings settings;
  for (CriterionSetting& setting : settings.built_in) setting.weight = 1.0;
  return settings;
}

// Circumstances of a motion from the body's start posture.
CriteriaContext at_start(const PosedBody& posed) { return {.start = posed.home}; }
CriteriaContext looking_at_goal(const PosedBody& posed) {
  return {.start = posed.home, .gaze = kGoal};
}

// Calls visit.operator()<Criterion>() for the class of each built-in criterion, in order.
template <class Visitor>
void for_each_class(Visitor&& visit) {
  const auto all = [&visit]<template <class> class... Criteria>() {
    (visit.template operator()<Criteria>(), ...);
  };
  all.template operator()<JointRange, Balance, Torque, BalanceZone, Discomfort, JointAcceleration,
                          Work, LowBack, Head, Collision, CentreOfPressure, Feasibility,
                          Coordination, HandCurve, TrunkTravel, MassAhead, Jolts>();
}

UserCriterion constant(double value, double weight = 0.1, double scale = 1.0) {
  return {.name = "constant",
          .weight = weight,
          .scale = scale,
          .value = [value](const BodyModel&, const Motion&) { return value; }};
}

// The penalty of a user's criterion with that value.
double user_penalty(double value, double scale = 1.0) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings.user = {constant(value, 0.1, scale)};
  return score_motion(posed, wild_motion(posed), settings).terms.back().penalty;
}

TEST(Score, NamesItsTermsInOrder) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings.user = {constant(0.5)};
  const Score score = score_motion(posed, wild_motion(posed), settings);
  ASSERT_EQ(score.terms.size(), 4u);
  EXPECT_EQ(score.terms[0].name, "joint_range");
  EXPECT_EQ(score.terms[1].name, "balance");
  EXPECT_EQ(score.terms[2].name, "torque");
  EXPECT_EQ(score.terms[3].name, "constant");
}

TEST(Score, AMotionWithoutTorquesIsRefused) {
  const PosedBody posed = full_body();
  Motion motion = wild_motion(posed);
  motion.torques.clear();
  EXPECT_THROW(static_cast<void>(score_motion(posed, motion, {})), PreconditionError);
}

TEST(Score, AddsUpToItsTotal) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings[CriterionKind::joint_range].weight = 0.7;
  settings.user = {constant(0.5, 0.3), constant(0.2, 2.0)};
  const Score score = score_motion(posed, wild_motion(posed), settings);
  double sum = 0.0;
  for (const ScoreTerm& term : score.terms) sum += term.weight * term.penalty;
  EXPECT_DOUBLE_EQ(score.total, sum);
  EXPECT_EQ(score.terms[0].weight, 0.7);
  EXPECT_EQ(score.terms[3].weight, 0.3);
}

TEST(CriteriaTable, NamesEachCriterionOnceInTheOrderOfItsKind) {
  std::set<std::string_view> names;
  for (std::size_t k = 0; k < kCriteria.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(kCriteria[k].kind), k) << kCriteria[k].word;
    EXPECT_GT(kCriteria[k].scale, 0.0) << kCriteria[k].word;
    names.insert(kCriteria[k].word);
  }
  EXPECT_EQ(names.size(), kCriteria.size());
}

TEST(CriteriaPresets, OfThePaperAreItsThree) {
  for (const CriteriaSettings& settings : {CriteriaSettings{}, paper_criteria()}) {
    for (const auto& [kind, name, counts, scale_name, scale] : kCriteria) {
      const double weight = name == "joint_range" ? 0.5
                            : name == "balance"   ? 0.3
                            : name == "torque"    ? 0.2
                                                  : 0.0;
      EXPECT_EQ(settings[kind].weight, weight) << name;
      EXPECT_EQ(settings[kind].scale, scale) << name;
    }
  }
}

// The weights of the column `default` in the table of docs/criteria.md.
std::map<std::string, double> documented_weights() {
  std::map<std::string, double> weights;
  std::ifstream docs(std::string(SHIGUSA_SOURCE_DIR) + "/docs/criteria.md");
  for (std::string line; std::getline(docs, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    const std::string name = cells.at(1).substr(2, cells.at(1).rfind('`') - 2);
    const bool weighs = cells.at(5).find_first_not_of(' ') != std::string::npos;
    weights[name] = weighs ? std::stod(cells.at(5)) : 0.0;
  }
  return weights;
}

TEST(CriteriaPresets, DefaultIsTheMixtureOfTheDocs) {
  const std::map<std::string, double> documented = documented_weights();
  const CriteriaSettings settings = default_criteria();
  for (const CriterionTraits& criterion : kCriteria) {
    const std::string name(criterion.word);
    ASSERT_TRUE(documented.contains(name)) << name;
    EXPECT_EQ(settings[criterion.kind].weight, documented.at(name)) << name;
  }
  EXPECT_EQ(documented.size(), kCriteria.size());
}

// A criterion's type states that it needs the body's placement, so it cannot get a frame without
// one.
static_assert(looks_at_placement<Head<double>, double>);
static_assert(looks_at_placement<Collision<double>, double>);
static_assert(looks_at_placement<CentreOfPressure<double>, double>);
static_assert(looks_at_placement<Feasibility<double>, double>);
static_assert(looks_at_placement<Coordination<double>, double>);
static_assert(looks_at_placement<HandCurve<double>, double>);
static_assert(looks_at_placement<TrunkTravel<double>, double>);
static_assert(looks_at_placement<MassAhead<double>, double>);
static_assert(looks_at_placement<Jolts<double>, double>);
static_assert(!looks_at_placement<JointRange<double>, double>);

TEST(Score, FramesWithoutPlacementAreRefusedWhereACriterionLooksAtIt) {
  const PosedBody posed = full_body();
  BuiltInCriteria<double> paper(posed, at_start(posed), paper_criteria());
  EXPECT_FALSE(paper.needs_placement());
  BuiltInCriteria<double> usual(posed, at_start(posed), default_criteria());
  EXPECT_TRUE(usual.needs_placement());
  EXPECT_THROW(usual.add(MotionFrame<double>{}), PreconditionError);
}

TEST(CriteriaPresets, HaveNames) {
  ASSERT_EQ(criteria_presets().size(), 3u);
  EXPECT_EQ(criteria_presets()[0].name, "paper");
  EXPECT_EQ(criteria_presets()[0].settings()[CriterionKind::torque].weight, kPaperTorqueWeight);
  EXPECT_EQ(criteria_presets()[1].name, "default");
  EXPECT_EQ(criteria_presets()[1].settings()[CriterionKind::torque].weight, 0.0);
  EXPECT_EQ(criteria_presets()[2].name, "pareto");
  EXPECT_DOUBLE_EQ(worst_score(criteria_presets()[2].settings()), 1.0);
}

TEST(Score, LeavesOutWhatHasNoWeight) {
  const PosedBody posed = full_body();
  CriteriaSettings settings = default_criteria();
  settings[CriterionKind::joint_range].weight = 0.0;
  std::vector<std::string> weighed;
  for (const CriterionTraits& criterion : kCriteria) {
    if (settings[criterion.kind].weight > 0.0) weighed.emplace_back(criterion.word);
  }
  std::vector<std::string> names;
  for (const ScoreTerm& term : score_motion(posed, wild_motion(posed), settings).terms) {
    names.push_back(term.name);
  }
  EXPECT_EQ(names, weighed);
  EXPECT_THAT(names, testing::Contains("balance_zone"));
  EXPECT_THAT(names, testing::Not(testing::Contains("joint_range")));
  EXPECT_THAT(names, testing::Not(testing::Contains("work")));
}

TEST(Score, TermsOfAllCriteriaAreTheirPenalties) {
  const PosedBody posed = full_body();
  const Motion motion = wild_motion(posed);
  const Score score = score_motion(posed, motion, every_criterion(), looking_at_goal(posed));
  std::size_t at = 0;
  for_each_class([&]<template <class> class CriterionOf>() {
    EXPECT_EQ(score.terms.at(at).name, word_of(CriterionOf<double>::kKind));
    EXPECT_EQ(score.terms.at(at++).penalty,
              penalty_by<CriterionOf>(posed, motion, looking_at_goal(posed)));
  });
  EXPECT_EQ(score.terms.size(), at);
}

TEST(Score, PenaltiesStayWithinZeroAndOneForAnyMotion) {
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) {
    Random random(62);
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<std::vector<double>> frames;
      for (int f = 0; f < 4; ++f) frames.push_back(random_vector(posed, -4.0, 4.0, random));
      Motion motion = motion_through(posed, frames);
      for (double& tau : motion.torques) tau = random.uniform(-1e4, 1e4);
      for (const ScoreTerm& term :
           score_motion(posed, motion, every_criterion(), looking_at_goal(posed)).terms) {
        ASSERT_GE(term.penalty, 0.0) << term.name;
        ASSERT_LE(term.penalty, 1.0) << term.name;
      }
    }
  }
}

TEST(Score, FrameByFrameIsTheSameAsOfTheWholeMotion) {
  const PosedBody posed = full_body();
  const Motion motion = wild_motion(posed);
  const CriteriaSettings settings;
  BuiltInCriteria<double> built_in(posed, {.start = motion.clip.state(0)}, settings);
  const std::size_t n = posed.body.dofs().size();
  for (int f = 0; f < motion.clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f);
    built_in.add(MotionFrame<double>{motion.clip.frame(f),
                                     std::span(motion.torques).subspan(k * n, n),
                                     motion.centre_of_mass[k]});
  }
  EXPECT_EQ(built_in.score(), score_motion(posed, motion, settings).total);
}

// The search reuses a criterion for one motion after the other.
TEST(Score, CriteriaForgetTheMotionBefore) {
  const PosedBody posed = human_body();
  const Motion before = wild_motion(posed);
  std::vector<std::vector<double>> frames(5, {posed.home.angles.begin(), posed.home.angles.end()});
  for (std::size_t f = 0; f < frames.size(); ++f) frames[f][7] += 0.01 * static_cast<double>(f);
  const Motion motion = motion_through(posed, frames);
  const CriteriaContext context = looking_at_goal(posed);
  for_each_class([&]<template <class> class CriterionOf>() {
    constexpr CriterionKind kKind = CriterionOf<double>::kKind;
    CriterionOf<double> used(posed, context, CriteriaSettings()[kKind].scale);
    EXPECT_EQ(used.penalty(), 0.0) << word_of(kKind);
    show_motion(posed, before, used);
    EXPECT_GT(used.penalty(), 0.0) << word_of(kKind);
    used.reset();
    EXPECT_EQ(used.penalty(), 0.0) << word_of(kKind);
    show_motion(posed, motion, used);
    EXPECT_EQ(used.penalty(), penalty_by<CriterionOf>(posed, motion, context)) << word_of(kKind);
  });
}

// Penalties consist of means and maxima over the frames, which for equal frames are those of one
// frame.
TEST(Score, AStillMotionIsTheSameOfOneFrameAndOfMany) {
  const PosedBody posed = full_body();
  // leaning far, an arm in the trunk and beyond its limits
  std::vector<double> posture(posed.home.angles.begin(), posed.home.angles.end());
  posture[static_cast<std::size_t>(posed.body.find_dof("right_elbow.flexion").value())] += 2.6;
  posture[static_cast<std::size_t>(posed.body.find_dof("right_shoulder.abduction").value())] -= 1.2;
  posture[static_cast<std::size_t>(posed.body.find_dof("right_hip.flexion").value())] += 1.5;
  posture[static_cast<std::size_t>(posed.body.find_dof("right_ankle.flexion").value())] += 0.5;
  const auto score = [&](std::size_t frames) {
    Motion motion = motion_through(posed, std::vector<std::vector<double>>(frames, posture));
    for (double& tau : motion.torques) tau = 40.0;
    return score_motion(posed, motion, every_criterion(), looking_at_goal(posed));
  };
  const Score one = score(1);
  const Score many = score(5);
  for (std::size_t i = 0; i < one.terms.size(); ++i) {
    const std::string& name = one.terms[i].name;
    EXPECT_NEAR(one.terms[i].penalty, many.terms[i].penalty, 1e-12) << name;
    // a body at rest neither accelerates nor works, and nothing changes
    const bool still =
        name == "joint_acceleration" || name == "work" || name == "hand_curve" || name == "jolts";
    EXPECT_EQ(one.terms[i].penalty == 0.0, still) << name;
  }
}

TEST(WorstScore, IsReachedByNoMotion) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings.user = {constant(1e9, 0.4)};
  EXPECT_DOUBLE_EQ(worst_score(settings), 1.4);
  EXPECT_LT(score_motion(posed, wild_motion(posed), settings).total, worst_score(settings));
}

TEST(UserCriterion, IsMeasuredByItsScale) {
  EXPECT_DOUBLE_EQ(user_penalty(0.3), 0.3);
  EXPECT_DOUBLE_EQ(user_penalty(30.0, 100.0), 0.3);
}

TEST(UserCriterion, IsHeldBetweenZeroAndOne) {
  EXPECT_EQ(user_penalty(-5.0), 0.0);
  EXPECT_EQ(user_penalty(5.0), 1.0);
  EXPECT_EQ(user_penalty(std::numeric_limits<double>::infinity()), 1.0);
  EXPECT_EQ(user_penalty(-std::numeric_limits<double>::infinity()), 0.0);
}

TEST(UserCriterion, NaNMakesTheScoreNaN) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings.user = {constant(kNaN), constant(0.5)};
  EXPECT_TRUE(std::isnan(score_motion(posed, wild_motion(posed), settings).total));
}

TEST(UserCriterion, SeesTheMotion) {
  const PosedBody posed = full_body();
  CriteriaSettings settings;
  settings.user = {{.name = "frames",
                    .weight = 1.0,
                    .scale = 10.0,
                    .value = [](const BodyModel& b, const Motion& m) {
                      EXPECT_EQ(b.name(), "full_body");
                      return static_cast<double>(m.clip.frames);
                    }}};
  EXPECT_DOUBLE_EQ(score_motion(posed, wild_motion(posed), settings).terms.back().penalty, 0.5);
}

}  // namespace
}  // namespace shigusa
