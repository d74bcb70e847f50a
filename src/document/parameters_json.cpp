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
  Parameter parameter;
};

std::vector<std::string> path_of(const Parameter& parameter) {
  const ParameterInfo& info = *parameter.info;
  const std::string& name = info.name;
  std::vector<std::string> path;
  switch (info.kind) {
    case ParameterKind::weight:
      if (parameter.below) path = {kArms, parameter.layer->name};
      path.insert(path.end(), {kWeights, name});
      break;
    case ParameterKind::contraction:
      path = {kContractions, name};
      break;
    case ParameterKind::swivel:
      path = {kArms, name, "swivel_rad"};
      break;
    case ParameterKind::final_angle:
      path = {parameter.layer->name, name + "_rad"};
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

std::vector<Placed> placed(std::span<const Layer> plan, Parameters& values) {
  std::vector<Placed> all;
  for (Parameter& parameter : parameters_of(plan, values)) {
    std::vector<std::string> path = path_of(parameter);
    all.push_back({std::move(path), std::move(parameter)});
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

void read_locked(JsonReader& reader, std::span<const Placed> weights) {
  for (const Placed& weight : weights) *weight.parameter.locked = false;
  if (!reader.has(kLocked)) return;
  if (!reader.value(kLocked).is_array()) reader.wrong(kLocked, say("list_of_texts"));
  for (const Json& name : reader.value(kLocked)) {
    const auto joint = std::find_if(weights.begin(), weights.end(), [&name](const Placed& known) {
      return name.is_string() && known.path.back() == name.get<std::string>();
    });
    if (joint != weights.end()) {
      *joint->parameter.locked = true;
    } else {
      reader.wrong(kLocked, say("no_such_freedom"));
    }
  }
}

// Reads what stands in one object. An angle or a share of a posture may be missing; it is 0 then.
void read_object(JsonReader& reader, std::span<const Placed> all, std::size_t depth) {
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
      const ParameterInfo& info = *first.parameter.info;
      double value = first.parameter.value();
      reader.number(key.c_str(), value, info.low, info.high);
      first.parameter.set(value);
    } else if (reader.has(key.c_str())) {
      JsonReader object = reader.object(key.c_str());
      read_object(object, inner, depth + 1);
      reader.absorb(object.finish());
    }
    if (key == kWeights) read_locked(reader, inner);
  }
}

// Whether a posture stands there; an empty one is weights alone.
bool has_posture(const Json& parameters) {
  const auto posture = parameters.find(kPosture);
  return posture != parameters.end() && !(posture->is_object() && posture->empty());
}

}  // namespace

Json parameters_to_json(std::span<const Layer> plan, Parameters values) {
  Json json = empty_weights();
  json[kContractions] = Json::object();
  json[kPosture] = Json::object();
  if (!moves_whole_body(plan)) json[kArms] = Json::object();
  for (const Placed& one : placed(plan, values)) {
    Json* object = &json;
    for (std::size_t k = 0; k + 1 < one.path.size(); ++k) {
      if (one.path[k] == kWeights && !object->contains(kLocked)) *object = empty_weights();
      if (one.path[k] == kWeights && *one.parameter.locked) {
        (*object)[kLocked].push_back(one.path.back());
      }
      object = &(*object)[one.path[k]];
    }
    (*object)[one.path.back()] = one.parameter.value();
  }
  if (values.reflected) json[kReflected] = true;
  return json;
}

Result<Parameters> read_parameters(std::span<const Layer> plan, const Json& candidate,
                                   const std::string& place) {
  const auto member = candidate.is_object() ? candidate.find("parameters") : candidate.end();
  if (!candidate.is_object() || member == candidate.end()) {
    return fail(ErrorCode::parse, say("is_missing"), place + ".parameters");
  }
  JsonReader reader(*member, place + ".parameters");
  Parameters values = start_values(plan);
  const bool whole = moves_whole_body(plan);
  if (whole && reader.has("later")) reader.wrong("later", say("one_phase"));
  give_posture(plan, values);
  read_object(reader, placed(plan, values), 0);
  reader.truth(kReflected, values.reflected);
  // these may stand there without anything in them
  for (const char* key : {kContractions, kPosture}) {
    const bool known = (key == kPosture) == whole;
    if (!known && reader.has(key)) reader.absorb(reader.object(key).finish());
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  if (!has_posture(*member)) values.posture = {};
  return values;
}

}  // namespace shigusa
