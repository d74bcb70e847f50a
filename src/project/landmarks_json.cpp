// SPDX-License-Identifier: MIT
#include "landmarks_json.hpp"

namespace shigusa {

Json landmarks_to_json(const Landmarks& person) {
  Json json;
  for_each_landmark(person, [&](const char* name, const Vec3d& p) { json[name] = to_json(p); });
  for (const Vec3d& p : person.spine) json["spine"].push_back(to_json(p));
  for_each_further_landmark(person, [&](const char* name, const std::optional<Vec3d>& p) {
    if (p) json[name] = to_json(*p);
  });
  return json;
}

namespace {

constexpr double kLengthRange = 100.0;  // m, of landmarks

// Coinciding joints would leave a body without lengths.
void check_segments(JsonReader& reader, const Landmarks& p) {
  constexpr double kShortest = 1e-3;  // m
  for (const Side side : {Side::left, Side::right}) {
    const auto& leg = p.leg(side);
    const auto& arm = p.arm(side);
    for (const double length : {norm(leg.hip - leg.knee), norm(leg.knee - leg.ankle),
                                norm(arm.shoulder - arm.elbow), norm(arm.elbow - arm.wrist),
                                norm(leg.toe - leg.ankle), norm(arm.fingertip - arm.wrist)}) {
      if (length < kShortest) reader.wrong("landmarks_m", "two joints of a limb coincide");
    }
  }
}

}  // namespace

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
  reader.absorb(landmarks.finish());
  reader.require("stature_m");
  check_segments(reader, person);
  return person;
}

}  // namespace shigusa
