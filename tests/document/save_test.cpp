// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/shigusa.hpp>

#include "files/file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

class Save : public testing::Test {
 protected:
  Save() : character_(open_character({.source = "full_body"}).value()), task_(character_) {
    task_.goals = {{"right_hand", {-0.2, 0.9, 0.4}}};
    task_.evaluations = 200;
    candidate_ = generate(task_).value().candidates[0];
  }

  WorkFolder work_;
  Character character_;
  Task task_;
  Candidate candidate_;
};

TEST_F(Save, WritesTheFormatOfTheEnding) {
  for (const auto& [name, format] : {std::pair{"a.bvh", FileFormat::bvh},
                                     {"a.b.SVG", FileFormat::svg},
                                     {"a.csv", FileFormat::csv}}) {
    ASSERT_TRUE(save(work_ / name, character_.spec, task_, candidate_)) << name;
    EXPECT_EQ(read_text_file(work_ / name, 1 << 24).value(),
              export_candidate(character_.spec, task_, candidate_, format).value())
        << name;
  }
}

TEST_F(Save, RefusesOtherEndingsAndWritesNothing) {
  for (const auto& [name, told] : {std::pair{"a", "'no ending'"},
                                   {"a.", "'no ending'"},
                                   {"a.jpg", "'jpg'"},
                                   {"a.bvh,csv", "'bvh,csv'"},
                                   {"a.fbx", "fbx"},
                                   {"", "'no ending'"}}) {
    const auto saved = save(work_ / name, character_.spec, task_, candidate_);
    ASSERT_FALSE(saved) << name;
    EXPECT_THAT(saved.error().to_string(), HasSubstr(told));
  }
  EXPECT_FALSE(save(work_ / "none/a.bvh", character_.spec, task_, candidate_));
  EXPECT_TRUE(std::filesystem::is_empty(work_ / ""));
}

TEST(OpenCharacter, FailsInWords) {
  const auto giant = open_character({.source = "human", .stature = 170.0});
  ASSERT_FALSE(giant);
  EXPECT_THAT(giant.error().to_string(), HasSubstr("170 m; allowed are 0.5 to 2.5 m"));
  const auto absent = open_character({.source = "absent.glb"});
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace shigusa
