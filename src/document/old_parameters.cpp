// SPDX-License-Identifier: MIT
#include "old_parameters.hpp"

#include <map>
#include <string>
#include <string_view>

namespace shigusa {
namespace {

// Old groups of parameters, and the suffix of today's names for each.
const std::map<std::string_view, std::string_view> kWords{{"weights", ".weight"},
                                                          {"contractions", ".contraction"},
                                                          {"posture", ""},
                                                          {"supports", ".support"},
                                                          {"rest", ".final_rad"}};

// Today's name of a parameter with the key `key` in the group `group`.
std::string name_of(std::string_view group, std::string key) {
  constexpr std::string_view kUnit = "_rad";
  if (group == "rest" && key.ends_with(kUnit)) key.resize(key.size() - kUnit.size());
  return key.append(kWords.at(group));
}

// Adds the parameters of one object; parameters of a layer have names that begin with `layer`.
void add_old(const Json& old, const std::string& layer, Json& parameters) {
  for (const auto& [group, members] : old.items()) {
    if (group == "locked" && members.is_array()) {
      for (const Json& key : members) {
        const bool text = key.is_string();
        parameters[group].push_back(text ? Json(layer + name_of("weights", key.get<std::string>()))
                                         : key);
      }
    } else if (group == "arms" && members.is_object()) {
      for (const auto& [arm, own] : members.items()) {
        if (own.is_object())
          add_old(own, arm + ".", parameters);
        else
          parameters[arm] = own;
      }
    } else if (kWords.contains(group) && members.is_object()) {
      for (const auto& [key, value] : members.items()) {
        parameters[layer + name_of(group, key)] = value;
      }
    } else {
      parameters[layer + group] = members;
    }
  }
}

}  // namespace

Json from_old_parameters(const Json& parameters) {
  if (!parameters.is_object() || !parameters.contains("weights")) return parameters;
  Json flat{{"locked", Json::array()}};
  add_old(parameters, "", flat);
  return flat;
}

}  // namespace shigusa
