// SPDX-License-Identifier: MIT
#include <shigusa/facts.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/result_file.hpp>
#include <shigusa/skeleton.hpp>

#include "criteria/built_in_criteria.hpp"
#include "io/json_text.hpp"

namespace shigusa {
namespace {

constexpr int kFactsVersion = 1;
constexpr int kEvaluationsMax = 1'000'000'000;  // that a task file may have

Json weights_to_json(CriteriaSettings criteria) {
  Json json;
  for_each_criterion(
      [&](const auto& criterion) { json[criterion.name] = criterion.weight(criteria); });
  return json;
}

// The name of the mixture that a function gives.
std::string_view mixture_of(CriteriaSettings (*settings)()) {
  for (const CriteriaPreset& mixture : criteria_presets()) {
    if (mixture.settings == settings) return mixture.name;
  }
  return {};
}

void add_criteria(Json& json) {
  for_each_criterion([&](const auto& criterion) {
    json["criteria"].push_back({{"name", criterion.name}, {"scale", criterion.scale_name}});
  });
  for (const CriteriaPreset& mixture : criteria_presets()) {
    json["mixtures"][std::string(mixture.name)] = weights_to_json(mixture.settings());
  }
  json["pareto_mixture"] = mixture_of(pareto_criteria);
}

Json preset_to_json(const PresetTraits& traits) {
  return {{"name", traits.word},
          {"mixture", mixture_of(traits.criteria)},
          {"search", word_of(traits.search)},
          {"candidates", traits.candidates},
          {"evaluations", traits.evaluations},
          {"layered", traits.layers.has_value()},
          {"natural", traits.natural}};
}

Json bodies_to_json() {
  Json list = Json::array();
  for (const std::string_view name : kBuiltInCharacters) {
    const Result<BodyModel> body = build_character({.source = std::string(name)});
    list.push_back({{"name", name}, {"dof", body.value().dof_count()}});
  }
  return list;
}

Json bones_to_json() {
  Json list = Json::array();
  for (int bone = 0; bone < kHumanoidBoneCount; ++bone) {
    list.push_back(humanoid_bone_name(static_cast<HumanoidBone>(bone)));
  }
  return list;
}

// What a person may set, by its key in files: [low, high].
Json ranges_to_json() {
  return {{"position_m", {-kGoalRange, kGoalRange}},
          {"load_kg", {0.0, kLoadMax}},
          {"tolerance_m", {0.0, kToleranceMax}},
          {"stature_m", {kStatureMin, kStatureMax}},
          {"mass_kg", {kMassMin, kMassMax}},
          {"seat_m", {kSeatMin, kSeatMax}},
          {"duration_s", {kTaskDurationMin, kTaskDurationMax}},
          {"obstacles", {0, kObstaclesMax}},
          {"phases", {1, kPhasesMax}},
          {"candidates", {1, kResultMaxCandidates}},
          {"evaluations", {kPaperPopulation, kEvaluationsMax}},
          {"fps", {kRateMin, kRateMax}}};
}

// The characters' formats that a format needs one of; none where any character will do.
Json needs_to_json(const FormatInfo& format) {
  Json list = Json::array();
  for (const FormatInfo& file : kFileFormats) {
    const bool meets = file.person && is_file(file.format, format.needs);
    if (meets && format.needs != NeededFile::none) list.push_back(file.word);
  }
  return list;
}

Json format_to_json(const FormatInfo& format) {
  Json endings = Json::array();
  for (const std::string_view ending : format.endings) {
    if (!ending.empty()) endings.push_back(ending);
  }
  const bool here = is_built_with(format.library);
  return {{"name", format.word},
          {"about", format.about},
          {"endings", std::move(endings)},
          {"media_type", format.media_type},
          {"person", here && format.person},
          {"robot", here && format.robot},
          {"clip", here && format.clip},
          {"written", here && format.written},
          {"rated", format.rated},
          {"needs", needs_to_json(format)},
          {"max_bytes", format.max_bytes}};
}

}  // namespace

std::string format_facts() {
  Json json{{"version", kFactsVersion}};
  add_criteria(json);
  for (const PresetTraits& traits : kPresets) json["presets"].push_back(preset_to_json(traits));
  const TaskFile plain;
  json["default_preset"] = word_of(plain.preset);
  json["default_body"] = plain.character.source;
  json["searches"] = all_words<SearchMethod>();
  json["generators"] = all_words<MotionGenerator>();
  json["layer_readings"] = all_words<LayerReading>();
  json["sexes"] = all_words<Sex>();
  json["extents"] = all_words<BodyExtent>();
  json["bodies"] = bodies_to_json();
  json["bones"] = bones_to_json();
  json["ranges"] = ranges_to_json();
  for (const FormatInfo& format : kFileFormats) json["formats"].push_back(format_to_json(format));
  return json.dump(2) + "\n";
}

}  // namespace shigusa
