// SPDX-License-Identifier: MIT
#include <shigusa/goal.hpp>

#include "character/character_fields.hpp"
#include "character/landmarks_json.hpp"
#include "criteria/built_in_criteria.hpp"
#include "problem/request_fields.hpp"
#include "task_values.hpp"

namespace shigusa {
namespace {

Json number_schema(double low, double high) {
  return {{"type", "number"}, {"minimum", low}, {"maximum", high}};
}

Json numbers_schema(const Json& item, int count) {
  return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

Json object_schema(const Json& properties) {
  return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

Json map_schema(const Json& value) { return {{"type", "object"}, {"additionalProperties", value}}; }

Json reference(const std::string& definition) { return {{"$ref", "#/$defs/" + definition}}; }

Json either(const Json& one, const Json& other) { return {{"anyOf", Json::array({one, other})}}; }

Json words_schema(std::span<const std::string> words) { return {{"enum", words}}; }

// Schema of each criterion's weight and reference scale.
Json criteria_schema() {
  Json properties;
  for (const CriterionTraits& criterion : kCriteria) {
    properties[std::string(criterion.word)] = object_schema(
        {{"weight", reference("weight")}, {std::string(criterion.scale_name), reference("scale")}});
  }
  Json schema = object_schema(properties);
  schema["description"] =
      "Weights of the score, not all 0, and the scale at which each penalty is full "
      "(docs/criteria.md). Absent ones are as in the preset's own mixture.";
  return schema;
}

std::vector<std::string> mixtures() {
  std::vector<std::string> names;
  for (const CriteriaPreset& preset : criteria_presets()) names.emplace_back(preset.name);
  return names;
}

// Schemas of a task's structs, each with the schemas that it refers to.
class Definitions {
 public:
  Definitions() {
    all_["point"] = numbers_schema(number_schema(-kGoalRange, kGoalRange), 3);
    all_["point"]["description"] = "[x, y, z] in metres.";
  }

  template <class Holder>
  [[nodiscard]] Json fields() {
    Json properties;
    Json required = Json::array();
    for_each_field<Holder>([&](const auto& field) {
      Json schema{{"description", field.says}};
      schema.update(of(field.traits, Holder{}.*field.member));
      properties[field.key] = schema;
      if (field.traits.required) required.push_back(field.key);
    });
    Json schema = object_schema(properties);
    if (!required.empty()) schema["required"] = required;
    return schema;
  }

  // Reference to a struct's schema.
  template <class Holder>
  [[nodiscard]] Json struct_schema() {
    const std::string name = kFields<Holder>.name;
    Json schema{{"description", kFields<Holder>.says}};
    schema.update(fields<Holder>());
    all_[name] = schema;
    return reference(name);
  }

  [[nodiscard]] Json take() { return std::move(all_); }

 private:
  template <class Traits, class Value>
  Json of(const Traits& traits, const std::optional<Value>&) {
    return of(traits, Value{});
  }
  template <class Traits, class Item>
  requires Tabled<Item> Json of(const Traits& traits, const std::vector<Item>&) {
    return {{"type", "array"}, {"maxItems", traits.high}, {"items", struct_schema<Item>()}};
  }
  template <class Traits, class Value>
  Json of(const Traits& traits, const Value&) {
    if constexpr (std::same_as<Value, bool>) {
      return {{"type", "boolean"}};
    } else if constexpr (std::integral<Value>) {
      const Json number{{"type", "integer"}, {"minimum", traits.low}, {"maximum", traits.high}};
      return traits.word.word.empty() ? number : either(number, {{"const", traits.word.word}});
    } else if constexpr (std::is_enum_v<Value>) {
      return words_schema(all_words<Value>());
    } else if constexpr (std::same_as<Value, double>) {
      return number_schema(traits.low, traits.high);
    } else {
      static_assert(std::same_as<Value, std::string>);
      return {{"type", "string"}};
    }
  }
  template <class Traits>
  Json of(const Traits&, const std::vector<std::string>&) {
    return {{"type", "array"}, {"items", {{"type", "string"}}}};
  }
  template <class Traits>
  Json of(const Traits& traits, const std::vector<Message>&) {
    return of(traits, std::vector<std::string>{});
  }
  template <class Traits>
  Json of(const Traits& traits, const Vec3d&) {
    if (traits.low == -kGoalRange && traits.high == kGoalRange) return reference("point");
    return numbers_schema(number_schema(traits.low, traits.high), 3);
  }
  template <class Traits>
  Json of(const Traits&, const Quatd&) {
    return numbers_schema({{"type", "number"}}, 4);
  }
  template <class Traits>
  Json of(const Traits&, const GoalAxis&) {
    const Json axis = struct_schema<GoalAxis>();
    Json& properties = all_["goal_axis"]["properties"];
    for (const auto& [key, words] :
         {std::pair{"axis", hand_axis_words()}, std::pair{"direction", direction_words()}}) {
      properties[key].erase("$ref");
      properties[key].update(either(words_schema(words), reference("point")));
    }
    return axis;
  }
  template <class Traits>
  Json of(const Traits&, const CriteriaSettings&) {
    all_["weight"] = number_schema(0.0, kCriteriaRange);
    all_["scale"] = number_schema(kCriteriaTiny, kCriteriaRange);
    all_["criteria"] = criteria_schema();
    return either(words_schema(mixtures()), reference("criteria"));
  }
  template <class Traits>
  Json of(const Traits&, const Habit&) {
    std::vector<std::string> words;
    for (const NamedHabit& named : kHabits) words.emplace_back(named.word);
    return either(words_schema(words), struct_schema<Habit>());
  }
  template <class Traits>
  Json of(const Traits&, const Ergonomics&) {
    return struct_schema<Ergonomics>();
  }
  template <class Traits>
  Json of(const Traits&, const PostureThresholds&) {
    return struct_schema<PostureThresholds>();
  }
  template <class Traits>
  Json of(const Traits&, const std::vector<Thing>&) {
    return map_schema(struct_schema<Thing>());
  }
  template <class Traits>
  Json of(const Traits&, const ThingHandle&) {
    return struct_schema<ThingHandle>();
  }
  template <class Traits>
  Json of(const Traits&, const Stance&) {
    Json stance = struct_schema<Stance>();
    all_["stance"]["properties"]["position_m"] =
        numbers_schema(number_schema(-kGoalRange, kGoalRange), 2);
    return stance;
  }
  template <class Traits>
  Json of(const Traits&, const BoneRequest&) {
    return map_schema({{"type", "string"}});
  }
  template <class Traits>
  Json of(const Traits&, const Places&) {
    return map_schema(reference("point"));
  }
  template <class Traits>
  Json of(const Traits&, const Landmarks&) {
    all_["sole"] = sole_schema();
    all_["part"] = part_schema();
    all_["landmarks"] = landmarks_schema();
    return reference("landmarks");
  }

  Json all_;
};

}  // namespace

std::string task_schema() {
  Definitions definitions;
  Json properties{
      {"version", {{"minimum", 1}, {"maximum", kTaskVersion}, {"type", "integer"}}},
      {"character",
       {{"description",
         "human when not given, full_body, half_body, a person's BVH, GLB, glTF, VRM or "
         "FBX file, or a robot's URDF or MJCF (.xml) file, relative to the task file."},
        {"anyOf",
         Json::array({Json{{"type", "string"}}, definitions.struct_schema<CharacterSpec>()})}}}};
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "shigusa task"},
              {"description", kFields<Request>.says}};
  schema.update(definitions.fields<Request>());
  properties.update(schema["properties"]);
  schema["properties"] = properties;
  schema["$defs"] = definitions.take();
  return schema.dump(2) + "\n";
}

}  // namespace shigusa
