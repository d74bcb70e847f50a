// SPDX-License-Identifier: MIT
// Meshes packed by meshopt and Draco are read like the originals.
#include <draco/compression/encode.h>
#include <gmock/gmock.h>
#include <meshoptimizer.h>

#include <functional>
#include <numbers>
#include <set>

#include "formats/gltf_skin.hpp"
#include "support/mesh_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kRings = 120;  // so near that no points come between
constexpr int kRound = 16;
constexpr const char* kExt = "EXT_meshopt_compression";
constexpr const char* kDraco = "KHR_draco_mesh_compression";

struct Grid {
  std::vector<float> positions;
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  std::vector<std::uint32_t> corners;
};

// A limb: a tube along the bones, bound to both alternately.
Grid tube() {
  Grid grid;
  for (int i = 0; i < kRings; ++i) {
    const float share = static_cast<float>(i) / (kRings - 1);
    for (int k = 0; k < kRound; ++k) {
      const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / kRound;
      grid.positions.insert(grid.positions.end(),
                            {2.0F * share, 0.05F * std::cos(angle), 0.05F * std::sin(angle)});
      grid.joints.insert(grid.joints.end(), {0, 1, 0, 0});
      grid.weights.insert(grid.weights.end(), {1.0F - share, share, 0.0F, 0.0F});
      if (i + 1 == kRings) continue;
      const auto at = [&](int ring, int point) {
        return static_cast<std::uint32_t>(ring * kRound + point % kRound);
      };
      grid.corners.insert(grid.corners.end(), {at(i, k), at(i, k + 1), at(i + 1, k), at(i, k + 1),
                                               at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  return grid;
}

json two_bones() {
  return json::parse(R"({"asset": {"version": "2.0"}, "nodes": [
      {"name": "lower", "children": [1]}, {"name": "upper", "translation": [1, 0.5, 0]},
      {"name": "shown", "mesh": 0, "skin": 0}],
      "skins": [{"joints": [0, 1]}], "meshes": [{"primitives": [{"attributes": {}}]}]})");
}

json& primitive(MeshFile& file) { return file.json["meshes"][0]["primitives"][0]; }

MeshFile plain() {
  const Grid grid = tube();
  MeshFile file(two_bones());
  primitive(file)["attributes"] = {{"POSITION", file.add(grid.positions, "VEC3", 5126)},
                                   {"JOINTS_0", file.add(grid.joints, "VEC4", 5123)},
                                   {"WEIGHTS_0", file.add(grid.weights, "VEC4", 5126)}};
  primitive(file)["indices"] = file.add(grid.corners, "SCALAR", 5125);
  return file;
}

// The same with each view packed, and the corners as triangles.
MeshFile by_meshopt() {
  MeshFile file = plain();
  const std::string whole = std::exchange(file.binary, "");
  for (auto& view : file.json["bufferViews"]) {
    const std::size_t offset = view["byteOffset"];
    const std::size_t length = view["byteLength"];
    const bool corners = &view == &file.json["bufferViews"].back();
    const std::size_t stride = corners ? 4 : &view == &file.json["bufferViews"][0] ? 12 : 8;
    const std::size_t count = length / stride;
    std::vector<unsigned char> packed(corners ? meshopt_encodeIndexBufferBound(count, count)
                                              : meshopt_encodeVertexBufferBound(count, stride));
    if (corners) {
      std::vector<std::uint32_t> all(count);
      std::memcpy(all.data(), whole.data() + offset, length);
      packed.resize(
          meshopt_encodeIndexBuffer(packed.data(), packed.size(), all.data(), all.size()));
    } else {
      packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), whole.data() + offset,
                                               count, stride));
    }
    view = {{"buffer", 1},
            {"byteLength", length},
            {"extensions",
             {{kExt,
               {{"buffer", 0},
                {"byteOffset", file.binary.size()},
                {"byteLength", packed.size()},
                {"byteStride", stride},
                {"count", count},
                {"mode", corners ? "TRIANGLES" : "ATTRIBUTES"}}}}}};
    file.binary.append(packed.begin(), packed.end());
  }
  return file;
}

template <class T>
std::unique_ptr<draco::PointAttribute> column(draco::GeometryAttribute::Type type,
                                              draco::DataType data, std::int8_t components,
                                              const std::vector<T>& values) {
  auto attribute = std::make_unique<draco::PointAttribute>();
  const std::size_t points = values.size() / static_cast<std::size_t>(components);
  attribute->Init(type, components, data, false, points);
  for (std::size_t i = 0; i < points; ++i) {
    attribute->SetAttributeValue(draco::AttributeValueIndex(static_cast<std::uint32_t>(i)),
                                 &values[i * static_cast<std::size_t>(components)]);
  }
  return attribute;
}

// The same as one mesh of Draco; `bits` of positions, 0: unquantised.
MeshFile by_draco(int method, int bits) {
  const Grid grid = tube();
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(grid.positions.size() / 3));
  for (std::size_t i = 0; i < grid.corners.size(); i += 3) {
    mesh.AddFace({{draco::PointIndex(grid.corners[i]), draco::PointIndex(grid.corners[i + 1]),
                   draco::PointIndex(grid.corners[i + 2])}});
  }
  using Kind = draco::GeometryAttribute;
  mesh.AddAttribute(column(Kind::POSITION, draco::DT_FLOAT32, 3, grid.positions));
  mesh.AddAttribute(column(Kind::GENERIC, draco::DT_UINT16, 4, grid.joints));
  mesh.AddAttribute(column(Kind::GENERIC, draco::DT_FLOAT32, 4, grid.weights));
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  if (bits > 0) encoder.SetAttributeQuantization(Kind::POSITION, bits);
  draco::EncoderBuffer packed;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &packed).ok());

  MeshFile file(two_bones());
  file.binary.assign(packed.data(), packed.size());
  file.json["bufferViews"] = {{{"buffer", 0}, {"byteLength", packed.size()}}};
  const auto count = mesh.num_points();
  file.json["accessors"] = {{{"componentType", 5126}, {"count", count}, {"type", "VEC3"}},
                            {{"componentType", 5123}, {"count", count}, {"type", "VEC4"}},
                            {{"componentType", 5126}, {"count", count}, {"type", "VEC4"}},
                            {{"componentType", 5125}, {"count", 0}, {"type", "SCALAR"}}};
  primitive(file) = {{"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}},
                     {"indices", 3},
                     {"extensions",
                      {{kDraco,
                        {{"bufferView", 0},
                         {"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}}}}}}};
  return file;
}

Skin read(MeshFile file) {
  if (!file.json.contains("buffers")) {
    file.json["buffers"] = {{{"byteLength", file.binary.size()}}, {{"byteLength", 1 << 20}}};
  }
  const std::string bytes = glb(file.json.dump(), file.binary);
  const auto character = parse_gltf(bytes, "hero.glb");
  EXPECT_TRUE(character) << character.error().to_string();
  return read_gltf_skin(bytes, "hero.glb", *character, character->places);
}

// Largest distance of a vertex of one mesh from the nearest of the other.
double apart(const Skin& one, const Skin& other) {
  double most = 0.0;
  for (const SkinVertex& vertex : one.vertices) {
    double nearest = 1e9;
    for (const SkinVertex& near : other.vertices) {
      if (near.node == vertex.node)
        nearest = std::min(nearest, norm(near.position - vertex.position));
    }
    most = std::max(most, nearest);
  }
  return most;
}

TEST(PackedMesh, OfMeshoptIsReadAsItWas) {
  const Skin packed = read(by_meshopt());
  const Skin as_it_was = read(plain());
  EXPECT_THAT(packed.doubts, IsEmpty());
  ASSERT_EQ(packed.vertices.size(), as_it_was.vertices.size());
  EXPECT_EQ(apart(packed, as_it_was), 0.0);
}

TEST(PackedMesh, OfDracoIsReadAsItWas) {
  const Skin as_it_was = read(plain());
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    for (const int bits : {0, 14}) {
      const Skin packed = read(by_draco(method, bits));
      const double off = bits == 0 ? 0.0 : 2.0 / (1 << bits) * 1.8;  // a diagonal of one step
      EXPECT_THAT(packed.doubts, IsEmpty());
      EXPECT_EQ(packed.vertices.size(), as_it_was.vertices.size());
      EXPECT_LE(apart(packed, as_it_was), off) << method;
      EXPECT_LE(apart(as_it_was, packed), off) << method;
    }
  }
}

struct Damaged {
  const char* what;
  MeshFile (*file)();
  std::function<void(MeshFile&)> make;
  const char* told;
};
std::ostream& operator<<(std::ostream& out, const Damaged& d) { return out << d.what; }

class DamagedMeshes : public testing::TestWithParam<Damaged> {};

TEST_P(DamagedMeshes, AreLeftOutAndTold) {
  MeshFile file = GetParam().file();
  GetParam().make(file);
  const Skin skin = read(std::move(file));
  EXPECT_THAT(skin.vertices, IsEmpty());
  EXPECT_THAT(skin.doubts, Contains(HasSubstr(GetParam().told)));
}

json& packed_view(MeshFile& file) { return file.json["bufferViews"][0]["extensions"][kExt]; }
MeshFile draco_file() { return by_draco(draco::MESH_EDGEBREAKER_ENCODING, 14); }

INSTANTIATE_TEST_SUITE_P(
    Of, DamagedMeshes,
    testing::Values(
        Damaged{"a count that its length is not", by_meshopt,
                [](MeshFile& f) { packed_view(f)["count"] = 7; },
                "its packed elements do not make the 23040 bytes"},
        Damaged{"more than may be", by_meshopt,
                [](MeshFile& f) {
                  packed_view(f)["count"] = 1u << 30;
                  f.json["bufferViews"][0]["byteLength"] = std::uint64_t{12} << 30;
                },
                "unpacks to more than the 536870912 bytes"},
        Damaged{"a stride that would write beside", by_meshopt,
                [](MeshFile& f) {
                  packed_view(f)["byteStride"] = 1;
                  packed_view(f)["count"] = 23040;
                },
                "meshopt packs no ATTRIBUTES of 23040 elements of 1 bytes"},
        Damaged{"a filter of another stride", by_meshopt,
                [](MeshFile& f) { packed_view(f)["filter"] = "QUATERNION"; },
                "with the filter QUATERNION"},
        Damaged{"bytes that are cut", by_meshopt,
                [](MeshFile& f) { packed_view(f)["byteLength"] = 40; },
                "its packed bytes are damaged"},
        Damaged{"a newer encoding", by_meshopt, [](MeshFile& f) { f.binary[0] |= 1; },
                "is packed by version 1 of meshopt's encoding; 0 is read here"},
        Damaged{"bytes that lie outside", by_meshopt,
                [](MeshFile& f) { packed_view(f)["byteOffset"] = 1u << 30; }, "lie beyond"},
        Damaged{"no mesh", draco_file, [](MeshFile& f) { f.binary[0] = 'd'; },
                "is no mesh of Draco 2.2"},
        Damaged{"a mesh that is cut", draco_file,
                [](MeshFile& f) { f.json["bufferViews"][0]["byteLength"] = 60; },
                "its packed bytes are damaged"},
        Damaged{"triangles of gigabytes", draco_file,
                [](MeshFile& f) {
                  // vertices and faces follow the header of 11 bytes and the way of edges
                  f.binary.replace(12, 4, "\xFF\xFF\xFF\x7F");
                },
                "unpacks to more than"},
        Damaged{
            "an attribute that is none", draco_file,
            [](MeshFile& f) { primitive(f)["extensions"][kDraco]["attributes"]["POSITION"] = 9; },
            "Draco's attribute 9 is not there with 3 components"},
        Damaged{
            "an attribute of other components", draco_file,
            [](MeshFile& f) { primitive(f)["extensions"][kDraco]["attributes"]["POSITION"] = 1; },
            "Draco's attribute 1 is not there with 3 components"},
        Damaged{"nothing told", draco_file,
                [](MeshFile& f) { primitive(f)["extensions"][kDraco] = json::object(); },
                "names no bufferView and attributes"}));

// With any byte of a packed mesh changed, the reader gives a mesh or a doubt.
TEST(PackedMesh, DamageIsNoHarm) {
  for (const auto make : {&by_meshopt, &draco_file}) {
    const MeshFile whole = make();
    for (std::size_t at = 0; at < whole.binary.size(); at += 41) {
      MeshFile file = whole;
      file.binary[at] = static_cast<char>(~file.binary[at]);
      const Skin skin = read(std::move(file));
      EXPECT_TRUE(!skin.vertices.empty() || !skin.doubts.empty()) << at;
    }
  }
}

}  // namespace
}  // namespace shigusa
