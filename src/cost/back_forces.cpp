// SPDX-License-Identifier: MIT
#include <shigusa/ergonomics.hpp>

namespace shigusa {
namespace {

// Revised Dortmund limits at two ages.
struct AgeLimits {
  double young;  // N, at kYoung
  double old;    // N, at kOld and above
};
constexpr double kYoung = 20.0;
constexpr double kOld = 60.0;
constexpr AgeLimits kMen{5400.0, 2200.0};
constexpr AgeLimits kWomen{4100.0, 1800.0};

}  // namespace

BackForces back_forces(double moment, double weight, double lean, double lever) {
  const SinCos<double> tilt = sin_cos(lean);
  const double muscle = abs(moment) / lever;
  return {muscle, muscle + weight * tilt.cos, weight * tilt.sin};
}

double back_limit(double age, Sex sex) {
  const AgeLimits& limits = sex == Sex::male ? kMen : kWomen;
  const double share = clamp((age - kYoung) / (kOld - kYoung), 0.0, 1.0);
  return limits.young + (limits.old - limits.young) * share;
}

}  // namespace shigusa
