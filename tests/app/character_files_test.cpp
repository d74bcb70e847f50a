// SPDX-License-Identifier: MIT
// A character's motions as written by the command line.
#include "app/result_checks.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;
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

  // By the GLB's own numbers.
  static void expect_glb_meets_goal(const StoredRun& stored) {
    const Json& candidate = stored.candidate(1);
    const ExportedGlb out(stored.get(candidate.at("files").at("glb")));
    const Json& goal = candidate.at("reached").at(0);
    const int last = candidate.at("file_frames").get<int>() - 1;
    EXPECT_LE(norm(out.at(goal.at("gltf_node"), candidate.at("glb_animation"), last) -
                   to_vec(goal.at("goal_m"))),
              kMillimetre);
  }

  WorkFolder work_;
};

TEST_F(CharacterFiles, AGltfCharacterLeavesAsGlbUnasked) {
  const ProgramRun run = reach({});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const StoredRun stored(work_, "out");
  expect_promises_kept(stored);
  EXPECT_EQ(stored.candidate(1).at("files").size(), 4u);
  expect_glb_meets_goal(stored);
}

TEST_F(CharacterFiles, AStartThatNobodyCouldHoldIsNoGoalsFault) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
  const std::string walk = shared + "/characters/bvhtoolbox_walk01.bvh";
  const ProgramRun asked = reach({"--frame", "0"}, walk);
  EXPECT_EQ(asked.exit_code, 3);
  EXPECT_THAT(asked.err, HasSubstr("that was asked for, frame 0, still"));
  EXPECT_THAT(asked.err, HasSubstr("unsteady: whatever the goal"));
  EXPECT_THAT(asked.out, HasSubstr("the start itself is impossible"));
  EXPECT_THAT(asked.out, Not(HasSubstr("candidate 1 is impossible")));
  const ProgramRun found = reach({"--out", "rest"}, walk);
  EXPECT_THAT(found.err, HasSubstr("starts from the rest pose"));
  EXPECT_EQ(StoredRun(work_, "rest").summary().at("task").at("character").at("frame"), "rest");
}

std::set<std::string> formats_of(const StoredRun& run) {
  std::set<std::string> formats;
  for (const auto& [format, name] : run.candidate(1).at("files").items()) formats.insert(format);
  return formats;
}

TEST_F(CharacterFiles, EditsAndMirrorImagesLeaveAsTheResultDid) {
  ASSERT_EQ(reach({}).exit_code, 0);
  const StoredRun reached(work_, "out");
  EXPECT_EQ(reached.summary().at("character_file"), "../person.glb");
  for (const std::string command : {"edit", "mirror"}) {
    for (const Words& more : {Words{}, Words{"--character", "person.glb"}}) {
      Words call{command, "out", "--out", command};
      call.insert(call.end(), more.begin(), more.end());
      const ProgramRun done = run(call);
      EXPECT_EQ(done.exit_code, 0) << done.err;
      EXPECT_THAT(done.err, testing::Not(HasSubstr("--character"))) << command;
      const StoredRun stored(work_, command);
      EXPECT_EQ(formats_of(stored), formats_of(reached)) << command;
      EXPECT_EQ(stored.summary().at("character_file"), "../person.glb");
      expect_promises_kept(stored);
      expect_glb_meets_goal(stored);
    }
  }
  // the same parameters give the same motion
  EXPECT_EQ(work_.get("edit/candidate-1.glb"), work_.get("out/candidate-1.glb"));
  // an edit of an edit finds the file too
  ASSERT_EQ(run({"mirror", "edit"}).exit_code, 0);
  EXPECT_EQ(StoredRun(work_, "edit/mirror-1").summary().at("character_file"), "../../person.glb");
  EXPECT_EQ(formats_of(StoredRun(work_, "edit/mirror-1")), formats_of(reached));
}

TEST_F(CharacterFiles, FewerFormatsStayFewer) {
  ASSERT_EQ(reach({"--formats", "glb,csv", "--fps", "24"}).exit_code, 0);
  ASSERT_EQ(run({"edit", "out", "--out", "a"}).exit_code, 0);
  const StoredRun edited(work_, "a");
  EXPECT_EQ(formats_of(edited), (std::set<std::string>{"glb", "csv"}));
  EXPECT_EQ(edited.candidate(1).at("fps"), 24.0);
  ASSERT_EQ(run({"edit", "out", "--out", "b", "--fps", "30"}).exit_code, 0);
  EXPECT_EQ(StoredRun(work_, "b").candidate(1).at("fps"), 30.0);
}

TEST_F(CharacterFiles, ABvhLeavesOnItsOwnNodesByTheOtherHandToo) {
  std::string text = person_bvh();
  for (const auto& [from, to] :
       {std::pair{"right_hand\n", "Bip01 R Hand\n"},
        {"Zrotation Xrotation Yrotation", "Yrotation Xrotation Zrotation"}}) {
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + 1)) {
      text.replace(at, std::string(from).size(), to);
    }
  }
  work_.put("person.bvh", text);
  ASSERT_EQ(reach({"--frame", "2", "--formats", "bvh"}, "person.bvh").exit_code, 0);
  const ProgramRun done = run({"mirror", "out", "--candidate", "1", "--out", "m"});
  EXPECT_THAT(done.exit_code, delivered()) << done.err;
  const StoredRun stored(work_, "m");
  expect_promises_kept(stored);
  EXPECT_EQ(stored.candidate(1).at("reached").at(0).at("effector"), "left_hand");
  EXPECT_EQ(to_vec(stored.candidate(1).at("reached").at(0).at("goal_m")).x, 0.2);
  const std::string bvh = stored.get("candidate-1.bvh");
  EXPECT_THAT(bvh, HasSubstr("JOINT Bip01_R_Hand\n"));
  EXPECT_THAT(bvh, HasSubstr("CHANNELS 3 Yrotation Xrotation Zrotation"));
}

TEST_F(CharacterFiles, WithoutTheFileAnEditSaysWhatToGive) {
  ASSERT_EQ(reach({}).exit_code, 0);
  std::filesystem::create_directory(work_ / "moved");
  std::filesystem::rename(work_ / "person.glb", work_ / "moved/person.glb");
  const ProgramRun without = run({"edit", "out", "--set", "right_knee.weight=3", "--out", "a"});
  EXPECT_THAT(without.exit_code, delivered()) << without.err;
  EXPECT_THAT(without.err, AllOf(HasSubstr("person.glb: note: "), HasSubstr("--character FILE"),
                                 HasSubstr("No such file")));
  EXPECT_EQ(formats_of(StoredRun(work_, "a")), (std::set<std::string>{"bvh", "csv", "svg"}));
  expect_promises_kept(StoredRun(work_, "a"));
  const ProgramRun refused = run({"edit", "out", "--formats", "glb", "--out", "b"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("needs the character's file, person.glb: give it by "
                                     "--character FILE"));
  EXPECT_FALSE(std::filesystem::exists(work_ / "b"));
  const ProgramRun with = run({"mirror", "out", "--character", "moved/person.glb", "--out", "c"});
  EXPECT_EQ(with.exit_code, 0) << with.err;
  EXPECT_EQ(StoredRun(work_, "c").candidate(1).at("files").size(), 4u);
  EXPECT_EQ(StoredRun(work_, "c").summary().at("character_file"), "../moved/person.glb");
  // another person's file in its place is not taken
  nlohmann::json other = person_gltf();
  other["nodes"][0]["scale"] = {1.1, 1.0, 1.0};
  work_.put("person.glb", glb(other.dump(), "data"));
  const ProgramRun another = run({"edit", "out", "--out", "d"});
  EXPECT_EQ(another.exit_code, 0);
  EXPECT_THAT(another.err, HasSubstr("is not the person of the result"));
  EXPECT_EQ(StoredRun(work_, "d").candidate(1).at("files").size(), 3u);
}

// The next motion begins in the final posture of the last one.
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

TEST_F(CharacterFiles, AFileThatRefersToOthersLeavesAsTheRest) {
  nlohmann::json file = person_gltf();
  file["images"] = {{{"uri", "skin.png"}}};
  work_.put("person.gltf", file.dump());
  const ProgramRun usual = reach({}, "person.gltf");
  EXPECT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_THAT(usual.err, HasSubstr("cannot be written as GLB: images[0] lies in another file"));
  EXPECT_EQ(StoredRun(work_, "out").candidate(1).at("files").size(), 3u);
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
