// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>

#include "character/character_rig.hpp"
#include "criteria/support_zone.hpp"
#include "io/json_text.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "person/measure_person.hpp"
#include "person/twist_bones.hpp"

namespace shigusa {
namespace {

Json to_json(const Vec3d& v) { return {v.x, v.y, v.z}; }

// Where goals are in the file: p_world = unit (left, up, ahead)ᵀ (p_file - origin).
Json placement_to_json(const Placement& p) {
  return {{"unit_m", p.unit},
          {"origin", to_json(p.origin)},
          {"left", to_json(p.left)},
          {"up", to_json(p.up)},
          {"ahead", to_json(p.ahead)}};
}

Json nodes_to_json(const CharacterSpec& spec, const BodyModel& body) {
  Json list = Json::array();
  for (const CharacterNode& node : character_nodes(spec, body)) {
    list.push_back(
        {{"name", node.name}, {"parent", node.parent}, {"offset", to_json(node.offset)}});
    if (node.file_node >= 0) list.back()["file_node"] = node.file_node;
  }
  return list;
}

// What of the body nothing should pass through, in the start posture.
Json capsules_to_json(const BodyModel& body) {
  const Kinematics<double> start = start_kinematics(body);
  Json list = Json::array();
  for (const Capsule& capsule : body.capsules()) {
    list.push_back({{"name", capsule.name},
                    {"from_m", to_json(start.point(capsule.link, capsule.from))},
                    {"to_m", to_json(start.point(capsule.link, capsule.to))},
                    {"radius_m", capsule.radius}});
  }
  return list;
}

}  // namespace

std::vector<Vec3d> start_places(const BodyModel& body) {
  Kinematics<double> start(body);
  forward_kinematics<double>(body, body.start(), start);
  std::vector<Vec3d> places;
  for (int i = 0; i < body.effector_count(); ++i) {
    const Effector& effector = body.effector(i);
    places.push_back(start.point(effector.link, effector.point));
  }
  return places;
}

std::pair<double, double> widest_limits(const BodyModel& body, int dof) {
  const Dof& d = body.dof(dof);
  const LimitCoupling* coupling = body.coupling_of(dof);
  return {d.lower, d.upper + (coupling == nullptr ? 0.0 : max(coupling->gain, 0.0))};
}

std::string file_joint(const BodyModel& body, int dof) {
  if (!body.robot()) return {};
  for (const RobotJoint& joint : body.robot()->joints) {
    if (joint.dof == dof) return joint.name;
  }
  return {};
}

std::vector<TwistShare> twist_shares(const CharacterSpec& spec) {
  std::vector<TwistShare> told;
  if (!spec.rig) return told;
  for (const TwistBone& twist : spec.rig->rig.twists) {
    told.push_back({spec.rig->skeleton.nodes[static_cast<std::size_t>(twist.node)].name,
                    std::string(humanoid_bone_name(twist.bone)), twist.share});
  }
  return told;
}

std::string format_character(const CharacterSpec& spec, const BodyModel& body) {
  Json json{{"name", body.name()},
            {"stature_m", body.stature()},
            {"mass_kg", body.mass()},
            {"dof", body.dof_count()},
            {"joints", Json::array()}};
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    const auto [lower, upper] = widest_limits(body, d);
    json["joints"].push_back(
        {{"name", dof.name},
         {"parent", dof.parent == kBaseLink ? Json(nullptr) : Json(body.dof(dof.parent).name)},
         {"dof", 1},
         {"limits_rad", {lower, upper}},
         {"strength_nm", {-dof.torque_negative, dof.torque_positive}},
         {"start_rad", body.start()[static_cast<std::size_t>(d)]}});
    if (const LimitCoupling* coupling = body.coupling_of(d)) {
      json["joints"].back()["limit_coupling"] = {{"driver", body.dof(coupling->driver).name},
                                                 {"driver_rad", {0.0, coupling->driver_full}},
                                                 {"upper_rad", {dof.upper, upper}}};
    }
    if (body.robot()) json["joints"].back()["file_joint"] = file_joint(body, d);
  }
  json["effectors"] = Json::array();
  json["places"] = Json::array();
  const std::vector<Vec3d> places = start_places(body);
  for (int i = 0; i < body.effector_count(); ++i) {
    const Effector& effector = body.effector(i);
    if (i < static_cast<int>(body.effectors().size())) {
      json["effectors"].push_back(effector.name);
    }
    json["places"].push_back({{"effector", effector.name},
                              {"node", effector.node},
                              {"start_m", to_json(places[static_cast<std::size_t>(i)])}});
  }
  json["humanoid"] = Json::object();
  for (const auto& [bone, node] : spec.humanoid) json["humanoid"][bone] = node;
  json["twist_bones"] = Json::array();
  for (const auto& [node, bone, share] : twist_shares(spec)) {
    json["twist_bones"].push_back({{"node", node}, {"along", bone}, {"share", share}});
  }
  json["nodes"] = nodes_to_json(spec, body);
  json["node_unit_m"] = node_unit(spec);
  json["support_polygon"] = Json::array();
  for (const Vec3d& corner : support_polygon(body)) {
    json["support_polygon"].push_back({corner.x, corner.z});
  }
  json["capsules"] = capsules_to_json(body);
  if (spec.rig) json["placement"] = placement_to_json(spec.rig->rig.placement);
  json["doubts"] = std::vector<std::string>(body.doubts().begin(), body.doubts().end());
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
