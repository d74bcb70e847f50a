// SPDX-License-Identifier: MIT
// The preset layers on the command line: results, the library's cache, edits, refusals.

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const char* const kGoal = "right_hand=-0.3,0.9,0.45";

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& member : object.items()) names.push_back(member.key());
  return names;
}

double last_angle(const std::string& csv, const std::string& dof) {
  return csv_column(csv, dof + " [rad]").back();
}

class Layers : public testing::Test {
 protected:
  ProgramRun run(Words call) {
    return run_shigusa(call, {.folder = work_.path(), .cache = work_ / "cache"});
  }

  ProgramRun reach(const Words& more, const std::string& out = "out") {
    Words call{"reach", "--preset", "layers", "--formats", "bvh,csv", "--out", out};
    call.insert(call.end(), more.begin(), more.end());
    if (std::find(call.begin(), call.end(), "--character") == call.end()) {
      call.insert(call.end(), {"--character", "half_body"});
    }
    return run(call);
  }

  ProgramRun edit(const std::string& result, const Words& more) {
    Words call{"edit", result, "--formats", "bvh,csv"};
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }

  // All files of a result, without the entries about the computation.
  [[nodiscard]] std::map<std::string, std::string> bytes(const std::string& folder) const {
    const StoredRun stored(work_, folder);
    std::map<std::string, std::string> all;
    for (const std::string& name : stored.files()) all[name] = stored.get(name);
    Json summary = stored.summary();
    for (const char* key : {"elapsed_ms", "threads", "simd", "cells_searched"}) summary.erase(key);
    all["summary.json"] = summary.dump();
    return all;
  }

  WorkFolder work_;
};

TEST_F(Layers, HandArrivesAndFeetStay) {
  for (const char* body : {"half_body", "full_body"}) {
    const ProgramRun run = reach({"--character", body, "--goal", kGoal}, body);
    EXPECT_THAT(run.exit_code, delivered()) << run.err;
    EXPECT_THAT(run.out, testing::AllOf(HasSubstr("arm in body mm"),
                                        HasSubstr("cells of the limb library searched")));
    const StoredRun stored(work_, body);
    expect_promises_kept(stored);
    // eight are asked for, and the paper's algorithm converges to fewer
    EXPECT_THAT(stored.summary().at("fewer"), HasSubstr("of 8 candidates"));
    EXPECT_EQ(stored.summary().at("preset"), "layers");
    EXPECT_EQ(stored.summary().at("search"), "paper_ga");
    EXPECT_GT(stored.summary().at("cells_searched"), 0);
    EXPECT_THAT(keys(stored.candidate(1).at("arm_collision")),
                ElementsAre("depth_mm", "searches", "left"));
  }
}

TEST_F(Layers, ColdWarmAndWithoutCacheGiveTheSameBytes) {
  const Words call{"--character", "full_body", "--goal", kGoal, "--seed", "4"};
  ASSERT_THAT(reach(call, "cold").exit_code, delivered());
  ASSERT_THAT(reach(call, "warm").exit_code, delivered());
  Words without{"reach", "--preset", "layers", "--formats", "bvh,csv", "--out", "without"};
  without.insert(without.end(), call.begin(), call.end());
  ASSERT_THAT(run_shigusa(without, {.folder = work_.path()}).exit_code, delivered());
  const auto cells = [this](const char* folder) {
    return StoredRun(work_, folder).summary().at("cells_searched").get<int>();
  };
  EXPECT_GT(cells("cold"), 0);
  EXPECT_EQ(cells("warm"), 0);
  EXPECT_EQ(cells("without"), cells("cold"));
  EXPECT_EQ(bytes("warm"), bytes("cold"));
  EXPECT_EQ(bytes("without"), bytes("cold"));
}

TEST_F(Layers, EditOfTheArmLeavesTheTrunkWhereItWas) {
  ASSERT_THAT(reach({"--goal", kGoal}).exit_code, delivered());
  const ProgramRun run = edit("out", {"--set", "right_arm.right_shoulder.weight=1", "--set",
                                      "right_arm.right_shoulder.rotation.locked=true"});
  ASSERT_THAT(run.exit_code, delivered()) << run.err;
  const StoredRun edited(work_, "out/edit-1");
  expect_promises_kept(edited);
  EXPECT_THAT(edited.candidate(1).at("parameters").at("locked"),
              testing::Contains("right_arm.right_shoulder.rotation.weight"));
  const std::string csv = edited.get("candidate-1.csv");
  EXPECT_THAT(csv_column(csv, "right_shoulder.rotation [rad]"),
              testing::Each(csv_column(csv, "right_shoulder.rotation [rad]").front()));
  for (const char* dof : {"right_hip.flexion", "right_knee.flexion", "right_ankle.flexion"}) {
    EXPECT_EQ(last_angle(csv, dof), last_angle(work_.get("out/candidate-1.csv"), dof));
  }
}

// The whole body takes over if the layers fail with such an arm: reach is the same for all presets.
TEST_F(Layers, ArmThatIsLockedStaysAsItIs) {
  ASSERT_THAT(reach({"--goal", kGoal}).exit_code, delivered());
  const ProgramRun run = edit("out", {"--set", "right_arm.right_shoulder.locked=true"});
  EXPECT_THAT(run.exit_code, delivered()) << run.err;
  const StoredRun stored(work_, "out/edit-1");
  for (const char* dof : {"right_shoulder.flexion", "right_shoulder.abduction"}) {
    const auto angles = csv_column(stored.get("candidate-1.csv"), std::string(dof) + " [rad]");
    EXPECT_THAT(angles, testing::Each(angles.front()));
  }
  expect_ends_as_told(stored.motion(stored.candidate(1)), stored.candidate(1));
}

TEST_F(Layers, WrongValuesAreRefusedInWords) {
  ASSERT_THAT(reach({"--goal", kGoal}).exit_code, delivered());
  const struct {
    Words call;
    Words told;
  } table[] = {
      {{"reach", "--goal", kGoal, "--preset", "layer"}, {"'layer'", "did you mean 'layers'?"}},
      {{"reach", "--goal", kGoal, "--preset", "layers", "--layer-reading", "shared_contraction"},
       {"'shared_contraction'", "did you mean 'shared_contractions'?"}},
      {{"reach", "--goal", kGoal, "--preset", "flat", "--layer-reading", "contraction_a_limb"},
       {"--layer-reading", "of the presets layers and human", "the preset is flat"}},
      {{"reach", "--preset", "layers", "--character", "half_body", "--goal", "left_hand=0,1,0.3"},
       {"'left_hand'", "Known: right_hand"}},
      {{"reach", "--preset", "layers", "--goal", kGoal, "--fix", "right_hip.weight=3"},
       {"fixed with the other presets"}},
      {{"edit", "out", "--set", "legs.contraction=16"},
       {"legs.contraction=16", "contraction is '16'", "0 to 15"}},
      {{"edit", "out", "--set", "legs.contraction=-1"}, {"'-1'", "0 to 15"}},
      {{"edit", "out", "--set", "legs.contraction=nan"}, {"'nan'", "0 to 15"}},
      {{"edit", "out", "--set", "legs.contraction="}, {"contraction is ''"}},
      {{"edit", "out", "--set", "legs.contraction"}, {"NAME.contraction=NUMBER"}},
      {{"edit", "out", "--set", "leggs.contraction=1"}, {"'leggs'", "did you mean 'legs'?"}},
      {{"edit", "out", "--set", "legs.weight=1"}, {"unknown joint 'legs'"}},
      {{"edit", "out", "--set", "right_hip.contraction=1"}, {"unknown limb 'right_hip'"}},
      {{"edit", "out", "--set", "legs.contractoin=1"}, {"did you mean 'contraction'?"}},
      {{"edit", "out", "--set", "right_hip.weight=0"}, {"'0'", "0.001 to 1000"}},
      {{"edit", "out", "--set", "right_hip.locked=yes"}, {"'yes'", "true and false"}},
      {{"edit", "out", "--set", "squat_deg=60"}, {"NAME.contraction=NUMBER"}},
      {{"edit", "out", "--set", "right_arm.right_elbw.weight=1"},
       {"did you mean 'right_arm.right_elbow'?"}},
  };
  const auto before = work_.contents();
  for (const auto& row : table) {
    const ProgramRun refused = run(row.call);
    EXPECT_EQ(refused.exit_code, 2) << row.call.back();
    EXPECT_EQ(refused.out, "");
    for (const std::string& word : row.told) EXPECT_THAT(refused.err, HasSubstr(word));
  }
  EXPECT_EQ(work_.contents(), before);
}

}  // namespace
}  // namespace shigusa
