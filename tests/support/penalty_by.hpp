// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>

#include "criteria/replay.hpp"

namespace shigusa::testing_support {

// A criterion's penalty for a whole motion that begins in the body's start posture.
template <template <class> class Criterion>
double penalty_by(const PosedBody& body, const Motion& motion, double scale,
                  CriteriaContext context = {}) {
  if (context.start.angles.empty()) context.start = body.home;
  Criterion<double> criterion(body.body, context, scale);
  show_motion(body.body, motion, criterion);
  return criterion.penalty();
}
template <template <class> class Criterion>
double penalty_by(const PosedBody& body, const Motion& motion,
                  const CriteriaContext& context = {}) {
  const double usual = CriteriaSettings()[Criterion<double>::kKind].scale;
  return penalty_by<Criterion>(body, motion, usual, context);
}

}  // namespace shigusa::testing_support
