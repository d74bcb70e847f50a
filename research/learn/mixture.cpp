// SPDX-License-Identifier: MIT
#include "mixture.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "criteria/built_in_criteria.hpp"

namespace shigusa::bench {
namespace {

// Weights that are searched; the others ensure that a motion is possible.
constexpr std::array kWeights{
    "joint_range",  "torque",     "balance_zone", "discomfort",   "joint_acceleration",
    "work",         "low_back",   "head",         "coordination", "hand_curve",
    "trunk_travel", "mass_ahead", "jolts"};
// Scales that a search may change by a factor of kScaleChange in either direction.
constexpr std::array kScales{"hand_curve", "coordination", "mass_ahead", "trunk_travel"};
constexpr double kScaleChange = 4.0;

CriterionSetting* setting_of(CriteriaSettings& mixture, const std::string& name) {
  for (const CriterionTraits& criterion : kCriteria) {
    if (name == criterion.word) return &mixture[criterion.kind];
  }
  return nullptr;
}
double* weight_of(CriteriaSettings& mixture, const std::string& name) {
  CriterionSetting* found = setting_of(mixture, name);
  return found == nullptr ? nullptr : &found->weight;
}
double* scale_of(CriteriaSettings& mixture, const std::string& name) {
  CriterionSetting* found = setting_of(mixture, name);
  return found == nullptr ? nullptr : &found->scale;
}

// Calls visit(name, weight, scale name, scale, usual scale) for each criterion.
template <class Visitor>
void for_each_member(const CriteriaSettings& mixture, Visitor&& visit) {
  for (const CriterionTraits& criterion : kCriteria) {
    const CriterionSetting& setting = mixture[criterion.kind];
    visit(std::string(criterion.word), setting.weight, std::string(criterion.scale_name),
          setting.scale, criterion.scale);
  }
}

}  // namespace

MixtureSpace::MixtureSpace(CriteriaSettings fixed, bool scales) : fixed_(std::move(fixed)) {
  for (const char* name : kWeights) {
    members_.push_back({weight_of, name, kLeastWeight, kMostWeight, true});
  }
  if (!scales) return;
  for (const char* name : kScales) {
    const double now = *scale_of(fixed_, name);
    members_.push_back({scale_of, name, now / kScaleChange, now * kScaleChange, false});
  }
}

CriteriaSettings MixtureSpace::mixture(std::span<const double> point) const {
  CriteriaSettings made = fixed_;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& m = members_[i];
    const double value = m.least * exponential(point[i] * natural_log(m.most / m.least));
    *m.of(made, m.name) = m.weight && value < kDropped ? 0.0 : value;
  }
  return made;
}

std::vector<double> MixtureSpace::point(const CriteriaSettings& mixture) const {
  CriteriaSettings from = mixture;
  std::vector<double> at;
  for (const Member& m : members_) {
    const double value = max(*m.of(from, m.name), m.least);
    at.push_back(clamp(natural_log(value / m.least) / natural_log(m.most / m.least), 0.0, 1.0));
  }
  return at;
}

Result<void> set_weights(std::string_view text, CriteriaSettings& mixture) {
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    const std::string name(part.substr(0, equals));
    double* member = weight_of(mixture, name);
    if (name.ends_with(".scale")) member = scale_of(mixture, name.substr(0, name.size() - 6));
    const char* end = part.data() + part.size();
    double value = -1.0;
    if (equals != part.npos) std::from_chars(part.data() + equals + 1, end, value);
    if (member == nullptr || value < 0.0) {
      return fail(ErrorCode::invalid_argument, fmt::format("\"{}\" is no weight", part));
    }
    *member = value;
  }
  return {};
}

std::string weights_text(const CriteriaSettings& mixture) {
  std::string text;
  for_each_member(mixture, [&](const std::string& name, double weight, const std::string&,
                               double scale, double usual) {
    if (weight > 0.0) text += fmt::format("{}{}={:.3g}", text.empty() ? "" : ",", name, weight);
    if (weight > 0.0 && scale != usual) text += fmt::format(",{}.scale={:.3g}", name, scale);
  });
  return text;
}

std::string weights_code(const CriteriaSettings& mixture) {
  std::string code;
  for_each_member(mixture, [&](const std::string& name, double weight,
                               const std::string& scale_name, double scale, double usual) {
    if (weight <= 0.0) return;
    const char* member = name == "centre_of_pressure" ? "pressure" : name.c_str();
    code += fmt::format("  settings.{}_weight = {:.3g};\n", member, weight);
    if (scale != usual) code += fmt::format("  // {}'s {} is {:.3g}\n", name, scale_name, scale);
  });
  return code;
}

std::string weights_json(const CriteriaSettings& mixture) {
  std::string json;
  for_each_member(mixture, [&](const std::string& name, double weight,
                               const std::string& scale_name, double scale, double) {
    json += fmt::format("{}\"{}\": {{\"weight\": {:.4g}, \"{}\": {:.4g}}}",
                        json.empty() ? "{" : ", ", name, weight, scale_name, scale);
  });
  return json + "}";
}

}  // namespace shigusa::bench
