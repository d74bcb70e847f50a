// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/edit.hpp>

#include "formats/json_text.hpp"
#include "problem/plan_of.hpp"

namespace shigusa {
namespace {

// The parameters that change a motion most come first.
bool comes_first(const Parameter& parameter) { return info_of(parameter.info->kind).word.empty(); }

EditableParameter editable(const Parameter& parameter) {
  const ParameterInfo& info = *parameter.info;
  const bool angle = info_of(info.kind).angle;
  const auto shown = [angle](double value) { return angle ? degrees(value) : value; };
  return {.name = parameter.spelled(),
          .group = info.group,
          .kind = parameter.locked != nullptr ? EditableKind::weight
                  : angle                     ? EditableKind::angle
                                              : EditableKind::share,
          .value = shown(parameter.value()),
          // of what is allowed, what makes sense
          .low = shown(min(info.shown_low, parameter.value())),
          .high = shown(max(info.shown_high, parameter.value())),
          .locked = parameter.locked != nullptr && *parameter.locked,
          .sentence = info.sentence};
}

}  // namespace

Result<std::vector<EditableParameter>> editable_parameters(const Task& task,
                                                           const Candidate& candidate) {
  SHG_TRY_ASSIGN(const Plan plan, plan_of(task));
  Parameters values = candidate.parameters;
  give_posture(plan, values);
  std::vector<Parameter> all = parameters_of(plan, values);
  std::stable_partition(all.begin(), all.end(), comes_first);
  std::vector<EditableParameter> list;
  for (const Parameter& parameter : all) list.push_back(editable(parameter));
  return list;
}

std::string format_parameters(const std::vector<EditableParameter>& parameters) {
  constexpr const char* kKinds[] = {"weight", "angle", "share"};
  Json list = Json::array();
  for (const EditableParameter& p : parameters) {
    list.push_back({{"name", p.name},
                    {"group", p.group},
                    {"kind", kKinds[static_cast<std::size_t>(p.kind)]},
                    {"value", p.value},
                    {"low", p.low},
                    {"high", p.high},
                    {"scale", p.kind == EditableKind::weight ? "log" : "linear"},
                    {"unit", p.kind == EditableKind::angle ? "deg" : ""},
                    {"locked", p.locked},
                    {"sentence", p.sentence}});
  }
  return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
