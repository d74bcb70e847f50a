// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <shigusa/project/character.hpp>
#include <tuple>

#include "commands.hpp"

namespace shigusa::app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3d& v) { return {v.x, v.y, v.z}; }

// Where goals are in the file: p_world = unit (left, up, ahead)ᵀ (p_file - origin).
Json placement_to_json(const Placement& p) {
  return {{"unit_m", p.unit},
          {"origin", to_json(p.origin)},
          {"left", to_json(p.left)},
          {"up", to_json(p.up)},
          {"ahead", to_json(p.ahead)}};
}

// (effectors) m, world: where goals can be given for, in the start posture.
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

// The file's joint that a freedom of a robot is; empty of a person's.
std::string file_joint(const BodyModel& body, int dof) {
  if (!body.robot()) return {};
  for (const RobotJoint& joint : body.robot()->joints) {
    if (joint.dof == dof) return joint.name;
  }
  return {};
}

// What is told of the file's twist bones: their names, and where they share whose twist.
std::vector<std::tuple<std::string, std::string, double>> twist_bones(const CharacterSpec& spec) {
  std::vector<std::tuple<std::string, std::string, double>> told;
  if (!spec.rig) return told;
  for (const TwistBone& twist : spec.rig->rig.twists) {
    told.emplace_back(spec.rig->skeleton.nodes[static_cast<std::size_t>(twist.node)].name,
                      humanoid_bone_name(twist.bone), twist.share);
  }
  return told;
}

Json body_to_json(const BodyModel& body, const CharacterSpec& spec) {
  Json json{{"name", body.name()},
            {"stature_m", body.stature()},
            {"mass_kg", body.mass()},
            {"dof", body.dof_count()},
            {"joints", Json::array()}};
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    json["joints"].push_back(
        {{"name", dof.name},
         {"parent", dof.parent == kBaseLink ? Json(nullptr) : Json(body.dof(dof.parent).name)},
         {"dof", 1},
         {"limits_rad", {dof.lower, dof.upper}},
         {"strength_nm", {-dof.torque_negative, dof.torque_positive}},
         {"start_rad", body.start()[static_cast<std::size_t>(d)]}});
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
  for (const auto& [node, bone, share] : twist_bones(spec)) {
    json["twist_bones"].push_back({{"node", node}, {"along", bone}, {"share", share}});
  }
  if (spec.rig) json["placement"] = placement_to_json(spec.rig->rig.placement);
  json["doubts"] = std::vector<std::string>(body.doubts().begin(), body.doubts().end());
  return json;
}

// rounded, so that nothing is printed as -0
double rounded_to(double parts, double x) {
  const double rounded = std::round(parts * x) / parts;
  return rounded == 0.0 ? 0.0 : rounded;
}
double tenths(double degrees) { return rounded_to(10.0, degrees); }
double thousandths(double metres) { return rounded_to(1000.0, metres); }

void print_body(const BodyModel& body, const CharacterSpec& spec) {
  fmt::print("{}: {:.3f} m, {:.1f} kg, {} dof\n", printable(body.name()), body.stature(),
             body.mass(), body.dof_count());
  fmt::print("{:<26} {:>8} {:>16} {:>18}\n", "freedom", "start °", "limits °", "strength N m");
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    const std::string source = printable(file_joint(body, d));
    fmt::print("{:<26} {:>8.1f} {:>7.0f} to {:>5.0f} {:>8.0f} to {:>5.0f}{}{}\n", dof.name,
               tenths(degrees(body.start()[static_cast<std::size_t>(d)])),
               tenths(degrees(dof.lower)), tenths(degrees(dof.upper)), -dof.torque_negative,
               dof.torque_positive, source.empty() ? "" : "  ", source);
  }
  const std::vector<Vec3d> places = start_places(body);
  fmt::print("{:<26} {:>24}\n", "goals can be given for", "start x y z m");
  for (int i = 0; i < body.effector_count(); ++i) {
    const Vec3d& at = places[static_cast<std::size_t>(i)];
    fmt::print("{:<26} {:>8.3f}{:>8.3f}{:>8.3f}\n", printable(body.effector(i).name),
               thousandths(at.x), thousandths(at.y), thousandths(at.z));
  }
  for (const auto& [bone, node] : spec.humanoid) fmt::print("{:<18} {}\n", bone, node);
  for (const auto& [node, bone, share] : twist_bones(spec)) {
    fmt::print("{:<18} {}, {:.0f} % along {}\n", "twist bone", printable(node), 100.0 * share,
               bone);
  }
  for (const std::string& doubt : body.doubts()) fmt::print("note: {}\n", printable(doubt));
}

}  // namespace

int body(const BodyOptions& options) {
  CharacterSpec spec;
  spec.source = options.source;
  if (const auto applied = apply_character_options(options.person, spec); !applied) {
    return report(applied.error());
  }
  if (const auto measured = measure_character(spec, {}); !measured) {
    return report(measured.error());
  }
  const Result<BodyModel> model = build_character(spec);
  if (!model) return report(model.error());
  if (options.json) {
    fmt::print("{}\n",
               body_to_json(*model, spec).dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    print_body(*model, spec);
  }
  return kDone;
}

}  // namespace shigusa::app
