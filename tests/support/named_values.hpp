// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>

#include "plan/plan.hpp"

// A plan's values by the names of their parameters.
namespace shigusa::testing_support {

// NaN where the values have none of that name.
inline double named_value(std::span<const Layer> plan, Parameters values, std::string_view name) {
  for (const Parameter& parameter : parameters_of(plan, values)) {
    if (parameter.info->name == name) return parameter.value();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

inline void fix_value(std::span<const Layer> plan, std::string_view name, double value,
                      FixedParameters& fixed) {
  const std::vector<Parameter> all = parameters_of(plan, fixed.values);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].info->name != name) continue;
    all[i].set(value);
    fixed.set[i] = true;
  }
}

}  // namespace shigusa::testing_support
