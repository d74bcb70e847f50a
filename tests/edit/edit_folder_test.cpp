// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/edit.hpp>

#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using testing_support::WorkFolder;

std::string made_in(const WorkFolder& work) {
  const auto folder = EditFolder::make(work.path(), "edit");
  return folder ? folder->path().filename().string() : folder.error().to_string();
}

TEST(EditFolder, IsANewOneEachTime) {
  const WorkFolder work;
  const auto one = EditFolder::make(work.path(), "edit");
  const auto other = EditFolder::make(work.path(), "edit");
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->path(), work / "edit-1");
  EXPECT_EQ(other->path(), work / "edit-2");
  EXPECT_EQ(EditFolder::make(work.path(), "mirror").value().path(), work / "mirror-1");
}

TEST(EditFolder, GoesAgainWhereNothingIsWritten) {
  const WorkFolder work;
  EXPECT_EQ(made_in(work), "edit-1");
  EXPECT_TRUE(work.contents().empty());
  {
    const auto folder = EditFolder::make(work.path(), "edit");
    work.put("edit-1/summary.json", "{}");
  }
  EXPECT_EQ(work.contents(),
            (std::map<std::string, std::string>{{"edit-1/", ""}, {"edit-1/summary.json", "{}"}}));
}

// Remains of a killed program: an empty folder, a staging folder, files without a summary.
TEST(EditFolder, OfAKilledProgramIsTakenAgain) {
  for (const std::vector<std::string>& left :
       {std::vector<std::string>{},
        {".shigusa-0123456789abcdef.tmp/candidate-1.bvh"},
        {".shigusa-00ab.tmp/summary.json", "candidate-1.bvh", "candidate-2.csv"}}) {
    const WorkFolder work;
    std::filesystem::create_directory(work / "edit-1");
    for (const std::string& name : left) work.put("edit-1/" + name, "left");
    const auto folder = EditFolder::make(work.path(), "edit");
    ASSERT_TRUE(folder);
    EXPECT_EQ(folder->path(), work / "edit-1") << left.size();
    EXPECT_FALSE(std::filesystem::exists(work / "edit-1/.shigusa-00ab.tmp"));
  }
}

TEST(EditFolder, OfSomebodyElseStays) {
  const WorkFolder work;
  work.put("edit-1/summary.json", "{}");
  work.put("edit-2/notes.txt", "mine");
  work.put("edit-3", "a file");
  EXPECT_EQ(made_in(work), "edit-4");
  EXPECT_EQ(work.get("edit-2/notes.txt"), "mine");
}

TEST(EditFolder, WhereNothingCanBeMadeIsTold) {
  const WorkFolder work;
  const auto folder = EditFolder::make(work / "not there", "edit");
  ASSERT_FALSE(folder);
  EXPECT_NE(folder.error().message.text.find("cannot make this folder"), std::string::npos);
}

}  // namespace
}  // namespace shigusa
