// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>

#include "criteria/replay.hpp"

namespace shigusa::testing_support {

// A criterion's penalty for a whole motion: penalty_by<Torque>(body, motion, {.share = 0.5}).
template <template <class> class Criterion>
double penalty_by(const BodyModel& body, const Motion& motion,
                  const typename Criterion<double>::Settings& settings = {}) {
  Criterion<double> criterion(body, settings);
  show_motion(body, motion, criterion);
  return criterion.penalty();
}

}  // namespace shigusa::testing_support
