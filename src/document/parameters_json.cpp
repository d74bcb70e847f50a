// SPDX-License-Identifier: MIT
#include "parameters_json.hpp"

#include <algorithm>

namespace shigusa {
namespace {

void read_contractions(JsonReader& reader, const std::vector<LayeredMember>& members) {
  reader.require("contractions");
  if (!reader.has("contractions")) return;
  JsonReader contractions = reader.object("contractions");
  for (const LayeredMember& member : members) {
    if (member.kind != LayerGeneKind::contraction) continue;
    double value = 0.0;
    contractions.require(member.name.c_str());
    contractions.number(member.name.c_str(), value, 0.0, kLayerGeneMax);
    for (double* limb : member.contraction) *limb = value;
  }
  reader.absorb(contractions.finish());
}

// "swivel_rad" of "right_arm.swivel", which stands under its arm; "left_elbow.flexion_rad"
std::string key_of(const LayeredMember& member) {
  const bool swivel = member.kind == LayerGeneKind::swivel;
  return (swivel ? member.name.substr(member.name.rfind('.') + 1) : member.name) + "_rad";
}

// The angle of each member of that kind and layer.
void read_angles(JsonReader& reader, const std::vector<LayeredMember>& members, LayerGeneKind kind,
                 const std::string& layer) {
  for (const LayeredMember& member : members) {
    if (member.kind != kind || member.layer != layer) continue;
    reader.require(key_of(member).c_str());
    reader.number(key_of(member).c_str(), *member.angle, member.low, member.high);
  }
}

}  // namespace

Result<const Json*> parameters_of(const Json& candidate, const std::string& place) {
  const auto member = candidate.is_object() ? candidate.find("parameters") : candidate.end();
  if (candidate.is_object() && member != candidate.end()) return &*member;
  return fail(ErrorCode::parse, "is missing", place + ".parameters");
}

void read_joints(JsonReader& reader, const NamedJoints& joints) {
  reader.require("weights");
  if (reader.has("weights")) {
    JsonReader weights = reader.object("weights");
    for (const auto& [name, joint] : joints) {
      weights.require(name.c_str());
      weights.number(name.c_str(), joint->weight, kWeightMin, kWeightMax);
      joint->locked = false;
    }
    reader.absorb(weights.finish());
  }
  if (!reader.has("locked")) return;
  if (!reader.value("locked").is_array()) reader.wrong("locked", "must be a list [ … ] of texts");
  for (const Json& name : reader.value("locked")) {
    const auto joint = std::find_if(joints.begin(), joints.end(), [&name](const auto& known) {
      return name.is_string() && known.first == name.get<std::string>();
    });
    if (joint != joints.end()) {
      joint->second->locked = true;
    } else {
      reader.wrong("locked", "names a freedom that this body does not have");
    }
  }
}

Json layered_to_json(std::span<const Layer> layers, LayeredParameters parameters) {
  Json json;
  for (const char* key : {"weights", "locked", "contractions", "posture", "arms"}) {
    json[key] = Json::object();
  }
  json["locked"] = Json::array();
  for (const LayeredMember& member : layered_members(layers, parameters)) {
    switch (member.kind) {
      case LayerGeneKind::contraction:
        json["contractions"][member.name] = *member.contraction.front();
        break;
      case LayerGeneKind::swivel:
        json["arms"][member.layer][key_of(member)] = *member.angle;
        break;
      case LayerGeneKind::final_angle:
        json[member.layer][key_of(member)] = *member.angle;
        break;
      case LayerGeneKind::weight: {
        Json& of = member.layer.empty() ? json : json["arms"][member.layer];
        if (!of.contains("locked")) of = {{"weights", Json::object()}, {"locked", Json::array()}};
        of["weights"][member.name] = member.joint->weight;
        if (member.joint->locked) of["locked"].push_back(member.name);
        break;
      }
    }
  }
  return json;
}

Result<LayeredParameters> read_layered(std::span<const Layer> layers, const Json& candidate,
                                       const std::string& place) {
  const Result<const Json*> object = parameters_of(candidate, place);
  if (!object) return tl::unexpected(object.error());
  JsonReader reader(**object, place + ".parameters");
  LayeredParameters parameters;
  const std::vector<LayeredMember> members = layered_members(layers, parameters);
  const auto joints_of = [&members](const std::string& layer) {
    NamedJoints joints;
    for (const LayeredMember& member : members) {
      if (member.joint != nullptr && member.layer == layer) {
        joints.emplace_back(member.name, member.joint);
      }
    }
    return joints;
  };
  read_joints(reader, joints_of(""));
  read_contractions(reader, members);
  if (reader.has("posture")) reader.absorb(reader.object("posture").finish());
  reader.require("arms");
  if (reader.has("arms")) {
    JsonReader arms = reader.object("arms");
    for (const Layer& layer : layers.subspan(1)) {
      const bool by_swivel = searches(layer, LayerGeneKind::swivel);
      if (!by_swivel && !searches(layer, LayerGeneKind::weight)) continue;
      arms.require(layer.name.c_str());
      if (!arms.has(layer.name.c_str())) continue;
      JsonReader arm = arms.object(layer.name.c_str());
      if (by_swivel) {
        read_angles(arm, members, LayerGeneKind::swivel, layer.name);
      } else {
        read_joints(arm, joints_of(layer.name));
      }
      arms.absorb(arm.finish());
    }
    reader.absorb(arms.finish());
  }
  for (const Layer& layer : layers.subspan(1)) {
    if (!searches(layer, LayerGeneKind::final_angle)) continue;
    reader.require(layer.name.c_str());
    if (!reader.has(layer.name.c_str())) continue;
    JsonReader finals = reader.object(layer.name.c_str());
    read_angles(finals, members, LayerGeneKind::final_angle, layer.name);
    reader.absorb(finals.finish());
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return parameters;
}

}  // namespace shigusa
