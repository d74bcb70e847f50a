// SPDX-License-Identifier: MIT
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

#include "cost_json.hpp"
#include "formats/message_json.hpp"
#include "measures_json.hpp"
#include "task_values.hpp"

namespace shigusa {
namespace {

constexpr int kFrameMost = 1'000'000'000;
constexpr double kCutoffMost = 1e6;  // Hz

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

Json action_to_json(const ActionScore& action) {
  const ActionResult& own = action.result;
  Json json{{"kind", word_of(own.kind)},
            {"start_s", own.start},
            {"end_s", own.end},
            {"verdict", word_of(own.judgement.verdict)},
            {"reasons", reasons_to_json(own.judgement)},
            {"score", own.score.total},
            {"criteria", penalties_to_json(own.score)}};
  if (action.taken) json["taken_s"] = *action.taken;
  for (const HandAtThing& hand : action.hands) {
    json["hands"].push_back(
        {{"effector", hand.effector}, {"distance_mm", hand.distance * kMillimetres}});
  }
  json["reached"] = Json::array();
  for (const GoalResult& goal : own.goals) {
    json["reached"].push_back({{"effector", goal.asked.effector},
                               {"goal_m", to_json(goal.asked.position)},
                               {"reached_m", to_json(goal.reached)},
                               {"error_mm", goal.error * kMillimetres}});
  }
  if (own.placed) json["placed"] = placed_to_json(*own.placed);
  return json;
}

}  // namespace

Result<ClipRequest> parse_clip_request(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  JsonReader reader(json, std::string(name) + ": ");
  ClipRequest request;
  read_mixture(reader, "criteria", request.settings.criteria);
  reader.integer("first", request.settings.first, 0, kFrameMost);
  if (reader.has("last")) {
    reader.integer("last", request.settings.last.emplace(), 0, kFrameMost);
  }
  reader.number("smoothed_hz", request.settings.cutoff, 0.0, kCutoffMost);
  reader.text("animation", request.animation);
  if (reader.has("ergonomics")) {
    read_composite(reader, "ergonomics", request.settings.ergonomics.emplace());
  }
  bool cost = request.settings.ergonomics.has_value();
  if (reader.has("cost")) reader.truth("cost", cost);
  if (!cost) request.settings.ergonomics.reset();
  if (cost && !request.settings.ergonomics) request.settings.ergonomics.emplace();
  if (reader.has("character")) {
    SHG_TRY_ASSIGN(request.character, parse_character_spec(reader.value("character").dump(), name));
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return request;
}

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
  json["criteria"] = penalties_to_json(score.score);
  json["follows"] = follows_to_json(score.fit, settings.first);
  json["feet"] = feet_to_json(recorded, score.fit);
  add_measures(recorded.body, score.measures, score.final_posture, json);
  if (score.cost) json["cost"] = cost_to_json(*score.cost, *settings.ergonomics);
  json["doubts"] = texts_to_json(recorded.doubts);
  for (const Message& doubt : score.doubts) json["doubts"].push_back(doubt.text);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string format_work_score(const std::string& clip, const RecordedMotion& recorded,
                              const ScoreSettings& settings, const WorkScore& score) {
  Json json{{"version", 1},
            {"clip", clip},
            {"character", recorded.body.name()},
            {"stature_m", recorded.body.stature()},
            {"mass_kg", recorded.body.mass()},
            {"smoothed_hz", settings.cutoff},
            {"verdict", word_of(score.judgement.verdict)},
            {"reasons", reasons_to_json(score.judgement)},
            {"score", score.score.total}};
  json["criteria"] = penalties_to_json(score.score);
  json["follows"] = follows_to_json(score.fit, settings.first);
  json["feet"] = feet_to_json(recorded, score.fit);
  json["actions"] = Json::array();
  for (const ActionScore& action : score.actions) json["actions"].push_back(action_to_json(action));
  if (score.cost) json["cost"] = cost_to_json(*score.cost, *settings.ergonomics);
  json["doubts"] = texts_to_json(recorded.doubts);
  for (const Message& doubt : score.doubts) json["doubts"].push_back(doubt.text);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
