// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/check.hpp"
#include "files/file.hpp"

namespace shigusa::testing_support {

// Validates JSON by a schema (2020-12), for the keywords in shigusa's schemas. Any other keyword is
// refused, so that no rule of a schema is ignored.
class SchemaCheck {
 public:
  using Json = nlohmann::json;

  explicit SchemaCheck(Json schema) : root_(std::move(schema)) {}

  // `name`: a file of docs/, "task.schema.json"
  static SchemaCheck in_docs(const std::string& name) {
    const auto text = read_text_file(SHIGUSA_SOURCE_DIR "/docs/" + name, 1 << 20);
    SHG_CHECK(text.has_value(), "the schema " + name);
    return SchemaCheck(Json::parse(*text));
  }

  // The value's first fault, or nothing: "candidates[0].rank: is above the maximum".
  [[nodiscard]] std::string judge(const Json& value) const { return judge(root_, value, "value"); }

 private:
  std::string judge(const Json& schema, const Json& value, const std::string& place) const {
    for (const auto& [keyword, rule] : schema.items()) {
      std::string wrong = judge_keyword(schema, keyword, rule, value, place);
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

  std::string judge_keyword(const Json& schema, const std::string& keyword, const Json& rule,
                            const Json& value, const std::string& place) const {
    const auto unless = [&](bool right, const char* wrong) {
      return right ? std::string() : place + ": " + wrong + " " + rule.dump();
    };
    if (keyword == "type") return unless(has_type(value, rule), "is not of type");
    if (keyword == "const") return unless(value == rule, "is not");
    if (keyword == "enum") {
      return unless(std::find(rule.begin(), rule.end(), value) != rule.end(), "is none of");
    }
    if (keyword == "minimum" || keyword == "minItems")
      return unless(at_least(value, rule), "is below");
    if (keyword == "maximum" || keyword == "maxItems")
      return unless(at_least(rule, value), "is above");
    if (keyword == "$ref") return judge_reference(rule, value, place);
    if (keyword == "anyOf") {
      bool any = false;
      for (const Json& choice : rule) any = any || judge(choice, value, place).empty();
      return unless(any, "is none of");
    }
    if (keyword == "items") return judge_items(rule, value, place);
    if (keyword == "required") return judge_required(rule, value, place);
    if (keyword == "properties" || keyword == "additionalProperties") {
      return keyword == "properties" && schema.contains("additionalProperties")
                 ? std::string()
                 : judge_members(schema, value, place);
    }
    const bool remark = keyword == "description" || keyword == "title" || keyword == "$schema" ||
                        keyword == "$defs";
    SHG_CHECK(remark, "a keyword that is not read: " + keyword);
    return {};
  }

  // Compares numbers, and a list by its length; the bound of either is a number. Signed and
  // unsigned ones compare by their values.
  static bool at_least(const Json& a, const Json& b) {
    const auto size = [](const Json& x) {
      return x.is_array() ? static_cast<double>(x.size()) : x.get<double>();
    };
    const bool comparable = (a.is_number() || a.is_array()) && (b.is_number() || b.is_array());
    return !comparable || size(a) >= size(b);
  }

  static bool has_type(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    SHG_CHECK(type == "integer", "a type that is not read: " + type);
    return value.is_number_integer();
  }

  std::string judge_reference(const std::string& to, const Json& value,
                              const std::string& place) const {
    const std::size_t sign = std::min(to.find('#'), to.size());
    const Json::json_pointer within(sign < to.size() ? to.substr(sign + 1) : "");
    if (sign == 0) return judge(root_.at(within), value, place);
    const SchemaCheck other = in_docs(to.substr(0, sign));
    return other.judge(other.root_.at(within), value, place);
  }

  std::string judge_items(const Json& rule, const Json& value, const std::string& place) const {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
      std::string wrong = judge(rule, value[i], place + "[" + std::to_string(i) + "]");
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

  static std::string judge_required(const Json& rule, const Json& value, const std::string& place) {
    for (const std::string key : rule) {
      if (value.is_object() && !value.contains(key)) return place + "." + key + ": is missing";
    }
    return {};
  }

  std::string judge_members(const Json& schema, const Json& value, const std::string& place) const {
    const Json properties = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    if (!value.is_object()) return {};
    for (const auto& [key, member] : value.items()) {
      const std::string at = place + "." + key;
      const bool known = properties.contains(key);
      if (!known && others == false) return at + ": is not known";
      const Json& rule = known ? properties.at(key) : others;
      std::string wrong = rule.is_object() ? judge(rule, member, at) : std::string();
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

  Json root_;
};

}  // namespace shigusa::testing_support
