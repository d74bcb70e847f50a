// SPDX-License-Identifier: MIT
#include "parameters_json.hpp"

#include "core/say.hpp"
#include "old_parameters.hpp"

namespace shigusa {
namespace {

constexpr const char* kLocked = "locked";
constexpr const char* kReflected = "reflected";

void read_locked(JsonReader& reader, const ParameterList& list, Parameters& values) {
  if (!reader.has(kLocked)) return;
  if (!reader.value(kLocked).is_array()) reader.wrong(kLocked, say("list_of_texts"));
  for (const Json& name : reader.value(kLocked)) {
    const auto known = name.is_string() ? list.find(name.get<std::string>()) : std::nullopt;
    if (known && list.all[*known].kind == ParameterKind::weight) {
      values.locked[*known] = true;
    } else {
      reader.wrong(kLocked, say("no_such_freedom"));
    }
  }
}

}  // namespace

Json parameters_to_json(const ParameterList& list, const Parameters& values) {
  Json json = Json::object();
  Json locked = Json::array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list.all[i].of_posture() && !values.posed) continue;
    const std::string name = list.all[i].spelled("_rad");
    json[name] = values.values[i];
    if (values.locked[i]) locked.push_back(name);
  }
  json[kLocked] = std::move(locked);
  if (values.reflected) json[kReflected] = true;
  return json;
}

Result<Parameters> read_parameters(const ParameterList& list, const Json& candidate,
                                   const std::string& place) {
  if (!candidate.is_object() || !candidate.contains("parameters")) {
    return fail(ErrorCode::parse, say("is_missing"), place + ".parameters");
  }
  const Json json = from_old_parameters(candidate["parameters"]);
  JsonReader reader(json, place + ".parameters");
  if (json.contains("later")) reader.wrong("later", say("one_phase"));
  Parameters values = list.start();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ParameterInfo& info = list.all[i];
    const std::string name = info.spelled("_rad");
    if (info.of_posture()) {
      values.posed = values.posed || reader.has(name.c_str());
    } else {
      reader.require(name.c_str());
    }
    reader.number(name.c_str(), values.values[i], info.low, info.high);
  }
  read_locked(reader, list, values);
  reader.truth(kReflected, values.reflected);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return values;
}

}  // namespace shigusa
