// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/run.hpp>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"
#include "criteria/built_in_criteria.hpp"
#include "replay.hpp"
#include "user_criteria.hpp"
#include "with_start.hpp"

namespace shigusa {

CriteriaSettings paper_criteria() { return {}; }

CriteriaSettings default_criteria() {
  return {{CriterionKind::joint_range, 0.25},
          {CriterionKind::balance_zone, 0.20},
          {CriterionKind::discomfort, 0.2},
          {CriterionKind::joint_acceleration, 0.10},
          {CriterionKind::low_back, 0.20},
          {CriterionKind::collision, 2.0},
          {CriterionKind::centre_of_pressure, 1.0},
          {CriterionKind::feasibility, 2.0},
          {CriterionKind::coordination, 1.0},
          {CriterionKind::hand_curve, 1.5},
          {CriterionKind::trunk_travel, 2},
          {CriterionKind::mass_ahead, 1.0},
          {CriterionKind::jolts, 1.0}};
}

CriteriaSettings pareto_criteria() {
  return {{CriterionKind::discomfort, 1.0 / 3.0},
          {CriterionKind::balance, 1.0 / 3.0},
          {CriterionKind::torque, 1.0 / 3.0}};
}

std::span<const CriteriaPreset> criteria_presets() {
  static constexpr std::array<CriteriaPreset, 3> kPresets{
      {{"paper", paper_criteria}, {"default", default_criteria}, {"pareto", pareto_criteria}}};
  return kPresets;
}

double worst_score(const CriteriaSettings& settings) {
  double sum = 0.0;
  for (const CriterionSetting& setting : settings.built_in) sum += setting.weight;
  for (const UserCriterion& user : settings.user) sum += user.weight;
  return sum;
}

CriteriaContext with_start(CriteriaContext context, const Clip& clip) {
  if (context.start.angles.empty() && clip.frames > 0) context.start = clip.state(0);
  return context;
}

namespace {

Score score_built_in(const BodyModel& body, const Motion& motion, const CriteriaSettings& settings,
                     const CriteriaContext& context) {
  const Clip& clip = motion.clip;
  SHG_CHECK(clip.dofs == body.dof_count(), "a clip has the body's freedoms");
  const auto frames = static_cast<std::size_t>(clip.frames);
  SHG_CHECK(motion.torques.size() == frames * static_cast<std::size_t>(clip.dofs) &&
                motion.centre_of_mass.size() == frames,
            "a motion has torques and a centre of mass for each frame");
  Score score;
  BuiltInCriteria<double> built_in(body, with_start(context, clip), settings);
  show_motion(body, motion, built_in);
  built_in.visit_penalties([&score](std::string_view name, double weight, double penalty) {
    score.terms.push_back({std::string(name), weight, penalty});
  });
  return score;
}

// Adds the terms of user-defined criteria to the scores (motions), and all terms up.
void add_up(const BodyModel& body, std::span<const Motion> motions,
            std::span<const UserCriterion> user, std::span<Score> scores) {
  for (const UserCriterion& own : user) {
    const std::vector<double> penalties = penalties_of(own, body, motions);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i].terms.push_back({own.name, own.weight, penalties[i]});
    }
  }
  for (Score& score : scores) {
    for (const ScoreTerm& term : score.terms) score.total += term.weight * term.penalty;
  }
}

}  // namespace

std::vector<double> penalties_of(const UserCriterion& user, const BodyModel& body,
                                 std::span<const Motion> motions) {
  std::vector<double> values(motions.size());
  if (user.values) {
    if (!motions.empty()) user.values(body, motions, values);
  } else {
    for (std::size_t i = 0; i < motions.size(); ++i) values[i] = user.value(body, motions[i]);
  }
  for (double& value : values) {
    value /= user.scale;
    // a NaN passes through, and is counted by the search
    value = value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
  }
  return values;
}

Score score_motion(const BodyModel& body, const Motion& motion, const CriteriaSettings& settings,
                   const CriteriaContext& context) {
  Score score = score_built_in(body, motion, settings, context);
  add_up(body, {&motion, 1}, settings.user, {&score, 1});
  return score;
}

void score_motions(const BodyModel& body, std::span<std::optional<Motion>> motions,
                   const CriteriaSettings& settings, const CriteriaContext& context, int threads,
                   std::span<double> scores) {
  std::vector<Motion> made;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    scores[i] = worst_score(settings);
    if (!motions[i]) continue;
    made.push_back(std::move(*motions[i]));
    places.push_back(i);
  }
  std::vector<Score> told(made.size());
  parallel_for(static_cast<int>(made.size()), threads, [&](int i, int) {
    told[index(i)] = score_built_in(body, made[index(i)], settings, context);
  });
  add_up(body, made, settings.user, told);
  for (std::size_t i = 0; i < made.size(); ++i) scores[places[i]] = told[i].total;
}

std::vector<std::string> criterion_names() {
  std::vector<std::string> names;
  for (const CriterionTraits& criterion : kCriteria) names.emplace_back(criterion.word);
  return names;
}

}  // namespace shigusa
