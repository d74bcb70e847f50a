// SPDX-License-Identifier: MIT
#include <shigusa/project/clip_score.hpp>

#include "json_text.hpp"

namespace shigusa {
namespace {

constexpr double kMillimetres = 1000.0;  // per metre

Json follows_to_json(const ClipFit& fit, int first) {
  return {{"mean_mm", fit.mean_distance * kMillimetres},
          {"worst_mm", fit.worst_distance * kMillimetres},
          {"worst_joint", fit.worst_joint},
          {"worst_time_s", (fit.worst_frame - first) * fit.clip.frame_time}};
}

Json feet_to_json(const RecordedMotion& recorded, const ClipFit& fit) {
  Json list = Json::array();
  for (const FootTravel& foot : fit.feet) {
    const auto node = static_cast<std::size_t>(foot.node);
    list.push_back({{"effector", foot.foot},
                    {"joint", recorded.motion.skeleton.nodes[node].name},
                    {"base", foot.base},
                    {"travel_mm", foot.travel * kMillimetres},
                    {"turn_deg", degrees(foot.turn)}});
  }
  return list;
}

}  // namespace

std::string format_clip_score(const std::string& clip, const RecordedMotion& recorded,
                              const ScoreSettings& settings, const ClipScore& score) {
  const Clip& scored = score.motion.clip;
  Json json{{"version", 1},
            {"clip", clip},
            {"character", recorded.body.name()},
            {"stature_m", recorded.body.stature()},
            {"mass_kg", recorded.body.mass()},
            {"frames", {settings.first, settings.first + scored.frames - 1}},
            {"duration_s", scored.duration()},
            {"smoothed_hz", settings.cutoff},
            {"score", score.score.total}};
  json["criteria"] = Json::object();
  for (const ScoreTerm& term : score.score.terms) json["criteria"][term.name] = term.penalty;
  json["follows"] = follows_to_json(score.fit, settings.first);
  json["feet"] = feet_to_json(recorded, score.fit);
  json["over_limit"] = Json::array();
  for (const LimitExcess& excess : score.over_limit) {
    json["over_limit"].push_back({{"dof", excess.dof}, {"excess_deg", degrees(excess.excess)}});
  }
  if (score.collides.depth > 0.0) {
    json["collision"] = {{"depth_mm", score.collides.depth * kMillimetres},
                         {"limb", score.collides.limb},
                         {"other", score.collides.other},
                         {"time_s", score.collides.time}};
  }
  json["final_posture"] = {{"words", posture_words(score.final_posture)},
                           {"knee_flexion_deg", degrees(score.final_posture.knee_flexion)},
                           {"trunk_turn_deg", degrees(score.final_posture.trunk_turn)}};
  if (score.final_posture.stoop_squat_index) {
    json["final_posture"]["stoop_squat_index"] = *score.final_posture.stoop_squat_index;
  }
  const auto measured = recorded.body.doubts();
  json["doubts"] = std::vector<std::string>(measured.begin(), measured.end());
  for (const std::string& doubt : score.doubts) json["doubts"].push_back(doubt);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
