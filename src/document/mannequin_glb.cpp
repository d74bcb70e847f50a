// SPDX-License-Identifier: MIT
#include "mannequin_glb.hpp"

#include <bit>
#include <limits>

#include "core/bytes.hpp"
#include "core/index.hpp"
#include "formats/glb.hpp"
#include "formats/json_text.hpp"

namespace shigusa {
namespace {

// Constants of glTF.
enum ComponentType { kUnsignedByte = 5121, kUnsignedShort = 5123, kFloat = 5126 };
enum Target { kNone = 0, kVertices = 34962, kIndices = 34963 };

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

float single(double value) { return static_cast<float>(value); }

void append_float(double value, std::string& bytes) {
  append_bytes(bytes, std::bit_cast<std::uint32_t>(single(value)));
}

// Buffer views and accessors of the GLB's binary chunk.
class GlbData {
 public:
  // Adds the bytes of `count` elements; returns the accessor's index.
  std::size_t add(const std::string& bytes, std::size_t count, ComponentType component,
                  const char* type, Target target) {
    Json view{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
    if (target != kNone) view["target"] = target;
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    views.push_back(std::move(view));
    binary += bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    return accessors.size() - 1;
  }

  std::size_t add(const std::vector<Vec3d>& vectors) {
    std::string bytes;
    for (const Vec3d& v : vectors) {
      for (const double value : {v.x, v.y, v.z}) append_float(value, bytes);
    }
    return add(bytes, vectors.size(), kFloat, "VEC3", kVertices);
  }

  std::size_t add_bytes(const std::vector<std::array<std::uint8_t, 4>>& fours) {
    std::string bytes;
    for (const auto& four : fours) bytes.append(four.begin(), four.end());
    return add(bytes, fours.size(), kUnsignedByte, "VEC4", kVertices);
  }

  Json accessors = Json::array();
  Json views = Json::array();
  std::string binary;
};

void add_bounds(const std::vector<Vec3d>& positions, Json& accessor) {
  constexpr double kMost = std::numeric_limits<double>::max();
  Vec3d low{kMost, kMost, kMost};
  Vec3d high = -low;
  for (const Vec3d& at : positions) {
    for (int i = 0; i < 3; ++i) {
      low[i] = min(low[i], single(at[i]));
      high[i] = max(high[i], single(at[i]));
    }
  }
  accessor["min"] = list_of(low);
  accessor["max"] = list_of(high);
}

std::size_t add_inverses(const std::vector<Transformd>& inverses, GlbData& data) {
  std::string bytes;
  for (const auto& [m, t] : inverses) {
    for (const double value : {m.cx.x, m.cx.y, m.cx.z, 0.0, m.cy.x, m.cy.y, m.cy.z, 0.0,  //
                               m.cz.x, m.cz.y, m.cz.z, 0.0, t.x, t.y, t.z, 1.0}) {
      append_float(value, bytes);
    }
  }
  return data.add(bytes, inverses.size(), kFloat, "MAT4", kNone);
}

Json primitive_of(const std::vector<Vec3d>& skin, GlbData& data) {
  const MannequinMesh& mesh = mannequin_mesh();
  const std::size_t positions = data.add(skin);
  add_bounds(skin, data.accessors[positions]);
  std::string corners;
  for (const std::uint16_t corner : mesh.corners) append_bytes(corners, corner);
  const std::size_t normals = data.add(vertex_normals(skin, mesh.corners));
  return {{"attributes",
           {{"POSITION", positions},
            {"NORMAL", normals},
            {"JOINTS_0", data.add_bytes(mesh.joints)},
            {"WEIGHTS_0", data.add_bytes(mesh.weights)}}},
          {"indices", data.add(corners, mesh.corners.size(), kUnsignedShort, "SCALAR", kIndices)},
          {"material", 0}};
}

Json nodes_of(const Skeleton& named, const std::vector<LocalTransform>& rest) {
  Json nodes = Json::array();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Quatd& turn = rest[i].rotation;
    Json& node = nodes.emplace_back(Json{{"name", named.nodes[i].name}});
    node["translation"] = list_of(rest[i].translation);
    if (turn != Quatd{}) node["rotation"] = {turn.x, turn.y, turn.z, turn.w};
    const int parent = named.nodes[i].parent;
    if (parent >= 0) nodes[index(parent)]["children"].push_back(i);
  }
  return nodes;
}

}  // namespace

std::string mannequin_glb(const std::string& name, const Skeleton& named,
                          const Mannequin& mannequin, const std::vector<Vec3d>& skin) {
  GlbData data;
  Json primitive = primitive_of(skin, data);
  data.accessors[primitive["attributes"]["WEIGHTS_0"].get<std::size_t>()]["normalized"] = true;
  const std::size_t inverses = add_inverses(mannequin.inverses(), data);
  Json nodes = nodes_of(named, mannequin.rest());
  nodes.push_back({{"name", name}, {"mesh", 0}, {"skin", 0}});
  const Json file{{"asset", {{"version", "2.0"}, {"generator", "shigusa"}}},
                  {"scene", 0},
                  {"scenes", {{{"name", name}, {"nodes", {0, nodes.size() - 1}}}}},
                  {"nodes", std::move(nodes)},
                  {"skins", {{{"inverseBindMatrices", inverses}, {"joints", mannequin.joints()}}}},
                  {"meshes", {{{"name", name}, {"primitives", {std::move(primitive)}}}}},
                  // the skin's colour in the studio's light theme, #dedad3, linear
                  {"materials",
                   {{{"name", "skin"},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", {0.7305, 0.7011, 0.6514, 1.0}},
                       {"metallicFactor", 0.0},
                       {"roughnessFactor", 0.55}}}}}},
                  {"accessors", std::move(data.accessors)},
                  {"bufferViews", std::move(data.views)},
                  {"buffers", {{{"byteLength", data.binary.size()}}}}};
  return glb_file(file.dump(), data.binary);
}

}  // namespace shigusa
