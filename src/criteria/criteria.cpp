// SPDX-License-Identifier: MIT
#include <array>

#include "core/check.hpp"
#include "criteria/built_in_criteria.hpp"
#include "replay.hpp"

namespace shigusa {

void set_reaching(CriteriaSettings& settings, const std::vector<int>& effectors) {
  settings.coordination.effectors = settings.hand_curve.effectors = effectors;
  settings.trunk_travel.effectors = settings.mass_ahead.effectors = effectors;
}

CriteriaSettings paper_criteria() { return {}; }

CriteriaSettings default_criteria() {
  CriteriaSettings settings;
  for_each_criterion([&](const auto& entry) { entry.weight(settings) = 0.0; });
  settings.joint_range_weight = 0.25;
  settings.balance_zone_weight = 0.20;
  settings.discomfort_weight = 0.2;
  settings.joint_acceleration_weight = 0.10;
  settings.low_back_weight = 0.20;
  settings.collision_weight = 2.0;
  settings.pressure_weight = 1.0;
  settings.feasibility_weight = 2.0;
  settings.coordination_weight = 1.0;
  settings.hand_curve_weight = 1.5;
  settings.trunk_travel_weight = 0.4;
  settings.mass_ahead_weight = 1.0;
  settings.jolts_weight = 1.0;
  return settings;
}

CriteriaSettings pareto_criteria() {
  CriteriaSettings settings;
  for_each_criterion([&](const auto& entry) { entry.weight(settings) = 0.0; });
  settings.discomfort_weight = settings.balance_weight = settings.torque_weight = 1.0 / 3.0;
  return settings;
}

std::span<const CriteriaPreset> criteria_presets() {
  static constexpr std::array<CriteriaPreset, 3> kPresets{
      {{"paper", paper_criteria}, {"default", default_criteria}, {"pareto", pareto_criteria}}};
  return kPresets;
}

double worst_score(const CriteriaSettings& settings) {
  double sum = 0.0;
  for_each_criterion([&](const auto& entry) { sum += entry.weight(settings); });
  for (const UserCriterion& user : settings.user) sum += user.weight;
  return sum;
}

Score score_motion(const BodyModel& body, const Motion& motion, const CriteriaSettings& settings) {
  const Clip& clip = motion.clip;
  SHG_CHECK(clip.dofs == body.dof_count(), "a clip has the body's freedoms");
  const auto frames = static_cast<std::size_t>(clip.frames);
  SHG_CHECK(motion.torques.size() == frames * static_cast<std::size_t>(clip.dofs) &&
                motion.centre_of_mass.size() == frames,
            "a motion has torques and a centre of mass for each frame");
  Score score;
  BuiltInCriteria<double> built_in(body, settings);
  show_motion(body, motion, built_in);
  built_in.visit_penalties([&score](const char* name, double weight, double penalty) {
    score.terms.push_back({name, weight, penalty});
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
  for_each_criterion([&](const auto& criterion) { names.emplace_back(criterion.name); });
  return names;
}

}  // namespace shigusa
