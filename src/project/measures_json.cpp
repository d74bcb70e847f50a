// SPDX-License-Identifier: MIT
#include "measures_json.hpp"

namespace shigusa {
namespace {

constexpr double kMillimetres = 1000.0;  // per metre

Json posture_to_json(const FinalPosture& posture) {
  Json json{{"words", posture_words(posture)},
            {"knee_flexion_deg", degrees(posture.knee_flexion)},
            {"trunk_turn_deg", degrees(posture.trunk_turn)}};
  if (posture.stoop_squat_index) json["stoop_squat_index"] = *posture.stoop_squat_index;
  return json;
}

Json margin_to_json(const SupportMargin& margin) {
  return {{"least_mm", margin.distance * kMillimetres}, {"time_s", margin.time}};
}

}  // namespace

void add_measures(const std::vector<LimitExcess>& over_limit,
                  const std::optional<SupportMargins>& support, const CollisionFound& collides,
                  const FinalPosture& ends, Json& json) {
  json["over_limit"] = Json::array();
  for (const LimitExcess& excess : over_limit) {
    json["over_limit"].push_back({{"dof", excess.dof}, {"excess_deg", degrees(excess.excess)}});
  }
  if (support) {
    json["support"] = {{"centre_of_mass", margin_to_json(support->centre_of_mass)},
                       {"pressure", margin_to_json(support->pressure)}};
  }
  if (collides.depth > 0.0) {
    json["collision"] = {{"depth_mm", collides.depth * kMillimetres},
                         {"limb", collides.limb},
                         {"other", collides.other},
                         {"time_s", collides.time}};
  }
  json["final_posture"] = posture_to_json(ends);
}

}  // namespace shigusa
