// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <shigusa/project/character.hpp>

#include "commands.hpp"

namespace shigusa::app {
namespace {

using Json = nlohmann::ordered_json;

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
  }
  json["effectors"] = Json::array();
  for (const Effector& effector : body.effectors()) json["effectors"].push_back(effector.name);
  json["humanoid"] = Json::object();
  for (const auto& [bone, node] : spec.humanoid) json["humanoid"][bone] = node;
  json["doubts"] = std::vector<std::string>(body.doubts().begin(), body.doubts().end());
  return json;
}

void print_body(const BodyModel& body, const CharacterSpec& spec) {
  fmt::print("{}: {:.3f} m, {:.1f} kg, {} dof\n", body.name(), body.stature(), body.mass(),
             body.dof_count());
  fmt::print("{:<26} {:>8} {:>16} {:>18}\n", "freedom", "start °", "limits °", "strength N m");
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    fmt::print("{:<26} {:>8.1f} {:>7.0f} to {:>5.0f} {:>8.0f} to {:>5.0f}\n", dof.name,
               degrees(body.start()[static_cast<std::size_t>(d)]), degrees(dof.lower),
               degrees(dof.upper), -dof.torque_negative, dof.torque_positive);
  }
  for (const auto& [bone, node] : spec.humanoid) fmt::print("{:<18} {}\n", bone, node);
  for (const std::string& doubt : body.doubts()) fmt::print("note: {}\n", doubt);
}

}  // namespace

int body(const BodyOptions& options) {
  CharacterSpec spec;
  spec.source = options.source;
  spec.stature = options.stature;
  spec.mass = options.mass;
  if (options.frame) spec.frame = *options.frame;
  if (options.sex) spec.sex = *options.sex == "female" ? Sex::female : Sex::male;
  if (options.extent) {
    spec.extent = *options.extent == "half" ? BodyExtent::half : BodyExtent::full;
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
