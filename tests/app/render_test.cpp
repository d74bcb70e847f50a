// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "support/person_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

class Render : public testing::Test {
 protected:
  Render() { work_.put("clips/person.bvh", person_bvh()); }

  ProgramRun render(const Words& arguments) {
    Words call{"render"};
    call.insert(call.end(), arguments.begin(), arguments.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(Render, DrawsEachFormatByTheEndingOfTheName) {
  for (const auto& [name, begin] :
       {std::pair{"a.svg", "<?xml"}, {"a.png", "\x89PNG"}, {"a.pdf", "%PDF"}}) {
    const ProgramRun run = render({"clips/person.bvh", "--out", name});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, std::string(name) + "\n");
    EXPECT_THAT(work_.get(name), StartsWith(begin));
  }
}

TEST_F(Render, WithoutANameDrawsHereUnderTheClipsName) {
  EXPECT_EQ(render({"clips/person.bvh"}).out, "person.svg\n");
  EXPECT_TRUE(std::filesystem::exists(work_ / "person.svg"));
}

TEST_F(Render, UnderstandsAPersonWithoutANote) { EXPECT_EQ(render({"clips/person.bvh"}).err, ""); }

TEST_F(Render, FramesAndPosesChoosePartOfTheClip) {
  ASSERT_EQ(render({"clips/person.bvh", "--out", "all.svg", "--poses", "3"}).exit_code, 0);
  ASSERT_EQ(
      render({"clips/person.bvh", "--out", "end.svg", "--poses", "2", "--frames", "1:2"}).exit_code,
      0);
  EXPECT_THAT(work_.get("all.svg"), Not(testing::Eq(work_.get("end.svg"))));
}

TEST_F(Render, SameClipSameBytes) {
  for (const char* name : {"a.svg", "b.svg", "a.pdf", "b.pdf", "a.png", "b.png"}) {
    ASSERT_EQ(render({"clips/person.bvh", "--out", name}).exit_code, 0);
  }
  for (const char* ending : {".svg", ".pdf", ".png"}) {
    EXPECT_EQ(work_.get(std::string("a") + ending), work_.get(std::string("b") + ending));
  }
}

TEST_F(Render, DrawsWhatIsNoPersonAsItStandsAndSaysSo) {
  work_.put("tail.bvh", one_joint_bvh());
  const ProgramRun run = render({"tail.bvh"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("tail.bvh: note: no whole person"));
}

TEST_F(Render, NeverReplacesTheClip) {
  const std::string clip = person_bvh();
  work_.put("clip.svg", clip);
  EXPECT_EQ(render({"clip.svg"}).exit_code, 2);
  EXPECT_EQ(work_.get("clip.svg"), clip);
}

TEST_F(Render, DrawsTheHalfBodysOwnMotionInMetres) {
  // half a body is no whole person, so its size is guessed
  ASSERT_EQ(run_shigusa({"reach", "--character", "half_body", "--goal", "right_hand=-0.2,1.1,0.4",
                         "--formats", "bvh", "--out", "."},
                        {.folder = work_.path()})
                .exit_code,
            0);
  const ProgramRun run = render({"candidate-1.bvh"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("1 unit = 0.01 m"));
}

TEST_F(Render, DrawsRecordedMotion) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded motion here";
  for (const char* clip : {"/characters/pybvh__bvh_test1.bvh",
                           "/characters/assimp__Boxing_Toes.bvh", "/reach/cmu_02_06_60hz.bvh"}) {
    const ProgramRun run = render({shared + clip, "--out", "recorded.png", "--frames", "10:60"});
    EXPECT_EQ(run.exit_code, 0) << clip << run.err;
    EXPECT_EQ(run.err, "") << clip;
  }
}

}  // namespace
}  // namespace shigusa
