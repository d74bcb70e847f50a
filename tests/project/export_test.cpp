// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/project/export.hpp>

#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ParseFormats, ReadsAListInItsOrder) {
  EXPECT_THAT(parse_formats("png,bvh,pdf,csv,svg").value(),
              ElementsAre(ExportFormat::png, ExportFormat::bvh, ExportFormat::pdf,
                          ExportFormat::csv, ExportFormat::svg));
  EXPECT_THAT(parse_formats("").value(), ElementsAre());
}

TEST(ParseFormats, NamesTheWordThatIsNone) {
  for (const auto& [list, word] : {std::pair{"bvh,gltf", "'gltf'"},
                                   {"bvh,", "''"},
                                   {",", "''"},
                                   {"bvh,,csv", "''"},
                                   {"BVH", "'BVH'"},
                                   {" bvh", "' bvh'"}}) {
    const auto formats = parse_formats(list);
    ASSERT_FALSE(formats) << list;
    EXPECT_THAT(formats.error().message, HasSubstr(word)) << list;
  }
}

TEST(PrepareFolder, MakesFoldersAndLeavesNothingInThem) {
  const WorkFolder work;
  ASSERT_TRUE(prepare_folder(work / "a/b"));
  ASSERT_TRUE(prepare_folder(work / "a/b"));
  EXPECT_TRUE(std::filesystem::is_empty(work / "a/b"));
}

TEST(PrepareFolder, TellsWhyItCannot) {
  const WorkFolder work;
  work.put("file", "");
  for (const std::filesystem::path& folder : {work / "file", work / "file/below"}) {
    const auto made = prepare_folder(folder);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::io);
    EXPECT_EQ(made.error().place, folder.string());
  }
  EXPECT_FALSE(prepare_folder(""));
}

TEST(ExportCandidate, GivesEachFormatItsOwnBytes) {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Candidate candidate = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  const auto bytes = [&](ExportFormat format) {
    return export_candidate(task, candidate, format).value();
  };
  EXPECT_THAT(bytes(ExportFormat::bvh), StartsWith("HIERARCHY"));
  EXPECT_THAT(bytes(ExportFormat::csv), StartsWith("time [s],right_ankle.flexion [rad]"));
  EXPECT_THAT(bytes(ExportFormat::svg), StartsWith("<?xml"));
  EXPECT_THAT(bytes(ExportFormat::png), StartsWith("\x89PNG"));
  EXPECT_THAT(bytes(ExportFormat::pdf), StartsWith("%PDF"));
}

}  // namespace
}  // namespace shigusa
