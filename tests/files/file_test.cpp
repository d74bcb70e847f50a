// SPDX-License-Identifier: MIT
#include "files/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "files/descriptor.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPlenty = 1 << 20;

// An empty folder of its own for each test.
class File : public ::testing::Test {
 protected:
  File() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("shigusa-file-test-" + std::to_string(getpid()) + "-" + test->name());
    fs::create_directories(folder_);
  }
  ~File() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  [[nodiscard]] fs::path at(const std::string& name) const { return folder_ / name; }

  // Makes a file without the functions that are tested.
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(at(name)) << text;
  }

  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

// During its lifetime, files may not grow beyond `bytes`, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit old_{};
  void (*handler_)(int);
};

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
  const auto text = read_text_file(folder_, kPlenty);
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

TEST_F(File, EndlessDeviceIsRefused) {
  if (!fs::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero here";
  EXPECT_FALSE(read_text_file("/dev/zero", kPlenty));
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

TEST_F(File, FullDiskLeavesTheOldFileWhole) {
  ASSERT_TRUE(write_file(at("a"), "old"));
  {
    const SmallDisk disk(1000);
    EXPECT_FALSE(write_file(at("a"), std::string(100'000, 'x')));
  }
  EXPECT_EQ(read_text_file(at("a"), kPlenty).value(), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(File, FullDeviceIsToldWithTheSystemsReason) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto done = write_file("/dev/full", "x");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().to_string(), "/dev/full: cannot write: No space left on device");
}

TEST_F(File, DeviceIsNotReplacedByAFile) {
  if (!fs::exists("/dev/null")) GTEST_SKIP() << "no /dev/null here";
  ASSERT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
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

TEST_F(File, ReadOnlyFileIsNotReplaced) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anything";
  ASSERT_TRUE(write_file(at("a"), "old"));
  fs::permissions(at("a"), fs::perms::owner_read);
  const auto done = write_file(at("a"), "new");
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.text.find("Permission denied"), std::string::npos);
}

TEST_F(File, OldFileKeepsItsPermissions) {
  ASSERT_TRUE(write_file(at("a"), "old"));
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(at("a"), mode);
  ASSERT_TRUE(write_file(at("a"), "new"));
  EXPECT_EQ(fs::status(at("a")).permissions(), mode);
}

TEST_F(File, SymbolicLinkStaysALinkToTheWrittenFile) {
  ASSERT_TRUE(write_file(at("real"), "old"));
  fs::create_symlink("real", at("link"));
  ASSERT_TRUE(write_file(at("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(read_text_file(at("real"), kPlenty).value(), "new");
}

TEST_F(File, ALinkInThePlaceOfATemporaryFileIsNotFollowed) {
  ASSERT_TRUE(write_file(at("victim"), "kept"));
  for (int i = 0; i < 1000; ++i) {
    fs::create_symlink("victim", at(".shigusa-" + std::to_string(i) + ".tmp"));
  }
  ASSERT_TRUE(write_file(at("a"), "new"));
  EXPECT_EQ(read_text_file(at("victim"), kPlenty).value(), "kept");
  EXPECT_EQ(files(), 1002u);
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
  const int other = open(at(".shigusa-0123456789abcdef.tmp").c_str(), O_RDONLY);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  ASSERT_TRUE(write_file(at("a"), "new"));
  EXPECT_EQ(files(), 4u);
  close(other);
}

TEST_F(File, ANamedPipeIsRefusedAndNotWaitedFor) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_text_file(at("pipe"), kPlenty).error().message, "is a pipe; a file is expected");
  EXPECT_EQ(write_file(at("pipe"), "x").error().message, "is a pipe; a file is expected");
}

TEST_F(File, APipeOfTheProgramsOwnIsReadToItsEnd) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  std::thread writer([&] {
    // late bytes are waited for
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(write(ends[1], "task", 4), 4);
    close(ends[1]);
  });
  EXPECT_EQ(read_text_file("/dev/fd/" + std::to_string(ends[0]), kPlenty).value(), "task");
  writer.join();
  close(ends[0]);
}

// With the standard streams closed, printed text would go to the file with their number.
TEST_F(File, FilesNeverGetAStandardStreamsNumber) {
  put("a", "text");
  const pid_t child = fork();
  if (child == 0) {
    for (int number = 0; number < 3; ++number) close(number);
    const Descriptor file = open_to_read(at("a"));
    _exit(file.number() > 2 && read_text_file(at("a"), kPlenty) ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace shigusa
