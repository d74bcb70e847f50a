// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/edit.hpp>

#include "formats/json_text.hpp"
#include "plan/parameter_info.hpp"

namespace shigusa {
namespace {

EditableParameter editable(const ParameterInfo& info, double value, bool locked) {
  const bool angle = info_of(info.kind).angle;
  const auto shown = [angle](double number) { return angle ? degrees(number) : number; };
  return {.name = info.spelled(),
          .group = info.group,
          .kind = info.kind == ParameterKind::weight ? EditableKind::weight
                  : angle                            ? EditableKind::angle
                                                     : EditableKind::share,
          .value = shown(value),
          // the useful part of the allowed range
          .low = shown(min(info.shown_low, value)),
          .high = shown(max(info.shown_high, value)),
          .locked = locked,
          .sentence = info.sentence};
}

}  // namespace

std::vector<EditableParameter> editable_parameters(const ParameterList& list,
                                                   const Parameters& values) {
  std::vector<EditableParameter> editables;
  // those with the largest effect on a motion come first
  for (const bool of_posture : {true, false}) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list.all[i].of_posture() != of_posture) continue;
      editables.push_back(editable(list.all[i], values.values[i], values.locked[i]));
    }
  }
  return editables;
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
