// SPDX-License-Identifier: MIT
#include "landmarks_json.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "body/anthropometry.hpp"
#include "core/say.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

namespace {

// Legs with the names of their soles.
template <class Person>
auto legs_of(Person& person) {
  using Leg = decltype((person.left_leg));
  return std::array<std::pair<const char*, Leg>, 2>{
      {{"left_sole", person.left_leg}, {"right_sole", person.right_leg}}};
}

}  // namespace

Json landmarks_to_json(const Landmarks& person) {
  Json json;
  for_each_landmark(person, [&](const char* name, const Vec3d& p) { json[name] = to_json(p); });
  for (const Vec3d& p : person.spine) json["spine"].push_back(to_json(p));
  for_each_further_landmark(person, [&](const char* name, const std::optional<Vec3d>& p) {
    if (p) json[name] = to_json(*p);
  });
  if (person.trunk_lean != 0.0) json["trunk_lean_rad"] = person.trunk_lean;
  for (const auto& [name, leg] : legs_of(person)) {
    if (!leg.sole) continue;
    for (const Vec3d& corner : *leg.sole) json[name].push_back(to_json(corner));
  }
  for (int i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    const auto& shape = person.parts[part];
    if (!shape) continue;
    Json& written = json["parts"][std::string(body_part_name(part))];
    written = {{"from_m", to_json(shape->from)},
               {"to_m", to_json(shape->to)},
               {"radius_m", shape->radius}};
    if (shape->to_radius != shape->radius) written["to_radius_m"] = shape->to_radius;
    if (shape->aside != Vec3d{}) written["aside_m"] = to_json(shape->aside);
  }
  return json;
}

namespace {

constexpr double kLengthRange = 100.0;  // m, of landmarks
constexpr double kThinnest = 1e-4;      // m, of parts

// Refuses coinciding joints, which would give segments without length.
void check_segments(JsonReader& reader, const Landmarks& p) {
  constexpr double kShortest = 1e-3;  // m
  for (const Side side : kBothSides) {
    const auto& leg = p.leg(side);
    const auto& arm = p.arm(side);
    for (const double length : {norm(leg.hip - leg.knee), norm(leg.knee - leg.ankle),
                                norm(arm.shoulder - arm.elbow), norm(arm.elbow - arm.wrist),
                                norm(leg.toe - leg.ankle), norm(arm.fingertip - arm.wrist)}) {
      if (length < kShortest) reader.wrong("landmarks_m", say("limb_coincides"));
    }
  }
}

// Reads a sole: roughly a rectangle seen from above, counter-clockwise.
void read_sole(JsonReader& landmarks, const char* name, std::optional<SoleOutline>& sole) {
  if (!landmarks.has(name)) return;
  constexpr double kShortest = 1e-3;  // m
  SoleOutline& read = sole.emplace();
  std::vector<Vec3d> corners;
  landmarks.vectors(name, corners, read.size(), kLengthRange);
  if (corners.size() != read.size()) return landmarks.wrong(name, say("four_corners"));
  std::copy(corners.begin(), corners.end(), read.begin());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Vec3d side = read[(i + 1) % 4] - read[i];
    const Vec3d next = read[(i + 2) % 4] - read[(i + 1) % 4];
    const double turn = side.z * next.x - side.x * next.z;  // about +Y
    if (turn > kShortest * kShortest) continue;
    return landmarks.wrong(name, say("sole_corners"));
  }
}

void read_part(JsonReader& parts, const char* name, std::optional<PartShape>& shape) {
  if (!parts.has(name)) return;
  JsonReader reader = parts.object(name);
  PartShape& read = shape.emplace();
  for (const char* key : {"from_m", "to_m", "radius_m"}) reader.require(key);
  reader.vector("from_m", read.from, kLengthRange);
  reader.vector("to_m", read.to, kLengthRange);
  reader.number("radius_m", read.radius, kThinnest, kLengthRange);
  read.to_radius = read.radius;
  reader.number("to_radius_m", read.to_radius, kThinnest, kLengthRange);
  reader.vector("aside_m", read.aside, kLengthRange);
  parts.absorb(reader.finish());
}

void read_parts(JsonReader& landmarks, PartShapes& parts) {
  if (!landmarks.has("parts")) return;
  JsonReader reader = landmarks.object("parts");
  for (int i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    read_part(reader, std::string(body_part_name(part)).c_str(), parts[part]);
  }
  landmarks.absorb(reader.finish());
}

}  // namespace

Json landmarks_schema() {
  const Json point{{"$ref", "#/$defs/point"}};
  Json properties;
  Json required;
  const auto add = [&](const char* name, const auto&) { properties[name] = point; };
  Landmarks person;
  for_each_landmark(person, add);
  for (const auto& [name, schema] : properties.items()) required.push_back(name);
  properties["spine"] = {
      {"description", "Joints between pelvis and shoulders, from below. Of the extent human."},
      {"type", "array"},
      {"items", point},
      {"maxItems", kSpineJoints}};
  for_each_further_landmark(person, add);
  properties["trunk_lean_rad"] = {
      {"description",
       "How far back the line from the hips to the shoulders leans of a trunk that is upright."},
      {"type", "number"},
      {"minimum", -kTrunkLeanMost},
      {"maximum", kTrunkLeanMost}};
  for (const auto& [name, leg] : legs_of(person)) properties[name] = {{"$ref", "#/$defs/sole"}};
  Json parts;
  for (int i = 0; i < kBodyPartCount; ++i) {
    parts[std::string(body_part_name(static_cast<BodyPart>(i)))] = {{"$ref", "#/$defs/part"}};
  }
  properties["parts"] = {
      {"description",
       "Of a character with a mesh: what of it nothing should pass through. Each part is a line "
       "with a thickness in its own frame: from the joint that it hangs on, y from its far end to "
       "that joint, x to the left, z ahead. Parts that are absent are by stature."},
      {"type", "object"},
      {"properties", parts},
      {"additionalProperties", false}};
  return {{"description", "A person as measured, in the start posture."},
          {"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

Json sole_schema() {
  return {{"description",
           "Corners of a sole, counter-clockwise from above: left of its tip, left of its heel, "
           "right of the heel, right of the tip. By stature when not given."},
          {"type", "array"},
          {"items", {{"$ref", "#/$defs/point"}}},
          {"minItems", std::tuple_size_v<SoleOutline>},
          {"maxItems", std::tuple_size_v<SoleOutline>}};
}

Json part_schema() {
  const Json point{{"$ref", "#/$defs/point"}};
  const Json radius{{"type", "number"}, {"minimum", kThinnest}, {"maximum", kLengthRange}};
  const auto told = [](Json schema, const char* what) {
    schema["description"] = what;
    return schema;
  };
  return {
      {"type", "object"},
      {"properties",
       {{"from_m", point},
        {"to_m", point},
        {"radius_m", told(radius, "At from_m.")},
        {"to_radius_m", told(radius, "At to_m; radius_m when not given.")},
        {"aside_m", told(point, "Of a flat part, two lines side by side: to either of them.")}}},
      {"required", {"from_m", "to_m", "radius_m"}},
      {"additionalProperties", false}};
}

std::optional<Landmarks> read_landmarks(JsonReader& reader) {
  if (!reader.has("landmarks_m")) return std::nullopt;
  JsonReader landmarks = reader.object("landmarks_m");
  Landmarks person;
  for_each_landmark(person, [&](const char* name, Vec3d& p) {
    landmarks.require(name);
    landmarks.vector(name, p, kLengthRange);
  });
  landmarks.vectors("spine", person.spine, kSpineJoints, kLengthRange);
  for_each_further_landmark(person, [&](const char* name, std::optional<Vec3d>& p) {
    if (landmarks.has(name)) landmarks.vector(name, p.emplace(), kLengthRange);
  });
  landmarks.number("trunk_lean_rad", person.trunk_lean, -kTrunkLeanMost, kTrunkLeanMost);
  for (auto& [name, leg] : legs_of(person)) read_sole(landmarks, name, leg.sole);
  read_parts(landmarks, person.parts);
  reader.absorb(landmarks.finish());
  reader.require("stature_m");
  check_segments(reader, person);
  return person;
}

}  // namespace shigusa
