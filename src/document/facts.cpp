// SPDX-License-Identifier: MIT
#include "document/facts.hpp"

#include <shigusa/files.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/motion.hpp>

#include "character/character_fields.hpp"
#include "core/messages.hpp"
#include "criteria/built_in_criteria.hpp"
#include "formats/json_text.hpp"
#include "formats/message_json.hpp"
#include "joint_names.hpp"
#include "problem/request_fields.hpp"

namespace shigusa {
namespace {

constexpr int kFactsVersion = 1;

Json weights_to_json(const CriteriaSettings& criteria) {
  Json json;
  for (const CriterionTraits& criterion : kCriteria) {
    json[std::string(criterion.word)] = criteria[criterion.kind].weight;
  }
  return json;
}

// Name of the mixture that a function returns.
std::string_view mixture_of(CriteriaSettings (*settings)()) {
  for (const CriteriaPreset& mixture : criteria_presets()) {
    if (mixture.settings == settings) return mixture.name;
  }
  return {};
}

void add_criteria(Json& json) {
  for (const CriterionTraits& criterion : kCriteria) {
    json["criteria"].push_back({{"name", criterion.word}, {"scale", criterion.scale_name}});
  }
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
    const Result<PosedBody> body = build_character({.source = std::string(name)});
    list.push_back({{"name", name}, {"dof", body.value().body.dof_count()}});
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

// Adds the bounds of a struct's fields, by their keys in files, as [low, high].
template <class Holder>
void add_ranges(std::initializer_list<std::string_view> keys, Json& ranges) {
  for (const std::string_view key : keys) {
    for_each_field<Holder>([&](const auto& field) {
      if (key == field.key) ranges[field.key] = {field.traits.low, field.traits.high};
    });
  }
}

// Bounds of the numbers that a user may set.
Json ranges_to_json() {
  Json ranges;
  add_ranges<Goal>({"position_m", "load_kg", "tolerance_m"}, ranges);
  add_ranges<CharacterSpec>({"stature_m", "mass_kg", "seat_m"}, ranges);
  add_ranges<Request>({"duration_s", "ease", "gaze_lead", "obstacles", "candidates", "evaluations"},
                      ranges);
  ranges["fps"] = {kRateMin, kRateMax};
  return ranges;
}

// Character formats of which a format needs one; empty if any character will do.
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
  return {{"name", format.word},           {"about", format.about},
          {"endings", std::move(endings)}, {"media_type", format.media_type},
          {"person", format.person},       {"robot", format.robot},
          {"clip", format.clip},           {"written", format.written && !format.from_svg},
          {"rated", format.rated},         {"needs", needs_to_json(format)},
          {"max_bytes", format.max_bytes}};
}

// Timing numbers that a user may set: parameters, and those of the task.
Json timing_to_json() {
  Json list = Json::array();
  for (const TimingNumber& number : kTimingNumbers) {
    list.push_back({{"name", number.name},
                    {"low", number.low},
                    {"high", number.high},
                    {"of", "motion"},
                    {"sentence", number.sentence}});
  }
  for_each_field<Request>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.traits.low), double>) {
      const std::string_view key = field.key;
      if (key != "ease" && key != "gaze_lead") return;
      list.push_back({{"name", field.key},
                      {"low", field.traits.low},
                      {"high", field.traits.high},
                      {"of", "task"},
                      {"sentence", field.says}});
    }
  });
  return list;
}

// Names of the built-in bodies' joints in other conventions, where they differ from their own.
Json joint_names_to_json() {
  Json list = Json::array();
  for (const EnumWord<JointNames>& names : kEnumWords<JointNames>) {
    Json bones = Json::object();
    for (const JointNameRow& row : joint_name_rows()) {
      bones[std::string(row[0])] = joint_name(names.value, row[0]);
    }
    list.push_back({{"name", names.word}, {"bones", std::move(bones)}});
  }
  return list;
}

}  // namespace

std::string format_facts() {
  Json json{{"version", kFactsVersion}};
  add_criteria(json);
  for (const PresetTraits& traits : kPresets) json["presets"].push_back(preset_to_json(traits));
  const TaskFile plain;
  json["default_preset"] = word_of(plain.preset);
  json["default_body"] = plain.character.source;
  for (const NamedHabit& habit : kHabits) {
    json["habits"].push_back({{"name", habit.word}, {"about", habit.about}});
  }
  json["searches"] = all_words<SearchMethod>();
  json["generators"] = all_words<MotionGenerator>();
  json["layer_readings"] = all_words<LayerReading>();
  json["sexes"] = all_words<Sex>();
  json["extents"] = all_words<BodyExtent>();
  json["bodies"] = bodies_to_json();
  json["bones"] = bones_to_json();
  json["ranges"] = ranges_to_json();
  json["timing"] = timing_to_json();
  for (const auto& table : messages::kAll) {
    for (const MessageText& message : table) {
      json["messages"].push_back({{"key", message.key}, {"text", message.text}});
    }
  }
  json["joint_names"] = joint_names_to_json();
  for (const FormatInfo& format : kFileFormats) json["formats"].push_back(format_to_json(format));
  return json.dump(2) + "\n";
}

std::string format_failure(const Error& error) {
  const Json json{{"place", error.place}, {"message", message_to_json(error.message)}};
  // names from files may hold any bytes; invalid UTF-8 is replaced
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace shigusa
