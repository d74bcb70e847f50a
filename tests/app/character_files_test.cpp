// SPDX-License-Identifier: MIT
// A character's motions as the command line writes them.
#include "app/result_checks.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class CharacterFiles : public testing::Test {
 protected:
  CharacterFiles() { work_.put("person.glb", glb(person_gltf().dump(), "data")); }

  ProgramRun run(Words call) { return run_shigusa(call, {.folder = work_.path()}); }
  ProgramRun reach(const Words& more, const std::string& character = "person.glb") {
    Words call{"reach",         "--character", character,      "--goal", "right_hand=-0.2,1.1,0.4",
               "--evaluations", "8",           "--candidates", "2"};
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }

  WorkFolder work_;
};

TEST_F(CharacterFiles, AGltfCharacterLeavesAsGlbUnasked) {
  const ProgramRun run = reach({});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const StoredRun stored(work_, "out");
  expect_promises_kept(stored);
  const Json& candidate = stored.candidate(1);
  EXPECT_EQ(candidate.at("files").size(), 5u);
  const ExportedGlb out(stored.get(candidate.at("files").at("glb")));
  const Json& goal = candidate.at("reached").at(0);
  const int last = candidate.at("frames").get<int>() - 1;
  EXPECT_LE(norm(out.at(goal.at("gltf_node"), candidate.at("glb_animation"), last) -
                 to_vec(goal.at("goal_m"))),
            kMillimetre);
}

TEST_F(CharacterFiles, EditsNeedTheFileForGlbAlone) {
  ASSERT_EQ(reach({}).exit_code, 0);
  const ProgramRun without = run({"edit", "out", "--set", "right_knee.weight=3", "--out", "a"});
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_EQ(StoredRun(work_, "a").candidate(1).at("files").size(), 4u);
  expect_promises_kept(StoredRun(work_, "a"));
  const ProgramRun refused = run({"edit", "out", "--formats", "glb", "--out", "b"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("needs the character's file, person.glb: give it by "
                                     "--character FILE"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "b"));
  const ProgramRun with = run({"edit", "out", "--character", "person.glb", "--out", "c"});
  EXPECT_EQ(with.exit_code, 0) << with.err;
  // the same parameters give the same motion
  EXPECT_EQ(work_.get("c/candidate-1.glb"), work_.get("out/candidate-1.glb"));
}

// What one motion ends with the next one begins with.
TEST_F(CharacterFiles, AFrameOfAGltfAnimationIsAStartPosture) {
  ASSERT_THAT(reach({"--duration", "1"}).exit_code, delivered());
  const Vec3d end =
      to_vec(StoredRun(work_, "out").candidate(1).at("reached").at(0).at("reached_m"));
  const auto again = [&](const Words& start) {
    Words call{
        "reach",         "--character", "out/candidate-1.glb", "--goal", "left_hand=0.2,1,0.4",
        "--evaluations", "8",           "--candidates",        "1",      "--out",
        "next"};
    call.insert(call.end(), start.begin(), start.end());
    return run(call);
  };
  const ProgramRun next = again({"--frame", "60"});
  ASSERT_EQ(next.exit_code, 0) << next.err;
  const StoredRun stored(work_, "next");
  expect_promises_kept(stored);
  const ExportedGlb out(stored.get("candidate-1.glb"));
  const Json first = StoredRun(work_, "out").candidate(1).at("reached").at(0);
  const Json& candidate = stored.candidate(1);
  // a twisted trunk faces another way, and the world goes with it, about the middle of the feet
  const Vec3d begin = out.at(first.at("gltf_node"), candidate.at("glb_animation"), 0);
  constexpr double kTenth = 1e-4;
  EXPECT_NEAR(begin.y, end.y, kTenth);
  EXPECT_NEAR(std::hypot(begin.x, begin.z), std::hypot(end.x, end.z), kTenth);
  // a result that holds its person does not need the animation any more
  EXPECT_EQ(run({"edit", "next", "--set", "right_knee.weight=3", "--out", "e"}).exit_code, 0);
  EXPECT_EQ(again({"--frame", "61"}).exit_code, 2);
  EXPECT_EQ(again({"--animation", "waving"}).exit_code, 2);
  EXPECT_EQ(again({"--animation", "shigusa candidate 1", "--frame", "30"}).exit_code, 0);
}

TEST_F(CharacterFiles, OneFileHoldsAllCandidates) {
  ASSERT_EQ(reach({"--one-file", "--formats", "glb"}).exit_code, 0);
  const StoredRun stored(work_, "out");
  const ExportedGlb out(stored.get("candidates.glb"));
  EXPECT_EQ(out.json().at("animations").size(), stored.summary().at("candidates").size());
  EXPECT_EQ(stored.files(), (std::set<std::string>{"candidates.glb", "summary.json"}));
}

TEST_F(CharacterFiles, FormatsThatACharacterHasNotAreRefusedBeforeTheSearch) {
  for (const auto& [character, format] :
       {std::pair{"full_body", "glb"}, {"person.glb", "vrma"}, {"person.bvh", "glb"}}) {
    work_.put("person.bvh", person_bvh());
    const ProgramRun run = reach({"--formats", format}, character);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr(std::string("the format ") + format));
    EXPECT_FALSE(std::filesystem::exists(work_ / "out"));
  }
}

TEST_F(CharacterFiles, AFileThatRefersToOthersLeavesAsTheRest) {
  nlohmann::json file = person_gltf();
  file["images"] = {{{"uri", "skin.png"}}};
  work_.put("person.gltf", file.dump());
  const ProgramRun usual = reach({}, "person.gltf");
  EXPECT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_THAT(usual.err, HasSubstr("cannot leave as GLB: images[0] lies in another file"));
  EXPECT_EQ(StoredRun(work_, "out").candidate(1).at("files").size(), 4u);
  const ProgramRun asked = reach({"--formats", "glb"}, "person.gltf");
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.err, HasSubstr("make it one .glb file first"));
}

TEST_F(CharacterFiles, SameSeedSameBytes) {
  ASSERT_EQ(reach({"--threads", "1", "--simd", "scalar"}).exit_code, 0);
  const std::string first = work_.get("out/candidate-1.glb");
  ASSERT_EQ(reach({"--threads", "2"}).exit_code, 0);
  EXPECT_EQ(work_.get("out/candidate-1.glb"), first);
}

}  // namespace
}  // namespace shigusa
