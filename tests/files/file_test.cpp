// SPDX-License-Identifier: MIT
#include "files/file.hpp"

#include <gtest/gtest.h>

#include "files/file_fixture.hpp"
#include "files/folder.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;
using testing_support::File;
using testing_support::kPlenty;

TEST_F(File, WhatIsWrittenIsReadBackByteForByte) {
  std::string bytes(200'000, 'x');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i % 251);
  ASSERT_TRUE(write_file(at("a.bin"), bytes));
  EXPECT_EQ(read_text_file(at("a.bin"), bytes.size()).value(), bytes);
}

TEST_F(File, EmptyFileReadsAsEmptyText) {
  ASSERT_TRUE(write_file(at("empty"), ""));
  EXPECT_EQ(read_text_file(at("empty"), 0).value(), "");
}

TEST_F(File, MissingFileIsNotFoundAndNamed) {
  const auto text = read_text_file(at("none.bvh"), kPlenty);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, ErrorCode::not_found);
  EXPECT_EQ(text.error().place, at("none.bvh").string());
  EXPECT_NE(text.error().message.text.find("No such file"), std::string::npos);
}

TEST_F(File, FolderIsRefusedForReading) {
  const auto text = read_text_file(folder_.path(), kPlenty);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, ErrorCode::io);
  EXPECT_NE(text.error().message.text.find("directory"), std::string::npos);
}

TEST_F(File, FileLargerThanAllowedIsRefusedWithTheBound) {
  ASSERT_TRUE(write_file(at("big"), std::string(1001, 'x')));
  const auto text = read_text_file(at("big"), 1000);
  ASSERT_FALSE(text);
  EXPECT_NE(text.error().message.text.find("1000 bytes"), std::string::npos);
}

TEST_F(File, WritingReplacesTheOldContents) {
  ASSERT_TRUE(write_file(at("a"), "a long first text"));
  ASSERT_TRUE(write_file(at("a"), "short"));
  EXPECT_EQ(read_text_file(at("a"), kPlenty).value(), "short");
}

TEST_F(File, WritingLeavesNoOtherFile) {
  ASSERT_TRUE(write_file(at("a"), "1"));
  ASSERT_TRUE(write_file(at("a"), "2"));
  EXPECT_EQ(files(), 1u);
}

TEST_F(File, WritingToAFolderIsRefused) {
  fs::create_directory(at("folder"));
  const auto done = write_file(at("folder"), "x");
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.text.find("directory"), std::string::npos);
}

TEST_F(File, WritingIntoAMissingFolderIsNotFound) {
  const auto done = write_file(at("none") / "a", "x");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::not_found);
  EXPECT_FALSE(fs::exists(at("none")));
}

TEST_F(File, WhatKilledProgramsLeftIsRemoved) {
  for (int i = 0; i < 1000; ++i) put(".shigusa-" + std::to_string(i) + ".tmp", "of an old version");
  fs::create_directory(at(".shigusa-0123456789abcdef.tmp"));
  put(".shigusa-0123456789abcdef.tmp/a", "half of it");
  ASSERT_TRUE(write_file(at("a"), "new"));
  EXPECT_EQ(files(), 1u);
}

TEST_F(File, WhatIsNotAProgramsLeftoverStays) {
  put(".shigusa-notes.tmp", "mine");
  put(".shigusa-12.tmp.txt", "mine");
  // of a program that is at work
  fs::create_directory(at(".shigusa-0123456789abcdef.tmp"));
  const Descriptor other = open_folder(at(".shigusa-0123456789abcdef.tmp"));
  ASSERT_EQ(lock_now(other, LockKind::alone), 0);
  ASSERT_TRUE(write_file(at("a"), "new"));
  EXPECT_EQ(files(), 4u);
}

}  // namespace
}  // namespace shigusa
