// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>

#include "body/further_effectors.hpp"
#include "body/sole.hpp"
#include "body/stance.hpp"
#include "character/character_rig.hpp"
#include "core/index.hpp"
#include "criteria/support_zone.hpp"
#include "formats/json_reader.hpp"
#include "formats/message_json.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/rig.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "measure/measure_person.hpp"
#include "rig/twist_bones.hpp"

namespace shigusa {
namespace {

// Coordinates of the file in the world of goals: p_world = unit (left, up, ahead)ᵀ (p_file -
// origin).
Json placement_to_json(const Placement& p) {
  return {{"unit_m", p.unit},
          {"origin", to_json(p.origin)},
          {"left", to_json(p.left)},
          {"up", to_json(p.up)},
          {"ahead", to_json(p.ahead)}};
}

// Whether the node is in the posture that was measured as it is at rest.
bool is_at_rest(const CharacterNode& node) {
  const Quatd& a = node.rotation;
  const Quatd& b = node.rest.rotation;
  return node.offset == node.rest.translation && node.scale == node.rest_scale && a.x == b.x &&
         a.y == b.y && a.z == b.z && a.w == b.w;
}

Json nodes_to_json(const CharacterSpec& spec, const PosedBody& posed) {
  Json list = Json::array();
  for (const CharacterNode& node : character_nodes(spec, posed)) {
    list.push_back({{"name", node.name},
                    {"parent", node.parent},
                    {"offset", to_json(node.offset)},
                    {"rotation", to_json(node.rotation)}});
    if (node.scale != Vec3d{1, 1, 1}) list.back()["scale"] = to_json(node.scale);
    if (node.file_node >= 0) list.back()["file_node"] = node.file_node;
    if (!is_at_rest(node)) {
      list.back()["rest"] = {{"offset", to_json(node.rest.translation)},
                             {"rotation", to_json(node.rest.rotation)},
                             {"scale", to_json(node.rest_scale)}};
    }
  }
  return list;
}

// Collision capsules in the start posture.
Json capsules_to_json(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  const Kinematics<double> start = home_kinematics(posed);
  Json list = Json::array();
  for (const Capsule& capsule : body.capsules()) {
    list.push_back({{"name", capsule.name},
                    {"from_m", to_json(start.point(capsule.link, capsule.from))},
                    {"to_m", to_json(start.point(capsule.link, capsule.to))},
                    {"radius_m", capsule.radius},
                    {"to_radius_m", capsule.to_radius}});
  }
  return list;
}

Json joints_to_json(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  Json list = Json::array();
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    const auto [lower, upper] = widest_limits(body, d);
    list.push_back(
        {{"name", dof.name},
         {"parent", dof.parent == kBaseLink ? Json(nullptr) : Json(body.dof(dof.parent).name)},
         {"dof", 1},
         {"limits_rad", {lower, upper}},
         {"strength_nm", {-dof.torque_negative, dof.torque_positive}},
         {"start_rad", posed.home.angles[index(d)]}});
    if (const LimitCoupling* coupling = body.coupling_of(d)) {
      list.back()["limit_coupling"] = {{"driver", body.dof(coupling->driver).name},
                                       {"driver_rad", {0.0, coupling->driver_full}},
                                       {"upper_rad", {dof.upper, upper}}};
    }
    if (posed.robot) list.back()["file_joint"] = file_joint(posed, d);
  }
  return list;
}

// Effectors that goals may be given for.
Json places_to_json(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  Json list = Json::array();
  const std::vector<Vec3d> places = start_places(posed);
  for (int i = 0; i < body.effector_count(); ++i) {
    const Effector& effector = body.effector(i);
    list.push_back({{"effector", effector.name},
                    {"node", effector.node},
                    {"start_m", to_json(places[index(i)])}});
  }
  return list;
}

// Soles, for goals of feet: their corners relative to the effector in its own frame, and the
// effector's height with the sole oriented as at the start.
Json feet_to_json(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  const Kinematics<double> start = home_kinematics(posed);
  Json list = Json::array();
  for (const Foot& foot : body.feet()) {
    const BodyNode* node = body.find_node(foot.node);
    const auto effector = body.find_effector(foot.node);
    if (node == nullptr) continue;
    const Transformd place{start.link_rotation(foot.link), start.link_origin(foot.link)};
    const Sole sole =
        sole_under(foot, effector ? body.effector(*effector).point : node->point, place);
    Json corners = Json::array();
    for (const Vec3d& corner : sole.corners) corners.push_back(to_json(corner));
    list.push_back({{"effector", foot.name},
                    {"sole_m", std::move(corners)},
                    {"floor_m", sole.floor},
                    {"least_m", sole.least_height(place.rotation)}});
  }
  return list;
}

}  // namespace

std::vector<Vec3d> start_places(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  const Kinematics<double> start = home_kinematics(posed);
  std::vector<Vec3d> places;
  for (int i = 0; i < body.effector_count(); ++i) {
    const Effector& effector = body.effector(i);
    places.push_back(start.point(effector.link, effector.point));
  }
  return places;
}

std::vector<GoalPlace> goal_places(const PosedBody& posed) {
  const BodyModel& body = posed.body;
  std::vector<GoalPlace> all;
  const std::vector<Vec3d> places = start_places(posed);
  for (int i = 0; i < body.effector_count(); ++i) {
    all.push_back({body.effector(i).name, body.effector(i).node, places[index(i)]});
  }
  const Kinematics<double> start = home_kinematics(posed);
  for (const BodyNode* node : base_nodes(body)) {
    all.push_back({joint_word(node->name), node->name, start.point(node->link, node->point)});
  }
  return all;
}

std::pair<double, double> widest_limits(const BodyModel& body, int dof) {
  const Dof& d = body.dof(dof);
  const LimitCoupling* coupling = body.coupling_of(dof);
  return {d.lower, d.upper + (coupling == nullptr ? 0.0 : max(coupling->gain, 0.0))};
}

std::string file_joint(const PosedBody& posed, int dof) {
  if (!posed.robot) return {};
  for (const RobotJoint& joint : posed.robot->joints) {
    if (joint.dof == dof) return joint.name;
  }
  return {};
}

std::vector<TwistShare> twist_shares(const CharacterSpec& spec) {
  std::vector<TwistShare> shares;
  if (!spec.rig) return shares;
  for (const TwistBone& twist : spec.rig->rig.twists) {
    shares.push_back({spec.rig->skeleton.nodes[index(twist.node)].name,
                      std::string(humanoid_bone_name(twist.bone)), twist.share});
  }
  return shares;
}

std::string format_character(const CharacterSpec& spec, const PosedBody& posed) {
  const BodyModel& body = posed.body;
  Json json{{"name", body.name()},
            {"stature_m", body.stature()},
            {"mass_kg", body.mass()},
            {"dof", body.dof_count()},
            {"joints", joints_to_json(posed)}};
  json["effectors"] = Json::array();
  for (const Effector& effector : body.effectors()) json["effectors"].push_back(effector.name);
  json["places"] = places_to_json(posed);
  json["feet"] = feet_to_json(posed);
  json["humanoid"] = Json::object();
  for (const auto& [bone, node] : spec.humanoid) json["humanoid"][bone] = node;
  json["twist_bones"] = Json::array();
  for (const auto& [node, bone, share] : twist_shares(spec)) {
    json["twist_bones"].push_back({{"node", node}, {"along", bone}, {"share", share}});
  }
  json["nodes"] = nodes_to_json(spec, posed);
  json["node_unit_m"] = node_unit(spec);
  json["support_polygon"] = Json::array();
  for (const Vec3d& corner : support_polygon(body, posed.home)) {
    json["support_polygon"].push_back({corner.x, corner.z});
  }
  json["capsules"] = capsules_to_json(posed);
  if (spec.rig) {
    json["placement"] = placement_to_json(spec.rig->rig.placement);
    json["animations"] = spec.rig->animations;
    json["frames"] = spec.rig->frames;
    json["stature_guessed"] = spec.rig->stature_guessed;
  }
  json["doubts"] = texts_to_json(posed.doubts);
  json["doubt_messages"] = messages_to_json(posed.doubts);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<CharacterNode> character_nodes(const CharacterSpec& character, const PosedBody& posed) {
  std::vector<CharacterNode> nodes;
  if (!character.rig) {
    for (const SkeletonNode& node : body_skeleton(posed.body).nodes) {
      nodes.push_back({.name = node.name,
                       .parent = node.parent,
                       .offset = node.offset,
                       .rest = {.translation = node.offset}});
    }
    return nodes;
  }
  const CharacterRig& rig = *character.rig;
  for (std::size_t i = 0; i < rig.rig.nodes.size(); ++i) {
    const int file_node = i < rig.file_node.size() ? rig.file_node[i] : -1;
    const RigNode& node = rig.rig.nodes[i];
    GltfPlace rest{node.translation, node.rotation, node.scale};
    if (i < rig.places.size()) {
      rest = rig.places[i];
    } else if (rig.format == FileFormat::bvh) {
      rest = {.translation = rig.skeleton.nodes[i].offset};
    }
    nodes.push_back({.name = rig.skeleton.nodes[i].name,
                     .parent = node.parent,
                     .offset = node.translation,
                     .scale = node.scale,
                     .file_node = file_node,
                     .rotation = node.rotation,
                     .rest = {rest.translation, rest.rotation},
                     .rest_scale = rest.scale});
  }
  return nodes;
}

double node_unit(const CharacterSpec& character) {
  return character.rig ? character.rig->rig.placement.unit : 1.0;
}

std::vector<LocalTransform> node_motion(const CharacterSpec& character, const PosedBody& posed,
                                        const Clip& clip, MotionPlace place) {
  if (!character.rig) return skeleton_motion(posed.body, clip).clip.local;
  return rig_motion(posed, clip, character.rig->rig, {}, place == MotionPlace::file).local;
}

}  // namespace shigusa
