// SPDX-License-Identifier: MIT
#include <shigusa/project/clip_score.hpp>

#include "measures_json.hpp"

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
  add_measures(score.over_limit, score.support, score.collides, score.final_posture, json);
  const auto measured = recorded.body.doubts();
  json["doubts"] = std::vector<std::string>(measured.begin(), measured.end());
  for (const std::string& doubt : score.doubts) json["doubts"].push_back(doubt);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
