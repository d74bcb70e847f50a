// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

#include "character/character_fields.hpp"
#include "core/field.hpp"
#include "core/say.hpp"
#include "formats/json_reader.hpp"
#include "formats/message_json.hpp"
#include "problem/request_fields.hpp"

namespace shigusa {

// Conversion of plain structs to JSON and back by their tables of fields. Numbers, texts, words,
// points, rotations and lists of such structs are handled here; other values have overloads of
// read_composite and composite_to_json.

template <class Holder>
void read_fields(JsonReader& reader, Holder& into);
template <class Holder>
[[nodiscard]] Json fields_to_json(const Holder& holder);

template <class Value>
inline constexpr bool kIsOptional = false;
template <class Value>
inline constexpr bool kIsOptional<std::optional<Value>> = true;
template <class Value>
inline constexpr bool kIsTable = false;  // a list of structs that have a table
template <Tabled Item>
inline constexpr bool kIsTable<std::vector<Item>> = true;

// Hooks called before and after each item of a list is read; overloads do more.
template <class Item>
void begin_item(std::vector<Item>&) {}
template <class Item>
void end_item(JsonReader&, const std::vector<Item>&) {}

template <class Item>
void read_list(JsonReader& holder, const char* key, std::vector<Item>& into, std::uint64_t most) {
  const Json& list = holder.value(key);
  if (!list.is_array()) return holder.wrong(key, say("must_be_list_of", key));
  if (list.size() > most) {
    return holder.wrong(key, say("at_most", list.size(), most));
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonReader reader(list[i], holder.place_of(fmt::format("{}[{}]", key, i)));
    into.emplace_back();
    begin_item(into);
    read_fields(reader, into.back());
    end_item(reader, into);
    holder.absorb(reader.finish());
  }
}

// Reads a whole number, or the word allowed in its place.
template <class Traits, class Number>
void read_whole_number(JsonReader& reader, const char* key, const Traits& traits, Number& into) {
  if (traits.word.word.empty() || !reader.value(key).is_string()) {
    return reader.integer(key, into, traits.low, traits.high);
  }
  into = static_cast<Number>(traits.word.value);
  if (reader.value(key) == traits.word.word) return;
  reader.wrong(key, say("whole_number_or", traits.low, traits.word.word));
}

// Reads the value of a member that the object has.
template <class Traits, class Value>
void read_value(JsonReader& reader, const char* key, const Traits& traits, Value& into) {
  if constexpr (requires { read_composite(reader, key, into); }) {
    read_composite(reader, key, into);
  } else if constexpr (kIsOptional<Value>) {
    read_value(reader, key, traits, into.emplace());
  } else if constexpr (std::same_as<Value, bool>) {
    reader.truth(key, into);
  } else if constexpr (std::integral<Value>) {
    read_whole_number(reader, key, traits, into);
  } else if constexpr (std::is_enum_v<Value>) {
    reader.word(key, into);
  } else if constexpr (std::same_as<Value, double>) {
    reader.number(key, into, traits.low, traits.high);
  } else if constexpr (std::same_as<Value, std::string>) {
    reader.text(key, into);
  } else if constexpr (std::same_as<Value, std::vector<std::string>>) {
    reader.texts(key, into);
  } else if constexpr (std::same_as<Value, std::vector<Message>>) {
    std::vector<std::string> texts;
    reader.texts(key, texts);
    into.assign(texts.begin(), texts.end());
  } else if constexpr (std::same_as<Value, Vec3d>) {
    reader.vector(key, into, traits.low, traits.high);
  } else if constexpr (std::same_as<Value, Quatd>) {
    reader.quaternion(key, into);
  } else {
    read_list(reader, key, into, traits.high);
  }
}

// Reads all members of a struct; members that the object lacks keep their values.
template <class Holder>
void read_fields(JsonReader& reader, Holder& into) {
  for_each_field<Holder>([&](const auto& field) {
    if (field.traits.required) reader.require(field.key);
    if (!reader.has(field.key)) return;
    auto value = into.*field.member;
    read_value(reader, field.key, field.traits, value);
    field.set(into, std::move(value));
  });
}

// Tag argument of composite_to_json, by which its overloads are found.
struct ToJson {};

template <class Value>
[[nodiscard]] Json value_to_json(const Value& value) {
  if constexpr (kIsOptional<Value>) {
    return value_to_json(*value);
  } else if constexpr (requires { composite_to_json(ToJson{}, value); }) {
    return composite_to_json(ToJson{}, value);
  } else if constexpr (std::is_enum_v<Value>) {
    return word_of(value);
  } else if constexpr (std::same_as<Value, Vec3d> || std::same_as<Value, Quatd>) {
    return to_json(value);
  } else if constexpr (Tabled<Value>) {
    return fields_to_json(value);
  } else if constexpr (kIsTable<Value>) {
    Json list = Json::array();
    for (const auto& item : value) list.push_back(fields_to_json(item));
    return list;
  } else if constexpr (std::same_as<Value, std::vector<Message>>) {
    return texts_to_json(value);
  } else {
    return value;
  }
}

// Whether a field of this holder is written to files.
template <class Holder, class Value>
[[nodiscard]] bool is_written(const Field<Holder, Value>& field, const Holder& holder) {
  const FieldTraits<Holder, Value>& traits = field.traits;
  if (traits.of != nullptr && !traits.of(holder)) return false;
  if (traits.written != nullptr && traits.written(holder)) return true;
  const Value& value = holder.*field.member;
  if constexpr (kIsOptional<Value>) {
    return value.has_value();
  } else if constexpr (requires { value.empty(); }) {
    return !value.empty();
  } else if constexpr (std::equality_comparable<Value>) {
    return !(value == Holder{}.*field.member);
  } else {
    return true;
  }
}

template <class Holder>
[[nodiscard]] Json fields_to_json(const Holder& holder) {
  Json json = Json::object();
  for_each_field<Holder>([&](const auto& field) {
    if (!is_written(field, holder)) return;
    json[field.key] = value_to_json(holder.*field.member);
    const EnumWord<int>& word = field.traits.word;
    if (!word.word.empty() && json[field.key] == word.value) json[field.key] = word.word;
  });
  return json;
}

}  // namespace shigusa
