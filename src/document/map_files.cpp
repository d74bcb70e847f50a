// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <limits>
#include <shigusa/files.hpp>

#include "core/index.hpp"
#include "formats/csv.hpp"
#include "formats/glb.hpp"
#include "map_colour.hpp"
#include "measures_json.hpp"

namespace shigusa {
namespace {

constexpr double kBeadRadius = 0.3;  // spacings

// The places of one verdict as octahedra, with a colour and the score by REBA for each corner.
struct Beads {
  std::string positions{};
  std::string colours{};
  std::string rebas{};
  std::string corners{};
  std::uint32_t count = 0;
  Vec3d low{};
  Vec3d high{};

  void add(const Vec3d& at, double radius, const MapPlace& place);
};

void append_float(std::string& bytes, double x) {
  append_word(bytes, __builtin_bit_cast(std::uint32_t, static_cast<float>(x)));
}

// A colour as the linear one of glTF: the square is near the curve of sRGB.
std::uint32_t linear(Colour colour) {
  std::uint32_t word = 0xFF000000;
  for (int shift = 0; shift < 24; shift += 8) {
    const std::uint32_t byte = colour.rgb >> (16 - shift) & 0xFF;
    word |= byte * byte / 255 << shift;
  }
  return word;
}

void Beads::add(const Vec3d& at, double radius, const MapPlace& place) {
  const Colour colour = colour_of(place);
  for (int k = 0; k < 6; ++k) {
    Vec3d corner = at;
    corner[k / 2] += k % 2 == 0 ? radius : -radius;
    for (int axis = 0; axis < 3; ++axis) {
      // the bounds of the file are those of its own numbers
      const double x = static_cast<double>(static_cast<float>(corner[axis]));
      append_float(positions, x);
      low[axis] = count == 0 && k == 0 ? x : min(low[axis], x);
      high[axis] = count == 0 && k == 0 ? x : max(high[axis], x);
    }
    append_word(colours, linear(colour));
    append_float(rebas, place.reba.value_or(0));
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t x = octant & 1;
    const std::uint32_t y = 2 + (octant >> 1 & 1);
    const std::uint32_t z = 4 + (octant >> 2 & 1);
    // counter-clockwise from outside: an odd number of negative sides turns it around
    const bool turned = std::popcount(octant) % 2 != 0;
    for (const std::uint32_t corner : {x, turned ? z : y, turned ? y : z}) {
      append_word(corners, 6 * count + corner);
    }
  }
  ++count;
}

Json to_list(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

// The JSON of a file whose binary chunk is being filled.
struct CloudFile {
  Json json{{"asset", {{"version", "2.0"}, {"generator", "shigusa"}}},
            {"scene", 0},
            {"scenes", Json::array({Json::object()})}};
  std::string binary{};

  int accessor(const std::string& bytes, int target, Json accessor) {
    json["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", binary.size()},
                                   {"byteLength", bytes.size()},
                                   {"target", target}});
    accessor["bufferView"] = json["bufferViews"].size() - 1;
    json["accessors"].push_back(std::move(accessor));
    binary += bytes;
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  void add(std::string_view name, const Beads& beads);
};

constexpr int kGlVertices = 34962;  // targets and component types of glTF
constexpr int kGlIndices = 34963;
constexpr int kGlFloat = 5126;
constexpr int kGlByte = 5121;
constexpr int kGlWord = 5125;

void CloudFile::add(std::string_view name, const Beads& beads) {
  if (beads.count == 0) return;
  const int positions = accessor(beads.positions, kGlVertices,
                                 {{"componentType", kGlFloat},
                                  {"count", 6 * beads.count},
                                  {"type", "VEC3"},
                                  {"min", to_list(beads.low)},
                                  {"max", to_list(beads.high)}});
  const int colours = accessor(beads.colours, kGlVertices,
                               {{"componentType", kGlByte},
                                {"normalized", true},
                                {"count", 6 * beads.count},
                                {"type", "VEC4"}});
  const int rebas =
      accessor(beads.rebas, kGlVertices,
               {{"componentType", kGlFloat}, {"count", 6 * beads.count}, {"type", "SCALAR"}});
  const int corners =
      accessor(beads.corners, kGlIndices,
               {{"componentType", kGlWord}, {"count", 24 * beads.count}, {"type", "SCALAR"}});
  const std::size_t node = json["nodes"].size();
  json["nodes"].push_back({{"name", name}, {"mesh", node}});
  json["meshes"].push_back(
      {{"name", name},
       {"primitives",
        Json::array(
            {{{"attributes", {{"POSITION", positions}, {"COLOR_0", colours}, {"_REBA", rebas}}},
              {"indices", corners},
              {"material", 0}}})}});
  json["scenes"][0]["nodes"].push_back(node);
}

}  // namespace

Colour colour_of(const MapPlace& place) {
  if (!place.verdict) return {0xD0D0D0};
  if (*place.verdict == Verdict::strains) return {0xE07B1F};
  if (*place.verdict == Verdict::impossible) return {0xB3261E};
  // from green to yellow with the score
  const double share = place.score / (place.score + kMiddleScore);
  const auto mix = [share](int from, int to) {
    return static_cast<std::uint32_t>(nearest_integer(from + (to - from) * share));
  };
  return {mix(0x12, 0xF2) << 16 | mix(0x8A, 0xD6) << 8 | mix(0x4E, 0x3C)};
}

std::string map_csv(const BodyModel& body, const ReachMap& map) {
  std::string text = "x [m],y [m],z [m],verdict,score,strength,joint,duration [s],reba\n";
  const auto into = std::back_inserter(text);
  for (std::size_t k = 0; k < map.places.size(); ++k) {
    const Vec3d at = map.position(k);
    const MapPlace& place = map.places[k];
    fmt::format_to(into, "{},{},{},", at.x, at.y, at.z);
    if (!place.verdict) {
      text += "unreachable,,,,,\n";
      continue;
    }
    const std::string joint = place.dof < 0 ? "" : csv_field(body.dof(place.dof).name);
    fmt::format_to(into, "{},{:.6g},{:.4g},{},{:.4g},{}\n", word_of(*place.verdict), place.score,
                   place.strength, joint, place.duration,
                   place.reba ? std::to_string(*place.reba) : "");
  }
  return text;
}

std::string map_glb(const ReachMap& map) {
  CloudFile file;
  for (const auto& [verdict, word] : kEnumWords<Verdict>) {
    Beads beads;
    for (std::size_t k = 0; k < map.places.size(); ++k) {
      if (map.places[k].verdict != verdict) continue;
      beads.add(map.position(k), kBeadRadius * map.spacing, map.places[k]);
    }
    file.add(word, beads);
  }
  if (file.binary.empty()) return glb_file(file.json.dump());
  file.json["materials"] = Json::array(
      {{{"name", "places"},
        {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}}});
  file.json["buffers"] = Json::array({{{"byteLength", file.binary.size()}}});
  return glb_file(file.json.dump(), file.binary);
}

std::string format_limits(std::span<const PersonLimit> limits) {
  Json list = Json::array();
  for (const auto& [person, limit] : limits) {
    Json json{{"person", person}, {"of", word_of(limit.kind)}, {"end", word_of(limit.end)}};
    json[limit.kind == LimitKind::load ? "value_kg" : "value_m"] = limit.value;
    json["sharp"] = limit.sharp;
    if (limit.again) json["again"] = *limit.again;
    json["out_of_reach"] = limit.out_of_reach;
    if (limit.reason) json["reason"] = reason_words(*limit.reason);
    json["trials"] = limit.trials;
    list.push_back(std::move(json));
  }
  return list.dump(2) + "\n";
}

}  // namespace shigusa
