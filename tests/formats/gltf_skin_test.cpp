// SPDX-License-Identifier: MIT
#include "formats/gltf_skin.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "support/mesh_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kSingle = 1e-6;  // of some products of single precision near 1

Skin read(const std::string& bytes) {
  const auto character = parse_gltf(bytes, "hero.glb");
  EXPECT_TRUE(character) << character.error().to_string();
  if (!character) return {};
  return read_gltf_skin(bytes, "hero.glb", *character, character->places);
}

// Two bones: one turned by 90° about z at x = 1, and one 1 along its x, which is up.
json two_bones() {
  return json::parse(R"({"asset": {"version": "2.0"}, "nodes": [
      {"name": "lower", "translation": [1, 0, 0], "children": [1],
       "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
      {"name": "upper", "translation": [1, 0, 0]},
      {"name": "shown", "mesh": 0, "skin": 0, "translation": [9, 9, 9]}],
      "skins": [{"joints": [0, 1]}], "meshes": [{"primitives": [{"attributes": {}}]}]})");
}

json& attributes(MeshFile& file) { return file.json["meshes"][0]["primitives"][0]["attributes"]; }

// One vertex, bound to both.
MeshFile one_vertex() {
  MeshFile file(two_bones());
  attributes(file)["POSITION"] = file.add(std::vector<float>{0.5F, 0.25F, 0.0F}, "VEC3", 5126);
  attributes(file)["JOINTS_0"] = file.add(std::vector<std::uint8_t>{0, 1, 0, 0}, "VEC4", 5121);
  attributes(file)["WEIGHTS_0"] =
      file.add(std::vector<float>{0.25F, 0.75F, 0.0F, 0.0F}, "VEC4", 5126);
  return file;
}

void expect_at(const Skin& skin, const Vec3d& at) {
  ASSERT_EQ(skin.vertices.size(), 1u) << testing::PrintToString(skin.doubts);
  EXPECT_LE(norm(skin.vertices[0].position - at), kSingle)
      << skin.vertices[0].position.x << ' ' << skin.vertices[0].position.y;
}

// a quarter turn takes (0.5, 0.25) to (-0.25, 0.5); one joint is at (1, 0), the other at (1, 1)
const Vec3d kBent{0.75, 0.5 + 0.75, 0.0};

TEST(GltfSkin, AVertexStandsWhereItsJointsTakeIt) {
  MeshFile file = one_vertex();
  const Skin skin = read(file.bytes());
  expect_at(skin, kBent);
  EXPECT_EQ(skin.vertices[0].node, 1);
  EXPECT_FALSE(skin.vertices[0].rigid);
  EXPECT_THAT(skin.doubts, IsEmpty());
}

TEST(GltfSkin, BindPosesAreUndone) {
  MeshFile file(two_bones());
  file.json.erase("skins");
  file.json.erase("meshes");
  file.json["nodes"].erase(2);
  file.add_skinned({{{0.3, 0.4, 0.5}, 0}, {{-1, 2, 3}, 1}});
  const Skin skin = read(file.bytes());
  ASSERT_EQ(skin.vertices.size(), 2u);
  // at rest everything is where it was modelled
  EXPECT_LE(norm(skin.vertices[0].position - Vec3d{0.3, 0.4, 0.5}), kSingle);
  EXPECT_LE(norm(skin.vertices[1].position - Vec3d{-1, 2, 3}), kSingle);
  EXPECT_EQ(skin.vertices[1].node, 1);
}

TEST(GltfSkin, WeightsNeedNotAddUpToOne) {
  MeshFile file = one_vertex();
  attributes(file)["WEIGHTS_0"] =
      file.add(std::vector<float>{1.0F, 3.0F, 0.0F, 0.0F}, "VEC4", 5126);
  expect_at(read(file.bytes()), kBent);
  attributes(file)["WEIGHTS_0"] = file.add(std::vector<float>{0, 0, 0, 0}, "VEC4", 5126);
  expect_at(read(file.bytes()), {0.75, 0.5, 0.0});  // the first joint's alone
}

TEST(GltfSkin, TheStrongestJointIsSummedOverBothSets) {
  MeshFile file = one_vertex();
  attributes(file)["JOINTS_1"] = file.add(std::vector<std::uint8_t>{0, 0, 0, 0}, "VEC4", 5121);
  attributes(file)["WEIGHTS_1"] = file.add(std::vector<float>{0.3F, 0.3F, 0, 0}, "VEC4", 5126);
  const Skin skin = read(file.bytes());
  ASSERT_EQ(skin.vertices.size(), 1u);
  EXPECT_EQ(skin.vertices[0].node, 0);  // 0.85 of 1.6
}

TEST(GltfSkin, QuantisedNumbersAreThoseOfFloats) {
  MeshFile file = one_vertex();
  // KHR_mesh_quantization: as they are, and the bind pose would scale them
  attributes(file)["POSITION"] = file.add(std::vector<std::int16_t>{2, 1, 0}, "VEC3", 5122);
  attributes(file)["WEIGHTS_0"] =
      file.add(std::vector<std::uint8_t>{64, 191, 0, 0}, "VEC4", 5121, true);
  file.json["skins"][0]["inverseBindMatrices"] =
      file.add(std::vector<float>{0.25F, 0, 0, 0, 0, 0.25F, 0, 0, 0, 0, 0.25F, 0, 0, 0, 0, 1,
                                  0.25F, 0, 0, 0, 0, 0.25F, 0, 0, 0, 0, 0.25F, 0, 0, 0, 0, 1},
               "MAT4", 5126);
  const Skin skin = read(file.bytes());
  ASSERT_EQ(skin.vertices.size(), 1u) << testing::PrintToString(skin.doubts);
  // 191 of 255 instead of 3/4
  EXPECT_LE(norm(skin.vertices[0].position - kBent), 1.0 / 255);
}

TEST(GltfSkin, SparseNumbersReplaceThoseBelow) {
  MeshFile file = one_vertex();
  const std::size_t at = file.add(std::vector<float>{0.5F, 0.25F, 0.0F}, "VEC3", 5126);
  const std::size_t index = file.add(std::vector<std::uint16_t>{0, 0}, "SCALAR", 5123);
  const auto view = [&](std::size_t accessor) {
    return file.json["accessors"][accessor]["bufferView"];
  };
  const json sparse{{"count", 1},
                    {"indices", {{"bufferView", view(index)}, {"componentType", 5123}}},
                    {"values", {{"bufferView", view(at)}}}};
  attributes(file)["POSITION"] = file.add(std::vector<float>{7, 7, 7}, "VEC3", 5126);
  file.json["accessors"].back()["sparse"] = sparse;
  expect_at(read(file.bytes()), kBent);
  file.json["accessors"].back().erase("bufferView");
  expect_at(read(file.bytes()), kBent);
}

TEST(GltfSkin, VerticesThatNoIndexNamesAreNotShown) {
  MeshFile file(two_bones());
  attributes(file)["POSITION"] =
      file.add(std::vector<float>{0, 0, 0, 0.5F, 0.25F, 0, 0, -5, 0}, "VEC3", 5126);
  attributes(file)["JOINTS_0"] =
      file.add(std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, "VEC4", 5121);
  attributes(file)["WEIGHTS_0"] =
      file.add(std::vector<float>{1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0}, "VEC4", 5126);
  file.json["meshes"][0]["primitives"][0]["indices"] =
      file.add(std::vector<std::uint32_t>{1, 1, 1}, "SCALAR", 5125);
  expect_at(read(file.bytes()), kBent);
}

TEST(GltfSkin, DataInTheTextIsReadAsTheChunkIs) {
  MeshFile file = one_vertex();
  file.json["buffers"] = {{{"byteLength", file.binary.size()}}};
  std::string base64;
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < file.binary.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool there = i + k < file.binary.size();
      group = group << 8 | (there ? static_cast<std::uint8_t>(file.binary[i + k]) : 0U);
    }
    for (int shift = 18; shift >= 0; shift -= 6) base64 += kDigits[group >> shift & 63];
  }
  file.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64;
  expect_at(read(file.json.dump()), kBent);
}

TEST(GltfSkin, AMeshWithoutSkinGoesWithItsNode) {
  MeshFile file = one_vertex();
  file.json["nodes"][2].erase("skin");
  // on the lower bone, by way of a node that is no bone
  file.json["nodes"].push_back(
      {{"name", "holder"}, {"children", {2}}, {"scale", {2, 2, 2}}, {"translation", {0, 0, 1}}});
  file.json["nodes"][0]["children"].push_back(3);
  file.json["nodes"][2]["translation"] = {0, 0, 0};
  const Skin skin = read(file.bytes());
  expect_at(skin, {1.0 - 0.5, 1.0, 1.0});
  EXPECT_EQ(skin.vertices[0].node, 0);
  EXPECT_TRUE(skin.vertices[0].rigid);
}

TEST(GltfSkin, NodesMayStandElsewhere) {
  MeshFile file = one_vertex();
  const std::string bytes = file.bytes();
  const GltfCharacter character = parse_gltf(bytes, "hero.glb").value();
  std::vector<GltfPlace> places = character.places;
  places[0].translation.y += 3.0;
  expect_at(read_gltf_skin(bytes, "hero.glb", character, places), kBent + Vec3d{0, 3, 0});
}

TEST(GltfSkin, OfTooManyVerticesEverySecondIsTaken) {
  MeshFile file(two_bones());
  file.json["nodes"][2].erase("skin");
  std::vector<float> positions(3 * (kSkinMaxVertices + 1), 0.5F);
  attributes(file)["POSITION"] = file.add(positions, "VEC3", 5126);
  EXPECT_EQ(read(file.bytes()).vertices.size(), kSkinMaxVertices / 2 + 1);
}

// In a mesh with many vertices, few of which are drawn, the cost counts the indices.
TEST(GltfSkin, PartsOfMoreThanTheMostIndicesInAllAreLeftOut) {
  MeshFile file(two_bones());
  file.json["nodes"][2].erase("skin");
  const std::size_t place = file.add(std::vector<float>{1, 2, 3}, "VEC3", 5126);
  const std::size_t corners = file.add(std::vector<std::uint8_t>{0, 1, 2}, "SCALAR", 5121);
  json& positions = file.json["accessors"][place];  // but for the first all are 0
  positions["count"] = kSkinMaxIndices;
  positions["sparse"] = {{"count", 1},
                         {"indices", {{"bufferView", corners}, {"componentType", 5121}}},
                         {"values", {{"bufferView", place}}}};
  positions.erase("bufferView");
  attributes(file)["POSITION"] = place;
  json& parts = file.json["meshes"][0]["primitives"];
  parts[0]["indices"] = corners;
  while (parts.size() < 70) parts.push_back(parts[0]);
  const Skin skin = read(file.bytes());
  EXPECT_EQ(skin.vertices.size(), 3U * 63U);
  EXPECT_THAT(skin.doubts, ElementsAre(HasSubstr("has more than 50000000 indices")));
}

struct Malformed {
  const char* name;
  std::function<void(MeshFile&)> make;
  const char* told;
};

void PrintTo(const Malformed& of, std::ostream* out) { *out << of.name; }

class MalformedSkins : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedSkins, AreToldAndLeftOut) {
  MeshFile file = one_vertex();
  GetParam().make(file);
  if (!file.json.contains("buffers")) file.json["buffers"] = {{{"byteLength", 1}}};
  const Skin skin = read(glb(file.json.dump(), file.binary));
  EXPECT_THAT(skin.vertices, IsEmpty());
  EXPECT_THAT(skin.doubts, ElementsAre(HasSubstr(GetParam().told)));
}

json& primitive(MeshFile& file) { return file.json["meshes"][0]["primitives"][0]; }

INSTANTIATE_TEST_SUITE_P(
    Of, MalformedSkins,
    testing::Values(
        Malformed{"another file",
                  [](MeshFile& f) {
                    f.json["buffers"] = {{{"uri", "hero.bin"}, {"byteLength", 12}}};
                  },
                  "is in another file, \"hero.bin\", which is not opened"},
        Malformed{"no position", [](MeshFile& f) { attributes(f).erase("POSITION"); },
                  "a part has no POSITION"},
        Malformed{"no such mesh", [](MeshFile& f) { f.json["nodes"][2]["mesh"] = 3; },
                  "3 is none of the 1"},
        Malformed{"a joint that is none",
                  [](MeshFile& f) {
                    attributes(f)["JOINTS_0"] =
                        f.add(std::vector<std::uint8_t>{0, 2, 0, 0}, "VEC4", 5121);
                  },
                  "vertex 0 is bound to joint 2 of 2"},
        Malformed{
            "fewer weights than vertices",
            [](MeshFile& f) {
              attributes(f)["POSITION"] = f.add(std::vector<float>{0, 0, 0, 1, 1, 1}, "VEC3", 5126);
            },
            "2 positions have 1 sets of joints and 1 of weights"},
        Malformed{
            "an index that is none",
            [](MeshFile& f) {
              primitive(f)["indices"] = f.add(std::vector<std::uint16_t>{1, 0}, "SCALAR", 5123);
            },
            "index 0 is 1, and there are 1 vertices"},
        Malformed{
            "indices with a sign",
            [](MeshFile& f) {
              primitive(f)["indices"] = f.add(std::vector<std::int16_t>{0, 0}, "SCALAR", 5122);
            },
            "whole numbers without a sign"},
        Malformed{"too few bind poses",
                  [](MeshFile& f) {
                    f.json["skins"][0]["inverseBindMatrices"] =
                        f.add(std::vector<float>(16, 0.0F), "MAT4", 5126);
                  },
                  "2 joints have 1 inverse bind poses"},
        Malformed{"no number",
                  [](MeshFile& f) {
                    attributes(f)["POSITION"] = f.add(
                        std::vector<float>{0, std::bit_cast<float>(0x7FC00000), 0}, "VEC3", 5126);
                  },
                  "vertex 0 stands beyond"},
        Malformed{
            "sparse indices that fall",
            [](MeshFile& f) {
              const std::size_t at = f.add(std::vector<float>(6, 0.0F), "VEC3", 5126);
              const std::size_t which = f.add(std::vector<std::uint16_t>{0, 0}, "SCALAR", 5123);
              json& accessor = f.json["accessors"][attributes(f)["POSITION"].get<std::size_t>()];
              accessor["count"] = 2;
              accessor.erase("bufferView");
              accessor["sparse"] = {
                  {"count", 2},
                  {"indices",
                   {{"bufferView", f.json["accessors"][which]["bufferView"]},
                    {"componentType", 5123}}},
                  {"values", {{"bufferView", f.json["accessors"][at]["bufferView"]}}}};
              attributes(f).erase("JOINTS_0");
            },
            "sparse index 1 is 0; indices must rise and be less than 2"},
        Malformed{"positions beyond their view",
                  [](MeshFile& f) { f.json["accessors"][0]["count"] = 1u << 31; },
                  "do not fit into its view"}));

TEST(GltfSkin, PartsThatAreReadStayWhereOthersAreNot) {
  MeshFile file = one_vertex();
  file.json["meshes"][0]["primitives"].push_back({{"attributes", json::object()}});
  const Skin skin = read(file.bytes());
  EXPECT_EQ(skin.vertices.size(), 1u);
  EXPECT_THAT(skin.doubts, ElementsAre(HasSubstr("1 of the mesh's 2 parts was not read")));
}

TEST(GltfSkin, AFileWithoutMeshHasNoDoubtOfIt) {
  const Skin skin = read(glb(person_gltf().dump()));
  EXPECT_THAT(skin.vertices, IsEmpty());
  EXPECT_THAT(skin.doubts, IsEmpty());
}

}  // namespace
}  // namespace shigusa
