// SPDX-License-Identifier: MIT
#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& member : object.items()) names.push_back(member.key());
  return names;
}

std::vector<std::string> example_tasks() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(SHIGUSA_SOURCE_DIR "/examples/tasks")) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class ExampleTask : public testing::TestWithParam<std::string> {
 protected:
  ExampleTask()
      : run_(run_shigusa({"reach", SHIGUSA_SOURCE_DIR "/examples/tasks/" + GetParam() + ".json",
                          "--formats", "bvh,csv,svg,png,pdf", "--out", "out"},
                         {.folder = work_.path()})),
        stored_(work_, "out") {}

  WorkFolder work_;
  ProgramRun run_;
  StoredRun stored_;
};

TEST_P(ExampleTask, ReachesItsGoalsWithPlantedFeetAndListsItsFiles) {
  EXPECT_THAT(run_.exit_code, delivered()) << run_.err;
  expect_promises_kept(stored_);
  std::set<std::string> listed{"summary.json"};
  for (const Json& candidate : stored_.summary().at("candidates")) {
    EXPECT_EQ(candidate.at("files").size(), 5u);
    for (const auto& file : candidate.at("files").items()) listed.insert(file.value());
  }
  EXPECT_EQ(stored_.files(), listed);
}

INSTANTIATE_TEST_SUITE_P(Of, ExampleTask, testing::ValuesIn(example_tasks()),
                         [](const auto& of) { return of.param; });

class Reach : public testing::Test {
 protected:
  // Runs `shigusa reach` with 8 motions, which is enough where it does not matter how good they
  // are.
  ProgramRun reach(const Words& more, const std::string& formats = "bvh,csv",
                   const std::string& out = "out") {
    Words call{"reach", "--evaluations", "8", "--formats", formats, "--out", out};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  WorkFolder work_;
};

// Feet planted, with a goal for the hands so far behind that nobody reaches it without falling.
TEST_F(Reach, TellsInWordsWhereAPersonCouldNotStand) {
  const auto least_mm = [&] {
    const StoredRun stored(work_, "out");
    return stored.candidate(1).at("support").at("centre_of_mass").at("least_mm").get<double>();
  };
  const ProgramRun behind = reach({"--character", "human", "--goal", "right_hand=-0.2,1,-1.5"});
  EXPECT_EQ(behind.exit_code, 3);
  EXPECT_THAT(behind.err, testing::HasSubstr("no motion was found that this body could make"));
  EXPECT_THAT(behind.out, testing::HasSubstr("the floor would have to press"));
  EXPECT_LT(least_mm(), -100.0);
  const ProgramRun ahead = reach({"--character", "human", "--goal", "right_hand=-0.2,1.2,0.5"});
  EXPECT_EQ(ahead.exit_code, 0) << ahead.err;
  EXPECT_THAT(ahead.err, testing::Not(testing::HasSubstr("balance")));
  EXPECT_GT(least_mm(), 10.0);
}

TEST_F(Reach, CriteriaOfTheCallReplaceThoseOfTheTaskFile) {
  const std::string task = work_.put(
      "task.json",
      R"({"character": "full_body", "preset": "paper", "criteria": {"work": {"weight": 0.5}},
          "goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.4]}]})");
  const auto terms_by = [&](const Words& more) {
    Words call{task};
    call.insert(call.end(), more.begin(), more.end());
    EXPECT_EQ(reach(call, "bvh").exit_code, 0);
    return keys(StoredRun(work_, "out").candidate(1).at("criteria"));
  };
  EXPECT_THAT(terms_by({}),
              testing::UnorderedElementsAre("joint_range", "balance", "torque", "work"));
  EXPECT_THAT(terms_by({"--criteria", "paper"}),
              testing::UnorderedElementsAre("joint_range", "balance", "torque"));
  EXPECT_THAT(terms_by({"--criteria", "default"}),
              testing::UnorderedElementsAre("joint_range", "balance_zone", "discomfort",
                                            "joint_acceleration", "low_back", "collision",
                                            "centre_of_pressure", "feasibility", "coordination",
                                            "hand_curve", "trunk_travel", "mass_ahead", "jolts"));
}

TEST_F(Reach, GoalsOfTheCallReplaceThoseOfTheTaskFile) {
  const std::string task =
      work_.put("task.json",
                R"({"seed": 4, "goals": [{"effector": "right_hand", "position_m": [0, 9, 0]}]})");
  const ProgramRun run = reach({"--goal", "right_hand=-0.2,1.1,0.4", task});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const StoredRun stored(work_, "out");
  EXPECT_EQ(stored.summary().at("seed"), 4);
  EXPECT_EQ(to_vec(stored.summary().at("goals").at(0).at("position_m")), (Vec3d{-0.2, 1.1, 0.4}));
}

TEST_F(Reach, TaskOfASummaryIsATaskFile) {
  ASSERT_EQ(reach({"--goal", "right_hand=-0.2,1.1,0.4", "--seed", "3"}).exit_code, 0);
  const StoredRun first(work_, "out");
  const std::string task = work_.put("task.json", first.summary().at("task").dump());
  ASSERT_EQ(reach({task}, "bvh", "again").exit_code, 0);
  EXPECT_EQ(StoredRun(work_, "again").get("candidate-1.bvh"), first.get("candidate-1.bvh"));
}

TEST_F(Reach, WithoutFormatsWritesTheSummaryAlone) {
  ASSERT_EQ(reach({"--goal", "right_hand=-0.2,1.1,0.4"}, "").exit_code, 0);
  EXPECT_EQ(StoredRun(work_, "out").files(), std::set<std::string>{"summary.json"});
}

TEST_F(Reach, GoalBelowTheFloorIsNoted) {
  const ProgramRun run = reach({"--goal", "right_hand=-0.2,-0.1,0.3"});
  EXPECT_THAT(
      run.err,
      HasSubstr(
          "goal: note: the goal of right_hand is 0.1 m below the floor: the hand goes through it"));
}

TEST_F(Reach, FilesHaveTheRateThatIsAskedFor) {
  for (const auto& [fps, frame_time] :
       {std::pair{"24", "0.041666666666666664"}, {"29.97", "0.033366700033366704"}}) {
    ASSERT_EQ(
        reach({"--goal", "right_hand=-0.2,1.1,0.4", "--fps", fps, "--duration", "1.1"}).exit_code,
        0);
    const StoredRun stored(work_, "out");
    expect_promises_kept(stored);
    EXPECT_THAT(stored.get("candidate-1.bvh"),
                testing::HasSubstr(std::string("Frame Time: ") + frame_time));
    EXPECT_EQ(stored.candidate(1).at("fps"), std::stod(fps));
    EXPECT_EQ(stored.candidate(1).at("duration_s"), 1.1);
    const std::string csv = stored.get("candidate-1.csv");
    const std::vector<double> times = csv_column(csv, "time [s]");
    EXPECT_EQ(times.size(), stored.candidate(1).at("frames").get<std::size_t>());
    EXPECT_EQ(times.front(), 0.0);
    EXPECT_NEAR(times.back(), 1.1, 1e-12);
    EXPECT_EQ(csv_column(csv, "right_knee.flexion torque [N m]").size(), times.size());
    const Vec3d end{csv_column(csv, "right_hand.x [m]").back(),
                    csv_column(csv, "right_hand.y [m]").back(),
                    csv_column(csv, "right_hand.z [m]").back()};
    EXPECT_LE(norm(end - Vec3d{-0.2, 1.1, 0.4}), kMillimetre);
  }
}

}  // namespace
}  // namespace shigusa
