// SPDX-License-Identifier: MIT
#include <array>

#include "core/check.hpp"
#include "criteria/built_in_criteria.hpp"
#include "replay.hpp"
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

Score score_motion(const BodyModel& body, const Motion& motion, const CriteriaSettings& settings,
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
  for (const UserCriterion& user : settings.user) {
    const double value = user.value(body, motion) / user.scale;
    // a NaN passes through, and is counted by the search
    const double penalty = value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
    score.terms.push_back({user.name, user.weight, penalty});
  }
  for (const ScoreTerm& term : score.terms) score.total += term.weight * term.penalty;
  return score;
}

std::vector<std::string> criterion_names() {
  std::vector<std::string> names;
  for (const CriterionTraits& criterion : kCriteria) names.emplace_back(criterion.word);
  return names;
}

}  // namespace shigusa
