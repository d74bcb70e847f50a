// SPDX-License-Identifier: MIT
#include "cost_json.hpp"

#include <algorithm>
#include <string>

#include "cost/posture_parts.hpp"
#include "field_json.hpp"
#include "formats/message_json.hpp"
#include "task_values.hpp"

namespace shigusa {
namespace {

// Number of joints that are told, the most loaded ones.
constexpr std::size_t kJointsTold = 10;

std::string side_word(Side side) { return side == Side::left ? "left" : "right"; }

Json course_to_json(const ScoreCourse& course) {
  return {{"worst", course.worst}, {"mean", course.mean}};
}

template <class Parts>
Json posture_to_json(const PostureCourse& course, const std::array<SubScore<Parts>, 9>& parts,
                     int least) {
  Json json = course_to_json(course.score);
  json["time_s"] = course.time;
  json["side"] = side_word(course.side);
  for (std::size_t k = 0; k < course.sides.size(); ++k) {
    if (course.sides[k].worst > 0) {
      json[side_word(k == 0 ? Side::left : Side::right)] = course_to_json(course.sides[k]);
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    json["parts"][std::string(parts[p].word)] = course_to_json(course.parts[p]);
  }
  for (std::size_t level = 0; level < course.above.size(); ++level) {
    json["share_from_level"][std::to_string(least + static_cast<int>(level))] = course.above[level];
  }
  return json;
}

Json zone_to_json(const ZoneCourse& course) {
  Json json{{"part", word_of(course.part)}, {"greatest_deg", degrees(course.greatest)}};
  if (course.side) json["side"] = side_word(*course.side);
  for (std::size_t z = 0; z < course.shares.size(); ++z) {
    if (!(course.shares[z] > 0.0)) continue;
    const std::string zone = std::to_string(static_cast<int>(z) - 1);
    json["share"][zone] = course.shares[z];
    json["longest_s"][zone] = course.longest[z];
  }
  if (course.verdict) json["verdict"] = word_of(*course.verdict);
  return json;
}

Json back_to_json(const BackCourse& back) {
  Json json{{"moment_nm", back.moment.value},
            {"moment_time_s", back.moment.time},
            {"mean_moment_nm", back.mean_moment}};
  if (!back.forces) return json;
  const BackForcesCourse& forces = *back.forces;
  json["compression_n"] = forces.compression.value;
  json["compression_time_s"] = forces.compression.time;
  json["mean_compression_n"] = forces.mean_compression;
  json["share_above_3400_n"] = forces.above_action;
  json["share_above_6400_n"] = forces.above_permissible;
  if (forces.limit) json["limit_by_age_n"] = *forces.limit;
  json["shear_n"] = forces.shear.value;
  json["shear_time_s"] = forces.shear.time;
  return json;
}

Json strengths_to_json(std::vector<StrengthCost> strengths) {
  std::stable_sort(strengths.begin(), strengths.end(),
                   [](const auto& a, const auto& b) { return a.able < b.able; });
  Json list = Json::array();
  for (std::size_t k = 0; k < std::min(kJointsTold, strengths.size()); ++k) {
    const StrengthCost& own = strengths[k];
    list.push_back({{"joint", own.dof},
                    {"torque_Nm", own.torque},
                    {"strength_Nm", own.strength},
                    {"able", own.able},
                    {"time_s", own.time}});
  }
  return list;
}

Json end_to_json(const Lift& lift, const LiftIndex& index) {
  Json json{{"H_m", lift.horizontal}, {"V_m", lift.vertical},
            {"D_m", lift.travel},     {"A_deg", degrees(lift.asymmetry)},
            {"HM", index.horizontal}, {"VM", index.vertical},
            {"DM", index.travel},     {"AM", index.asymmetry},
            {"FM", index.frequency},  {"CM", index.coupling},
            {"RWL_kg", index.limit},  {"FIRWL_kg", index.free_limit}};
  if (index.index) json["LI"] = *index.index;
  if (!index.notes.empty()) json["notes"] = texts_to_json(index.notes);
  return json;
}

Json lift_to_json(const LiftCost& lift, std::span<const FrameCost> frames) {
  const auto time = [&](int frame) { return frames[static_cast<std::size_t>(frame)].time; };
  Json json{{"thing", lift.span.thing},
            {"mass_kg", lift.span.mass},
            {"weight_limit_kg", lift.limit},
            {"taken_s", time(lift.span.taken)},
            {"put_s", time(lift.span.put)},
            {"origin", end_to_json(lift.origin, lift.at_origin)},
            {"destination", end_to_json(lift.destination, lift.at_destination)}};
  if (lift.index) json["lifting_index"] = *lift.index;
  if (!lift.notes.empty()) json["notes"] = texts_to_json(lift.notes);
  return json;
}

// All options, also those that have their default.
template <class Holder>
Json options_to_json(const Holder& holder) {
  Json json = Json::object();
  for_each_field<Holder>([&](const auto& field) {
    const auto& value = holder.*field.member;
    using Value = std::decay_t<decltype(value)>;
    if constexpr (Tabled<Value>) {
      json[field.key] = options_to_json(value);
    } else if constexpr (kIsOptional<Value>) {
      if (value) json[field.key] = value_to_json(*value);
    } else {
      json[field.key] = value_to_json(value);
    }
  });
  return json;
}

}  // namespace

Json cost_to_json(const MotionCost& cost, const Ergonomics& ergonomics) {
  Json json{{"ergonomics", options_to_json(ergonomics)}};
  if (cost.reba) json["reba"] = posture_to_json(*cost.reba, kRebaParts, 0);
  if (cost.rula) json["rula"] = posture_to_json(*cost.rula, kRulaParts, 1);
  json["en_1005_4"] = Json::array();
  for (const ZoneCourse& zone : cost.zones) json["en_1005_4"].push_back(zone_to_json(zone));
  if (cost.back) json["low_back"] = back_to_json(*cost.back);
  json["strengths"] = strengths_to_json(cost.strengths);
  json["niosh"] = Json::array();
  for (const LiftCost& lift : cost.lifts) json["niosh"].push_back(lift_to_json(lift, cost.frames));
  if (cost.repeated) {
    if (cost.repeated->index) json["composite_index"] = *cost.repeated->index;
    if (!cost.repeated->notes.empty()) {
      json["composite_notes"] = texts_to_json(cost.repeated->notes);
    }
  }
  json["notes"] = texts_to_json(cost.notes);
  json["note_messages"] = Json::array();
  for (const Message& note : cost.notes) json["note_messages"].push_back(message_to_json(note));
  return json;
}

}  // namespace shigusa
