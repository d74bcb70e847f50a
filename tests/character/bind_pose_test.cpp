// SPDX-License-Identifier: MIT
// Characters whose nodes rest in a motion, and whose mesh shows the pose in which it was bound.
#include <gmock/gmock.h>

#include <shigusa/character.hpp>

#include "formats/gltf_animation.hpp"
#include "support/mesh_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;

std::size_t index_of(const json& gltf, const std::string& name) {
  for (std::size_t i = 0; i < gltf["nodes"].size(); ++i) {
    if (gltf["nodes"][i].value("name", "") == name) return i;
  }
  throw std::runtime_error("no node " + name);
}

// A person whose mesh was bound standing, in centimetres with z up, as in Blender's FBX files: the
// node that shows the mesh determines how that space lies in the world. The nodes rest in a leap.
std::string leaping_file() {
  json gltf = person_gltf();
  std::vector<MeshPoint> points;
  for (int i = 0; i < 20; ++i) {
    points.push_back({{0.01 * i, 1.0, 0.0}, static_cast<int>(index_of(gltf, "hips"))});
  }
  MeshFile file(gltf);
  file.add_skinned(points);
  json& shown = file.json["nodes"].back();
  shown["scale"] = {0.01, 0.01, 0.01};
  shown["rotation"] = {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
  // the inverse bind matrices, from that space
  const std::size_t accessor = file.json["skins"][0]["inverseBindMatrices"];
  const std::size_t view = file.json["accessors"][accessor]["bufferView"];
  const std::size_t offset = file.json["bufferViews"][view]["byteOffset"];
  const Transformd space{{{0.01, 0, 0}, {0, 0, -0.01}, {0, 0.01, 0}}, {}};
  for (std::size_t j = 0; j < file.json["skins"][0]["joints"].size(); ++j) {
    float m[16];
    std::memcpy(m, file.binary.data() + offset + sizeof(m) * j, sizeof(m));
    const Transformd inverse =
        Transformd{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}},
                   {m[12], m[13], m[14]}} *
        space;
    const Vec3d* columns[] = {&inverse.rotation.cx, &inverse.rotation.cy, &inverse.rotation.cz,
                              &inverse.translation};
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 3; ++r) m[4 * c + r] = static_cast<float>((*columns[c])[r]);
    }
    std::memcpy(file.binary.data() + offset + sizeof(m) * j, m, sizeof(m));
  }
  for (const char* thigh : {"left_upper_leg", "right_upper_leg"}) {
    file.json["nodes"][index_of(file.json, thigh)]["rotation"] = {-std::sqrt(0.5), 0.0, 0.0,
                                                                  std::sqrt(0.5)};
  }
  return file.bytes();
}

TEST(BindPose, IsInTheWorldOfTheNodeThatShowsTheMesh) {
  CharacterSpec plain{.source = "plain.glb"};
  ASSERT_TRUE(load_character(glb(person_gltf().dump(), ""), plain));
  CharacterSpec spec{.source = "leaping.glb"};
  ASSERT_TRUE(load_character(leaping_file(), spec));
  EXPECT_NEAR(*spec.stature, *plain.stature, 1e-4);
  EXPECT_THAT(spec.doubts, testing::Contains(testing::HasSubstr("the pose in which the mesh")));
  EXPECT_LT(norm(spec.landmarks->left_arm.shoulder - plain.landmarks->left_arm.shoulder), 1e-3);
}

}  // namespace
}  // namespace shigusa
