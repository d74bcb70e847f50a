// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

#include "core/say.hpp"
#include "json_text.hpp"

namespace shigusa {

// Reads a JSON object member by member and keeps its first error, so that a caller reads everything
// and checks once. Every member must be requested: finish() reports the others.
class JsonReader {
 public:
  JsonReader(const Json& object, std::string place) : object_(&object), place_(std::move(place)) {
    if (!object.is_object()) wrong("", say("must_be_object"));
  }

  [[nodiscard]] bool has(const char* key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return object_->is_object() && object_->contains(key);
  }

  // The member as a nested reader; use after has().
  [[nodiscard]] JsonReader object(const char* key) const {
    return JsonReader((*object_)[key], place_of(key));
  }
  [[nodiscard]] const Json& value(const char* key) const { return (*object_)[key]; }
  [[nodiscard]] std::string place_of(const std::string& key) const {
    return place_ + (place_.ends_with(": ") ? "" : ".") + key;
  }

  void number(const char* key, double& into, double low, double high) {
    if (!has(key)) return;
    const Json& member = value(key);
    if (!member.is_number() || !(member.get<double>() >= low && member.get<double>() <= high)) {
      return wrong(key, say("must_be_number_in", shown(member), low, high));
    }
    into = member.get<double>();
  }

  template <class Integer>
  void integer(const char* key, Integer& into, std::uint64_t low, std::uint64_t high) {
    if (!has(key)) return;
    const Json& member = value(key);
    if (!member.is_number_unsigned() || member.get<std::uint64_t>() < low ||
        member.get<std::uint64_t>() > high) {
      return wrong(key, low == high ? say("allowed_is_one", shown(member), low)
                                    : say("whole_numbers", shown(member), low, high));
    }
    into = static_cast<Integer>(member.get<std::uint64_t>());
  }

  void text(const char* key, std::string& into) {
    if (!has(key)) return;
    const Json& member = value(key);
    if (!member.is_string()) return wrong(key, say("must_be_text", shown(member)));
    into = member.get<std::string>();
  }

  void truth(const char* key, bool& into) {
    if (!has(key)) return;
    if (!value(key).is_boolean()) return wrong(key, say("must_be_truth"));
    into = value(key).get<bool>();
  }

  // Appends to the texts.
  void texts(const char* key, std::vector<std::string>& into) {
    if (!has(key)) return;
    const Json& list = value(key);
    const auto is_text = [](const Json& text) { return text.is_string(); };
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text)) {
      return wrong(key, say("must_be_texts"));
    }
    for (const Json& text : list) into.push_back(text.get<std::string>());
  }

  // a word of an enum
  template <class Enum>
  void word(const char* key, Enum& into) {
    std::vector<std::pair<std::string, Enum>> choices;
    for (const EnumWord<Enum>& known : kEnumWords<Enum>) {
      choices.emplace_back(known.word, known.value);
    }
    choice(key, into, choices);
  }

  // one of several words
  template <class Enum>
  void choice(const char* key, Enum& into,
              const std::vector<std::pair<std::string, Enum>>& choices) {
    if (!has(key)) return;
    std::string word;
    text(key, word);
    std::vector<std::string> names;
    for (const auto& [name, meaning] : choices) {
      if (name == word) {
        into = meaning;
        return;
      }
      names.push_back(name);
    }
    wrong(key, unknown_name("word", word, names));
  }

  void vector(const char* key, Vec3d& into, double range) { vector(key, into, -range, range); }
  void vector(const char* key, Vec3d& into, double low, double high) {
    if (!has(key)) return;
    if (!read_vector(value(key), into, low, high)) {
      wrong(key, say("must_be_point", shown(value(key)), low, high));
    }
  }

  void quaternion(const char* key, Quatd& into) {
    if (!has(key)) return;
    const Json& member = value(key);
    double q[4] = {};
    bool valid = member.is_array() && member.size() == 4;
    for (std::size_t k = 0; valid && k < 4; ++k) {
      valid = member[k].is_number();
      if (valid) q[k] = member[k].get<double>();
    }
    const Quatd read{q[0], q[1], q[2], q[3]};
    if (!valid || !is_unit(read)) {
      return wrong(key, say("must_be_quaternion", shown(member)));
    }
    into = read;
  }

  // a list of at most `most` of them
  void vectors(const char* key, std::vector<Vec3d>& into, std::size_t most, double range) {
    if (!has(key)) return;
    const Json& list = value(key);
    bool valid = list.is_array() && list.size() <= most;
    for (std::size_t i = 0; valid && i < list.size(); ++i) {
      valid = read_vector(list[i], into.emplace_back(), -range, range);
    }
    if (!valid) {
      wrong(key, say("must_be_points", most, -range, range));
    }
  }

  // a required member
  void require(const char* key) {
    if (!object_->is_object() || object_->contains(key) || missing_) return;
    missing_ = Error{ErrorCode::parse, say("is_missing"), place_of(key)};
  }

  void wrong(const std::string& key, const Message& message) {
    if (!error_) {
      error_ = Error{ErrorCode::parse, message, key.empty() ? place() : place_of(key)};
    }
  }
  void absorb(const std::optional<Error>& nested) {
    if (!error_) error_ = nested;
  }

  // The first error, if any. Unrequested members are errors too, reported before missing ones,
  // since they may be misspellings of these.
  [[nodiscard]] const std::optional<Error>& finish() {
    if (!object_->is_object()) return error_;
    for (const auto& item : object_->items()) {
      bool asked = false;
      for (const std::string& key : known_) asked = asked || key == item.key();
      if (!asked) wrong("", unknown_name("key", item.key(), known_));
    }
    absorb(missing_);
    return error_;
  }

 private:
  static bool read_vector(const Json& member, Vec3d& into, double low, double high) {
    bool valid = member.is_array() && member.size() == 3;
    for (std::size_t k = 0; valid && k < 3; ++k) {
      valid = member[k].is_number() && member[k].get<double>() >= low &&
              member[k].get<double>() <= high;
      if (valid) into[static_cast<int>(k)] = member[k].get<double>();
    }
    return valid;
  }

  // the object itself; the outermost one has only its name
  [[nodiscard]] std::string place() const {
    return place_.ends_with(": ") ? place_.substr(0, place_.size() - 2) : place_;
  }

  // a value for a message, shortened
  static std::string shown(const Json& value) {
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
  }

  const Json* object_;
  std::string place_;
  std::vector<std::string> known_;
  std::optional<Error> error_;
  std::optional<Error> missing_;  // the first member that must be there and is not
};

[[nodiscard]] inline Json to_json(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }
[[nodiscard]] inline Json to_json(const Quatd& q) { return Json::array({q.x, q.y, q.z, q.w}); }

}  // namespace shigusa
