// SPDX-License-Identifier: MIT
#include "parameters_json.hpp"

#include <algorithm>
#include <utility>

#include "core/say.hpp"

namespace shigusa {
namespace {

constexpr const char* kWeights = "weights";
constexpr const char* kLocked = "locked";
constexpr const char* kContractions = "contractions";
constexpr const char* kPosture = "posture";
constexpr const char* kArms = "arms";
constexpr const char* kSupports = "supports";
constexpr const char* kReflected = "reflected";

// Where a parameter stands: {"posture", "squat_rad"}.
struct Placed {
  std::vector<std::string> path;
  std::size_t index;  // of the list
  const ParameterInfo* info;
};

std::vector<std::string> path_of(const ParameterInfo& info) {
  const std::string& name = info.name;
  std::vector<std::string> path;
  switch (info.kind) {
    case ParameterKind::weight:
      if (!info.layer.empty()) path = {kArms, info.layer};
      path.insert(path.end(), {kWeights, name});
      break;
    case ParameterKind::contraction:
      path = {kContractions, name};
      break;
    case ParameterKind::swivel:
      path = {kArms, name, "swivel_rad"};
      break;
    case ParameterKind::final_angle:
      path = {info.layer, name + "_rad"};
      break;
    case ParameterKind::mode:
      path = {kPosture, name + "_rad"};
      break;
    case ParameterKind::timing:
      path = {kPosture, name};
      break;
    case ParameterKind::support:
      path = {kSupports, name};
      break;
  }
  return path;
}

// All that the values have.
std::vector<Placed> placed(const ParameterList& list, const Parameters& values) {
  std::vector<Placed> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ParameterInfo& info = list.all[i];
    if (values.posed || !info.of_posture()) all.push_back({path_of(info), i, &info});
  }
  return all;
}

Json empty_weights() { return {{kWeights, Json::object()}, {kLocked, Json::array()}}; }

// Those of `all` whose path has `key` at `depth`.
std::vector<Placed> below(std::span<const Placed> all, std::size_t depth, const std::string& key) {
  std::vector<Placed> found;
  for (const Placed& one : all) {
    if (one.path[depth] == key) found.push_back(one);
  }
  return found;
}

void read_locked(JsonReader& reader, std::span<const Placed> weights, Parameters& values) {
  if (!reader.has(kLocked)) return;
  if (!reader.value(kLocked).is_array()) reader.wrong(kLocked, say("list_of_texts"));
  for (const Json& name : reader.value(kLocked)) {
    const auto joint = std::find_if(weights.begin(), weights.end(), [&name](const Placed& known) {
      return name.is_string() && known.path.back() == name.get<std::string>();
    });
    if (joint != weights.end()) {
      values.locked[joint->index] = true;
    } else {
      reader.wrong(kLocked, say("no_such_freedom"));
    }
  }
}

// Reads what stands in one object. An angle or a share of a posture may be missing; it is 0 then.
void read_object(JsonReader& reader, std::span<const Placed> all, std::size_t depth,
                 Parameters& values) {
  std::vector<std::string> keys;
  for (const Placed& one : all) {
    const std::string& key = one.path[depth];
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
  for (const std::string& key : keys) {
    const std::vector<Placed> inner = below(all, depth, key);
    const Placed& first = inner.front();
    const bool optional = key == kPosture || (depth > 0 && first.path[depth - 1] == kPosture);
    if (!optional) reader.require(key.c_str());
    if (first.path.size() == depth + 1) {
      reader.number(key.c_str(), values.values[first.index], first.info->low, first.info->high);
    } else if (reader.has(key.c_str())) {
      JsonReader object = reader.object(key.c_str());
      read_object(object, inner, depth + 1, values);
      reader.absorb(object.finish());
    }
    if (key == kWeights) read_locked(reader, inner, values);
  }
}

// Whether a posture stands there; an empty one is weights alone.
bool has_posture(const Json& parameters) {
  const auto posture = parameters.find(kPosture);
  return posture != parameters.end() && !(posture->is_object() && posture->empty());
}

// Whether motions may have a posture: those that move the whole body at once.
bool has_posture(const ParameterList& list) {
  return std::any_of(list.all.begin(), list.all.end(),
                     [](const ParameterInfo& info) { return info.of_posture(); });
}

}  // namespace

Json parameters_to_json(const ParameterList& list, const Parameters& values) {
  Json json = empty_weights();
  json[kContractions] = Json::object();
  json[kPosture] = Json::object();
  if (!has_posture(list)) json[kArms] = Json::object();
  for (const Placed& one : placed(list, values)) {
    Json* object = &json;
    for (std::size_t k = 0; k + 1 < one.path.size(); ++k) {
      if (one.path[k] == kWeights && !object->contains(kLocked)) *object = empty_weights();
      if (one.path[k] == kWeights && values.locked[one.index]) {
        (*object)[kLocked].push_back(one.path.back());
      }
      object = &(*object)[one.path[k]];
    }
    (*object)[one.path.back()] = values.values[one.index];
  }
  if (values.reflected) json[kReflected] = true;
  return json;
}

Result<Parameters> read_parameters(const ParameterList& list, const Json& candidate,
                                   const std::string& place) {
  const auto member = candidate.is_object() ? candidate.find("parameters") : candidate.end();
  if (!candidate.is_object() || member == candidate.end()) {
    return fail(ErrorCode::parse, say("is_missing"), place + ".parameters");
  }
  JsonReader reader(*member, place + ".parameters");
  Parameters values = list.start();
  const bool whole = has_posture(list);
  if (whole && reader.has("later")) reader.wrong("later", say("one_phase"));
  values.posed = whole && has_posture(*member);
  read_object(reader, placed(list, values), 0, values);
  reader.truth(kReflected, values.reflected);
  // these may stand there without anything in them
  for (const char* key : {kContractions, kPosture}) {
    const bool known = key == kPosture ? values.posed : !whole;
    if (!known && reader.has(key)) reader.absorb(reader.object(key).finish());
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return values;
}

}  // namespace shigusa
