// SPDX-License-Identifier: MIT
// The mistakes of somebody's first hour: each message says where it is, what was seen, what is
// allowed, and what to try.
#include <gmock/gmock.h>

#include "support/gltf_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const char* const kGoal = "right_hand=-0.2,1.1,0.4";

struct Mistake {
  Words call;
  Words told;  // what the message must contain
};

// A call of reach with a goal that is right.
Words reach(Words more) {
  Words call{"reach", "--goal", kGoal};
  call.insert(call.end(), more.begin(), more.end());
  return call;
}

const std::vector<Mistake>& of_commands() {
  static const std::vector<Mistake> mistakes{
      {{}, {"give a command", "reach, edit, mirror", "shigusa --help"}},
      {{"reech"}, {"'reech'", "did you mean 'reach'?"}},
      {{"out.bvh"}, {"'out.bvh' is no command", "a file comes after one", "render"}},
      {{"--goal", kGoal}, {"--goal comes after the command that has it: reach"}},
      {{"--frobnicate"}, {"unknown option '--frobnicate'", "Known: --help"}},
      {{"dataset", "mrge", "DIR"}, {"shigusa dataset", "'mrge'", "did you mean 'merge'?"}},
      {{"dataset", "mrge"}, {"command or plan 'mrge'", "did you mean 'merge'?"}},
      {{"dataset"}, {"give a plan", "shigusa dataset PLAN.json --out FOLDER"}},
      {{"dataset", "task.json", "--out", "d"}, {"unknown key", "`shigusa reach` makes"}},
      {{"dataset", "merge"}, {"folder is required: Folder of the data set"}},
      {{"dataset", "merge", "folder"}, {"folder/plan.json", "a data set is a folder that"}},
      {{"dataset", "check", "gone"}, {"gone/plan.json", "there is no folder gone"}},
      {{"dataset", "export", "folder", "--to", "csv"}, {"--out FOLDER is required"}},
      {{"dataset", "export", "folder", "--to", "xls", "--out", "x"},
       {"--to", "'xls'", "Known: npz, humanml3d, csv, glb"}},
      {{"dataset", "export", "folder", "--to", "csv", "--out", "x", "--tasks", "5"},
       {"--tasks", "'5'", "FIRST:LAST, such as 0:100"}},
      {{"dataset", "plan.json", "--part", "1/2", "--shards", "0:1", "--out", "d"},
       {"--part", "--shards", "give one of both"}},
      {{"schema", "plan"}, {"'plan' is one argument too many", "did you mean '--plan'?"}},
      {{"manual", "reech"}, {"'reech'", "did you mean 'reach'?"}},
      {{"manual", "reach", "--as", "html"}, {"--as", "'html'", "text, man, markdown"}},
      {{"completion", "tcsh"}, {"'tcsh'", "Known: bash, zsh, fish"}},
      {{"studio", "--port", "http"}, {"--port", "'http'", "0 to 65535"}},
      {{"studio", "--folder", "folder"}, {"folder", "index.html", "scripts/build_studio"}},
  };
  return mistakes;
}

const std::vector<Mistake>& of_goals() {
  static const std::vector<Mistake> mistakes{
      {{"reach"}, {"no goal", std::string("--goal ") + kGoal}},
      {{"reach", "--gaol", kGoal}, {"'--gaol'", "did you mean '--goal'?"}},
      {{"reach", "--goal"}, {"--goal needs a value, EFFECTOR=X,Y,Z", "metres"}},
      {reach({"--formats", "glb", "vrma"}),
       {"vrma: cannot open", "commas, as in --formats bvh,glb"}},
      {{"reach", "--goal", "--out", "x"}, {"--goal", "needs a value", "--out follows it"}},
      {{"reach", "--goal", "right_hand"}, {"EFFECTOR=X,Y,Z", kGoal, "no '=' is in it"}},
      {{"reach", "--goal", "right_hand=0.2,1.1"}, {"EFFECTOR=X,Y,Z", "2 numbers are given"}},
      {{"reach", "--goal", "right_hand=-0,2,1,1,0,4"}, {"decimals have a point"}},
      {{"reach", "--goal", "right_hand=-0.2;1.1;0.4"}, {"commas stand between numbers"}},
      {{"reach", "--goal", "right_hand=-0.2,x,0.4"}, {"'x' is no number"}},
      {{"reach", "--goal", "right_hand", "-0.2", "1.1", "0.4"}, {"with commas and no blanks"}},
      {{"reach", "--goal", "right_hand=-0.2,", "1.1,", "0.4"}, {"with commas and no blanks"}},
      {{"reach", "--goal", "right_hand=550,1000,300"},
       {"if millimetres are meant, give 0.55,1,0.3", "-100 to 100 m"}},
      {{"reach", "--goal", "right_hnad=0,1,0.4"}, {"'right_hnad'", "did you mean 'right_hand'?"}},
      {{"reach", kGoal}, {"No such file", std::string("--goal ") + kGoal}},
      {{"reach", "--goal", kGoal, "--goal", kGoal}, {"two goals for right_hand"}},
      {reach({"--palm", "right_hand=sideways"}), {"--palm", "'sideways'", "up, down", "X,Y,Z"}},
      {reach({"--palm", "up"}), {"--palm 'up'", "HAND=DIRECTION, such as right_hand=up"}},
      {reach({"--palm", "left_hand=up"}), {"left_hand has none", "--goal left_hand=X,Y,Z"}},
      {reach({"--load", "left_hand=5"}), {"left_hand has none", "--goal left_hand=X,Y,Z"}},
      {reach({"--load", "5"}), {"--load '5'", "EFFECTOR=KILOGRAMS", "right_hand=5"}},
      {reach({"--load", "right_hand=5kg"}), {"'5kg' is no number"}},
      {reach({"--load", "right_hand=900"}), {"900 kg", "0 to 500 kg"}},
      {reach({"--rotation", "right_hand=0,90,0"}), {"X,Y,Z,W", "3 numbers are given"}},
      {reach({"--tolerance", "right_hand=0.1"}), {"X,Y,Z", "1 number is given"}},
      {reach({"--look-at", "1,2"}), {"--look-at", "X,Y,Z", "2 numbers are given"}},
      {reach({"--contacts", "left_feet"}), {"'left_feet'", "did you mean 'left_foot'?"}},
      {reach({"--obstacle", "table=0,0.7,0.5"}), {"NAME=X,Y,Z,SX,SY,SZ", "3 numbers are given"}},
      {reach({"--obstacle", "table=0,0.7,0.5,1,-0.05,0.6"}),
       {"obstacle table", "size along y is -0.05", "0 to 100 m"}},
      {reach({"--obstacle", "0,0.7,0.5,1,0.05,0.6"}), {"NAME=X,Y,Z,SX,SY,SZ", "no '='"}},
      {reach({"--support", "thigh"}), {"HAND=PLACE, such as left_hand=thigh"}},
      {reach({"--support", "left_hand=table"}), {"'table'", "Known: thigh"}},
      {reach({"--preset", "layers", "--palm", "right_hand=up"}), {"layers", "the preset flat"}},
  };
  return mistakes;
}

const std::vector<Mistake>& of_people_and_settings() {
  static const std::vector<Mistake> mistakes{
      {reach({"--stature", "155"}), {"--stature", "155 m", "0.5 to 2.5 m", "155 cm are 1.55"}},
      {reach({"--stature", "1,55"}), {"'1,55'", "decimals have a point: 1.55"}},
      {reach({"--stature", "p10"}), {"'p10'", "p5, p50 and p95"}},
      {reach({"--mass", "0"}), {"0 kg", "2 to 300 kg"}},
      {reach({"--mass", "60,5"}), {"--mass", "decimals have a point: 60.5"}},
      {reach({"--sex", "woman"}), {"--sex", "'woman'", "male, female"}},
      {reach({"--seat", "45"}), {"--seat", "45 m", "0.1 to 1.2 m", "45 cm are 0.45"}},
      {reach({"--character", "huma"}), {"'huma'", "did you mean 'human'?"}},
      {reach({"--character", "hero.obj"}), {"'hero.obj'", ".bvh, .glb"}},
      {reach({"--character", "somebody_else.vrm"}),
       {"No such file", "this folder has no .vrm file"}},
      {reach({"--character", "folder/somebody_else.bvh"}), {"folder has no .bvh file"}},
      {reach({"--character", "a_colleague_of_mine.bvh"}), {"this folder has person.bvh"}},
      {reach({"--character", "persn.bvh"}), {"persn.bvh", "did you mean 'person.bvh'?"}},
      {reach({"--map", "right_hand=Bone"}), {"--map", "human is built in", "give a file"}},
      {reach({"--frame", "3"}), {"--frame", "human is built in", "give a file"}},
      {reach({"--character", "person.bvh", "--frame", "first"}), {"'first'", "or rest"}},
      {reach({"--character", "person.bvh", "--map", "rigt_hand=hips"}),
       {"'rigt_hand'", "did you mean 'right_hand'?"}},
      {reach({"--character", "person.bvh", "--map", "right_hand=Object_4711"}),
       {"has no 'Object_4711' for right_hand", "its nodes are "}},
      {{"body", "person.bvh", "--extent", "whole"}, {"--extent", "'whole'", "half, full, human"}},
      {{"body"}, {"source is required: A built-in body"}},
      {reach({"--preset", "papr"}), {"--preset", "'papr'", "did you mean 'paper'?"}},
      {reach({"--criteria", "defualt"}), {"--criteria", "did you mean 'default'?"}},
      {reach({"--formats", "gltf"}), {"--formats", "'gltf'", "bvh, csv, svg, png, pdf, glb"}},
      {reach({"--formats", "vrma"}), {"human is none", "--character"}},
      {reach({"--simd", "mmx"}), {"--simd", "'mmx'", "scalar"}},
      {reach({"--duration", "2s"}), {"--duration", "'2s'", "numbers, such as 1.5"}},
      {reach({"--seed", "1", "--seed", "2"}), {"--seed is given 2 times", "once"}},
      {reach({"--candidates", "many"}), {"--candidates", "'many'", "1 to 1000"}},
      {reach({"--seconds", "0"}), {"--seconds", "'0'", "0.001 to 1000000"}},
      {reach({"--fps", "500"}), {"--fps", "'500'", "1 to 240"}},
      {reach({"--json=maybe"}), {"--json takes no value"}},
      {reach({"--fix", "sqat_deg=60"}), {"sqat_deg", "did you mean 'squat_deg'?"}},
  };
  return mistakes;
}

const std::vector<Mistake>& of_files() {
  static const std::vector<Mistake> mistakes{
      {{"reach", "tsk.json"}, {"tsk.json", "No such file", "did you mean 'task.json'?"}},
      {{"reach", "empty.json"}, {"empty.json", "empty", "shigusa schema"}},
      {{"reach", "text.json"}, {"not JSON", "line 1", "shigusa schema"}},
      {{"reach", "folder"}, {"folder", "Is a directory", "a task file (JSON)"}},
      {{"reach", "person.bvh"}, {"not JSON", "--character person.bvh"}},
      {reach({"--out", "taken"}), {"taken", "Not a directory", "give another by --out"}},
      {reach({"--out", "/proc/x"}), {"/proc/x", "give another by --out"}},
      {{"edit"}, {"result is required", "summary.json"}},
      {{"edit", "resul"}, {"resul", "did you mean 'result'?"}},
      {{"edit", "folder"}, {"folder/summary.json", "a result is a folder that reach"}},
      {{"edit", "old"}, {"old/summary.json", "version is 99", "allowed is 1", "another version"}},
      {{"edit", "result/candidate-1.bvh"}, {"not JSON", "give the folder that it is in"}},
      {{"edit", "result", "--set", "right_elbw.weight=3"}, {"did you mean 'right_elbow'?"}},
      {{"edit", "result", "--set", "right_elbow.weight=3,5"},
       {"--set", "'3,5'", "0.001 to 1000", "decimals have a point: 3.5"}},
      {{"edit", "result", "--set", "right_elbow.weight"}, {"NAME.weight=NUMBER"}},
      {{"edit", "result", "--candidate", "best"}, {"--candidate", "'best'", "whole numbers"}},
      {{"edit", "result", "--candidate", "99"}, {"candidate 99", "the candidates 1 to 2"}},
      {{"edit", "result", "--out", "result"}, {"never writes over", "give another"}},
      {{"show", "folder"}, {"folder/summary.json", "a result is a folder"}},
      {{"render"}, {"clip is required", "BVH file"}},
      {{"render", "result"}, {"Is a directory", "such as candidate-1.bvh"}},
      {{"render", "hero.glb"}, {"hero.glb", "render draws BVH files alone"}},
      {{"render", "person.bvh", "--out", "p.jpg"}, {"p.jpg", ".svg, .png or .pdf", "'.jpg'"}},
      {{"render", "person.bvh", "--out", "none/p.svg"}, {"there is no folder none"}},
      {{"render", "person.bvh", "--frames", "0-2"}, {"'0-2'", "FIRST:LAST", "0:120"}},
      {{"render", "person.bvh", "--frames", "0:99"}, {"0 to 99", "0 to 2"}},
      {{"score", "taken"}, {"taken", "is no clip", ".bvh"}},
      {{"score", "person.bvh", "--criteria", "good"}, {"--criteria", "'good'", "paper, default"}},
      {{"score", "person.bvh", "--smooth", "fast"}, {"--smooth", "'fast'", "numbers"}},
  };
  return mistakes;
}

class FirstHour : public testing::Test {
 protected:
  FirstHour() {
    folder_.put("person.bvh", person_bvh());
    folder_.put("hero.glb", glb(person_gltf().dump()));
    folder_.put("task.json",
                R"({"goals": [{"effector": "right_hand", "position_m": [0, 1, 0.4]}]})");
    folder_.put("empty.json", "");
    folder_.put("text.json", "hello");
    folder_.put("folder/kept.txt", "kept");
    folder_.put("taken", "a file where a folder is wanted");
    const ProgramRun run =
        run_shigusa({"reach", "--goal", kGoal, "--character", "half_body", "--preset", "paper",
                     "--candidates", "2", "--formats", "bvh", "--out", "result"},
                    {.folder = folder_.path()});
    SHG_CHECK(run.exit_code == 0 || run.exit_code == 3, run.err);
    std::string summary = folder_.get("result/summary.json");
    const std::string version = "\"version\": 1";
    summary.replace(summary.find(version), version.size(), "\"version\": 99");
    folder_.put("old/summary.json", summary);
  }

  void expect_told(const std::vector<Mistake>& mistakes) {
    const auto before = folder_.contents();
    for (const auto& [call, told] : mistakes) {
      const ProgramRun run = run_shigusa(call, {.folder = folder_.path()});
      EXPECT_EQ(run.exit_code, 2) << run.err;
      EXPECT_EQ(run.out, "") << run.err;
      for (const std::string& word : told) EXPECT_THAT(run.err, HasSubstr(word));
    }
    EXPECT_EQ(folder_.contents(), before);
  }

  WorkFolder folder_;
};

TEST_F(FirstHour, MistakesInCommandsAreTold) { expect_told(of_commands()); }
TEST_F(FirstHour, MistakesInGoalsAreTold) { expect_told(of_goals()); }
TEST_F(FirstHour, MistakesInPeopleAndSettingsAreTold) { expect_told(of_people_and_settings()); }
TEST_F(FirstHour, MistakesInFilesAreTold) { expect_told(of_files()); }

TEST_F(FirstHour, CentimetresAreTakenForWhatTheyAre) {
  const ProgramRun run = run_shigusa({"reach", "--goal", "right_hand=-20,110,40", "--character",
                                      "half_body", "--preset", "paper", "--formats", "bvh"},
                                     {.folder = folder_.path()});
  EXPECT_EQ(run.exit_code, 2) << run.err;  // 110 m is further than any goal may be
  EXPECT_THAT(run.err, HasSubstr("if centimetres are meant, give -0.2,1.1,0.4"));
  const ProgramRun far = run_shigusa({"reach", "--goal", "right_hand=-20,90,40", "--character",
                                      "half_body", "--preset", "paper", "--formats", "bvh"},
                                     {.folder = folder_.path()});
  EXPECT_EQ(far.exit_code, 3) << far.err;
  EXPECT_THAT(far.err, HasSubstr("if centimetres are meant, give -0.2,0.9,0.4"));
}

}  // namespace
}  // namespace shigusa
