// SPDX-License-Identifier: MIT
// FBX files as read by assimp, and files written by it.
#include "formats/fbx.hpp"

#include <assimp/config.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <map>
#include <shigusa/formats.hpp>
#include <shigusa/run.hpp>
#include <string>

#include "core/check.hpp"
#include "formats/gltf.hpp"
#include "support/fbx_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kCentimetre = 0.01;  // m

void collect(const aiNode& node, const aiMatrix4x4& above, std::map<std::string, Vec3d>& at) {
  const aiMatrix4x4 world = above * node.mTransformation;
  at[node.mName.C_Str()] = {world.a4, world.b4, world.c4};
  for (unsigned i = 0; i < node.mNumChildren; ++i) collect(*node.mChildren[i], world, at);
}

// Positions of nodes by assimp, in the file's unit.
std::map<std::string, Vec3d> places(const aiScene& scene) {
  std::map<std::string, Vec3d> at;
  collect(*scene.mRootNode, {}, at);
  return at;
}

std::map<std::string, Vec3d> read_by_assimp(const std::string& bytes) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "fbx");
  SHG_CHECK(scene != nullptr, importer.GetErrorString());
  return places(*scene);
}

// Number of this reader's nodes at the positions of their namesakes in `theirs`.
int expect_same(const std::string& bytes, const std::map<std::string, Vec3d>& theirs) {
  const Result<std::string> glb = glb_of_fbx(bytes, "f.fbx");
  if (!glb) {
    ADD_FAILURE() << glb.error().to_string();
    return 0;
  }
  const Skeleton skeleton = parse_gltf(*glb, "f.fbx").value().rest.skeleton;
  const std::vector<Vec3d> ours = rest_origins(skeleton);
  int found = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto node = theirs.find(skeleton.nodes[i].name);
    if (node == theirs.end()) continue;
    ++found;
    // assimp computes in single precision: some 1e-7 of metres per joint of a chain of ten
    EXPECT_LE(norm(ours[i] - node->second * kCentimetre), 1e-5) << node->first;
  }
  return found;
}

FbxRecord property(const char* name, const Vec3d& v) {
  const std::string type = std::string(name).starts_with("Lcl") ? name : "Vector3D";
  return {"P", {name, type, "Vector", "A", v.x, v.y, v.z}, {}};
}
FbxRecord property(const char* name, std::int32_t value) {
  return {"P", {name, "enum", "", "", value}, {}};
}

// A chain of joints with all kinds of transform properties except post-rotations: assimp 5.2 does
// not invert them, as Autodesk's formula does.
FbxFile with_everything(std::uint64_t seed) {
  FbxFile file(standing_figure());
  Random random(seed);
  const auto some = [&](double most) {
    return Vec3d{random.uniform(-most, most), random.uniform(-most, most),
                 random.uniform(-most, most)};
  };
  for (std::int64_t i = 0; i < 6; ++i) {
    const double scale = random.uniform(0.8, 1.2);
    file.more.push_back(
        {"Model",
         {2000 + i, fmt::format("Model::chain{}", i), std::string("LimbNode")},
         {{"Version", {std::int32_t{232}}, {}},
          {"Properties70",
           {},
           {property("RotationActive", 1), property("RotationOrder", static_cast<std::int32_t>(i)),
            property("Lcl Translation", some(30.0)), property("Lcl Rotation", some(170.0)),
            property("Lcl Scaling", Vec3d{scale, scale, scale}),
            property("PreRotation", some(170.0)), property("RotationOffset", some(5.0)),
            property("RotationPivot", some(5.0)), property("ScalingOffset", some(5.0)),
            property("ScalingPivot", some(5.0))}}}});
    file.more_links.push_back({2000 + i, i == 0 ? 1000 : 1999 + i});
  }
  return file;
}

TEST(AssimpReadsFbx, AsWeDoWithAllThatIsSaidOfAPlace) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FbxFile file = with_everything(seed);
    for (const std::string& bytes : {file.text(), file.bytes()}) {
      EXPECT_GE(expect_same(bytes, read_by_assimp(bytes)), 20);
    }
  }
}

TEST(AssimpWritesFbx, ThatWeReadInBothForms) {
  const Skeleton figure = standing_figure().skeleton();
  SkeletonMotion motion{figure, {0.1, 2, {}}};
  for (SkeletonNode& node : motion.skeleton.nodes) node.end_site = false;
  for (std::size_t i = 0; i < motion.skeleton.nodes.size(); ++i) {
    SkeletonNode& node = motion.skeleton.nodes[i];
    if (node.name.empty()) node.name = fmt::format("tip{}", i);
  }
  for (int f = 0; f < 2; ++f) {
    for (const SkeletonNode& node : motion.skeleton.nodes)
      motion.clip.local.push_back({node.offset, {}});
  }
  const std::string bvh = format_bvh(motion);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bvh.data(), bvh.size(), 0, "bvh");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  for (const char* form : {"fbx", "fbxa"}) {
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(scene, form);
    ASSERT_NE(blob, nullptr) << exporter.GetErrorString();
    const std::string bytes(static_cast<const char*>(blob->data), blob->size);
    EXPECT_GE(expect_same(bytes, places(*scene)), 20) << form;
  }
}

}  // namespace
}  // namespace shigusa
