// SPDX-License-Identifier: MIT
#include "old_parameters.hpp"

#include <array>
#include <string>
#include <string_view>

namespace shigusa {
namespace {

constexpr const char* kOldLocked = "locked";

// The objects whose keys are names of parameters, and what a parameter's name has after them.
struct OldGroup {
  std::string_view key;
  std::string_view word;
};
constexpr std::array<OldGroup, 5> kOldGroups{{{"weights", ".weight"},
                                              {"contractions", ".contraction"},
                                              {"posture", ""},
                                              {"supports", ".support"},
                                              {"rest", ".final_rad"}}};

std::string_view suffix_of(std::string_view group) {
  for (const OldGroup& known : kOldGroups) {
    if (known.key == group) return known.word;
  }
  return {};
}

// Adds what stands in one object, with the names of its layer's parameters after `layer`.
void add_old(const Json& old, const std::string& layer, Json& parameters) {
  constexpr std::string_view kUnit = "_rad";
  for (const auto& [key, value] : old.items()) {
    if (key == kOldLocked && value.is_array()) {
      for (const Json& name : value) {
        parameters[kOldLocked].push_back(
            name.is_string() ? layer + name.get<std::string>() + ".weight" : name);
      }
    } else if (key == "arms" && value.is_object()) {
      for (const auto& [arm, own] : value.items()) {
        own.is_object() ? add_old(own, arm + ".", parameters) : void(parameters[arm] = own);
      }
    } else if (value.is_object()) {
      for (const auto& [name, number] : value.items()) {
        const bool final = key == "rest" && name.ends_with(kUnit);
        const std::string bare = final ? name.substr(0, name.size() - kUnit.size()) : name;
        parameters[layer + bare + std::string(suffix_of(key))] = number;
      }
    } else {
      parameters[layer + key] = value;
    }
  }
}

}  // namespace

Json from_old_parameters(const Json& parameters) {
  if (!parameters.is_object() || !parameters.contains("weights")) return parameters;
  Json flat{{kOldLocked, Json::array()}};
  add_old(parameters, "", flat);
  return flat;
}

}  // namespace shigusa
