// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

#include "math/linear_map.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

// glTF files with meshes, written and read back by their own definition.
namespace shigusa::testing_support {

// A vertex in the world at rest, bound to one node of the file.
struct MeshPoint {
  Vec3d at;
  int node = 0;
};

// Numbers added to a file.
class MeshFile {
 public:
  explicit MeshFile(nlohmann::json gltf) : json(std::move(gltf)) {}

  nlohmann::json json;
  std::string binary;

  // `type`: "VEC3"; component: 5126 and so on. Returns the accessor's index.
  template <class T>
  std::size_t add(const std::vector<T>& values, const char* type, int component,
                  bool normalised = false) {
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t offset = binary.size();
    binary.resize(offset + values.size() * sizeof(T));
    std::memcpy(binary.data() + offset, values.data(), values.size() * sizeof(T));
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    const std::string kind = type;
    const std::size_t per = kind == "SCALAR" ? 1 : kind == "VEC3" ? 3 : kind == "VEC4" ? 4 : 16;
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", values.size() / per},
                                 {"type", type}});
    if (normalised) json["accessors"].back()["normalized"] = true;
    return json["accessors"].size() - 1;
  }

  // A mesh of these points, skinned to all nodes of the file.
  void add_skinned(const std::vector<MeshPoint>& points) {
    const auto nodes = json["nodes"].size();
    const ExportedGlb rest(glb(json.dump(), ""));
    std::vector<float> inverse;
    nlohmann::json joints = nlohmann::json::array();
    for (std::size_t i = 0; i < nodes; ++i) {
      joints.push_back(i);
      const Transformd place = rest.place(static_cast<int>(i));
      const Mat3d m = inverse_of(place.rotation).value();
      const Vec3d t = m * -place.translation;
      for (const Vec3d& column : {m.cx, m.cy, m.cz, t}) {
        for (int k = 0; k < 3; ++k) inverse.push_back(static_cast<float>(column[k]));
        inverse.push_back(&column == &t ? 1.0F : 0.0F);
      }
    }
    std::vector<float> positions;
    std::vector<std::uint16_t> bound;
    std::vector<float> weights;
    for (const MeshPoint& p : points) {
      for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p.at[k]));
      bound.insert(bound.end(), {static_cast<std::uint16_t>(p.node), 0, 0, 0});
      weights.insert(weights.end(), {1.0F, 0.0F, 0.0F, 0.0F});
    }
    const std::size_t inverse_at = add(inverse, "MAT4", 5126);
    const std::size_t skin = json["skins"].size();
    json["skins"].push_back({{"joints", joints}, {"inverseBindMatrices", inverse_at}});
    nlohmann::json attributes{{"POSITION", add(positions, "VEC3", 5126)},
                              {"JOINTS_0", add(bound, "VEC4", 5123)},
                              {"WEIGHTS_0", add(weights, "VEC4", 5126)}};
    // points: vertices without faces
    json["meshes"].push_back({{"primitives", {{{"mode", 0}, {"attributes", attributes}}}}});
    json["nodes"].push_back(
        {{"name", "body mesh"}, {"mesh", json["meshes"].size() - 1}, {"skin", skin}});
  }

  [[nodiscard]] std::string bytes() {
    json["buffers"] = {{{"byteLength", binary.size()}}};
    return glb(json.dump(), binary);
  }
};

// The lowest vertex, in a frame of an animation, of a mesh of MeshFile::add_skinned that one of
// these nodes moves; by the file's own numbers alone.
inline double lowest_vertex(const ExportedGlb& file, const std::vector<int>& nodes,
                            const std::string& animation, int frame) {
  const auto& skin = file.json().at("skins").back();
  const auto& attributes = file.json().at("meshes").back().at("primitives").at(0).at("attributes");
  const auto& bound = file.json().at("accessors").at(attributes.at("JOINTS_0").get<std::size_t>());
  const auto& view = file.json().at("bufferViews").at(bound.at("bufferView").get<std::size_t>());
  const std::size_t offset = view.value("byteOffset", std::size_t{0});
  std::vector<Transformd> moves;
  for (std::size_t j = 0; j < skin.at("joints").size(); ++j) {
    const auto m =
        file.element(skin.at("inverseBindMatrices").get<std::size_t>(), static_cast<int>(j));
    const Transformd inverse{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}},
                             {m[12], m[13], m[14]}};
    moves.push_back(file.place(skin.at("joints").at(j), animation, frame) * inverse);
  }
  double lowest = 1e9;
  for (int i = 0; i < bound.at("count").get<int>(); ++i) {
    const auto joint =
        static_cast<std::uint8_t>(file.binary().at(offset + 8 * static_cast<std::size_t>(i)));
    const int node = skin.at("joints").at(joint);
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
    const auto p = file.element(attributes.at("POSITION").get<std::size_t>(), i);
    lowest = std::min(lowest, (moves[joint] * Vec3d{p[0], p[1], p[2]}).y);
  }
  return lowest;
}

}  // namespace shigusa::testing_support
