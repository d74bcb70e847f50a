// SPDX-License-Identifier: MIT
#include "plan/parameter_info.hpp"

#include <algorithm>
#include <utility>

#include "body/joint_name.hpp"
#include "core/say.hpp"

namespace shigusa {
namespace {

// The group of a name: "right_leg" for "right_knee.flexion", "legs", "trunk".
std::string limb_group(std::string_view name) {
  const JointPlace part = parse_joint_name(name);
  if (part.limb == LimbKind::trunk) return "trunk";
  if (!part.side) return part.limb == LimbKind::leg ? "legs" : "arms";
  const std::string side = part.side == Side::left ? "left_" : "right_";
  return side + (part.limb == LimbKind::leg ? "leg" : "arm");
}

std::string group_of(ParameterKind kind, std::string_view name) {
  const bool of_limb = !info_of(kind).word.empty() || parse_joint_name(name).side;
  if (of_limb) return limb_group(name);
  return kind == ParameterKind::timing ? "path" : "posture";
}

}  // namespace

ParameterInfo parameter_info(ParameterKind kind, std::string name, std::vector<int> applies_to) {
  const ParameterKindInfo& common = info_of(kind);
  ParameterInfo info{.name = std::move(name), .kind = kind, .applies_to = std::move(applies_to)};
  info.start = kind == ParameterKind::weight ? 1.0 : 0.0;
  info.group = group_of(kind, info.name);
  info.sentence = common.sentence;
  return within(std::move(info), common.low, common.high);
}

ParameterInfo within(ParameterInfo info, double least, double most) {
  info.low = info.shown_low = least;
  info.high = info.shown_high = most;
  return info;
}

std::string ParameterInfo::subject() const {
  const bool of_layer = kind == ParameterKind::weight && !layer.empty();
  return of_layer ? layer + "." + name : name;
}

std::string ParameterInfo::spelled(std::string_view unit) const {
  const ParameterKindInfo& common = info_of(kind);
  std::string text = subject();
  if (!common.word.empty()) text.append(".").append(common.word);
  return common.angle ? text.append(unit) : text;
}

std::vector<std::string> ParameterList::names() const {
  std::vector<std::string> names;
  for (const ParameterInfo& info : all) names.push_back(info.spelled("_rad"));
  return names;
}

std::optional<std::size_t> ParameterList::find(std::string_view spelled) const {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].spelled("_rad") == spelled || all[i].spelled("_deg") == spelled) return i;
  }
  return std::nullopt;
}

bool ParameterList::has_posture() const {
  return std::any_of(all.begin(), all.end(),
                     [](const ParameterInfo& info) { return info.of_posture(); });
}

std::vector<double> ParameterList::of_kind(ParameterKind kind, const Parameters& values) const {
  std::vector<double> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind == kind) found.push_back(values.values[i]);
  }
  return found;
}

Parameters ParameterList::start() const {
  Parameters start{.locked = std::vector<bool>(size())};
  for (const ParameterInfo& info : all) start.values.push_back(info.start);
  return start;
}

Result<void> ParameterList::check(const Parameters& values) const {
  if (values.values.size() != size() || values.locked.size() != size()) {
    return fail(ErrorCode::invalid_argument, say("plan_counts", values.values.size(), size()));
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const ParameterInfo& info = all[i];
    if (values.values[i] >= info.low && values.values[i] <= info.high) continue;
    const std::string_view word = info_of(info.kind).word;
    return fail(ErrorCode::invalid_argument,
                say("parameter_range", word.empty() ? "value" : word, values.values[i], info.low,
                    info.high),
                info.subject());
  }
  return {};
}

FixedParameters no_fixed_parameters(const ParameterList& list) {
  return {list.start(), std::vector<bool>(list.size())};
}

}  // namespace shigusa
