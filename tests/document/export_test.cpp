// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <shigusa/files.hpp>

#include "files/sha256.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ParseFormats, ReadsAListInItsOrder) {
  EXPECT_THAT(parse_formats("png,bvh,pdf,csv,svg").value(),
              ElementsAre(FileFormat::png, FileFormat::bvh, FileFormat::pdf, FileFormat::csv,
                          FileFormat::svg));
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

TEST(ParseFormats, TakesEachOnce) {
  EXPECT_THAT(parse_formats("csv,bvh,csv").value(), ElementsAre(FileFormat::csv, FileFormat::bvh));
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

class WriteResult : public testing::Test {
 protected:
  WriteResult() { file_.goals = {{"right_hand", {-0.2, 1.1, 0.4}}}; }

  Result<WrittenResult> write(const std::string& formats = "bvh,csv", std::size_t candidates = 1) {
    const Task task = make_task(file_, {}).value();
    GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
    generation.candidates.resize(candidates, generation.candidates[0]);
    return write_result(work_.path(), {file_, task, generation},
                        {.formats = parse_formats(formats).value()});
  }

  WorkFolder work_;
  TaskFile file_;
};

TEST_F(WriteResult, FollowsNoLinkThatStandsInTheFolder) {
  work_.put("elsewhere/victim", "kept");
  for (const char* name :
       {".shigusa-probe", "candidate-1.bvh", "candidate-2.csv", "summary.json"}) {
    std::filesystem::create_symlink("elsewhere/victim", work_ / name);
  }
  ASSERT_TRUE(prepare_folder(work_.path()));
  ASSERT_TRUE(write());
  EXPECT_EQ(work_.get("elsewhere/victim"), "kept");
  EXPECT_TRUE(std::filesystem::is_symlink(work_ / ".shigusa-probe"));
  EXPECT_FALSE(std::filesystem::is_symlink(work_ / "candidate-1.bvh"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "candidate-2.csv"));
}

TEST_F(WriteResult, GoesIntoAFolderThatIsALink) {
  const WorkFolder other;
  std::filesystem::remove(other / "link");
  std::filesystem::create_directory_symlink(work_.path(), other / "link");
  ASSERT_TRUE(prepare_folder(other / "link"));
  EXPECT_TRUE(read_result(other / "link").error().code == ErrorCode::not_found);
  ASSERT_TRUE(write());
  EXPECT_TRUE(read_result(other / "link", 1));
}

TEST_F(WriteResult, WhatIsNoFileIsRefusedAndTheOlderResultStays) {
  const std::string before = write("csv").value().summary;
  ASSERT_EQ(mkfifo((work_ / "candidate-1.bvh").c_str(), 0600), 0);
  EXPECT_THAT(write().error().to_string(), HasSubstr("a pipe stands in the place"));
  EXPECT_EQ(work_.get("summary.json"), before);
  std::filesystem::remove(work_ / "candidate-1.bvh");
  std::filesystem::create_directory(work_ / "candidate-1.bvh");
  EXPECT_THAT(write().error().to_string(), HasSubstr("a folder stands in the place"));
  EXPECT_EQ(work_.get("summary.json"), before);
  EXPECT_TRUE(read_result(work_.path(), 1));
}

TEST_F(WriteResult, RemovesOlderCandidatesAndNothingElse) {
  ASSERT_TRUE(write("bvh,csv", 12));
  const char* others[] = {"candidate-.bvh", "candidate-3.bvh.txt", "candidate-x.csv", "my.bvh",
                          "edit-1/candidate-1.bvh"};
  for (const char* name : others) work_.put(name, "mine");
  // a gap ends nothing
  std::filesystem::remove(work_ / "candidate-5.bvh");
  std::filesystem::remove(work_ / "candidate-5.csv");
  ASSERT_TRUE(write("bvh", 2));
  for (const char* name : others) EXPECT_EQ(work_.get(name), "mine");
  EXPECT_FALSE(std::filesystem::exists(work_ / "candidate-12.csv"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "candidate-1.csv"));
  EXPECT_TRUE(std::filesystem::exists(work_ / "candidate-2.bvh"));
}

TEST_F(WriteResult, AFileThatIsNotTheOneDescribedIsFoundAndOneThatIsMissingIsNot) {
  ASSERT_TRUE(write("bvh,csv", 2));
  ASSERT_TRUE(read_result(work_.path(), 2));
  work_.put("candidate-2.csv", "changed");
  const auto changed = read_result(work_.path(), 2);
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().to_string(), HasSubstr("candidate-2.csv: is not the file that "
                                                     "summary.json describes"));
  EXPECT_TRUE(read_result(work_.path(), 1)) << "of another candidate";
  EXPECT_TRUE(read_result(work_.path()));
  std::filesystem::remove(work_ / "candidate-2.csv");
  EXPECT_TRUE(read_result(work_.path(), 2));
  ASSERT_EQ(mkfifo((work_ / "candidate-2.csv").c_str(), 0600), 0);
  EXPECT_FALSE(read_result(work_.path(), 2)) << "and is not waited for";
}

TEST_F(WriteResult, DigestsAreThoseOfTheFiles) {
  const auto stored = parse_result(write().value().summary, "summary.json").value();
  EXPECT_EQ(stored.files.at(0).at("csv").sha256, sha256(work_.get("candidate-1.csv")));
  // FIPS 180-4's example
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ExportCandidate, GivesEachFormatItsOwnBytes) {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Candidate candidate = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  const auto bytes = [&](FileFormat format) {
    return export_candidate(task, candidate, format).value();
  };
  EXPECT_THAT(bytes(FileFormat::bvh), StartsWith("HIERARCHY"));
  EXPECT_THAT(bytes(FileFormat::csv), StartsWith("time [s],right_ankle.inversion [rad]"));
  EXPECT_THAT(bytes(FileFormat::svg), StartsWith("<?xml"));
}

TEST(ExportCandidate, PngAndPdfAreWhatTheCallerMakesOfTheSvg) {
  TaskFile file;
  file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Candidate candidate = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  const std::string svg = export_candidate(task, candidate, FileFormat::svg).value();
  FileSettings settings;
  for (const FileFormat format : {FileFormat::png, FileFormat::pdf}) {
    settings.from_svg = nullptr;
    EXPECT_EQ(export_candidate(task, candidate, format, settings).error().code,
              ErrorCode::unsupported);
    settings.from_svg = [](const std::string& drawn, FileFormat asked) -> Result<std::string> {
      return std::string(word_of(asked)) + drawn;
    };
    EXPECT_EQ(export_candidate(task, candidate, format, settings).value(),
              std::string(word_of(format)) + svg);
  }
}

}  // namespace
}  // namespace shigusa
