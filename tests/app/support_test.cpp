// SPDX-License-Identifier: MIT
// Resting hands on the command line, measured by the written files' own kinematics.
#include <algorithm>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Words = std::vector<std::string>;

class Supports : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }

  ProgramRun reach(const std::string& folder, const Words& more) {
    Words call{"reach", "--character", "human", "--formats",    "bvh,csv", "--out",
               folder,  "--seed",      "3",     "--candidates", "2"};
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }
  // One hand reaches to the floor.
  ProgramRun pick_up(const std::string& folder, Words more = {}) {
    more.insert(more.begin(), {"--goal", "right_hand=-0.1,0.12,0.4"});
    return reach(folder, more);
  }

  [[nodiscard]] Json first(const std::string& folder) const {
    return StoredRun(work_, folder).candidate(1);
  }

  // The largest moment (N·m) that straightens the lowest joint of the back.
  [[nodiscard]] double low_back(const std::string& folder) const {
    const std::string text = work_.get(folder + "/candidate-1.csv");
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    const auto cells = [](const std::string& row) {
      Words all;
      std::istringstream in(row);
      for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
      return all;
    };
    const Words head = cells(line);
    const auto column = static_cast<std::size_t>(
        std::find(head.begin(), head.end(), "spine.flexion torque [N m]") - head.begin());
    double most = 0.0;
    while (std::getline(lines, line)) most = std::max(most, -std::stod(cells(line).at(column)));
    return most;
  }

  WorkFolder work_;
};

// Kingma et al. 2016: a hand on the thigh takes 17 to 25 % off the peak moment about L5/S1 of men
// who pick up a pencil.
TEST_F(Supports, AHandOnTheThighUnloadsTheLowBack) {
  ASSERT_EQ(pick_up("free").exit_code, 0);
  ASSERT_EQ(pick_up("resting", {"--support", "left_hand=thigh"}).exit_code, 0);
  const Json best = first("resting");
  const Json& resting = best.at("resting").at(0);
  EXPECT_EQ(resting.at("effector"), "left_hand");
  EXPECT_EQ(resting.at("on"), "thigh");
  EXPECT_LE(resting.at("max_slide_mm").get<double>(), 1.0);
  EXPECT_GT(best.at("parameters").at("left_hand.support").get<double>(), 0.0);
  const double less = 1.0 - low_back("resting") / low_back("free");
  RecordProperty("low_back_percent", static_cast<int>(100 * less));
  EXPECT_GT(less, 0.08);
  EXPECT_LT(less, 0.35);
  const ExportedMotion motion = StoredRun(work_, "resting").motion(best);
  expect_goals_met(motion, best);
  expect_feet_stand(motion, best);
}

TEST_F(Supports, AHandStaysFreeWhereRestingDoesNotPay) {
  ASSERT_EQ(
      reach("out", {"--goal", "right_hand=-0.2,1.4,0.5", "--support", "left_hand=thigh"}).exit_code,
      0);
  const Json best = first("out");
  EXPECT_FALSE(best.contains("resting"));
  EXPECT_LT(best.at("parameters").at("left_hand.support").get<double>(), 0.0);
}

TEST_F(Supports, AnEditPressesMoreAndFreesTheHand) {
  ASSERT_EQ(pick_up("out", {"--support", "left_hand=thigh"}).exit_code, 0);
  ASSERT_EQ(run({"edit", "out/summary.json", "--candidate", "1", "--set", "left_hand.support=0.25",
                 "--formats", "csv", "--out", "more"})
                .exit_code,
            0);
  EXPECT_LT(low_back("more"), low_back("out") - 1.0);
  // without the hand the body may not be able to make the motion
  const ProgramRun freed = run({"edit", "out/summary.json", "--candidate", "1", "--set",
                                "left_hand.support=-0.05", "--formats", "csv", "--out", "freed"});
  EXPECT_THAT(freed.exit_code, testing::AnyOf(0, 3)) << freed.err;
  EXPECT_FALSE(first("freed").contains("resting"));
}

TEST_F(Supports, AMirrorImageRestsTheOtherHand) {
  ASSERT_EQ(pick_up("out", {"--support", "left_hand=thigh"}).exit_code, 0);
  ASSERT_EQ(run({"mirror", "out/summary.json", "--formats", "csv", "--out", "image"}).exit_code, 0);
  const Json image = first("image");
  EXPECT_EQ(image.at("resting").at(0).at("effector"), "right_hand");
  EXPECT_NEAR(image.at("resting").at(0).at("force_N").get<double>(),
              first("out").at("resting").at(0).at("force_N").get<double>(), 1e-6);
}

TEST_F(Supports, AHandRestsOnATable) {
  const Words asked{"--goal",     "right_hand=-0.2,0.75,0.75",
                    "--obstacle", "table=0,0.35,0.6,1.2,0.7,0.5",
                    "--support",  "left_hand=table"};
  const ProgramRun done = reach("out", asked);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json best = first("out");
  EXPECT_EQ(best.at("resting").at(0).at("on"), "table");
  EXPECT_LE(best.at("resting").at(0).at("max_slide_mm").get<double>(), 1.0);
  const ExportedMotion motion = StoredRun(work_, "out").motion(best);
  const double height = motion.at_end(best.at("resting").at(0).at("joint")).y;
  // a hand's thickness above the top
  EXPECT_GT(height, 0.70);
  EXPECT_LT(height, 0.75);
}

}  // namespace
}  // namespace shigusa
