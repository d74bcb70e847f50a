// SPDX-License-Identifier: MIT
#include "measures_json.hpp"

#include "formats/json_reader.hpp"

namespace shigusa {
namespace {

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

Json reason_to_json(const Reason& reason) {
  Json json{{"kind", word_of(reason.kind)}, {"verdict", word_of(reason.verdict)}};
  switch (reason.kind) {
    case ReasonKind::strength:
      json["joint"] = reason.subject;
      json["share"] = reason.amount;
      json["torque_nm"] = reason.torque;
      json["strength_nm"] = reason.strength;
      break;
    case ReasonKind::pressure:
      json["outside_mm"] = reason.amount * kMillimetres;
      break;
    case ReasonKind::collision:
      json["limb"] = reason.subject;
      json["other"] = reason.other;
      json["depth_mm"] = reason.amount * kMillimetres;
      break;
    case ReasonKind::limit:
      json["joint"] = reason.subject;
      json["excess_deg"] = degrees(reason.amount);
      break;
  }
  if (reason.time) json["time_s"] = *reason.time;
  json["words"] = reason_words(reason);
  return json;
}

}  // namespace

void add_measures(const BodyModel& body, const MotionMeasures& measures, const FinalPosture& ends,
                  Json& json) {
  const auto& [loads, over_limit, support, collides, sudden] = measures;
  if (const JointLoad* load = most_loaded(measures)) {
    json["most_loaded"] = {{"joint", body.dof(load->dof).name},
                           {"share", load->share},
                           {"torque_nm", abs(load->torque)},
                           {"time_s", load->time}};
  }
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
  json["sudden"] = {{"pressure_mm", sudden.pressure * kMillimetres},
                    {"torque_share", sudden.torque}};
  json["final_posture"] = posture_to_json(ends);
}

Json penalties_to_json(const Score& score) {
  Json json = Json::object();
  for (const ScoreTerm& term : score.terms) json[term.name] = term.penalty;
  return json;
}

Json placed_to_json(const PlacedThing& placed) {
  return {{"thing", placed.name},
          {"position_m", to_json(placed.position)},
          {"rotation_xyzw", to_json(placed.turn)},
          {"error_mm", placed.error * kMillimetres},
          {"error_deg", degrees(placed.turn_error)}};
}

Json reasons_to_json(const Judgement& judgement) {
  Json json = Json::array();
  for (const Reason& reason : judgement.reasons) json.push_back(reason_to_json(reason));
  return json;
}

}  // namespace shigusa
