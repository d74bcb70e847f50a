// SPDX-License-Identifier: MIT
// Whatever is wrong with a call or a file: exit code 2, a message that names the place, the value
// and what is allowed, and no file changed.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "support/gltf_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

const char* const kGoal = "right_hand=-0.2,1.1,0.4";

struct Case {
  const char* name;
  Words call;
  Words told;  // what the message must contain
};

// Gives each case's test the case's name.
constexpr auto name_of = [](const auto& info) { return std::string(info.param.name); };

// Cuts the person's file to pieces that are none.
std::string without_lengths(std::string bvh) {
  for (std::size_t at = bvh.find("OFFSET"); at != bvh.npos; at = bvh.find("OFFSET", at + 1)) {
    bvh.replace(at, bvh.find('\n', at) - at, "OFFSET 0 0 0");
  }
  return bvh;
}

class FolderOfBadInput : public testing::Test {
 protected:
  FolderOfBadInput() {
    const std::string person = person_bvh();
    const std::string binary(
        "\x7f"
        "ELF\0\xff\xfe\x01\x02\0\0\0",
        12);
    folder_.put("person.bvh", person);
    folder_.put("one_joint.bvh", one_joint_bvh());
    folder_.put("no_lengths.bvh", without_lengths(person));
    folder_.put("million.bvh", one_joint_bvh("Frames: 1000000\nFrame Time: 0.1\n0 0 0\n"));
    folder_.put("infinite.bvh", one_joint_bvh("Frames: 1\nFrame Time: 0.1\n0 inf 0\n"));
    folder_.put("short.bvh", one_joint_bvh("Frames: 9\nFrame Time: 0.1\n0 0 0\n"));
    folder_.put("truncated.bvh", person.substr(0, person.size() / 3));
    folder_.put("truncated.glb", glb(person_gltf().dump()).substr(0, 100));
    SHG_CHECK(mkfifo((folder_ / "pipe.bvh").c_str(), 0600) == 0, "a pipe");
    folder_.put("truncated.json", R"({"version": 1, "goals": [{"effec)");
    folder_.put("folder/kept.txt", "kept");
    folder_.put("taken", "a file where a folder is wanted");
    for (const std::string ending : {"bvh", "glb", "json"}) {
      folder_.put("empty." + ending, "");
      folder_.put("binary." + ending, binary);
      folder_.put("huge." + ending, "");
      std::filesystem::resize_file(folder_ / ("huge." + ending), 200'000'000);
    }
    make_result();
  }

  void make_result() {
    const ProgramRun run = run_shigusa(
        {"reach", "--goal", kGoal, "--candidates", "2", "--formats", "bvh", "--out", "result"},
        {.folder = folder_.path()});
    SHG_CHECK(run.exit_code == 0, run.err);
    folder_.put("cut/summary.json", folder_.get("result/summary.json").substr(0, 900));
  }

  // Runs the call and expects it to be refused in these words.
  void expect_refused(const Words& call, const Words& told) {
    const auto before = folder_.contents();
    const ProgramRun run = run_shigusa(call, {.folder = folder_.path()});
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, testing::StartsWith("shigusa"));
    EXPECT_THAT(run.err, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("internal fault"))));
    for (const std::string& word : told) EXPECT_THAT(run.err, HasSubstr(word));
    EXPECT_EQ(folder_.contents(), before);
  }

  WorkFolder folder_;
};

class BadInput : public FolderOfBadInput, public testing::WithParamInterface<Case> {};

TEST_P(BadInput, IsRefusedAndChangesNothing) { expect_refused(GetParam().call, GetParam().told); }

INSTANTIATE_TEST_SUITE_P(
    Calls, BadInput,
    testing::Values(
        Case{"NoCommand", {}, {"give a command", "reach, edit, mirror, show, render, body, score"}},
        Case{"UnknownCommand", {"reech"}, {"'reech'", "did you mean 'reach'?"}},
        Case{"UnknownOption", {"reach", "--gaol", "x"}, {"'--gaol'", "did you mean '--goal'?"}},
        Case{"TooManyFiles", {"reach", "a.json", "b.json"}, {"'b.json' is one argument too many"}},
        Case{"NoResult", {"edit"}, {"shigusa edit", "result is required"}},
        Case{"NoClip", {"render"}, {"clip is required"}},
        Case{"NoSource", {"body"}, {"source is required"}},
        Case{"NoValue", {"reach", "--goal"}, {"--goal"}},
        Case{"NegativeSeed",
             {"reach", "--goal", kGoal, "--seed", "-1"},
             {"--seed", "'-1'", "0 to 18446744073709551615"}},
        Case{"NegativeFrame", {"body", "person.bvh", "--frame", "-1"}, {"--frame", "'-1'"}},
        Case{"NegativeCandidates",
             {"reach", "--goal", kGoal, "--candidates", "-1"},
             {"--candidates", "'-1'", "1 to 1000"}},
        Case{"TooFewEvaluations",
             {"reach", "--goal", kGoal, "--evaluations", "7"},
             {"--evaluations", "'7'", "from 8"}},
        Case{"RateOfNothing", {"reach", "--goal", kGoal, "--fps", "0"}, {"--fps", "0"}},
        Case{"RateTooHigh", {"reach", "--goal", kGoal, "--fps", "241"}, {"--fps", "241", "240"}},
        Case{"RateOfText", {"edit", "result", "--fps", "film"}, {"--fps", "film"}},
        Case{"TextForANumber", {"reach", "--stature", "tall"}, {"--stature", "tall"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Goals, BadInput,
    testing::Values(
        Case{"None", {"reach"}, {"no goal"}},
        Case{"Nan",
             {"reach", "--goal", "right_hand=nan,0,0"},
             {"x coordinate is nan", "-100 to 100"}},
        Case{"Infinite", {"reach", "--goal", "right_hand=0,-inf,0"}, {"y coordinate is -inf"}},
        Case{
            "FarTooLarge", {"reach", "--goal", "right_hand=0,0,1e308"}, {"z coordinate is 1e+308"}},
        Case{"LargerThanADouble",
             {"reach", "--goal", "right_hand=1e999,0,0"},
             {"x coordinate is inf"}},
        Case{"TwoNumbers",
             {"reach", "--goal", "right_hand=0,0"},
             {"'right_hand=0,0'", "EFFECTOR=X,Y,Z"}},
        Case{"FourNumbers", {"reach", "--goal", "right_hand=0,0,0,0"}, {"EFFECTOR=X,Y,Z"}},
        Case{"NoEqualsSign", {"reach", "--goal", "right_hand"}, {"EFFECTOR=X,Y,Z"}},
        Case{"NoName", {"reach", "--goal", "=0,0,0"}, {"EFFECTOR=X,Y,Z"}},
        Case{"UnknownEffector",
             {"reach", "--goal", "right_hnad=0,1,0"},
             {"'right_hnad'", "did you mean 'right_hand'?"}},
        Case{"EffectorOfAnotherBody",
             {"reach", "--character", "half_body", "--goal", "left_hand=0,1,0"},
             {"'left_hand'", "Known: right_hand"}},
        Case{"TwoForOneHand",
             {"reach", "--goal", kGoal, "--goal", kGoal},
             {"two goals for right_hand"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Settings, BadInput,
    testing::Values(
        Case{"Preset", {"reach", "--preset", "papr"}, {"'papr'", "did you mean 'paper'?"}},
        Case{"Search", {"reach", "--search", "cmaes"}, {"'cmaes'", "cma_es"}},
        Case{"Criteria",
             {"reach", "--criteria", "defualt"},
             {"'defualt'", "did you mean 'default'?"}},
        Case{"Format", {"reach", "--formats", "bvh,gltf"}, {"'gltf'", "bvh, csv, svg, png, pdf"}},
        Case{"FormatAfterLastComma", {"reach", "--formats", "bvh,"}, {"unknown format ''"}},
        Case{"Stature", {"reach", "--goal", kGoal, "--stature", "17"}, {"17 m", "0.5 to 2.5 m"}},
        Case{"Mass", {"reach", "--goal", kGoal, "--mass", "nan"}, {"nan kg", "2 to 300 kg"}},
        Case{"Duration", {"reach", "--goal", kGoal, "--duration", "0"}, {"0 s", "0.05 to 60 s"}},
        Case{"Sex", {"reach", "--goal", kGoal, "--sex", "x"}, {"--sex", "male"}},
        Case{"UnknownFixedParameter",
             {"reach", "--goal", kGoal, "--fix", "sqat_deg=60"},
             {"fixed parameter sqat_deg=60", "squat_deg"}},
        Case{"FixedParameterOutOfRange",
             {"reach", "--goal", kGoal, "--fix", "right_elbow.weight=0"},
             {"right_elbow.weight=0", "allowed are numbers from 0.001 to 1000"}},
        Case{"FrameOfABuiltInBody",
             {"reach", "--goal", kGoal, "--frame", "1"},
             {"--frame", "human"}},
        Case{"ExtentOfABuiltInBody",
             {"body", "full_body", "--extent", "half"},
             {"--extent", "full_body"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    OutputFolder, BadInput,
    testing::Values(
        Case{"IsAFile", {"reach", "--goal", kGoal, "--out", "taken"}, {"taken", "Not a directory"}},
        Case{"BelowAFile", {"reach", "--goal", kGoal, "--out", "taken/a/b"}, {"taken/a/b"}},
        Case{"CannotBeMade",
             {"reach", "--goal", kGoal, "--out", "/proc/shigusa"},
             {"/proc/shigusa"}},
        Case{"WithoutAName", {"reach", "--goal", kGoal, "--out", ""}, {"empty name"}},
        Case{"OfAnEditIsAFile", {"edit", "result", "--out", "taken"}, {"taken", "Not a directory"}},
        Case{"OfAnEditIsTheResults",
             {"edit", "result", "--out", "./result"},
             {"never writes over"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    TaskFiles, BadInput,
    testing::Values(
        Case{"Missing", {"reach", "missing.json"}, {"missing.json", "No such file"}},
        Case{"Empty", {"reach", "empty.json"}, {"empty.json", "empty"}},
        Case{"Binary", {"reach", "binary.json"}, {"binary.json", "not JSON", "line 1, column 1"}},
        Case{"Truncated", {"reach", "truncated.json"}, {"truncated.json", "not JSON", "line 1"}},
        Case{"Huge", {"reach", "huge.json"}, {"huge.json", "1048576 bytes"}},
        Case{"Folder", {"reach", "folder"}, {"folder", "Is a directory"}},
        Case{"EndlessDevice", {"reach", "/dev/zero"}, {"/dev/zero", "1048576 bytes"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Characters, BadInput,
    testing::Values(
        Case{
            "Unknown", {"body", "half_bodi"}, {"'half_bodi'", "did you mean 'half_body'?", ".bvh"}},
        Case{"OtherFormat",
             {"body", "hero.obj"},
             {"'hero.obj'", ".bvh, .glb, .gltf, .vrm, .fbx, .urdf, .xml or .mjcf"}},
        Case{"MissingVrm", {"body", "hero.vrm"}, {"hero.vrm", "No such file"}},
        Case{"EmptyGlb", {"body", "empty.glb"}, {"empty.glb", "empty"}},
        Case{"BinaryGlb", {"body", "binary.glb"}, {"binary.glb", "not glTF"}},
        Case{"HugeGlb", {"body", "huge.glb"}, {"huge.glb", "134217728 bytes"}},
        Case{"Missing",
             {"reach", "--goal", kGoal, "--character", "gone.bvh"},
             {"gone.bvh", "No such file"}},
        Case{"Empty",
             {"reach", "--goal", kGoal, "--character", "empty.bvh"},
             {"empty.bvh", "HIERARCHY"}},
        Case{"Binary", {"body", "binary.bvh"}, {"line 1 of binary.bvh", "HIERARCHY"}},
        Case{"Truncated", {"body", "truncated.bvh"}, {"truncated.bvh", "line "}},
        Case{"Huge", {"body", "huge.bvh"}, {"huge.bvh", "67108864 bytes"}},
        Case{"WithoutLegs", {"body", "one_joint.bvh"}, {"one_joint.bvh"}},
        Case{"WithoutLengths", {"body", "no_lengths.bvh"}, {"no_lengths.bvh"}},
        Case{"MillionFrames", {"body", "million.bvh"}, {"million.bvh", "1000000", "200000"}},
        Case{"Infinite", {"body", "infinite.bvh"}, {"infinite.bvh", "inf"}},
        Case{"TruncatedGlb",
             {"body", "truncated.glb", "--frame", "1"},
             {"truncated.glb: its header"}},
        Case{"PipeForACharacter", {"body", "pipe.bvh"}, {"pipe.bvh: is a pipe"}},
        Case{"NoSuchFrame", {"body", "person.bvh", "--frame", "3"}, {"frame 3", "0 to 2"}},
        Case{"StatureOutOfRange", {"body", "person.bvh", "--stature", "9"}, {"9 m", "0.5 to 2.5"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Edits, BadInput,
    testing::Values(
        Case{"Missing", {"edit", "gone"}, {"gone", "No such file"}},
        Case{"FolderWithoutAResult", {"edit", "folder"}, {"folder/summary.json", "No such file"}},
        Case{"Empty", {"edit", "empty.json"}, {"empty.json", "empty"}},
        Case{"Binary", {"edit", "binary.json"}, {"binary.json", "not JSON"}},
        Case{"Truncated", {"edit", "cut"}, {"summary.json", "not JSON", "line "}},
        Case{"Huge", {"edit", "huge.json"}, {"huge.json", "67108864 bytes"}},
        Case{"CandidateBeyondTheLast", {"edit", "result", "--candidate", "99"}, {"99", "1 to 2"}},
        Case{"CandidateZero", {"edit", "result", "--candidate", "0"}, {"candidate 0", "1 to 2"}},
        Case{"NegativeCandidate", {"edit", "result", "--candidate", "-1"}, {"-1", "1 to 2"}},
        Case{"UnknownJoint",
             {"edit", "result", "--set", "right_sholder.flexion.weight=2"},
             {"'right_sholder.flexion'", "did you mean 'right_shoulder.flexion'?"}},
        Case{"UnknownParameter",
             {"edit", "result", "--set", "right_knee.flexion.wait=2"},
             {"'wait'", "did you mean 'weight'?"}},
        Case{"WeightOfText",
             {"edit", "result", "--set", "right_knee.flexion.weight=much"},
             {"right_knee.flexion.weight=much", "'much'", "0.001 to 1000"}},
        Case{"WeightOfZero", {"edit", "result", "--set", "right_knee.weight=0"}, {"'0'", "0.001"}},
        Case{"LockedPerhaps",
             {"edit", "result", "--set", "right_knee.locked=perhaps"},
             {"'perhaps'", "true and false"}},
        Case{"NoEqualsSign",
             {"edit", "result", "--set", "right_knee.weight"},
             {"NAME.weight=NUMBER"}},
        Case{"Formats", {"edit", "result", "--formats", "bhv"}, {"'bhv'", "did you mean 'bvh'?"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Renders, BadInput,
    testing::Values(
        Case{"Missing", {"render", "gone.bvh"}, {"gone.bvh", "No such file"}},
        Case{"Empty", {"render", "empty.bvh"}, {"empty.bvh", "HIERARCHY"}},
        Case{"Binary", {"render", "binary.bvh"}, {"line 1 of binary.bvh"}},
        Case{"Truncated", {"render", "truncated.bvh"}, {"truncated.bvh", "line "}},
        Case{"Huge", {"render", "huge.bvh"}, {"huge.bvh", "67108864 bytes"}},
        Case{"MillionFrames", {"render", "million.bvh"}, {"million.bvh", "1000000"}},
        Case{"FewerFramesThanTold", {"render", "short.bvh"}, {"short.bvh", "9"}},
        Case{"FormatOfThePicture",
             {"render", "person.bvh", "--out", "p.gif"},
             {"p.gif", ".svg, .png or .pdf"}},
        Case{"PictureInNoFolder", {"render", "person.bvh", "--out", "none/p.png"}, {"none/p.png"}},
        Case{
            "PictureBelowAFile", {"render", "person.bvh", "--out", "taken/p.png"}, {"taken/p.png"}},
        Case{"FramesBeyondTheLast",
             {"render", "person.bvh", "--frames", "0:3"},
             {"person.bvh", "0 to 3", "0 to 2"}},
        Case{"FramesBackwards", {"render", "person.bvh", "--frames", "2:1"}, {"2 to 1"}},
        Case{"FramesOfText", {"render", "person.bvh", "--frames", "a:b"}, {"'a:b'", "FIRST:LAST"}},
        Case{"NegativeFrames",
             {"render", "person.bvh", "--frames", "-1:2"},
             {"'-1:2'", "FIRST:LAST"}},
        Case{"NoPoses", {"render", "person.bvh", "--poses", "0"}, {"0", "1 to 60"}},
        Case{"StatureOfADwarf",
             {"render", "person.bvh", "--stature", "0.1"},
             {"0.1 m", "0.5 to 2.5 m"}}),
    name_of);

// The text of task.json and what is told of it.
struct TaskText {
  const char* name;
  std::string text;
  Words told;
};

std::string nested(int depth) {
  const auto count = static_cast<std::size_t>(depth);
  return std::string(count, '[') + std::string(count, ']');
}

std::string with_goal(const std::string& more) {
  return R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.4]}], )" + more + "}";
}

std::string with_position(const std::string& position) {
  return R"({"goals": [{"effector": "right_hand", "position_m": )" + position + "}]}";
}

std::string many_members() {
  std::string text = R"({"k0": 0)";
  for (int i = 1; i < 70'000; ++i) text += ", \"k" + std::to_string(i) + "\": 0";
  return text + "}";
}

const std::vector<TaskText>& bad_tasks() {
  static const std::vector<TaskText> tasks{
      {"NotAnObject", "[]", {"task.json: must be an object"}},
      {"NoGoals", "{}", {"task.json", "no goal"}},
      {"OtherVersion", R"({"version": 2})", {"version", "is 2", "allowed is 1"}},
      {"UnknownKey", R"({"gaols": []})", {"'gaols'", "did you mean 'goals'?"}},
      {"UnknownBeforeMissing",
       R"({"goals": [{"effector": "right_hand", "position": [0, 1, 0.4]}]})",
       {"goals[0]: unknown key 'position'", "did you mean 'position_m'?"}},
      {"UnknownKeyInside",
       with_goal(R"("criteria": {"balnce": {}})"),
       {"criteria", "did you mean 'balance'?"}},
      {"KeyTwice", with_goal(R"("goals": [])"), {"'goals'", "twice"}},
      {"GoalsAreNoList", R"({"goals": {}})", {"task.json: goals", "list"}},
      {"GoalIsNoObject", R"({"goals": [7]})", {"goals[0]", "object"}},
      {"NoEffector", R"({"goals": [{"position_m": [0, 1, 0]}]})", {"goals[0].effector", "missing"}},
      {"UnknownEffector",
       R"({"goals": [{"effector": "left_hnd", "position_m": [0, 1, 0]}], "character": "full_body"})",
       {"task.json", "'left_hnd'", "did you mean 'left_hand'?"}},
      {"NoPosition",
       R"({"goals": [{"effector": "right_hand"}]})",
       {"goals[0].position_m", "missing"}},
      {"TwoCoordinates",
       with_position("[0, 1]"),
       {"goals[0].position_m", "[0,1]", "three numbers"}},
      {"TextCoordinate", with_position(R"([0, "1", 0])"), {"goals[0].position_m", "three numbers"}},
      {"CoordinateTooLarge", with_position("[0, 1e308, 0]"), {"1e+308", "-100 to 100"}},
      {"CoordinateInfinite", with_position("[0, 1e999, 0]"), {"task.json", "1e999"}},
      {"CoordinateNan", with_position("[0, NaN, 0]"), {"task.json", "line 1"}},
      {"GoalTwice",
       R"({"goals": [{"effector": "right_hand", "position_m": [0, 1, 0]}, {"effector": "right_hand", "position_m": [0, 1, 0]}]})",
       {"goals[1].effector", "'right_hand'", "one for each"}},
      {"NegativeSeed", with_goal(R"("seed": -1)"), {"seed", "-1", "from 0"}},
      {"SeedWithFraction", with_goal(R"("seed": 1.5)"), {"seed", "1.5", "whole"}},
      {"NoCandidates", with_goal(R"("candidates": 0)"), {"candidates", "is 0", "1 to 1000"}},
      {"TooFewEvaluations", with_goal(R"("evaluations": 1)"), {"evaluations", "is 1", "from 8"}},
      {"DurationAsText",
       with_goal(R"("duration_s": "long")"),
       {"duration_s", "long", "0.05 to 60"}},
      {"EmptyPreset", with_goal(R"("preset": "")"), {"preset", "Known: paper"}},
      {"UnknownCharacter",
       with_goal(R"("character": "ful_body")"),
       {"task.json: character", "'full_body'?"}},
      {"CharacterFileMissing",
       with_goal(R"("character": "gone.bvh")"),
       {"gone.bvh", "No such file"}},
      {"CharacterWithoutLegs",
       with_goal(R"("character": {"source": "one_joint.bvh"})"),
       {"one_joint.bvh"}},
      {"MassOutOfRange",
       with_goal(R"("character": {"source": "half_body", "mass_kg": 1e4})"),
       {"character.mass_kg", "10000", "2 to 300"}},
      {"FrameOfABuiltInBody",
       with_goal(R"("character": {"source": "half_body", "frame": 2})"),
       {"character.frame", "built in"}},
      {"LandmarksOfABuiltInBody",
       with_goal(R"("character": {"source": "half_body", "landmarks_m": {}})"),
       {"character.landmarks_m"}},
      {"AllWeightsZero",
       with_goal(
           R"("preset": "paper", "criteria": {"joint_range": {"weight": 0}, "balance": {"weight": 0}, "torque": {"weight": 0}})"),
       {"task.json: criteria", "all weights are 0"}},
      {"FixedIsNoList",
       with_goal(R"("fixed": "squat_deg=60")"),
       {"fixed", "must be a list of texts"}},
      {"FixedIsNoAssignment",
       with_goal(R"("fixed": ["squat_deg"])"),
       {"fixed parameter squat_deg"}},
      {"UnknownMixture",
       with_goal(R"("criteria": "papre")"),
       {"task.json: criteria", "did you mean 'paper'?"}},
      {"CriteriaThatAreNoObject",
       with_goal(R"("criteria": [0.5, 0.3, 0.2])"),
       {"task.json: criteria", "must be an object"}},
      {"NegativeMargin",
       with_goal(R"("criteria": {"balance_zone": {"margin_m": -0.03}})"),
       {"criteria.balance_zone.margin_m", "-0.03"}},
      {"NegativeWeight",
       with_goal(R"("criteria": {"torque": {"weight": -1}})"),
       {"criteria.torque.weight", "-1"}},
      {"DeepNesting", nested(100'000), {"task.json", "deeper than 32"}},
      {"DeepNestingUnclosed", std::string(100'000, '['), {"task.json", "deeper than 32"}},
      {"ManyMembers", many_members(), {"task.json", "256 members"}},
  };
  return tasks;
}

class BadTask : public FolderOfBadInput, public testing::WithParamInterface<TaskText> {};

TEST_P(BadTask, IsRefusedAndChangesNothing) {
  folder_.put("task.json", GetParam().text);
  expect_refused({"reach", "task.json"}, GetParam().told);
}

INSTANTIATE_TEST_SUITE_P(Texts, BadTask, testing::ValuesIn(bad_tasks()), name_of);

}  // namespace
}  // namespace shigusa
