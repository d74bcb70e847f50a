// SPDX-License-Identifier: MIT
#include "files/folder.hpp"

#include <gtest/gtest.h>

#include <cerrno>

#include "files/staging.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using testing_support::WorkFolder;
using Type = std::filesystem::file_type;

TEST(Folder, TellsWhatHasAName) {
  const WorkFolder work;
  work.put("file", "text");
  std::filesystem::create_directory(work / "folder");
  const Descriptor folder = open_folder(work.path());
  EXPECT_EQ(type_in(folder, "file"), Type::regular);
  EXPECT_EQ(type_in(folder, "folder"), Type::directory);
  EXPECT_EQ(type_in(folder, "none"), Type::not_found);
  EXPECT_EQ(type_of(open_entry(folder, "file")), Type::regular);
  EXPECT_FALSE(open_entry(folder, "none"));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(type_of(Descriptor()), Type::not_found);
  EXPECT_EQ(names_in(folder).size(), 2u);
}

TEST(Folder, RemovesAFileAndTellsWhyItCannot) {
  const WorkFolder work;
  work.put("file", "text");
  const Descriptor folder = open_folder(work.path());
  EXPECT_EQ(check_writable(folder, "file"), 0);
  EXPECT_EQ(remove_in(folder, "file"), 0);
  EXPECT_EQ(remove_in(folder, "file"), ENOENT);
  EXPECT_EQ(check_writable(folder, "file"), ENOENT);
  EXPECT_EQ(settle(folder), 0);
}

TEST(Folder, OneLockAloneKeepsOutOthersAndSharedOnesDoNot) {
  const WorkFolder work;
  const Descriptor one = open_folder(work.path());
  Descriptor other = open_folder(work.path());
  EXPECT_TRUE(try_lock(one, LockKind::shared));
  EXPECT_TRUE(try_lock(other, LockKind::shared));
  EXPECT_FALSE(try_lock(one, LockKind::alone));
  EXPECT_EQ(other.close(), 0);
  EXPECT_TRUE(try_lock(one, LockKind::alone));
  EXPECT_FALSE(try_lock(open_folder(work.path()), LockKind::shared));
}

TEST(Folder, OfAFileIsNone) {
  const WorkFolder work;
  work.put("file", "text");
  EXPECT_FALSE(open_folder(work / "file"));
  EXPECT_EQ(errno, ENOTDIR);
}

TEST(Folder, KnowsWhatIsCalledByAName) {
  const WorkFolder work;
  work.put("one", "text");
  work.put("other", "text");
  const Descriptor folder = open_folder(work.path());
  const Descriptor one = open_entry(folder, "one");
  EXPECT_TRUE(is_named(one, folder, "one"));
  EXPECT_FALSE(is_named(one, folder, "other"));
  EXPECT_FALSE(is_named(one, folder, "none"));
}

TEST(Folder, MakesAndRemovesFoldersWithin) {
  const WorkFolder work;
  const Descriptor folder = open_folder(work.path());
  EXPECT_EQ(make_folder_in(folder, "within"), 0);
  EXPECT_EQ(make_folder_in(folder, "within"), EEXIST);
  work.put("within/file", "text");
  EXPECT_EQ(remove_folder_in(folder, "within"), ENOTEMPTY);
  EXPECT_EQ(remove_in(open_entry(folder, "within"), "file"), 0);
  EXPECT_EQ(remove_folder_in(folder, "within"), 0);
  EXPECT_TRUE(names_in(folder).empty());
}

TEST(Folder, CreatesNoFileInThePlaceOfAnother) {
  const WorkFolder work;
  const Descriptor folder = open_folder(work.path());
  Descriptor file = create_in(folder, "仕草.bin");
  EXPECT_EQ(write_all(file, "text"), 0);
  EXPECT_FALSE(create_in(folder, "仕草.bin"));
  EXPECT_EQ(errno, EEXIST);
  EXPECT_EQ(work.get("仕草.bin"), "text");
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"仕草.bin"});
}

TEST(Descriptor, TellsItsAge) {
  const WorkFolder work;
  const Descriptor folder = open_folder(work.path());
  EXPECT_FALSE(older_than(folder, std::chrono::hours(1)));
  EXPECT_TRUE(older_than(folder, std::chrono::hours(-1)));
}

TEST(Descriptor, ReadsAtAPlaceAllOrNothing) {
  const WorkFolder work;
  work.put("file", "0123456789");
  const Descriptor file = open_to_read(work / "file");
  char block[4] = {};
  EXPECT_TRUE(read_at(file, 6, block, 4));
  EXPECT_EQ(std::string_view(block, 4), "6789");
  EXPECT_FALSE(read_at(file, 7, block, 4));
  EXPECT_EQ(go_to_end(file), 10u);
  EXPECT_EQ(go_to(file, 8), 0);
  EXPECT_EQ(read_some(file, block, 4), 2);
}

// A file that another program writes by its path, and that is discarded.
TEST(Staging, AFileThatIsNotMovedOutGoesWithIt) {
  const WorkFolder work;
  {
    Staging first;
    ASSERT_EQ(first.open(work.path()), 0);
    ASSERT_EQ(first.make(), 0);
    const Staging moved = std::move(first);
    EXPECT_FALSE(std::filesystem::exists(moved.path_of("file")));
    EXPECT_EQ(names_in(moved.folder()).size(), 1u);
  }
  Staging staging;
  ASSERT_EQ(staging.open(work.path()), 0);
  EXPECT_TRUE(names_in(staging.folder()).empty());
  ASSERT_EQ(staging.make(), 0);
  const Descriptor file = staging.create("file");
  EXPECT_EQ(write_all(file, "mine"), 0);
  EXPECT_TRUE(std::filesystem::exists(staging.path_of("file")));
  EXPECT_EQ(staging.move_out("file", "there"), 0);
  EXPECT_EQ(type_in(staging.folder(), "there"), Type::regular);
}

}  // namespace
}  // namespace shigusa
