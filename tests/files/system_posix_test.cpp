// SPDX-License-Identifier: MIT
// Devices, pipes, links and permissions of POSIX.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "files/file.hpp"
#include "files/file_fixture.hpp"
#include "files/folder.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;
using testing_support::File;
using testing_support::kPlenty;

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

TEST_F(File, EndlessDeviceIsRefused) {
  if (!fs::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero here";
  EXPECT_FALSE(read_text_file("/dev/zero", kPlenty));
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

TEST_F(File, FollowsNoLinkAndDoesNotWaitForAPipe) {
  put("file", "text");
  fs::create_symlink("file", at("link"));
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  const Descriptor folder = open_folder(folder_.path());
  EXPECT_EQ(type_in(folder, "link"), fs::file_type::symlink);
  EXPECT_EQ(type_in(folder, "pipe"), fs::file_type::fifo);
  EXPECT_EQ(type_of(open_entry(folder, "pipe")), fs::file_type::fifo);
  EXPECT_EQ(type_of(open_entry(folder, "link")), fs::file_type::not_found);
}

}  // namespace
}  // namespace shigusa
