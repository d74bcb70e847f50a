// SPDX-License-Identifier: MIT
// For any wrong call or file: exit code 2, a message with the place, the value and the values
// allowed or a suggestion, and no file changed.
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

struct Mistake {
  Words call;
  Words told;  // required words of the message
};
using Mistakes = std::vector<Mistake>;

Words joined(Words begin, const Words& more) {
  begin.insert(begin.end(), more.begin(), more.end());
  return begin;
}
// A call of reach with a valid goal.
Words reach(const Words& more) { return joined({"reach", "--goal", kGoal}, more); }
Words edit(const Words& more) { return joined({"edit", "result"}, more); }
Words render(const Words& more) { return joined({"render", "person.bvh"}, more); }
Words score(const Words& more) { return joined({"score", "person.bvh"}, more); }
Words body(const Words& more) { return joined({"body", "person.bvh"}, more); }
// A call that makes a data set of twelve tasks in four shards.
Words dataset(const Words& more) { return joined({"dataset", "data.json", "--out", "d"}, more); }

// Splits the person's file into invalid pieces.
std::string without_lengths(std::string bvh) {
  for (std::size_t at = bvh.find("OFFSET"); at != bvh.npos; at = bvh.find("OFFSET", at + 1)) {
    bvh.replace(at, bvh.find('\n', at) - at, "OFFSET 0 0 0");
  }
  return bvh;
}

std::string with_goal(const std::string& more) {
  return R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.4]}])" + more + "}";
}

class Mistaken : public testing::Test {
 protected:
  Mistaken() {
    put_persons();
    put_broken_files();
    put_results();
    folder_.put("task.json", with_goal(""));
    folder_.put("data.json",
                R"({"version": 1, "seed": 3, "tasks": 12, "shard_tasks": 3, "task": )" +
                    with_goal(R"(, "character": "half_body")") + "}");
    folder_.put("folder/kept.txt", "kept");
    folder_.put("taken", "a file where a folder is wanted");
  }

  void put_persons() {
    const std::string person = person_bvh();
    folder_.put("person.bvh", person);
    folder_.put("alone/person.bvh", person);
    folder_.put("hero.glb", glb(person_gltf().dump()));
    folder_.put("still.gltf", person_gltf().dump());
    folder_.put("one_joint.bvh", one_joint_bvh());
    folder_.put("no_lengths.bvh", without_lengths(person));
    folder_.put("million.bvh", one_joint_bvh("Frames: 1000000\nFrame Time: 0.1\n0 0 0\n"));
    folder_.put("infinite.bvh", one_joint_bvh("Frames: 1\nFrame Time: 0.1\n0 inf 0\n"));
    folder_.put("short.bvh", one_joint_bvh("Frames: 9\nFrame Time: 0.1\n0 0 0\n"));
    folder_.put("truncated.bvh", person.substr(0, person.size() / 3));
    folder_.put("truncated.glb", glb(person_gltf().dump()).substr(0, 100));
    SHG_CHECK(mkfifo((folder_ / "pipe.bvh").c_str(), 0600) == 0, "a pipe");
  }

  void put_broken_files() {
    const std::string binary(
        "\x7f"
        "ELF\0\xff\xfe\x01\x02\0\0\0",
        12);
    for (const std::string ending : {"bvh", "glb", "json", "urdf"}) {
      folder_.put("empty." + ending, "");
      folder_.put("binary." + ending, binary);
      folder_.put("huge." + ending, "");
      std::filesystem::resize_file(folder_ / ("huge." + ending), 200'000'000);
    }
    folder_.put("truncated.json", R"({"version": 1, "goals": [{"effec)");
    folder_.put("map.json", R"({"head": "neck", "neck": "chest"})");
    folder_.put("map.txt", "nothing of the kind");
  }

  void put_results() {
    const ProgramRun run =
        run_shigusa({"reach", "--goal", kGoal, "--character", "half_body", "--preset", "paper",
                     "--candidates", "2", "--formats", "bvh", "--out", "result"},
                    {.folder = folder_.path()});
    SHG_CHECK(run.exit_code == 0 || run.exit_code == 3, run.err);
    std::string summary = folder_.get("result/summary.json");
    folder_.put("cut/summary.json", summary.substr(0, 900));
    const std::string version = "\"version\": 1";
    summary.replace(summary.find(version), version.size(), "\"version\": 99");
    folder_.put("old/summary.json", summary);
    folder_.put("broken/summary.json", "{}");
  }

  void expect_told(const Mistakes& mistakes) {
    const auto before = folder_.contents();
    for (const auto& [call, told] : mistakes) {
      SCOPED_TRACE(testing::PrintToString(call));
      const ProgramRun run = run_shigusa(call, {.folder = folder_.path()});
      EXPECT_EQ(run.exit_code, 2) << run.err;
      EXPECT_EQ(run.out, "");
      EXPECT_THAT(run.err, testing::StartsWith("shigusa"));
      EXPECT_THAT(run.err, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("internal fault"))));
      for (const std::string& word : told) EXPECT_THAT(run.err, HasSubstr(word));
    }
    EXPECT_EQ(folder_.contents(), before);
  }

  WorkFolder folder_;
};

TEST_F(Mistaken, CommandsAreTold) {
  expect_told({
      {{},
       {"give a command", "reach, edit, mirror, show, render, limit, map, body, score",
        "shigusa --help"}},
      {{"reech"}, {"'reech'", "did you mean 'reach'?"}},
      {{"out.bvh"}, {"'out.bvh' is no command", "a file comes after one", "render"}},
      {{"--goal", kGoal}, {"--goal comes after the command that has it: reach"}},
      {{"--frobnicate"}, {"unknown option '--frobnicate'", "Known: --help"}},
      {{"reach", "--gaol", kGoal}, {"'--gaol'", "did you mean '--goal'?"}},
      {{"reach", "a.json", "b.json"}, {"'b.json' is one argument too many"}},
      {{"schema", "plan"}, {"'plan' is one argument too many", "did you mean '--plan'?"}},
      {{"edit"}, {"shigusa edit", "result is required", "summary.json"}},
      {{"show"}, {"results"}},
      {{"render"}, {"clip is required", "BVH file"}},
      {{"body"}, {"source is required: A built-in body"}},
      {{"reach", "--goal"}, {"--goal needs a value, EFFECTOR=X,Y,Z", "metres"}},
      {{"reach", "--goal", "--out", "x"}, {"--goal", "needs a value", "--out follows it"}},
      {reach({"--json=maybe"}), {"--json takes no value"}},
      {reach({"--seed", "1", "--seed", "2"}), {"--seed is given 2 times", "once"}},
      {{"show", "result", "--title", "a", "--title", "b"}, {"--title"}},
      {{"manual", "reech"}, {"'reech'", "did you mean 'reach'?"}},
      {{"manual", "reach", "--as", "html"}, {"--as", "'html'", "text, man, markdown"}},
      {{"completion", "tcsh"}, {"'tcsh'", "Known: bash, zsh, fish"}},
      {{"studio", "--port", "http"}, {"--port", "'http'", "0 to 65535"}},
      {{"studio", "--folder", "folder"}, {"folder", "index.html", "scripts/build_studio"}},
  });
}

TEST_F(Mistaken, GoalsAreTold) {
  expect_told({
      {{"reach"}, {"no goal", std::string("--goal ") + kGoal}},
      {{"reach", kGoal}, {"No such file", std::string("--goal ") + kGoal}},
      {{"reach", "--goal", "right_hand"}, {"EFFECTOR=X,Y,Z", kGoal, "no '=' is in it"}},
      {{"reach", "--goal", "=0,0,0"}, {"EFFECTOR=X,Y,Z"}},
      {{"reach", "--goal", "right_hand=0.2,1.1"},
       {"'right_hand=0.2,1.1'", "EFFECTOR=X,Y,Z", "2 numbers are given"}},
      {{"reach", "--goal", "right_hand=0,0,0,0"}, {"EFFECTOR=X,Y,Z"}},
      {{"reach", "--goal", "right_hand=-0,2,1,1,0,4"}, {"decimals have a point"}},
      {{"reach", "--goal", "right_hand=-0.2;1.1;0.4"}, {"commas stand between numbers"}},
      {{"reach", "--goal", "right_hand=-0.2,x,0.4"}, {"'x' is no number"}},
      {{"reach", "--goal", "right_hand", "-0.2", "1.1", "0.4"}, {"with commas and no blanks"}},
      {{"reach", "--goal", "right_hand=-0.2,", "1.1,", "0.4"}, {"with commas and no blanks"}},
      {{"reach", "--goal", "right_hand=nan,0,0"}, {"x coordinate is nan", "-100 to 100"}},
      {{"reach", "--goal", "right_hand=0,-inf,0"}, {"y coordinate is -inf"}},
      {{"reach", "--goal", "right_hand=0,0,1e308"}, {"z coordinate is 1e+308"}},
      {{"reach", "--goal", "right_hand=1e999,0,0"}, {"x coordinate is inf"}},
      {{"reach", "--goal", "right_hand=550,1000,300"},
       {"if millimetres are meant, give 0.55,1,0.3", "-100 to 100 m"}},
      {{"reach", "--goal", "right_hand=-20,110,40"},
       {"if centimetres are meant, give -0.2,1.1,0.4"}},
      {{"reach", "--goal", "right_hnad=0,1,0.4"}, {"'right_hnad'", "did you mean 'right_hand'?"}},
      {{"reach", "--goal", "right_elbwo=0,1,0"}, {"'right_elbow'"}},
      {{"reach", "--character", "half_body", "--goal", "left_hand=0,1,0"},
       {"'left_hand'", "Known: right_hand"}},
      {reach({"--goal", kGoal}), {"two goals for right_hand"}},
      {{"reach", "--goal", "right_elbow=-0.3,1,0.2", "--goal", "right_lower_arm=-0.3,1,0.2"},
       {"two goals"}},
      {reach({"--goal", "left_hand=0,1,0", "--goal", "head=0,1,0", "--goal", "hips=0,1,0", "--goal",
              "chest=0,1,0", "--goal", "right_elbow=0,1,0", "--goal", "left_elbow=0,1,0"}),
       {"rows"}},
      {{"reach", "--goal", "left_foot=0.1,0.07,0.3", "--goal", "right_foot=-0.1,0.07,0.3"},
       {"cannot move"}},
      {{"reach", "--preset", "layers", "--goal", "left_foot=0.1,0.067,0.3"},
       {"flat takes other joints too"}},
  });
}

// Within the range of goals, and out of reach for anyone.
TEST_F(Mistaken, CentimetresAreTakenForWhatTheyAre) {
  const ProgramRun run = run_shigusa({"reach", "--goal", "right_hand=-20,90,40", "--character",
                                      "half_body", "--preset", "paper", "--formats", "bvh"},
                                     {.folder = folder_.path()});
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr("if centimetres are meant, give -0.2,0.9,0.4"));
}

TEST_F(Mistaken, FieldsOfGoalsAreTold) {
  expect_told({
      {reach({"--palm", "right_hand=sideways"}), {"--palm", "'sideways'", "up, down", "X,Y,Z"}},
      {reach({"--palm", "right_hand=dwon"}), {"'down'"}},
      {reach({"--palm", "up"}), {"--palm 'up'", "HAND=DIRECTION, such as right_hand=up"}},
      {reach({"--palm", "left_hand=up"}), {"left_hand has none", "--goal left_hand=X,Y,Z"}},
      {reach({"--palm", "right_hand=0,0,0"}), {"not 0"}},
      {reach({"--palm", "right_hand=down", "--thumb", "right_hand=up"}), {"one line"}},
      {{"reach", "--goal", "head=0,1.5,0.1", "--palm", "head=down"}, {"left_hand and right_hand"}},
      {reach({"--preset", "layers", "--palm", "right_hand=up"}), {"layers", "the preset flat"}},
      {reach({"--character", "full_body", "--preset", "human", "--palm", "right_hand=down"}),
       {"flat takes rotations"}},
      {reach({"--rotation", "right_hand=0,90,0"}), {"X,Y,Z,W", "3 numbers are given"}},
      {reach({"--rotation", "right_hand=0,0,0,0"}), {"unit quaternion"}},
      {reach({"--rotation", "right_hand=nan,0,0,1"}), {"unit quaternion"}},
      {reach({"--rotation", "left_hand=0,0,0,1"}), {"left_hand has none"}},
      {reach({"--load", "left_hand=5"}), {"left_hand has none", "--goal left_hand=X,Y,Z"}},
      {reach({"--load", "5"}), {"--load '5'", "EFFECTOR=KILOGRAMS", "right_hand=5"}},
      {reach({"--load", "right_hand=5kg"}), {"'5kg' is no number"}},
      {reach({"--load", "right_hand=900"}), {"900 kg", "0 to 500 kg"}},
      {reach({"--tolerance", "right_hand=0.1"}), {"X,Y,Z", "1 number is given"}},
      {reach({"--tolerance", "right_hand=0.1,-0.1,0"}), {"y tolerance is -0.1"}},
      {reach({"--tolerance", "right_hand=nan,0,0"}), {"x tolerance is nan"}},
  });
}

TEST_F(Mistaken, SurroundingsAreTold) {
  const Words step{"reach", "--goal", "left_foot=0.1,0.07,0.3"};
  const Words thigh{"--support", "left_hand=thigh"};
  Mistakes mistakes{
      {reach({"--look-at", "1,2"}), {"--look-at", "X,Y,Z", "2 numbers are given"}},
      {reach({"--look-at", "nan,0,0"}), {"look_at"}},
      {reach({"--contacts", "left_feet"}), {"'left_feet'", "did you mean 'left_foot'?"}},
      {reach({"--contacts", ""}), {"contact"}},
      {joined(step, {"--contacts", "left_foot,right_foot"}), {"is to stand and has a goal"}},
      {reach({"--obstacle", "table=0,0.7,0.5"}), {"NAME=X,Y,Z,SX,SY,SZ", "3 numbers are given"}},
      {reach({"--obstacle", "table=0,0.7,0.5,1,-0.05,0.6"}),
       {"obstacle table", "size along y is -0.05", "0 to 100 m"}},
      {reach({"--obstacle", "0,0.7,0.5,1,0.05,0.6"}), {"NAME=X,Y,Z,SX,SY,SZ", "no '='"}},
      {reach({"--support", "thigh"}), {"is not HAND=PLACE, such as left_hand=thigh"}},
      {reach({"--support", "left_hand=table"}), {"unknown place 'table'", "Known: thigh"}},
      {reach({"--support", "tail=thigh"}), {"unknown hand 'tail'"}},
      {reach({"--support", "right_hand=thigh"}), {"its arm has a goal"}},
      {reach(joined(thigh, thigh)), {"is a second one for this hand"}},
      {reach(joined(thigh, {"--preset", "human"})),
       {"the preset human cannot rest hands on supports"}},
      {reach(joined(thigh, {"--generator", "nlp_ik"})), {"cannot rest hands on supports"}},
      // the search alone finds out, when its folder is made
      {reach(
           {"--support", "left_hand=wall", "--obstacle", "wall=3,1,0,0.1,2,2", "--out", "folder"}),
       {"does not reach wall"}},
      {reach({"--seat", "45"}), {"--seat", "45 m", "0.1 to 1.2 m", "45 cm are 0.45"}},
      {reach({"--character", "half_body", "--seat", "0.4"}), {"seat"}},
  };
  for (const Words& nobody : {Words{"--character", "full_body"},
                              {"--character", "half_body"},
                              {"--seat", "0.45"},
                              {"--preset", "paper"},
                              {"--preset", "layers"},
                              {"--preset", "human"}}) {
    mistakes.push_back({reach(joined({"--heels"}, nobody)), {"heels"}});
  }
  expect_told(mistakes);
}

TEST_F(Mistaken, PeopleAndSettingsAreTold) {
  expect_told({
      {reach({"--stature", "155"}), {"--stature", "155 m", "0.5 to 2.5 m", "155 cm are 1.55"}},
      {reach({"--stature", "1,55"}), {"'1,55'", "decimals have a point: 1.55"}},
      {reach({"--stature", "p10"}), {"'p10'", "p5, p50 and p95"}},
      {{"reach", "--stature", "tall"}, {"--stature", "tall"}},
      {reach({"--mass", "0"}), {"0 kg", "2 to 300 kg"}},
      {reach({"--mass", "nan"}), {"nan kg", "2 to 300 kg"}},
      {reach({"--mass", "60,5"}), {"--mass", "decimals have a point: 60.5"}},
      {reach({"--sex", "woman"}), {"--sex", "'woman'", "male, female"}},
      {reach({"--preset", "papr"}), {"--preset", "'papr'", "did you mean 'paper'?"}},
      {reach({"--search", "cmaes"}), {"'cmaes'", "cma_es"}},
      {reach({"--criteria", "defualt"}), {"--criteria", "'defualt'", "did you mean 'default'?"}},
      {reach({"--formats", "bvh,gltf"}), {"--formats", "'gltf'", "bvh, csv, svg, png, pdf, glb"}},
      {reach({"--formats", "bvh,"}), {"unknown format ''"}},
      {reach({"--formats", "vrma"}), {"human is none", "--character"}},
      {reach({"--formats", "glb", "vrma"}),
       {"vrma: cannot open", "commas, as in --formats bvh,glb"}},
      {reach({"--simd", "mmx"}), {"--simd", "'mmx'", "scalar"}},
      {reach({"--duration", "0"}), {"0 s", "0.05 to 60 s"}},
      {reach({"--duration", "2s"}), {"--duration", "'2s'", "numbers, such as 1.5"}},
      {reach({"--seed", "-1"}), {"--seed", "'-1'", "0 to 18446744073709551615"}},
      {reach({"--candidates", "-1"}), {"--candidates", "'-1'", "1 to 1000"}},
      {reach({"--candidates", "many"}), {"--candidates", "'many'", "1 to 1000"}},
      {reach({"--evaluations", "7"}), {"--evaluations", "'7'", "from 8"}},
      {reach({"--seconds", "0"}), {"--seconds", "'0'", "0.001 to 1000000"}},
      {reach({"--fps", "0"}), {"--fps", "0"}},
      {reach({"--fps", "241"}), {"--fps", "'241'", "1 to 240"}},
      {edit({"--fps", "film"}), {"--fps", "film"}},
      {reach({"--fix", "sqat_deg=60"}),
       {"fixed parameter sqat_deg=60", "did you mean 'squat_deg'?"}},
      {reach({"--fix", "right_elbow.weight=0"}),
       {"right_elbow.weight=0", "allowed are numbers from 0.001 to 1000"}},
  });
}

TEST_F(Mistaken, CharactersAreTold) {
  expect_told({
      {{"body", "half_bodi"}, {"'half_bodi'", "did you mean 'half_body'?", ".bvh"}},
      {{"body", "hero.obj"}, {"'hero.obj'", ".bvh, .glb, .gltf, .vrm, .fbx, .urdf, .xml or .mjcf"}},
      {{"body", "gone.vrm"}, {"gone.vrm", "No such file", "this folder has no .vrm file"}},
      {reach({"--character", "folder/somebody_else.bvh"}), {"folder has no .bvh file"}},
      {reach({"--character", "alone/a_colleague_of_mine.bvh"}), {"alone has person.bvh"}},
      {reach({"--character", "persn.bvh"}),
       {"persn.bvh", "No such file", "did you mean 'person.bvh'?"}},
      {{"body", "empty.glb"}, {"empty.glb", "empty"}},
      {{"body", "binary.glb"}, {"binary.glb", "not glTF"}},
      {{"body", "truncated.glb", "--frame", "1"}, {"truncated.glb: its header"}},
      {{"body", "huge.glb"}, {"huge.glb", "134217728 bytes"}},
      {{"body", "huge.urdf"}, {"huge.urdf"}},
      {reach({"--character", "empty.bvh"}), {"empty.bvh", "HIERARCHY"}},
      {{"body", "binary.bvh"}, {"line 1 of binary.bvh", "HIERARCHY"}},
      {{"body", "truncated.bvh"}, {"truncated.bvh", "line "}},
      {{"body", "huge.bvh"}, {"huge.bvh", "67108864 bytes"}},
      {{"body", "one_joint.bvh"}, {"one_joint.bvh"}},
      {{"body", "no_lengths.bvh"}, {"no_lengths.bvh"}},
      {{"body", "million.bvh"}, {"million.bvh", "1000000", "200000"}},
      {{"body", "infinite.bvh"}, {"infinite.bvh", "inf"}},
      {{"body", "pipe.bvh"}, {"pipe.bvh: is a pipe"}},
      {body({"--frame", "-1"}), {"--frame", "'-1'"}},
      {body({"--frame", "3"}), {"frame 3", "0 to 2"}},
      {body({"--frame", "first"}), {"'first'", "or rest"}},
      {body({"--stature", "9"}), {"9 m", "0.5 to 2.5"}},
      {body({"--extent", "whole"}), {"--extent", "'whole'", "half, full, human"}},
      {{"body", "full_body", "--extent", "half"}, {"--extent", "full_body"}},
      {reach({"--frame", "3"}), {"--frame", "human is built in", "give a file"}},
      {reach({"--map", "right_hand=Bone"}), {"--map", "human is built in", "give a file"}},
      {body({"--map", "rigt_hand=hips"}), {"'rigt_hand'", "did you mean 'right_hand'?"}},
      {body({"--map", "right_hand=right_hnad"}),
       {"person.bvh has no 'right_hnad' for right_hand; did you mean 'right_hand'?"}},
      {body({"--map", "right_hand=Object_4711"}),
       {"has no 'Object_4711' for right_hand", "its nodes are "}},
      {{"body", "hero.glb", "--map", "neck=#999"}, {"has no '#999' for neck; its nodes are "}},
      {body({"--map", "map.json"}), {}},  // the neck's arms are above
      {body({"--map", "map.txt"}), {"map.txt: names no bones"}},
  });
}

TEST_F(Mistaken, FilesAreTold) {
  expect_told({
      {{"reach", "tsk.json"}, {"tsk.json", "No such file", "did you mean 'task.json'?"}},
      {{"reach", "empty.json"}, {"empty.json", "empty", "shigusa schema"}},
      {{"reach", "binary.json"}, {"binary.json", "not JSON", "line 1, column 1", "shigusa schema"}},
      {{"reach", "truncated.json"}, {"truncated.json", "not JSON", "line 1"}},
      {{"reach", "huge.json"}, {"huge.json", "1048576 bytes"}},
      {{"reach", "folder"}, {"folder", "Is a directory", "a task file (JSON)"}},
      {{"reach", "/dev/zero"}, {"/dev/zero", "1048576 bytes"}},
      {{"reach", "person.bvh"}, {"not JSON", "--character person.bvh"}},
      {reach({"--out", "taken"}), {"taken", "Not a directory", "give another by --out"}},
      {reach({"--out", "taken/a/b"}), {"taken/a/b"}},
      {reach({"--out", "/proc/x"}), {"/proc/x", "give another by --out"}},
      {reach({"--out", ""}), {"empty name"}},
      {edit({"--out", "taken"}), {"taken", "Not a directory"}},
      {edit({"--out", "./result"}), {"never writes over", "give another"}},
      {{"edit", "resul"}, {"resul", "No such file", "did you mean 'result'?"}},
      {{"edit", "folder"},
       {"folder/summary.json", "No such file", "a result is a folder that reach"}},
      {{"edit", "empty.json"}, {"empty.json", "empty"}},
      {{"edit", "binary.json"}, {"binary.json", "not JSON"}},
      {{"edit", "cut"}, {"summary.json", "not JSON", "line "}},
      {{"edit", "huge.json"}, {"huge.json", "67108864 bytes"}},
      {{"edit", "old"}, {"old/summary.json", "version is 99", "allowed is 1", "another version"}},
      {{"edit", "result/candidate-1.bvh"}, {"not JSON", "give the folder that it is in"}},
      {edit({"--candidate", "99"}), {"candidate 99", "the candidates 1 to 2"}},
      {edit({"--candidate", "0"}), {"candidate 0", "1 to 2"}},
      {edit({"--candidate", "-1"}), {"-1", "1 to 2"}},
      {edit({"--candidate", "best"}), {"--candidate", "'best'", "whole numbers"}},
      {edit({"--formats", "bhv"}), {"'bhv'", "did you mean 'bvh'?"}},
      {edit({"--set", "right_elbw.weight=3"}), {"did you mean 'right_elbow'?"}},
      {edit({"--set", "right_sholder.flexion.weight=2"}),
       {"'right_sholder.flexion'", "did you mean 'right_shoulder.flexion'?"}},
      {edit({"--set", "right_knee.flexion.wait=2"}), {"'wait'", "did you mean 'weight'?"}},
      {edit({"--set", "right_elbow.weight=3,5"}),
       {"--set", "'3,5'", "0.001 to 1000", "decimals have a point: 3.5"}},
      {edit({"--set", "right_knee.weight"}), {"NAME.weight=NUMBER"}},
      {{"show", "none"}, {"none", "No such file"}},
      {{"show", "folder"}, {"folder/summary.json", "a result is a folder"}},
      {{"show", "broken"}, {"not a result of shigusa"}},
      {{"show", "result", "--picture", "a.gif"}, {".svg, .png or .pdf"}},
  });
}

TEST_F(Mistaken, ClipsAreTold) {
  expect_told({
      {{"render", "gone.bvh"}, {"gone.bvh", "No such file"}},
      {{"render", "empty.bvh"}, {"empty.bvh", "HIERARCHY"}},
      {{"render", "binary.bvh"}, {"line 1 of binary.bvh"}},
      {{"render", "truncated.bvh"}, {"truncated.bvh", "line "}},
      {{"render", "huge.bvh"}, {"huge.bvh", "67108864 bytes"}},
      {{"render", "million.bvh"}, {"million.bvh", "1000000"}},
      {{"render", "short.bvh"}, {"short.bvh", "9"}},
      {{"render", "result"}, {"Is a directory", "such as candidate-1.bvh"}},
      {{"render", "hero.glb"}, {"hero.glb", "render draws BVH files alone"}},
      {render({"--out", "p.jpg"}), {"p.jpg", ".svg, .png or .pdf", "'.jpg'"}},
      {render({"--out", "none/p.svg"}), {"none/p.svg", "there is no folder none"}},
      {render({"--out", "taken/p.png"}), {"taken/p.png"}},
      {render({"--frames", "0-2"}), {"'0-2'", "FIRST:LAST", "0:120"}},
      {render({"--frames", "0:3"}), {"person.bvh", "0 to 3", "0 to 2"}},
      {render({"--frames", "2:1"}), {"2 to 1"}},
      {render({"--frames", "a:b"}), {"'a:b'", "FIRST:LAST"}},
      {render({"--frames", "-1:2"}), {"'-1:2'", "FIRST:LAST"}},
      {render({"--poses", "0"}), {"0", "1 to 60"}},
      {render({"--stature", "0.1"}), {"0.1 m", "0.5 to 2.5 m"}},
      {{"score", "taken"}, {"taken", "is no clip", ".bvh"}},
      {{"score", "none.bvh"}, {"none.bvh"}},
      {{"score", "still.gltf"}, {"holds no animation"}},
      {score({"--animation", "jump"}), {"one motion without a name"}},
      {score({"--frames", "2"}), {"is not FIRST:LAST"}},
      {score({"--frames", "1:9"}), {"the file has 0 to 2"}},
      {score({"--frames", "9:9"}), {"frame 9 does not exist"}},
      {score({"--criteria", "good"}), {"--criteria", "'good'", "paper, default"}},
      {score({"--smooth", "fast"}), {"--smooth", "'fast'", "numbers"}},
      {score({"--smooth", "-1"}), {"-1 Hz"}},
      {score({"--character", "robot.urdf"}), {"is a robot"}},
  });
}

TEST_F(Mistaken, DataSetsAreTold) {
  expect_told({
      {{"dataset"}, {"give a plan", "shigusa dataset PLAN.json --out FOLDER"}},
      {{"dataset", "mrge", "DIR"}, {"shigusa dataset", "'mrge'", "did you mean 'merge'?"}},
      {{"dataset", "mrge"}, {"command or plan 'mrge'", "did you mean 'merge'?"}},
      {{"dataset", "nothing.json", "--out", "d"}, {"nothing.json"}},
      {{"dataset", "task.json", "--out", "d"}, {"unknown key", "`shigusa reach` makes"}},
      {{"dataset", "data.json"}, {"--out"}},
      {dataset({"--shards", "3:2"}), {"--shards", "0:4"}},
      {dataset({"--shards", "0:9"}), {"4 shards"}},
      {dataset({"--shards", "x"}), {}},
      {dataset({"--task", "12"}), {"tasks 0 to 11"}},
      {dataset({"--simd", "mmx"}), {"mmx"}},
      {dataset({"--part", "3/3"}), {"K/N"}},
      {dataset({"--part", "1/2", "--shards", "0:1"}), {"--part", "--shards", "give one of both"}},
      {{"dataset", "merge"}, {"folder is required: Folder of the data set"}},
      {{"dataset", "merge", "folder"}, {"folder/plan.json", "a data set is a folder that"}},
      {{"dataset", "check", "gone"}, {"gone/plan.json", "there is no folder gone"}},
      {{"dataset", "export", "folder"}, {"--out FOLDER is required"}},
      {{"dataset", "export", "folder", "--out", "x", "--tasks", "5"},
       {"--tasks", "'5'", "FIRST:LAST, such as 0:100"}},
  });
}

std::string with_position(const std::string& position) {
  return R"({"goals": [{"effector": "right_hand", "position_m": )" + position + "}]}";
}

std::string many_members() {
  std::string text = R"({"k0": 0)";
  for (int i = 1; i < 70'000; ++i) text += ", \"k" + std::to_string(i) + "\": 0";
  return text + "}";
}

TEST_F(Mistaken, TextsOfTaskFilesAreTold) {
  const std::string twice = R"({"effector": "right_hand", "position_m": [0, 1, 0]})";
  const std::pair<std::string, Words> table[] = {
      {"[]", {"task.json: must be an object"}},
      {"{}", {"task.json", "no goal"}},
      {R"({"version": 3})", {"version", "is 3", "from 1 to 2"}},
      {R"({"gaols": []})", {"'gaols'", "did you mean 'goals'?"}},
      // before that a key is missing
      {R"({"goals": [{"effector": "right_hand", "position": [0, 1, 0.4]}]})",
       {"goals[0]: unknown key 'position'", "did you mean 'position_m'?"}},
      {with_goal(R"(, "criteria": {"balnce": {}})"), {"criteria", "did you mean 'balance'?"}},
      {with_goal(R"(, "goals": [])"), {"'goals'", "twice"}},
      {R"({"goals": {}})", {"task.json: goals", "list"}},
      {R"({"goals": [7]})", {"goals[0]", "object"}},
      {R"({"goals": [{"position_m": [0, 1, 0]}]})", {"goals[0].effector", "missing"}},
      {R"({"goals": [{"effector": "left_hnd", "position_m": [0, 1, 0]}], "character": "full_body"})",
       {"task.json", "'left_hnd'", "did you mean 'left_hand'?"}},
      {R"({"goals": [{"effector": "right_hand"}]})", {"goals[0].position_m", "missing"}},
      {with_position("[0, 1]"), {"goals[0].position_m", "[0,1]", "three numbers"}},
      {with_position(R"([0, "1", 0])"), {"goals[0].position_m", "three numbers"}},
      {with_position("[0, 1e308, 0]"), {"1e+308", "-100 to 100"}},
      {with_position("[0, 1e999, 0]"), {"task.json", "1e999"}},
      {with_position("[0, NaN, 0]"), {"task.json", "line 1"}},
      {"{\"goals\": [" + twice + ", " + twice + "]}",
       {"goals[1].effector", "'right_hand'", "one for each"}},
      {with_goal(R"(, "seed": -1)"), {"seed", "-1", "from 0"}},
      {with_goal(R"(, "seed": 1.5)"), {"seed", "1.5", "whole"}},
      {with_goal(R"(, "candidates": 0)"), {"candidates", "is 0", "1 to 1000"}},
      {with_goal(R"(, "evaluations": 1)"), {"evaluations", "is 1", "from 8"}},
      {with_goal(R"(, "duration_s": "long")"), {"duration_s", "long", "0.05 to 60"}},
      {with_goal(R"(, "preset": "")"), {"preset", "Known: paper"}},
      {with_goal(R"(, "character": "ful_body")"), {"task.json: character", "'full_body'?"}},
      {with_goal(R"(, "character": "gone.bvh")"), {"gone.bvh", "No such file"}},
      {with_goal(R"(, "character": {"source": "one_joint.bvh"})"), {"one_joint.bvh"}},
      {with_goal(R"(, "character": {"source": "half_body", "mass_kg": 1e4})"),
       {"character.mass_kg", "10000", "2 to 300"}},
      {with_goal(R"(, "character": {"source": "half_body", "frame": 2})"),
       {"character.frame", "built in"}},
      {with_goal(R"(, "character": {"source": "half_body", "landmarks_m": {}})"),
       {"character.landmarks_m"}},
      {with_goal(R"(, "preset": "paper", "criteria": {"joint_range": {"weight": 0},
                      "balance": {"weight": 0}, "torque": {"weight": 0}})"),
       {"task.json: criteria", "all weights are 0"}},
      {with_goal(R"(, "fixed": "squat_deg=60")"), {"fixed", "must be a list of texts"}},
      {with_goal(R"(, "fixed": ["squat_deg"])"), {"fixed parameter squat_deg"}},
      {with_goal(R"(, "criteria": "papre")"), {"task.json: criteria", "did you mean 'paper'?"}},
      {with_goal(R"(, "criteria": [0.5, 0.3, 0.2])"), {"task.json: criteria", "must be an object"}},
      {with_goal(R"(, "criteria": {"balance_zone": {"margin_m": -0.03}})"),
       {"criteria.balance_zone.margin_m", "-0.03"}},
      {with_goal(R"(, "criteria": {"torque": {"weight": -1}})"), {"criteria.torque.weight", "-1"}},
      {std::string(100'000, '[') + std::string(100'000, ']'), {"task.json", "deeper than 32"}},
      {std::string(100'000, '['), {"task.json", "deeper than 32"}},
      {many_members(), {"task.json", "256 members"}},
  };
  for (const auto& [text, told] : table) {
    SCOPED_TRACE(text.substr(0, 200));
    folder_.put("task.json", text);
    expect_told({{{"reach", "task.json"}, told}});
  }
}

}  // namespace
}  // namespace shigusa
