// SPDX-License-Identifier: MIT
#include "formats/file_kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shigusa {
namespace {

using testing::HasSubstr;

std::string told(std::string_view bytes, const std::string& name) {
  const Result<void> kind = check_file_kind(bytes, name);
  return kind ? "" : kind.error().to_string();
}

TEST(FileKind, WhatAFileIsIsNamed) {
  constexpr std::string_view kPage = "\n<!DOCTYPE html>\n<html><body>Not found</body></html>";
  constexpr std::string_view kOlderPage = "<HTML><HEAD>";
  constexpr std::string_view kPointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0";
  for (const char* ending : {".bvh", ".glb", ".gltf", ".vrm", ".fbx", ".urdf", ".xml"}) {
    const std::string name = std::string("hero") + ending;
    EXPECT_EQ(told("PK\x03\x04....", name), name + ": this is a ZIP archive, not a " + ending +
                                                " file: unpack it and give what is in it");
    EXPECT_THAT(told(kPage, name), HasSubstr("this is an HTML page"));
    EXPECT_THAT(told(kOlderPage, name), HasSubstr("this is an HTML page"));
    EXPECT_THAT(told(kPointer, name), HasSubstr("a pointer of Git LFS"));
    EXPECT_THAT(told("BLENDER-v401", name), HasSubstr("a Blender file"));
    EXPECT_THAT(told("\x1F\x8B\x08", name), HasSubstr("a compressed file"));
    EXPECT_THAT(told("\xFF\xFEH", name), HasSubstr("save it as UTF-8"));
    EXPECT_THAT(told("<?xml version=\"1.0\"?><COLLADA/>", name), HasSubstr("a COLLADA file"));
  }
}

TEST(FileKind, OfOurOwnFormatsTheEndingIsTold) {
  constexpr std::string_view kRobot =
      "<?xml version=\"1.0\"?>\n<!-- made by <a> -->\n<robot name=\"r\">";
  EXPECT_THAT(told("glTF\2", "hero.bvh"), HasSubstr("this is a GLB file, not a .bvh file"));
  EXPECT_THAT(told("\xEF\xBB\xBFHIERARCHY\nROOT a", "walk.fbx"), HasSubstr("call it .bvh"));
  EXPECT_THAT(told("Kaydara FBX Binary  ", "walk.BVH"), HasSubstr("an FBX file"));
  EXPECT_THAT(told("; FBX 7.4.0 project file", "a.glb"), HasSubstr("an FBX file"));
  EXPECT_THAT(told(" {\"asset\":{}}", "a.fbx"), HasSubstr("a glTF file"));
  EXPECT_THAT(told("{\"error\":1}", "a.urdf"), HasSubstr("a JSON text"));
  EXPECT_THAT(told(kRobot, "a.xml"), HasSubstr("call it .urdf"));
  EXPECT_THAT(told(kRobot, "a.vrm"), HasSubstr("a URDF file"));
  EXPECT_THAT(told("<mujoco/>", "a.urdf"), HasSubstr("an MJCF file"));
  EXPECT_THAT(told("<a/>", "a.bvh"), HasSubstr("an XML text"));
}

TEST(FileKind, WhatItsNameSaysIsLeftToItsReader) {
  for (const auto& [bytes, name] : {std::pair<std::string_view, std::string>("HIERARCHY", "a.bvh"),
                                    {"glTF\2", "a.glb"},
                                    {"{\"asset\":{}}", "a.vrm"},
                                    {"{\"error\":1}", "a.gltf"},
                                    {"Kaydara FBX Binary", "a.fbx"},
                                    {"<robot name=\"r\"/>", "a.urdf"},
                                    {"<mujoco>", "a.xml"},
                                    {"<include/>", "a.xml"},
                                    {"", "a.glb"},
                                    {"nothing known", "a.bvh"},
                                    {"<!-- never closed", "a.urdf"}}) {
    EXPECT_EQ(told(bytes, name), "") << name << ' ' << bytes;
  }
}

}  // namespace
}  // namespace shigusa
