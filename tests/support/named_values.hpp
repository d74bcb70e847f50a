// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <shigusa/parameters.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "body/posture_modes.hpp"
#include "plan/plan.hpp"

// Access to parameter values by name.
namespace shigusa::testing_support {

// All parameters of the whole body.
inline ParameterList list_of(const BodyModel& body, std::span<const Support> supports = {}) {
  return parameter_list(whole_body_plan(body, supports));
}

// Index of the first parameter with that name, such as "squat", or that spelling.
inline std::size_t number_of(const ParameterList& list, std::string_view name) {
  if (const auto spelled = list.find(name)) return *spelled;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list.all[i].name == name) return i;
  }
  throw std::invalid_argument("no parameter " + std::string(name));
}

inline double& value_of(const ParameterList& list, Parameters& parameters, std::string_view name) {
  return parameters.values[number_of(list, name)];
}
inline double value_of(const ParameterList& list, const Parameters& parameters,
                       std::string_view name) {
  return parameters.values[number_of(list, name)];
}

// The same for values of the whole body.
inline double& value_of(const BodyModel& body, Parameters& parameters, std::string_view name) {
  return value_of(list_of(body), parameters, name);
}
inline double value_of(const BodyModel& body, const Parameters& parameters, std::string_view name) {
  return value_of(list_of(body), parameters, name);
}
inline std::vector<double> modes_of(const BodyModel& body, const Parameters& parameters) {
  return list_of(body).of_kind(ParameterKind::mode, parameters);
}

// Sets the posture of whole-body values: value(mode) for each mode, in order.
template <class Value>
void pose(const BodyModel& body, Parameters& parameters, Value&& value) {
  std::size_t number = body.dofs().size();
  for (const PostureMode& mode : posture_modes(body)) parameters.values[number++] = value(mode);
  parameters.posed = true;
}

inline void lock_all(Parameters& parameters, bool locked = true) {
  parameters.locked.assign(parameters.locked.size(), locked);
}

inline void fix_value(const ParameterList& list, std::string_view name, double value,
                      FixedParameters& fixed) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list.all[i].name != name) continue;
    fixed.values.values[i] = value;
    fixed.set[i] = true;
  }
}

}  // namespace shigusa::testing_support
