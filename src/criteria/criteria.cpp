// SPDX-License-Identifier: MIT
#include <shigusa/criteria/criteria.hpp>

namespace shigusa {

double worst_score(const CriteriaSettings& settings) {
  double sum = settings.joint_range_weight + settings.balance_weight + settings.torque_weight;
  for (const UserCriterion& user : settings.user) sum += user.weight;
  return sum;
}

Score score_motion(const BodyModel& body, const Motion& motion, const CriteriaSettings& settings) {
  Score score;
  score.terms = {
      {"joint_range", settings.joint_range_weight,
       joint_range_penalty(body, motion, settings.joint_range)},
      {"balance", settings.balance_weight, balance_penalty(body, motion, settings.balance)},
      {"torque", settings.torque_weight, torque_penalty(body, motion, settings.torque)},
  };
  for (const UserCriterion& user : settings.user) {
    const double value = user.value(body, motion) / user.scale;
    // a NaN passes through, to be counted by the search
    const double penalty = value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
    score.terms.push_back({user.name, user.weight, penalty});
  }
  for (const ScoreTerm& term : score.terms) score.total += term.weight * term.penalty;
  return score;
}

}  // namespace shigusa
