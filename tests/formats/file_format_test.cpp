// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <shigusa/formats.hpp>

namespace shigusa {
namespace {

TEST(FileFormats, StandInTheOrderOfTheirEnumAndHaveAWordEach) {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < kFileFormats.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kFileFormats[i].format), i) << kFileFormats[i].word;
    words.insert(kFileFormats[i].word);
  }
  EXPECT_EQ(words.size(), kFileFormats.size());
}

TEST(FileFormats, AreReadOrWrittenAndSaySo) {
  for (const FormatInfo& info : kFileFormats) {
    const bool read = info.person || info.robot || info.clip;
    EXPECT_TRUE(read || info.written) << info.word;
    EXPECT_EQ(read, info.max_bytes > 0) << info.word;
    EXPECT_TRUE(info.about.ends_with('.')) << info.word;
    EXPECT_NE(info.media_type.find('/'), std::string_view::npos) << info.word;
    EXPECT_TRUE(info.written || !(info.usual || info.rated)) << info.word;
    const std::string ending = "." + std::string(info.word);
    EXPECT_TRUE(!info.written || info.endings[0] == ending) << info.word;
  }
}

TEST(FileFormats, AreFoundByEachEndingInAnyCase) {
  for (const FormatInfo& info : kFileFormats) {
    for (const std::string_view ending : info.endings) {
      if (ending.empty()) continue;
      const bool read = info.person || info.robot || info.clip;
      const std::optional<FileFormat> found = format_of_file("a.b" + std::string(ending));
      EXPECT_EQ(found, read ? std::optional(info.format) : std::nullopt) << ending;
    }
  }
  EXPECT_EQ(format_of_file("WALK.BvH"), FileFormat::bvh);
  EXPECT_EQ(format_of_file("gltf"), std::nullopt);
  EXPECT_EQ(format_of_file("a.obj"), std::nullopt);
}

TEST(FileFormats, NeedFilesThatPeopleComeFrom) {
  EXPECT_TRUE(is_file(FileFormat::vrm, NeededFile::gltf));
  EXPECT_TRUE(is_file(FileFormat::fbx, NeededFile::gltf));
  EXPECT_FALSE(is_file(FileFormat::bvh, NeededFile::gltf));
  EXPECT_FALSE(is_file(FileFormat::glb, NeededFile::vrm));
  EXPECT_TRUE(is_file(FileFormat::bvh, NeededFile::none));
}

TEST(FileFormats, AreListedAsAPersonReads) {
  EXPECT_EQ(format_words([](const FormatInfo& info) { return info.rated; }),
            "bvh, glb, vrma and npz");
  EXPECT_EQ(format_endings([](const FormatInfo& info) { return info.robot; }),
            ".urdf, .xml or .mjcf");
  EXPECT_EQ(format_words([](const FormatInfo&) { return false; }), "");
}

}  // namespace
}  // namespace shigusa
